/* dense.h: systems as mutable tables of rationals, for the generators and the shrinker. */
#ifndef FMB_TEST_DENSE_H
#define FMB_TEST_DENSE_H

#include "support.h"

typedef struct dense {
    int dim, rows;
    fmb_rel *rel;
    mpq_t *cell; /* [rows][dim + 1], right side last */
} dense;

/* That many rows of zeros, relation <=. */
dense dense_new(int dim, int rows);
dense dense_of(const fmb_system *s);
void dense_free(dense *d);
/* Row i, or its right side. */
mpq_t *dense_row(const dense *d, int i);
mpq_ptr dense_rhs(const dense *d, int i);
void dense_swap(dense *d, int i, int k);
/* Without row i (-1: none), without column j (-1: none). */
dense dense_without(const dense *d, int i, int j);
fmb_system *dense_system(const dense *d);

#endif
