/* dixon.h: the solution of B x = right modulo powers of p, digit by digit (Dixon 1982).
 *
 * After k digits, right - B (digit 0 + digit 1 p + ... ) = p^k (residual + the rest of right) holds
 * in integers. A residual is less than about the sum of a row's |entries|, whatever the numbers of
 * the solution: so its lowest words determine it, division by p is a product with 1/p modulo 2^64,
 * and if the rows are short nothing has more than 64 bits. Longer right sides are added digit by
 * digit in base p.
 */
#ifndef FMB_LP_DIXON_H
#define FMB_LP_DIXON_H

#include "lp/linalg/modular/sparse.h"
#include "lp/linalg/modular/sweep.h"
#include "trace/run.h"

typedef struct fmb_dixon_rest {
    int place;
    mpz_t rest; /* the rest of the right side there */
} fmb_dixon_rest;

typedef struct fmb_dixon {
    fmb_mem *mem;
    const fmb_prime *q;
    const fmb_sparse *b; /* in the order of the pivots */
    const fmb_sweep *first, *second;
    size_t n;
    int *first_step, *second_step; /* [n] rows of the factors that are not skipped */
    size_t first_steps, second_steps;
    uint64_t *v;        /* [n] */
    bool wide;          /* some residual is longer than a word */
    size_t *word_start; /* [n + 1] */
    fmb_word *word;     /* residuals, in two's complement */
    uint64_t *digit;    /* [digits][n] */
    size_t digits, digit_room;
    fmb_dixon_rest *rest; /* [rests] right sides longer than a word */
    size_t rests, rest_room;
} fmb_dixon;

/* B and its factors, in the order of their sweeps, must outlive l. Errors: MEMORY, LIMIT. */
fmb_status fmb_dixon_init(fmb_dixon *l, fmb_arena *arena, const fmb_prime *q, const fmb_sparse *b,
                          const fmb_sweep *first, const fmb_sweep *second);
void fmb_dixon_clear(fmb_dixon *l);
/* Begin with right[at[k]] as the right side of row k. Errors: MEMORY, LIMIT. */
fmb_status fmb_dixon_begin(fmb_dixon *l, mpz_t *right, const int *at);
/* Compute one more digit. Errors: MEMORY, LIMIT. */
fmb_status fmb_dixon_step(fmb_dixon *l);
/* Unknown k modulo p^digits, not negative, from so many digits. Errors: the status of poll. */
fmb_status fmb_dixon_value(fmb_dixon *l, size_t k, size_t digits, mpz_t out, const fmb_poll *poll);

#endif
