/* combination.h: a row as an exact combination of some other rows.
 *
 * The caller guesses these rows. Their factors are solved for modulo a prime and lifted: at once if
 * Hadamard's bound shows that no numerator or denominator is larger, otherwise digit by digit
 * (Dixon 1982, Exact solution of linear equations using p-adic expansions), until fractions are
 * found that hold in integers.
 */
#ifndef FMB_LP_COMBINATION_H
#define FMB_LP_COMBINATION_H

#include <gmp.h>

#include "lp/linalg/exact/rational.h"
#include "lp/model/row.h"
#include "num/prime.h"
#include "trace/run.h"

typedef struct fmb_combination {
    fmb_mem *mem;
    size_t n;
    const fmb_lp_row *row;
    fmb_prime q;
    /* all (a_i) = sum_k part[k] a_index[k], all > 0; left = all b_i - sum_k part[k] b_index[k]. */
    size_t size, *index; /* [n] */
    mpz_t *part;         /* [n] */
    mpz_t all, left;
    /* Scratch. Equations are columns of the rows, unknowns the factors of the rows. */
    fmb_run *run; /* the query in progress */
    size_t i, equations, unknowns;
    size_t *column;    /* [n] of each equation; first those that determine the unknowns */
    uint64_t *matrix;  /* [n][n + 1] modulo the prime: L and U, and the right side */
    uint64_t *inverse; /* [n] of the diagonal of U */
    uint64_t *digit;   /* [n] the solution modulo the prime; then its next digit */
    uint64_t *sum;     /* [n] */
    mpz_t *rest;       /* [n] residuals after the digits so far, over their power of q */
    mpz_t power, s, t, u, v;
    fmb_rational rational;
} fmb_combination;

/* row must outlive c. Errors: MEMORY, LIMIT; call fmb_combination_clear even then. */
fmb_status fmb_combination_init(fmb_combination *c, fmb_mem *mem, size_t n, const fmb_lp_row *row);
void fmb_combination_clear(fmb_combination *c);

/* Write row i as a combination of the rows support[size], size <= n, without those whose factor is
 * 0. *found false: there is none, or these rows are dependent. Errors: LIMIT. */
fmb_status fmb_combine(fmb_combination *c, fmb_run *run, size_t i, const size_t *support,
                       size_t size, bool *found);
/* Does the combination found prove row i? A strict row needs a smaller right side, or a strict row
 * among the others; only equalities may have negative factors. */
bool fmb_combination_proves(const fmb_combination *c);

#endif
