/* updated_lu.h: the members of a basis as a sparse matrix W, factored in doubles, with exchanges of
 * single members.
 *
 * Row r of W is the member at place r. Members with one column, mostly bounds, are singletons: they
 * are not factored, their places and columns are not in the core, and other members' entries in
 * these columns are kept beside. The core is W = M T_k ... T_1 V. Elimination takes pivots step by
 * step, each with a place and a column: the row of that place, minus what earlier steps subtracted,
 * is a row of V, with a slot; the multiples subtracted from rows of later steps are in M, with ones
 * as pivots. At first there is no T.
 *
 * Theorem 1. Let row a replace the member at place p of the core, with slot s. Let z = M^-1 e_p,
 * and x_p entry p of a written in W. Then W' = M' T T_k ... T_1 V, where T subtracts z_q / z_s
 * times entry s from each other entry q, and M' is M without its row and column s, and with m = a
 * V^-1 T_1^-1 ... T_k^-1 as a last row, with the pivot x_p times the old one of s.
 *
 * Proof. M with row m in place of row s, times T_k ... T_1 V, is W'. In M T^-1 column s is M z /
 * z_s: it vanishes in all rows but s. The other columns are unchanged. The determinants of W' and W
 * have the ratio x_p, and so have the pivots.
 *
 * Theorem 2. Let row a replace a singleton at place p, with column j and coefficient w. Then p gets
 * a slot whose row of V has w alone; column j of V is -w T_1^-1 ... T_k^-1 M^-1 times edge p's
 * right side in the core, -w_rj / w in row r; M gets m as a last row as before, with the pivot x_p.
 *
 * Proof. Before the exchange this is W with row w e_j, and with column j of the others. A row of M
 * with 1 alone then becomes that of a, in a column without other entries.
 *
 * m and z are intermediate results of the last two solutions: a written in W, and edge p. The value
 * at the place of a singleton follows from its column j: y_p w = c_j - sum_r y_r w_rj.
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

/* Most exchanges before the basis is factored afresh. */
#define FMB_MOST_EXCHANGES 101

typedef struct fmb_updated_lu {
    const fmb_scaled_program *f;
    size_t n, core;             /* places; pivots of the elimination */
    size_t *member;             /* [n] the current one at each place */
    int *singleton;             /* [n] by place: the column of a singleton, or -1 */
    int *singleton_of;          /* [n] by column: the place of a singleton, or -1 */
    double *reciprocal;         /* [n] by place: of the coefficient of a singleton */
    fmb_compressed_rows beside; /* by column of a singleton: place in the core, value; initially */
    fmb_triangle lower, upper;  /* M, V: `upper` by slots */
    int *slot_of_place, *slot_of_column, *slot_of_step; /* [n], -1: singleton; [n + exchanges] */
    int *place_of_step, *column, *step;                 /* [n + exchanges]; [n] by slot */
    fmb_compressed_rows turn;                           /* T: slot, multiple */
    int *turned;                                        /* [turns] slot s of each */
    fmb_compressed_rows written, left; /* by slot: m, and z or -V_j/w, of the last solutions */
    size_t turns;
    fmb_arena arena; /* of an elimination */
} fmb_updated_lu;

/* Nothing is factored yet. Errors: MEMORY, LIMIT; call fmb_updated_lu_clear even then. */
fmb_status fmb_updated_lu_init(fmb_updated_lu *u, const fmb_scaled_program *f);
void fmb_updated_lu_clear(fmb_updated_lu *u);

/* Factor these members; those that depend on others are replaced by unit vectors in member[]
 * itself. Errors: MEMORY, LIMIT; then nothing is factored. */
fmb_status fmb_updated_lu_factor(fmb_updated_lu *u, size_t *member);
/* Put this member, which was the last to be written, at a place, whose edge was the last solution;
 * entry: that of the member at the place. Errors: MEMORY, LIMIT. */
fmb_status fmb_updated_lu_pivot(fmb_updated_lu *u, size_t place, size_t member, double entry);
/* Would factoring afresh be cheaper than going on with the updates? */
bool fmb_updated_lu_is_long(const fmb_updated_lu *u);

/* W x = b: b by place, set to zero; x by column. */
void fmb_updated_lu_solve(fmb_updated_lu *u, fmb_indexed_vector *b, fmb_indexed_vector *x);
/* y W = c: c by column, set to zero; y by place, and full if most of it is nonzero. */
void fmb_updated_lu_solve_transposed(fmb_updated_lu *u, fmb_indexed_vector *c,
                                     fmb_indexed_vector *y);

/* ---- for the other files of the factors ------------------------------------------------------ */

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

/* Compute the pivots of the core by slots, their rows as `upper.ahead`, by column, and the
 * multiples as `lower.ahead`, by place. Places whose rows vanish get no slot but -1, and so do
 * columns. Errors: MEMORY, LIMIT. */
fmb_status fmb_updated_lu_eliminate(fmb_updated_lu *u);
/* Give this pivot the next slot, whose lists are complete. */
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
