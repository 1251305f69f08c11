/* simplex_state.h: the state of the revised simplex method: a basis with its inverse, the slacks of
 * the rows, and the multipliers of a cost. The backend has one, and the membership program of ray
 * shooting.
 *
 * Invariants: slack = right - rows times the point, which is about 0 for rows in the basis; y times
 * the basis is the cost.
 */
#ifndef FMB_LP_SIMPLEX_STATE_H
#define FMB_LP_SIMPLEX_STATE_H

#include "lp/simplex/basis_inverse.h"
#include "lp/simplex/columns.h"

/* A pivot with a larger relative error is not used. */
#define FMB_SIMPLEX_DOUBTFUL 1e-6

/* The condition on the multiplier of a member, or on a row outside of the basis. */
typedef enum fmb_role {
    FMB_ROLE_LESS,  /* >= 0; the row is an inequality */
    FMB_ROLE_EQUAL, /* any sign; an equality */
    FMB_ROLE_FREE   /* zero: a unit vector or a row that is off; a row in the basis */
} fmb_role;

typedef struct fmb_simplex_state {
    const fmb_scaled_program *f;
    size_t n, m;
    fmb_basis_inverse basis;
    fmb_columns columns;
    fmb_indexed_vector entry, edge,
        rate;                 /* [n], [n], [m]: a row in the basis, an edge, rows along it */
    double *y, *cost, *given; /* [n]; given: right sides by place */
    double *edge_weight;      /* [n] of Devex, or squared lengths, for the primal method */
    uint8_t *member_role;     /* [n] */
    int *falling;             /* [n] scratch of the dual method: places */
    double *right, *slack;    /* [m] current right sides */
    double *row_weight;       /* [m] of Devex, for the dual method */
    uint8_t *row_role;        /* [m] */
    int *violated;            /* [violations] of the dual method: rows perhaps violated */
    bool *is_listed;          /* [m] among them */
    size_t violations;
    size_t right_room, slack_room, row_weight_room, row_role_room, violated_room, listed_room;
    double nudge;             /* least multiplier given to a row if the dual method stalls */
    size_t steps, most_steps; /* so far; after which the primal method gives up */
    size_t idle;              /* steps of the primal method since the point moved */
    uint64_t random;
    /* For many short walks with an explicit inverse: slacks are kept from one to the next, ends are
     * not checked with a recomputed basis, and edges are measured at each step; the primal method
     * stops, too, where the cost of the point is more than `enough`. */
    bool is_brief;
    double enough;
    bool placed;
    bool feasible, moved; /* right sides differ from those of the scaled program */
} fmb_simplex_state;

/* A basis of unit vectors, and all rows of the scaled program. Errors: MEMORY, LIMIT. The caller
 * must call fmb_simplex_state_clear even then. */
fmb_status fmb_simplex_state_init(fmb_simplex_state *o, const fmb_scaled_program *f,
                                  fmb_inverse_kind kind);
void fmb_simplex_state_clear(fmb_simplex_state *o);
/* Copy the rows that the scaled program got since. Errors: MEMORY, LIMIT. */
fmb_status fmb_simplex_state_grow(fmb_simplex_state *o);

/* Use these members as the basis. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_simplex_state_place(fmb_simplex_state *o, const size_t *member);
/* Read the rows again, of which some were removed, and use these members. */
fmb_status fmb_simplex_state_reload(fmb_simplex_state *o, const size_t *member);
/* Recompute slacks and multipliers from the basis, which is itself recomputed if it is stale, or
 * found to be inexact. */
fmb_status fmb_simplex_state_refresh(fmb_simplex_state *o);
/* The same, with the basis recomputed always. */
fmb_status fmb_simplex_state_renew(fmb_simplex_state *o);
/* Recompute the multipliers. */
void fmb_simplex_state_price(fmb_simplex_state *o);
/* edge = the point. */
void fmb_simplex_state_find_point(fmb_simplex_state *o);
/* Set the role of row i as one outside of the basis, on or off. */
void fmb_simplex_state_note_role(fmb_simplex_state *o, size_t i);

/* Compute edge r, and the rates of the rows along it. */
void fmb_simplex_state_look_along(fmb_simplex_state *o, size_t r);
/* Put row i, written in the basis, at place r, whose edge was computed: the point moves until row i
 * is tight. */
fmb_status fmb_simplex_state_pivot(fmb_simplex_state *o, size_t r, size_t i);
/* Replace a row that is off, at place r, by the nearest row along its edge, or a unit vector. */
fmb_status fmb_simplex_state_expel(fmb_simplex_state *o, size_t r);

/* Add `part` times the member at place r to the cost. */
void fmb_simplex_state_add_to_cost(fmb_simplex_state *o, size_t r, double part);

/* Work of a pivot (fmb_run_count). */
static inline size_t fmb_simplex_state_work(const fmb_simplex_state *o)
{
    return 400 + 8 * (o->n + o->m) + 2 * fmb_indexed_vector_count(&o->rate);
}

/* For a right side of about 1, smaller slacks count as zero. */
static inline double fmb_simplex_state_tolerance(const fmb_simplex_state *o)
{
    return o->f->sharp ? 1e-11 : 1e-9;
}
/* With row i written and edge r computed: does their pivot differ between the two? Then its
 * rounding errors are as large as the pivot. */
static inline bool fmb_simplex_state_is_doubtful(const fmb_simplex_state *o, size_t r, size_t i)
{
    double by_row = o->entry.at[r], by_edge = o->rate.at[i];
    return fabs(by_row - by_edge) > FMB_SIMPLEX_DOUBTFUL * fabs(by_edge);
}
/* A random number from 1 to 2. */
static inline double fmb_simplex_state_draw(fmb_simplex_state *o)
{
    o->random = o->random * 6364136223846793005u + 1442695040888963407u;
    return 1 + (double)(o->random >> 12) * 0x1p-52;
}

#endif
