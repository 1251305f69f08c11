/* system.h: inside of an fmb_system.
 *
 * Invariants: terms of a row are sorted by variable, without zeros; val holds nnz coefficients,
 * then the right side, then the denominator den > 0: the row as written is (val / den), and the
 * integers are what everything downstream works with.
 */
#ifndef FMB_SYSTEM_SYSTEM_H
#define FMB_SYSTEM_SYSTEM_H

#include <fmb/gmp.h>
#include <fmb/system.h>

#include "num/vec.h"
#include "system/names.h"

typedef struct fmb_sysrow {
    int *var;    /* [nnz], increasing */
    fmb_vec val; /* [nnz + 2]: coefficients, right side, denominator; s is owned by the row */
    size_t nnz;
    fmb_rel rel;
    char *label; /* or NULL */
} fmb_sysrow;

struct fmb_system {
    fmb_mem mem;
    fmb_sysrow *row; /* [rows] */
    size_t rows, row_capacity;
    fmb_names names;
    bool *kept; /* [names.size] marks of the projection the source asks for */
    size_t kept_capacity;
    bool asks_projection;
};

static inline const fmb_sysrow *fmb_system_row(const fmb_system *s, size_t i)
{
    return &s->row[i];
}

/* Append sum coef[k]/den x_var[k] REL rhs/den with integers z = coef[0..n), rhs, den (n + 2 of
 * them, den > 0), var strictly increasing, no zero coefficient. Errors: MEMORY. */
fmb_status fmb_system_append(fmb_system *s, size_t n, const int *var, mpz_t *z, fmb_rel rel);

/* Remove row i; the rows behind it move up. */
void fmb_system_remove(fmb_system *s, size_t i);

#endif
