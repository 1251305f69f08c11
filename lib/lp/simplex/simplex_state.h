/* simplex_state.h: the state of the revised simplex method: a basis with its inverse, what the rows
 * have left there, and the multipliers of a cost.
 *
 * Invariants: slack = right - rows times the point, that of rows in the basis is about 0; y times
 * the basis is the cost.
 */
#ifndef FMB_LP_SIMPLEX_STATE_H
#define FMB_LP_SIMPLEX_STATE_H

#include "lp/simplex/basis_inverse.h"
#include "lp/simplex/columns.h"

/* A pivot that is known with a larger share of error is none. */
#define FMB_SIMPLEX_DOUBTFUL 1e-6

/* What holds for the multiplier of a member, and what does for a row outside of the basis. */
typedef enum fmb_role {
    FMB_ROLE_LESS,  /* >= 0; the row is an inequality */
    FMB_ROLE_EQUAL, /* any sign; an equality */
    FMB_ROLE_FREE   /* zero: a unit vector or a row that is off; a row inside of the basis */
} fmb_role;

typedef struct fmb_simplex_state {
    const fmb_scaled_program *f;
    size_t n, m;
    fmb_basis_inverse basis;
    fmb_columns columns;
    fmb_indexed_vector entry, edge,
        rate;                 /* [n], [n], [m]: a row in the basis, an edge, rows along it */
    double *y, *cost, *given; /* [n]; given: right sides by place */
    double *edge_weight;      /* [n] of Devex, for the primal method */
    uint8_t *member_role;     /* [n] */
    int *falling;             /* [n] scratch of the dual method: places */
    double *right, *slack;    /* [m] right sides as they are now */
    double *row_weight;       /* [m] of Devex, for the dual method */
    uint8_t *row_role;        /* [m] */
    int *violated;            /* [violations] of the dual method: rows that may be */
    bool *is_listed;          /* [m] among them */
    size_t violations;
    size_t right_room, slack_room, row_weight_room, row_role_room, violated_room, listed_room;
    double nudge; /* the least multiplier that a row is given where the dual method stands still */
    size_t steps, most_steps; /* so far; after which the primal method gives up */
    uint64_t random;
    bool placed;
    bool feasible, moved; /* right sides are moved away from those of the scaled program */
} fmb_simplex_state;

/* At the unit vectors, before all rows that the scaled program has; the basis in factors or as
 * seems best. In any case fmb_simplex_state_clear it. Errors: MEMORY, LIMIT. */
fmb_status fmb_simplex_state_init(fmb_simplex_state *o, const fmb_scaled_program *f, bool factors);
void fmb_simplex_state_clear(fmb_simplex_state *o);
/* Take in the rows that the scaled program has by now. Errors: MEMORY, LIMIT. */
fmb_status fmb_simplex_state_grow(fmb_simplex_state *o);

/* Take these members. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_simplex_state_place(fmb_simplex_state *o, const size_t *member);
/* Slacks and multipliers from the basis alone, which is computed afresh where it is stale, or found
 * to be inexact. */
fmb_status fmb_simplex_state_refresh(fmb_simplex_state *o);
/* The same, with the basis computed afresh in any case. */
fmb_status fmb_simplex_state_renew(fmb_simplex_state *o);
/* The point, into `edge`. */
void fmb_simplex_state_find_point(fmb_simplex_state *o);
/* What row i is, inside or outside, on or off, has changed. */
void fmb_simplex_state_note_role(fmb_simplex_state *o, size_t i);

/* Edge r, and the rates of the rows along it. */
void fmb_simplex_state_look_along(fmb_simplex_state *o, size_t r);
/* Row i, written in the basis, takes place r, whose edge was looked along: the point goes there
 * until row i is tight. */
fmb_status fmb_simplex_state_pivot(fmb_simplex_state *o, size_t r, size_t i);
/* A row that is off leaves place r; the point goes to the nearest row that stops it, either way. */
fmb_status fmb_simplex_state_expel(fmb_simplex_state *o, size_t r);

/* The cost grows by this times the member at place r. */
void fmb_simplex_state_add_to_cost(fmb_simplex_state *o, size_t r, double part);

/* Steps of a pivot (fmb_run_count). */
static inline size_t fmb_simplex_state_work(const fmb_simplex_state *o)
{
    return 400 + 8 * (o->n + o->m) + 2 * fmb_indexed_vector_count(&o->rate);
}

/* Slacks that are less, for a right side of about 1, are none. */
static inline double fmb_simplex_state_tolerance(const fmb_simplex_state *o)
{
    return o->f->sharp ? 1e-11 : 1e-9;
}
/* Row i was written, and edge r looked along: is their pivot not the same number both ways? Then
 * rounding errors are as large as it is. */
static inline bool fmb_simplex_state_is_doubtful(const fmb_simplex_state *o, size_t r, size_t i)
{
    double by_row = o->entry.at[r], by_edge = o->rate.at[i];
    return fabs(by_row - by_edge) > FMB_SIMPLEX_DOUBTFUL * fabs(by_edge);
}
/* From 1 to 2. */
static inline double fmb_simplex_state_draw(fmb_simplex_state *o)
{
    o->random = o->random * 6364136223846793005u + 1442695040888963407u;
    return 1 + (double)(o->random >> 12) * 0x1p-52;
}

#endif
