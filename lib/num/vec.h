/* vec.h: vectors of integers that start as int64 and widen, each by itself, to GMP.
 *
 * A vec of n entries is *small* (z == NULL; entries in s, every |entry| < 2^bits, bits <= 62) or
 * *wide* (entries in z). The owner provides the n words at s in either case, so that a wide vec can
 * become small again; z belongs to the vec. `bits` shows before a multiplication whether int64 or
 * 128 bits suffice, so nothing ever overflows.
 */
#ifndef FMB_NUM_VEC_H
#define FMB_NUM_VEC_H

#include <gmp.h>

#include "base/mem.h"
#include "base/poll.h"
#include "num/kernels/kernels.h"
#include "num/word.h"
#include "num/work.h"

#define FMB_SMALL_BITS 62
/* Combinations of at most this many bits are not reduced: combining two of them fits int64.
 */
#define FMB_LAZY_BITS 30

typedef struct fmb_vec {
    int64_t *s;
    mpz_t *z;
    int bits;
    uint32_t limbs; /* wide: charged to the allocator */
} fmb_vec;

/* Context of the operations: the memory for wide entries, kernels, counters and scratch. */
typedef struct fmb_num {
    fmb_mem *mem;
    bool wide_only;             /* keep every vec wide (options.arith = gmp) */
    const fmb_kernels *kernels; /* initially the best of this processor */
    uint64_t promotions;        /* small vecs that became wide */
    fmb_poll poll;              /* asked within operations on long numbers; initially none */
    mpz_t p, q, t;              /* scratch */
    fmb_i128 *scratch;          /* [scratch_size] */
    size_t scratch_size;
} fmb_num;

/* Scratch for vecs of at most n entries. Errors: MEMORY, LIMIT. */
fmb_status fmb_num_init(fmb_num *k, fmb_mem *mem, size_t n, bool wide_only);
void fmb_num_clear(fmb_num *k);

/* Release z (not s), of a wide vec or of any; the vec is then small and undefined. */
void fmb_vec_release(fmb_vec *v, size_t n, fmb_mem *mem);
static inline void fmb_vec_clear(fmb_vec *v, size_t n, fmb_mem *mem)
{
    if (v->z)
        fmb_vec_release(v, n, mem);
}

static inline bool fmb_vec_is_wide(const fmb_vec *v)
{
    return v->z != NULL;
}
/* Work (steps of trace/run.h) of the combination of n entries whose result is v. Small: products of
 * half-words fit a word. Wide: the operands are half as long as the result, and mostly two gcds
 * find the common divisor of all entries. */
static inline uint64_t fmb_vec_work(const fmb_vec *v, size_t n)
{
    if (!v->z)
        return n * (v->bits > 31 ? 45 : 4);
    size_t limbs = v->limbs / n > 2 ? v->limbs / n - 2 : 1; /* as fmb_vec_settle counts them */
    return n * (fmb_limbs_work(limbs / 2) + fmb_limbs_work(limbs)) + 2 * fmb_gcd_work(limbs);
}
static inline int fmb_vec_sgn(const fmb_vec *v, size_t i)
{
    return v->z ? mpz_sgn(v->z[i]) : (v->s[i] > 0) - (v->s[i] < 0);
}
/* The least b with |entry i| < 2^b; 0 for entry 0. */
size_t fmb_vec_entry_bits(const fmb_vec *v, size_t i);
/* The same of the longest of n entries. */
size_t fmb_vec_most_bits(const fmb_vec *v, size_t n);
/* Entry i times 2^-exponent, rounded; 0 below 2^-1000. */
double fmb_vec_entry_double(const fmb_vec *v, size_t i, int exponent);
/* Bound on the bits of the d x d minors of the matrix of rows v[size], by Hadamard's inequality. */
size_t fmb_vec_minor_bits(const fmb_vec *v, size_t size, size_t d);
void fmb_vec_get(const fmb_vec *v, size_t i, mpz_t out);
static inline void fmb_vec_get_q(const fmb_vec *v, size_t i, mpq_t out)
{
    fmb_vec_get(v, i, mpq_numref(out));
    mpz_set_ui(mpq_denref(out), 1);
}

