/* updated_lu.h: the members of a basis as a sparse matrix W, factored in doubles, and exchanged one
 * by one.
 *
 * Row r of W is the member at place r. Members that name one column alone, bounds as a rule, rest:
 * they are not factored, a place and a column leave with each of them, and what other members have
 * in that column is kept beside. What is left, the core, is W = M T_k ... T_1 V. Elimination takes
 * pivots step by step, each with a place and a column: the row of that place, less what earlier
 * steps took away, is a row of V, and has a slot; its multiples that were subtracted from rows of
 * later steps are in M, with ones as pivots. There is no T at first.
 *
 * Theorem 1. Row a takes place p of the core, with slot s. Let z = M^-1 e_p, and x_p the number at
 * place p of a written in W. Then W' = M' T T_k ... T_1 V, where T subtracts z_q / z_s times number
 * s from each other number q, and M' is M without its row and column s, and with m = a V^-1 T_1^-1
 * ... T_k^-1 as a last row, with the pivot x_p times the old one of s.
 *
 * Proof. M with row m in place of row s, times T_k ... T_1 V, is W'. In M T^-1 column s is M z /
 * z_s by what is in it: it vanishes in all rows but s. Other columns are as they were. The
 * determinants of W' and W have the ratio x_p, and so have the pivots.
 *
 * Theorem 2. Place p rests, with column j and coefficient w, and row a takes it. Then p gets a slot
 * with a row of V of w alone; column j of V is -w T_1^-1 ... T_k^-1 M^-1 times what edge p
 * subtracts from the core, and M gets m as a last row as before, with the pivot x_p.
 *
 * Proof. Before a comes in, that is W with row w e_j, and with column j of the others. A row of M
 * of 1 alone then becomes that of a, in a column where no other row has a number.
 *
 * Both m and z are halves of what was solved last: a written in W, and edge p. What is at a place
 * that rests follows from its column j once others are known, y_p w = c_j - sum_r y_r w_rj.
 *
 * Source: Markowitz 1957, The elimination form of the inverse and its application to linear
 * programming; Forrest and Tomlin 1972, Updated triangular factors of the basis to maintain
 * sparsity in the product form simplex method.
 */
#ifndef FMB_LP_UPDATED_LU_H
#define FMB_LP_UPDATED_LU_H

#include "base/arena.h"
#include "base/mem.h"
#include "lp/linalg/doubles/indexed_vector.h"
#include "lp/linalg/doubles/triangle.h"
#include "lp/model/scaled_program.h"

/* Exchanges that are kept. */
#define FMB_MOST_EXCHANGES 101

typedef struct fmb_updated_lu {
    const fmb_scaled_program *f;
    size_t n, core;             /* places; that the elimination found pivots for */
    size_t *member;             /* [n] at each place as it is now */
    int *singleton;             /* [n] by place: its column while it rests, -1 */
    int *singleton_of;          /* [n] by column: its place while that rests, -1 */
    double *reciprocal;         /* [n] by place: of the coefficient of a singleton */
    fmb_compressed_rows beside; /* by column of a singleton: place in the core, value, at first */
    fmb_triangle lower, upper;  /* M, V: `upper` by slots */
    int *slot_of_place, *slot_of_column, *slot_of_step; /* [n], -1: it rests; [n + exchanges] */
    int *place_of_step, *column, *step;                 /* [n + exchanges]; [n] by slot */
    fmb_compressed_rows turn;                           /* T: slot, multiple */
    int *turned;                                        /* [turns] number s of each */
    fmb_compressed_rows written, left; /* by slot: m of the last solution, z or -V_j/w of it */
    size_t turns;
    fmb_arena arena; /* of an elimination */
} fmb_updated_lu;

/* Nothing factored yet. In any case fmb_updated_lu_clear it. Errors: MEMORY, LIMIT. */
fmb_status fmb_updated_lu_init(fmb_updated_lu *u, const fmb_scaled_program *f);
void fmb_updated_lu_clear(fmb_updated_lu *u);

/* Factor these members; one that depends on others becomes a unit vector, in member itself. Errors:
 * MEMORY, LIMIT; then nothing is factored. */
fmb_status fmb_updated_lu_factor(fmb_updated_lu *u, size_t *member);
/* This member, which was the last to be written, takes the place, whose edge was the last solution:
 * with this entry there. Errors: MEMORY, LIMIT. */
fmb_status fmb_updated_lu_pivot(fmb_updated_lu *u, size_t place, size_t member, double entry);
/* Would factoring afresh pay? */
bool fmb_updated_lu_is_long(const fmb_updated_lu *u);

/* W x = b: b by place becomes zero, x is by column. */
void fmb_updated_lu_solve(fmb_updated_lu *u, fmb_indexed_vector *b, fmb_indexed_vector *x);
/* y W = c: c by column becomes zero, y is by place; full where most is not zero. */
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

/* Pivots of the core by slots, with their rows as `upper.ahead`, by column, and multiples as
 * `lower.ahead`, by place; places whose rows vanish get no slot, and have -1, as have columns.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_updated_lu_eliminate(fmb_updated_lu *u);
/* This pivot has the next slot, whose lists are complete. */
static inline void fmb_updated_lu_take_slot(fmb_updated_lu *u, int place, int column, double pivot)
{
    size_t k = u->core++;
    u->place_of_step[k] = place;
    u->column[k] = column;
    u->slot_of_place[place] = u->slot_of_column[column] = u->slot_of_step[k] = u->step[k] = (int)k;
    u->upper.pivot[k] = pivot;
    u->lower.pivot[k] = 1;
    u->upper.ahead.start[k + 1] = u->upper.ahead.size;
    u->lower.ahead.start[k + 1] = u->lower.ahead.size;
}

#endif
