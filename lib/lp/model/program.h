/* program.h: the rows of a linear program, sparse and in integers: a_i.x REL b_i, x free.
 *
 * Invariants: terms of a row are sorted by column, without zeros, and value holds `size`
 * coefficients, then the right side. Values are borrowed from the owner of the rows, unless the
 * program made them itself.
 */
#ifndef FMB_LP_PROGRAM_H
#define FMB_LP_PROGRAM_H

#include "lp/model/row.h"

typedef struct fmb_program_row {
    size_t size;
    int *column;          /* [size], increasing */
    const fmb_vec *value; /* [size + 1] */
    fmb_rel rel;
    bool off;  /* switched off for now */
    int shift; /* in doubles the row is divided by 2^shift, the length of long numbers [bits] */
} fmb_program_row;

typedef struct fmb_program {
    fmb_mem *mem;
    int n; /* columns */
    size_t m, capacity;
    fmb_program_row *row; /* [capacity] */
    size_t terms;         /* of all rows */
    bool any_strict;
    fmb_vec **own; /* [own_capacity] values that the program made, or NULL; NULL: none */
    size_t own_capacity;
} fmb_program;

/* No rows yet. */
void fmb_program_init(fmb_program *p, fmb_mem *mem, int n);
void fmb_program_clear(fmb_program *p);

/* Append a row of `size` terms, where variable var[k] is column place[var[k]] (NULL: column
 * var[k]); value[size + 1] is borrowed (NULL: none), var and place are not. Columns must increase.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_program_add(fmb_program *p, size_t size, const int *var, const int *place,
                           const fmb_vec *value, fmb_rel rel);
/* The same with value copied, where variables are columns. Errors: MEMORY, LIMIT. */
fmb_status fmb_program_add_copy(fmb_program *p, size_t size, const int *column,
                                const fmb_vec *value, fmb_rel rel);
/* Remove the rows from number m on. */
void fmb_program_shorten(fmb_program *p, size_t m);
/* Give row i, whose value the program made, another right side. Errors: MEMORY, LIMIT. */
fmb_status fmb_program_set_right(fmb_program *p, size_t i, const mpz_t b);
/* Append a dense row v[n + 1]: copied without its zeros. Errors: MEMORY, LIMIT. */
fmb_status fmb_program_add_dense(fmb_program *p, const fmb_vec *v, fmb_rel rel);

/* Append row i of the program `from`, which has fewer columns; a strict row gets the coefficient
 * 2^lift in the last column: a.x + 2^lift t <= b. All relations become those of the closure.
 */
fmb_status fmb_program_add_interior_row(fmb_program *p, const fmb_program *from, size_t i,
                                        int lift);
/* Append z[0..n).x REL z[n], copied. Errors: MEMORY, LIMIT. */
fmb_status fmb_program_add_integers(fmb_program *p, mpz_t *z, fmb_rel rel);

/* to += a_i.x, x[n]. */
void fmb_program_add_product(const fmb_program *p, size_t i, mpz_t *x, mpz_t to);
/* Coefficient k of row i, k == size: its right side. */
static inline void fmb_program_get(const fmb_program *p, size_t i, size_t k, mpz_t out)
{
    fmb_vec_get(p->row[i].value, k, out);
}

/* Term k of row i / 2^shift as a double, k == size: its right side. 0 below 2^-1000. */
double fmb_program_double(const fmb_program *p, size_t i, size_t k);

#endif
