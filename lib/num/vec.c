/* vec.c: vectors of integers that widen; see vec.h. */
#include "num/vec.h"

#include <math.h>
#include <string.h>

#include "num/gcd.h"

fmb_status fmb_num_init(fmb_num *k, fmb_mem *mem, size_t n, bool wide_only)
{
    *k =
        (fmb_num){.mem = mem, .wide_only = wide_only, .kernels = fmb_kernels_choose(FMB_SIMD_AUTO)};
    FMB_TRY(FMB_GET(mem, k->scratch, n));
    k->scratch_size = n;
    mpz_inits(k->p, k->q, k->t, NULL);
    return FMB_OK;
}

void fmb_num_clear(fmb_num *k)
{
    if (!k->scratch)
        return;
    fmb_mem_put(k->mem, k->scratch, k->scratch_size, sizeof *k->scratch);
    mpz_clears(k->p, k->q, k->t, NULL);
    k->scratch = NULL;
}

void fmb_vec_release(fmb_vec *v, size_t n, fmb_mem *mem)
{
    fmb_vec_block_free(v->z, n, mem);
    fmb_mem_refund(mem, v->limbs * sizeof(mp_limb_t));
    v->z = NULL;
    v->limbs = 0;
}

/* Charges the memory of the entries, which may exceed their numbers' need. malloc rounds an
 * allocation up to about 16 bytes; two more limbs an entry approximate that. */
fmb_status fmb_vec_settle(fmb_vec *v, size_t n, fmb_mem *mem)
{
    size_t limbs = 2 * n;
    for (size_t i = 0; i < n; i++)
        limbs += (size_t)v->z[i]->_mp_alloc;
    fmb_mem_refund(mem, v->limbs * sizeof(mp_limb_t));
    v->limbs = 0;
    if (limbs > UINT32_MAX)
        return FMB_ERR_MEMORY;
    if (!fmb_mem_charge(mem, limbs * sizeof(mp_limb_t)))
        return FMB_LIMIT;
    v->limbs = (uint32_t)limbs;
    return FMB_OK;
}

void fmb_vec_get(const fmb_vec *v, size_t i, mpz_t out)
{
    if (v->z)
        mpz_set(out, v->z[i]);
    else
        fmb_integer_set_i64(out, v->s[i]);
}

void fmb_vec_measure(fmb_vec *v, size_t n)
{
    uint64_t all = 0;
    for (size_t i = 0; i < n; i++)
        all |= fmb_abs64(v->s[i]);
    v->bits = fmb_bits64(all);
}

size_t fmb_vec_entry_bits(const fmb_vec *v, size_t i)
{
    if (!v->z)
        return (size_t)fmb_bits64(fmb_abs64(v->s[i]));
    return mpz_sgn(v->z[i]) == 0 ? 0 : mpz_sizeinbase(v->z[i], 2);
}

size_t fmb_vec_most_bits(const fmb_vec *v, size_t n)
{
    size_t most = 0;
    for (size_t i = 0; i < n; i++) {
        size_t bits = fmb_vec_entry_bits(v, i);
        most = bits > most ? bits : most;
    }
    return most;
}

double fmb_vec_entry_double(const fmb_vec *v, size_t i, int exponent)
{
    long own = 0;
    double x = v->z ? mpz_get_d_2exp(&own, v->z[i]) : (double)v->s[i];
    return own - exponent < -1000 ? 0 : ldexp(x, (int)(own - exponent));
}

/* A column with d entries less than 2^b has a length less than sqrt(d) 2^b. */
size_t fmb_vec_minor_bits(const fmb_vec *v, size_t size, size_t d)
{
    size_t bits = (d * (size_t)fmb_bits64(d) + 1) / 2;
    for (size_t k = 0; k < d; k++) {
        size_t most = 0;
        for (size_t i = 0; i < size; i++) {
            size_t b = fmb_vec_entry_bits(&v[i], k);
            most = b > most ? b : most;
        }
        bits += most;
    }
    return bits;
}

mpz_t *fmb_vec_block(size_t n, fmb_mem *mem)
{
    mpz_t *z = fmb_mem_get(mem, n, sizeof *z);
    if (!z)
        return NULL;
    for (size_t i = 0; i < n; i++)
        mpz_init(z[i]);
    return z;
}

void fmb_vec_block_free(mpz_t *z, size_t n, fmb_mem *mem)
{
    for (size_t i = 0; z && i < n; i++)
        mpz_clear(z[i]);
    fmb_mem_put(mem, z, n, sizeof *z);
}

