/* system_private.h: inside of an fmb_system.
 *
 * Invariants: terms of a row are sorted by variable, without zeros; val holds nnz coefficients,
 * then the right side, then the denominator den > 0. The row as written is (val / den); all other
 * rooms work with the integers.
 */
#ifndef FMB_SYSTEM_SYSTEM_PRIVATE_H
#define FMB_SYSTEM_SYSTEM_PRIVATE_H

#include <fmb/gmp.h>
#include <fmb/system.h>

#include "num/vec.h"
#include "system/names.h"

typedef struct fmb_sysrow {
    int *var;    /* [nnz], increasing */
    fmb_vec val; /* [nnz + 2]: coefficients, right side, denominator; s is owned by the row */
    size_t nnz;
    fmb_rel rel;
    bool turned; /* it was given as >= or >, and is stored negated */
    char *label; /* or NULL */
} fmb_sysrow;

/* Marks that the source sets on a variable. */
typedef struct fmb_variable_mark {
    bool kept; /* by the projection that the source asks for */
    bool integer;
} fmb_variable_mark;

struct fmb_system {
    fmb_mem mem;
    fmb_sysrow *row; /* [rows] */
    size_t rows, row_capacity;
    fmb_names names;
    fmb_variable_mark *mark; /* [names.size] */
    size_t mark_capacity;
    bool asks_projection;
    fmb_sense sense;
    fmb_sysrow objective; /* unless sense is NONE: the right side is the constant */
    char error[160];      /* the last message of fmb_system_refuse */
};

static inline const fmb_sysrow *fmb_system_row(const fmb_system *s, size_t i)
{
    return &s->row[i];
}

/* Is variable j one of the polyhedron that s stands for when used in lifts (fmb/lift.h)? */
static inline bool fmb_system_keeps(const fmb_system *s, int j)
{
    return !s->asks_projection || s->mark[j].kept;
}

/* The first integer variable, or -1. */
int fmb_system_first_integer(const fmb_system *s);

/* Note which argument was wrong, for fmb_system_trouble; always FMB_ERR_ARG. s may be NULL. */
__attribute__((format(printf, 2, 3))) fmb_status fmb_system_refuse(fmb_system *s,
                                                                   const char *format, ...);

/* Append sum coef[k]/den x_var[k] REL rhs/den with integers z = coef[0..n), rhs, den (n + 2 of
 * them, den > 0), var strictly increasing, no zero coefficient. Errors: MEMORY. */
fmb_status fmb_system_append(fmb_system *s, size_t n, const int *var, mpz_t *z, fmb_rel rel);

/* The same for row[n + 1], zeros included: entry j is the coefficient of variable place[var[j]], or
 * of j if var is NULL. Errors: MEMORY, LIMIT. */
fmb_status fmb_system_append_dense(fmb_system *s, size_t n, const int *var, const int *place,
                                   const fmb_vec *row, fmb_rel rel);

/* The same for small integers (num/vec.h). */
fmb_status fmb_system_append_small(fmb_system *s, size_t n, const int *var, const int64_t *z,
                                   fmb_rel rel);

/* Append a copy of a row, with its label. Errors: MEMORY. */
fmb_status fmb_system_copy_row(fmb_system *to, const fmb_sysrow *from);
/* Take row i out of a system, or put it back into one that still has the memory from before. Rows
 * are neither freed nor copied. */
void fmb_system_take_row(fmb_system *s, size_t i, fmb_sysrow *out);
void fmb_system_put_row(fmb_system *s, size_t i, const fmb_sysrow *r);
void fmb_system_free_row(fmb_system *s, fmb_sysrow *r);
/* Give row i another right side, in the direction as given, >= or <=: *old is the old row without
 * its label, which stays. Errors: ARG (denominator 0), MEMORY. */
fmb_status fmb_system_change_right(fmb_system *s, size_t i, const mpq_t b, fmb_sysrow *old);
/* [give] fmb_system_copy with that allocator. */
fmb_status fmb_system_copy_to(const fmb_system *s, const fmb_alloc *hook, fmb_system **out);

/* Remove the last variable, which is in no row and not in the objective. */
void fmb_system_drop_last_variable(fmb_system *s);
/* Remove row i; the rows behind it move up. */
void fmb_system_remove(fmb_system *s, size_t i);
/* Give t the objective of s, where variable j of s is place[j] of t; no objective if one of its
 * variables has no place (-1). Errors: MEMORY. */
fmb_status fmb_system_carry_objective(fmb_system *t, const fmb_system *s, const int *place);
/* Remove the objective. */
void fmb_system_drop_objective(fmb_system *s);

/* An order of rows of integers: equations before inequalities, then by the first variable in which
 * they differ; inequalities with fewer variables first, then by these, then larger coefficients
 * first, then larger right sides. -1, 0 or 1. */
int fmb_sysrow_compare(const fmb_sysrow *a, const fmb_sysrow *b);

/* z[n + 1] = the coefficients in n columns, then the right side: as written, times the denominator.
 */
void fmb_sysrow_expand(const fmb_sysrow *r, size_t n, mpz_t *z);
/* Entry k of a row as written, k = nnz: the right side; 0 if r is NULL or has no entry k. */
void fmb_sysrow_get_q(const fmb_sysrow *r, size_t k, mpq_t out);

#endif
