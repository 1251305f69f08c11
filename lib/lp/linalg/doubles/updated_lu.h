/* updated_lu.h: the members of a basis as a sparse matrix W, factored in doubles, and exchanged one
 * by one.
 *
 * Row r of W is the member at place r. Members that name one column alone, bounds as a rule, are
 * not factored: a place and a column leave with each of them, and what other members have in that
 * column is kept beside. Of what is left, the core, elimination takes pivots step by step: step k
 * has a place and a column; the row of that place, less what earlier steps took away, is a row of
 * U; its multiples are subtracted from rows of later steps, which is L. Members that come in
 * afterwards are kept as etas. Where row a takes place p of W, `entry` writes a in W and `edge` is
 * column p of the inverse, W' = (I + e_p (entry - e_p)) W    so    y W' = c follows from y W = c,
 * and W'^-1 = W^-1 - edge (a W^-1 - e_p) / entry_p    so    W' x = b follows from W x = b, both
 * without looking at what is zero. Steps where something is not zero are marked in a bit set.
 *
 * A singleton rests until it is exchanged. The number y_p at its place p follows from its column j
 * once others are known, y_p w_pj = c_j - sum_r y_r w_rj: at the end, or just before the place is
 * exchanged, from the members as they are then. So what exchanges change at places that rest is not
 * kept, and all that is kept is of the core.
 *
 * Source: Markowitz 1957, The elimination form of the inverse and its application to linear
 * programming; Dantzig and Orchard-Hays 1954, The product form for the inverse in the simplex
 * method; Huangfu and Hall 2015, Novel update techniques for the revised simplex method.
 */
#ifndef FMB_LP_UPDATED_LU_H
#define FMB_LP_UPDATED_LU_H

#include "base/arena.h"
#include "base/mem.h"
#include "lp/linalg/doubles/indexed_vector.h"
#include "lp/model/scaled_program.h"

/* Lists of numbered values, one after another: list k is start[k] .. start[k + 1]. */
typedef struct fmb_compressed_rows {
    size_t *start; /* [n + 1] */
    int *index;
    double *value;
    size_t size, index_room, value_room, start_room;
} fmb_compressed_rows;

/* Room for the starts of so many lists. Errors: MEMORY, LIMIT. */
fmb_status fmb_compressed_rows_reserve_starts(fmb_compressed_rows *l, fmb_mem *mem, size_t lists);
void fmb_compressed_rows_free(fmb_compressed_rows *l, fmb_mem *mem);

/* Room for so many values more. Errors: MEMORY, LIMIT. */
fmb_status fmb_compressed_rows_reserve(fmb_compressed_rows *l, fmb_mem *mem, size_t more);
static inline void fmb_compressed_rows_push(fmb_compressed_rows *l, size_t index, double value)
{
    l->index[l->size] = (int)index;
    l->value[l->size++] = value;
}

/* An exchange: member i takes this place; right is scratch. */
typedef struct fmb_eta {
    size_t place, member;
    double pivot, right;
} fmb_eta;

typedef struct fmb_updated_lu {
    const fmb_scaled_program *f;
    size_t n, steps;
    size_t *member;                      /* [n] at each place as it is now */
    int *singleton;                      /* [n] by place: its column, -1: the core */
    int *singleton_of;                   /* [n] by column: its place, -1: the core */
    double *reciprocal;                  /* [n] by place: of the coefficient of a singleton */
    bool *rests;                         /* [n] by place: a singleton, not exchanged yet */
    int *resting;                        /* [n] by column: its place if that rests, -1 */
    int *latest;                         /* [n] by place: its last exchange, -1: none */
    fmb_compressed_rows beside;          /* by column of a singleton: place in the core, value */
    int *place, *column;                 /* [steps] of each step */
    int *step_of_place, *step_of_column; /* [n] -1: a singleton's */
    double *pivot;                       /* [steps] of each step */
    fmb_compressed_rows lower, lower_by_target; /* by step: place, factor; by step of the place:
                                         place of the pivot, factor */
    fmb_compressed_rows upper,
        upper_by_column;             /* by step: column, value; by step of the column: place */
    fmb_compressed_rows entry, edge; /* by exchange: place, entry, without the pivot and places at
                              rest; column, edge */
    fmb_compressed_rows activated; /* by exchange of a place at rest: place, value of its column */
    fmb_eta *eta;                  /* [etas] */
    size_t eta_room, etas;
    uint64_t *marks; /* [n / 64 + 1], all zero between calls */
    fmb_arena arena; /* of an elimination */
} fmb_updated_lu;

/* Nothing factored yet. In any case fmb_updated_lu_clear it. Errors: MEMORY, LIMIT. */
fmb_status fmb_updated_lu_init(fmb_updated_lu *u, const fmb_scaled_program *f);
void fmb_updated_lu_clear(fmb_updated_lu *u);

/* Factor these members; one that depends on others becomes a unit vector, in member itself. Errors:
 * MEMORY, LIMIT; then nothing is factored. */
fmb_status fmb_updated_lu_factor(fmb_updated_lu *u, size_t *member);
/* This member takes the place, of which these are the writing and the edge. Errors: MEMORY, LIMIT.
 */
fmb_status fmb_updated_lu_pivot(fmb_updated_lu *u, size_t place, size_t member,
                                const fmb_indexed_vector *entry, const fmb_indexed_vector *edge);
/* Would factoring afresh pay? */
bool fmb_updated_lu_is_long(const fmb_updated_lu *u);

/* W x = b: b by place becomes zero, x is by column. */
void fmb_updated_lu_solve(fmb_updated_lu *u, fmb_indexed_vector *b, fmb_indexed_vector *x);
/* y W = c: c by column becomes zero, y is by place. */
void fmb_updated_lu_solve_transposed(fmb_updated_lu *u, fmb_indexed_vector *c,
                                     fmb_indexed_vector *y);

/* ---- between the files of the factors -------------------------------------------------------- */

/* The terms of a member; *one is scratch. */
typedef struct fmb_terms {
    const int *column;
    const double *value;
    size_t size;
} fmb_terms;
static inline fmb_terms fmb_member_terms(const fmb_scaled_program *f, size_t i, int *one)
{
    static const double one_itself = 1;
    if (i < FMB_UNIT)
        return (fmb_terms){fmb_scaled_program_columns(f, i), &f->value[f->start[i]],
                           f->start[i + 1] - f->start[i]};
    *one = (int)(i - FMB_UNIT);
    return (fmb_terms){one, &one_itself, 1};
}

/* Pivots, lower and upper by steps, of the core; places whose rows vanish get no step. Columns and
 * places without one have step -1; steps is the number of pivots. Errors: MEMORY, LIMIT. */
fmb_status fmb_updated_lu_eliminate(fmb_updated_lu *u);

#endif