fmb_status fmb_vec_set_z(fmb_vec *v, size_t n, mpz_t *from, fmb_mem *mem)
{
    if (fmb_vec_most_bits(&(fmb_vec){.z = from}, n) <= FMB_SMALL_BITS) {
        fmb_vec_clear(v, n, mem);
        for (size_t i = 0; i < n; i++)
            v->s[i] = fmb_integer_get_i64(from[i]);
        fmb_vec_measure(v, n);
        return FMB_OK;
    }
    if (!v->z) {
        v->z = fmb_vec_block(n, mem);
        if (!v->z)
            return fmb_mem_status(mem);
    }
    for (size_t i = 0; i < n; i++)
        mpz_set(v->z[i], from[i]);
    return fmb_vec_settle(v, n, mem);
}

fmb_status fmb_vec_widen(fmb_vec *v, size_t n, fmb_mem *mem)
{
    if (v->z)
        return FMB_OK;
    mpz_t *z = fmb_vec_block(n, mem);
    if (!z)
        return fmb_mem_status(mem);
    for (size_t i = 0; i < n; i++)
        fmb_integer_set_i64(z[i], v->s[i]);
    v->z = z;
    return fmb_vec_settle(v, n, mem);
}

fmb_status fmb_vec_copy(fmb_vec *to, const fmb_vec *from, size_t n, fmb_mem *mem)
{
    if (from->z) {
        if (!to->z)
            to->z = fmb_vec_block(n, mem);
        if (!to->z)
            return fmb_mem_status(mem);
        for (size_t i = 0; i < n; i++)
            mpz_set(to->z[i], from->z[i]);
        return fmb_vec_settle(to, n, mem);
    }
    fmb_vec_clear(to, n, mem);
    memcpy(to->s, from->s, n * sizeof *to->s);
    to->bits = from->bits;
    return FMB_OK;
}

fmb_status fmb_vec_drop_entry(fmb_vec *v, size_t n, size_t c, fmb_mem *mem)
{
    if (!v->z) {
        v->s[c] = v->s[n - 1];
        return FMB_OK;
    }
    mpz_swap(v->z[c], v->z[n - 1]);
    __mpz_struct last = *v->z[n - 1];
    mpz_t *z = fmb_mem_grow(mem, v->z, n, n - 1, sizeof *z);
    if (!z) {
        fmb_status st = fmb_mem_status(mem);
        fmb_vec_clear(v, n, mem);
        memset(v->s, 0, n * sizeof *v->s);
        v->bits = 0;
        return st;
    }
    mpz_clear(&last);
    v->z = z;
    return fmb_vec_settle(v, n - 1, mem);
}

/* The least nonzero entry is the first candidate divisor: mostly it is 1, or remainders are soon 0.
 */
uint64_t fmb_content_small(const int64_t *s, size_t n, int *bits)
{
    uint64_t g = UINT64_MAX, all = 0;
    for (size_t i = 0; i < n; i++) { /* 0 - 1 wraps: 0 counts as the largest */
        uint64_t a = fmb_abs64(s[i]);
        all |= a;
        g = a - 1 < g ? a - 1 : g;
    }
    g++;
    for (size_t i = 0; i < n && g > 1; i++)
        g = fmb_gcd64(g, fmb_abs64(s[i]) % g);
    *bits = fmb_bits64(all);
    return g;
}

void fmb_vec_reduce_small(fmb_vec *v, size_t n)
{
    uint64_t g = fmb_content_small(v->s, n, &v->bits);
    if (g <= 1)
        return;
    for (size_t i = 0; i < n; i++)
        v->s[i] /= (int64_t)g;
    fmb_vec_measure(v, n);
}

/* k->t = the content of a wide vec; 0 if all entries are 0. */
static fmb_status content_of_wide(const fmb_vec *v, size_t n, fmb_num *k)
{
    mpz_set_ui(k->t, 0);
    for (size_t i = 0; i < n && mpz_cmp_ui(k->t, 1) != 0; i++)
        FMB_TRY(fmb_long_gcd(k->t, k->t, v->z[i], &k->poll));
    return FMB_OK;
}

/* Divide a wide vec by k->t. Division by a long divisor writes to other memory, so that the vec is
 * unchanged if it is cut off. */