/* Recompute `bits` of a small vec after s was filled in. The caller guarantees |s[i]| < 2^62. */
void fmb_vec_measure(fmb_vec *v, size_t n);

/* Set from n integers: small if they fit, otherwise wide. */
fmb_status fmb_vec_set_z(fmb_vec *v, size_t n, mpz_t *from, fmb_mem *mem);
/* *to = *from; to->s must have room. */
fmb_status fmb_vec_copy(fmb_vec *to, const fmb_vec *from, size_t n, fmb_mem *mem);
/* Make a small vec wide. */
fmb_status fmb_vec_widen(fmb_vec *v, size_t n, fmb_mem *mem);

/* Remove entry c; the last of the n entries takes its place. After an error the vec is zero, but
 * valid. Errors: MEMORY, LIMIT. */
fmb_status fmb_vec_drop_entry(fmb_vec *v, size_t n, size_t c, fmb_mem *mem);

/* Divide by the greatest common divisor of the entries; a zero vec is unchanged. Wide vecs that fit
 * become small again unless k->wide_only. Errors: MEMORY, LIMIT, the status of k->poll; the vec is
 * valid even after an error. */
fmb_status fmb_vec_reduce(fmb_vec *v, size_t n, fmb_num *k);

/* dst = (|b_c|/g) a - sgn(a_c b_c) (|a_c|/g) b with g = gcd(a_c, b_c), which makes entry c zero,
 * then reduced. a_c and b_c must not be 0. a is always scaled by a positive number; b too when a_c
 * and b_c have opposite signs. dst may be a. */
fmb_status fmb_vec_cancel(fmb_vec *dst, const fmb_vec *a, const fmb_vec *b, size_t n, size_t c,
                          fmb_num *k);

/* Sign of x_i |y_j| - z_k |w_l|. */
int fmb_vec_compare_products(const fmb_vec *x, size_t i, const fmb_vec *y, size_t j,
                             const fmb_vec *z, size_t k, const fmb_vec *w, size_t l);

/* Sign of a.b over the first n entries. */
int fmb_vec_product_sign(const fmb_vec *a, const fmb_vec *b, size_t n, fmb_num *k);
/* Entry n of v, a vec of `width` entries, becomes row.v over the first n. Errors: MEMORY, LIMIT.
 */
fmb_status fmb_vec_set_product(fmb_vec *v, size_t n, size_t width, const fmb_vec *row, fmb_num *k);
/* Change the signs of the first n entries. */
void fmb_vec_negate(fmb_vec *v, size_t n);

/* Equal in the first n entries. */
bool fmb_vec_equal(const fmb_vec *a, const fmb_vec *b, size_t n);
/* Lexicographic order of the first n entries: -1, 0 or 1. */
int fmb_vec_compare(const fmb_vec *a, const fmb_vec *b, size_t n);
/* Equal vecs have equal hashes, whether small or wide. */
uint64_t fmb_vec_hash(const fmb_vec *v, size_t n);

/* A block of n GMP zeros, or NULL; z may be NULL. */
mpz_t *fmb_vec_block(size_t n, fmb_mem *mem);
void fmb_vec_block_free(mpz_t *z, size_t n, fmb_mem *mem);

/* ---- for the other files of this room -------------------------------------------------------- */

/* Charge the limbs of a wide vec that has changed. Errors: LIMIT, MEMORY; the vec is valid even
 * then. */
fmb_status fmb_vec_settle(fmb_vec *v, size_t n, fmb_mem *mem);
/* Divide a small vec by its content and recompute `bits`. */
void fmb_vec_reduce_small(fmb_vec *v, size_t n);
/* The greatest common divisor of n integers, each below 2^62, 0 if all are 0; *bits as of a vec. */
uint64_t fmb_content_small(const int64_t *s, size_t n, int *bits);

#endif
