/* sparse.h: a square sparse matrix of integers, by rows.
 *
 * Entries that do not fit into int64 are GMP numbers borrowed from their owners.
 */
#ifndef FMB_LP_SPARSE_H
#define FMB_LP_SPARSE_H

#include "base/arena.h"
#include "lp/model/program.h"
#include "num/prime.h"

typedef struct fmb_sparse {
    size_t n;
    size_t *start;   /* [n + 1] */
    int *index;      /* [start[n]] columns */
    int64_t *value;  /* [start[n]], |value| < 2^62; 0 where big */
    mpz_srcptr *big; /* [start[n]], NULL where value holds; NULL: there are none */
    uint32_t *bits;  /* [n] the sum of |entries| of the row is < 2^bits */
    uint32_t bits_max;
} fmb_sparse;

/* The rows of a basis; see factor.h. Errors: MEMORY, LIMIT. */
fmb_status fmb_sparse_gather(fmb_sparse *s, fmb_arena *arena, const fmb_program *p,
                             const size_t *basis);
/* to: row k is row row_at[k] of s, and column j of s becomes column column_place[j]. */
fmb_status fmb_sparse_permute(const fmb_sparse *s, fmb_arena *arena, const int *row_at,
                              const int *column_place, fmb_sparse *to);
fmb_status fmb_sparse_transpose(const fmb_sparse *s, fmb_arena *arena, fmb_sparse *to);

/* Entry t modulo p. */
static inline uint64_t fmb_sparse_residue(const fmb_sparse *s, size_t t, const fmb_prime *q)
{
    return s->big && s->big[t] ? fmb_prime_of_integer(q, s->big[t])
                               : fmb_prime_of_signed(q, s->value[t]);
}

/* log2 of a bound on |determinant|: the product of the rows' sums. */
double fmb_sparse_determinant_bits(const fmb_sparse *s);

#endif