static fmb_status divide_wide(fmb_vec *v, size_t n, fmb_num *k)
{
    bool apart = mpz_sizeinbase(k->t, 2) > FMB_LONG_BITS;
    fmb_status st = FMB_OK;
    if (mpz_cmp_ui(k->t, 1) <= 0)
        return FMB_OK;
    mpz_t *to = apart ? fmb_vec_block(n, k->mem) : v->z;
    if (!to)
        return fmb_mem_status(k->mem);
    for (size_t i = 0; st == FMB_OK && i < n; i++) {
        mpz_divexact(to[i], v->z[i], k->t);
        st = apart ? fmb_poll_ask(&k->poll) : FMB_OK;
    }
    for (size_t i = 0; st == FMB_OK && apart && i < n; i++)
        mpz_swap(v->z[i], to[i]);
    if (apart)
        fmb_vec_block_free(to, n, k->mem);
    return st;
}

fmb_status fmb_vec_reduce(fmb_vec *v, size_t n, fmb_num *k)
{
    if (!v->z) {
        fmb_vec_reduce_small(v, n);
        return k->wide_only ? fmb_vec_widen(v, n, k->mem) : FMB_OK;
    }
    FMB_TRY(content_of_wide(v, n, k));
    FMB_TRY(divide_wide(v, n, k));
    if (k->wide_only || fmb_vec_most_bits(v, n) > FMB_SMALL_BITS)
        return fmb_vec_settle(v, n, k->mem);
    for (size_t i = 0; i < n; i++)
        v->s[i] = fmb_integer_get_i64(v->z[i]);
    fmb_vec_clear(v, n, k->mem);
    fmb_vec_measure(v, n);
    return FMB_OK;
}

/* out = x_i |y_j|. */
static void multiply_absolute(mpz_t out, mpz_t room, const fmb_vec *x, size_t i, const fmb_vec *y,
                              size_t j)
{
    fmb_vec_get(x, i, out);
    fmb_vec_get(y, j, room);
    mpz_abs(room, room);
    mpz_mul(out, out, room);
}

int fmb_vec_compare_products(const fmb_vec *x, size_t i, const fmb_vec *y, size_t j,
                             const fmb_vec *z, size_t k, const fmb_vec *w, size_t l)
{
    if (!x->z && !y->z && !z->z && !w->z) {
        fmb_i128 left = fmb_i128_product(x->s[i], (int64_t)fmb_abs64(y->s[j]));
        fmb_i128 right = fmb_i128_product(z->s[k], (int64_t)fmb_abs64(w->s[l]));
        return fmb_i128_compare(left, right);
    }
    mpz_t left, right, room;
    mpz_inits(left, right, room, NULL);
    multiply_absolute(left, room, x, i, y, j);
    multiply_absolute(right, room, z, k, w, l);
    int order = mpz_cmp(left, right);
    mpz_clears(left, right, room, NULL);
    return order;
}

bool fmb_vec_equal(const fmb_vec *a, const fmb_vec *b, size_t n)
{
    if (!a->z && !b->z)
        return memcmp(a->s, b->s, n * sizeof *a->s) == 0;
    for (size_t i = 0; i < n; i++) {
        int same = a->z && b->z ? mpz_cmp(a->z[i], b->z[i])
                   : a->z       ? fmb_integer_compare_i64(a->z[i], b->s[i])
                                : fmb_integer_compare_i64(b->z[i], a->s[i]);
        if (same != 0)
            return false;
    }
    return true;
}

static int compare_entries(const fmb_vec *a, const fmb_vec *b, size_t k)
{
    if (!a->z && !b->z)
        return (a->s[k] > b->s[k]) - (a->s[k] < b->s[k]);
    int order = a->z && b->z ? mpz_cmp(a->z[k], b->z[k])
                : a->z       ? fmb_integer_compare_i64(a->z[k], b->s[k])
                             : -fmb_integer_compare_i64(b->z[k], a->s[k]);
    return (order > 0) - (order < 0);
}

int fmb_vec_compare(const fmb_vec *a, const fmb_vec *b, size_t n)
{
    int order = 0;
    for (size_t k = 0; k < n && order == 0; k++)
        order = compare_entries(a, b, k);
    return order;
}

uint64_t fmb_vec_hash(const fmb_vec *v, size_t n)
{
    uint64_t h = 0x9e3779b97f4a7c15u;
    for (size_t i = 0; i < n; i++) {
        uint64_t low = v->z ? fmb_integer_low(v->z[i]) : fmb_abs64(v->s[i]);
        h = (h ^ (fmb_vec_sgn(v, i) < 0 ? ~low : low)) * 0xff51afd7ed558ccdu;
        h ^= h >> 32;
    }
    return h;
}
