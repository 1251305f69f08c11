/* normal.c: see normal.h. Words are in two's complement, the lowest first. */
#include "pair/kernels/normal.h"

#include <string.h>

#include "num/int128.h"

#define NORMAL_INLINE static inline __attribute__((always_inline))

void fmb_normal_begin(int words, int dim, double error, normal *n)
{
    n->words = words;
    n->dim = dim;
    n->known = 0;
    n->error = error;
    n->near[0] = 1;
    memset(n->low[0], 0, sizeof n->low[0]);
    n->low[0][0] = 1;
}

/* sum += x a: as if x were not negative, and less 2^64 a if it is. */
NORMAL_INLINE void add_product(int words, int64_t x, const uint64_t *a, uint64_t *sum)
{
    const uint64_t minus = x < 0 ? UINT64_MAX : 0;
    uint64_t carry = 0, borrow = 0;
    if (words == 1) {
        sum[0] += (uint64_t)x * a[0];
        return;
    }
#pragma GCC unroll 3
    for (int i = 0; i < words; i++) {
        fmb_u128 t = fmb_u128_plus_product(fmb_u128_of(carry), (uint64_t)x, a[i]);
        t = fmb_u128_plus(t, fmb_u128_of(sum[i]));
        carry = fmb_u128_high(t);
        sum[i] = fmb_u128_low(t);
        if (i > 0) {
            const fmb_u128 less =
                fmb_u128_minus(fmb_u128_minus(fmb_u128_of(sum[i]), fmb_u128_of(a[i - 1] & minus)),
                               fmb_u128_of(borrow));
            borrow = fmb_u128_high(less) & 1;
            sum[i] = fmb_u128_low(less);
        }
    }
}

NORMAL_INLINE bool are_zero(int words, const uint64_t *a)
{
    return !(a[0] | (words > 1 ? a[1] : 0) | (words > 2 ? a[2] : 0));
}

/* By Laplace, with the numbers of v in the last row; `at` is constant where that is worth it. */
NORMAL_INLINE bool take_vector(int words, int at, const normal_vector *v, normal *n)
{
    bool any = false;
    double most = 0;
    for (unsigned set = (2U << at) - 1; set < 1U << n->dim;) {
        double near[2] = {0, 0};
        uint64_t low[NORMAL_WORDS] = {0};
        unsigned left = set;
#pragma GCC unroll 4
        for (int i = at; i >= 0; i--, left &= left - 1) {
            const int j = __builtin_ctz(left);
            const unsigned less = set & ~(1U << j);
            near[i % 2] += v->near[j] * n->near[less];
            add_product(words, i % 2 ? -v->whole[j] : v->whole[j], n->low[less], low);
        }
        n->near[set] = near[0] - near[1];
        memcpy(n->low[set], low, (size_t)words * sizeof *low);
        any |= !are_zero(words, low);
        most = fabs(n->near[set]) > most ? fabs(n->near[set]) : most;
        const unsigned bit = set & -set, carry = set + bit;
        set = carry | (set ^ carry) >> (2 + __builtin_ctz(bit));
    }
    return !any && most <= n->error;
}

NORMAL_INLINE bool take(int words, int at, const normal_vector *v, normal *n)
{
    return at == 1   ? take_vector(words, 1, v, n)
           : at == 2 ? take_vector(words, 2, v, n)
           : at == 3 ? take_vector(words, 3, v, n)
                     : take_vector(words, at, v, n);
}

bool fmb_normal_put(int at, int number, const normal_vector *v, normal *n)
{
    if (at < n->known && n->taken[at] == number)
        return false;
    n->taken[at] = number;
    n->known = at + 1;
    return n->words == 1   ? take(1, at, v, n)
           : n->words == 2 ? take(2, at, v, n)
                           : take_vector(3, at, v, n);
}

int fmb_normal_sign(const normal *n, double near, double error, const int64_t *v)
{
    const unsigned all = (1U << n->dim) - 1;
    uint64_t low[NORMAL_WORDS] = {0};
    if (near > error || near < -error)
        return near > 0 ? 1 : -1;
    for (int r = 0; r < n->dim; r++)
        add_product(n->words, r % 2 ? -v[r] : v[r], n->low[all & ~(1U << r)], low);
    return are_zero(n->words, low) ? 0 : low[n->words - 1] >> 63 ? -1 : 1;
}
