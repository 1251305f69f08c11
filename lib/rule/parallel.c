/* parallel.c: finds parallel rows by hashing; see parallel.h.
 *
 * Rows are compared as if divided by the greatest common divisor (the scale) of the entries in
 * question: a is parallel to b if a_j scale_b = b_j scale_a for each j. Large numbers are compared
 * in GMP, small ones in the row itself; both have equal hashes.
 */
#include "rule/parallel.h"

#include <fmb/gmp.h>

#include "num/word.h"

typedef struct parallel_search {
    const fmb_view *w;
    int entries;
    uint64_t *scale; /* [rows] of small rows */
    size_t *slot;    /* [size] place in the view + 1, 0 = free: a table at most half full */
    size_t size;     /* a power of two */
    mpz_t a, b, scale_a, scale_b;
} parallel_search;

static uint64_t absolute_value(int64_t v)
{
    return v < 0 ? 0 - (uint64_t)v : (uint64_t)v;
}

static uint64_t gcd_by_euclid(uint64_t a, uint64_t b)
{
    while (b != 0) {
        uint64_t t = a % b;
        a = b;
        b = t;
    }
    return a;
}

static uint64_t scale_of_int64_row(const int64_t *row, int entries)
{
    uint64_t g = 0;
    for (int j = 0; j < entries && g != 1; j++)
        if (row[j] != 0)
            g = gcd_by_euclid(absolute_value(row[j]), g);
    return g == 0 ? 1 : g;
}

static void scale_of_gmp_row(parallel_search *s, size_t row, mpz_t g)
{
    mpz_set_ui(g, 0);
    for (int j = 0; j < s->entries; j++) {
        fmb_view_get(s->w, row, j, s->a);
        mpz_gcd(g, g, s->a);
    }
    if (mpz_sgn(g) == 0)
        mpz_set_ui(g, 1);
}

/* Mix the nonzero entry j into the hash. */
static uint64_t stir_into_hash(uint64_t h, int j, uint64_t low, bool negative)
{
    h = (h ^ (negative ? ~low : low) ^ (uint64_t)j << 48) * 0xff51afd7ed558ccdu;
    return h ^ h >> 32;
}

static uint64_t hash_of_int64_row(const int64_t *v, int entries, uint64_t scale)
{
    uint64_t h = 0x9e3779b97f4a7c15u;
    for (int j = 0; j < entries; j++) {
        uint64_t size = absolute_value(v[j]);
        if (size != 0)
            h = stir_into_hash(h, j, scale == 1 ? size : size / scale, v[j] < 0);
    }
    return h;
}

static uint64_t hash_of_row(parallel_search *s, size_t i)
{
    size_t row = fmb_view_row(s->w, i);
    const int64_t *v = fmb_view_int64(s->w, row);
    uint64_t h = 0x9e3779b97f4a7c15u;
    if (v)
        return hash_of_int64_row(v, s->entries, s->scale[i]);
    scale_of_gmp_row(s, row, s->scale_a);
    for (int j = 0; j < s->entries; j++) {
        fmb_view_get(s->w, row, j, s->a);
        mpz_divexact(s->a, s->a, s->scale_a);
        if (mpz_sgn(s->a) != 0)
            h = stir_into_hash(h, j, fmb_integer_low(s->a), mpz_sgn(s->a) < 0);
    }
    return h;
}

/* The scales of the i-th and the k-th row, if at least one is not small. */
static void set_scales_in_gmp(parallel_search *s, size_t i, size_t k)
{
    size_t x = fmb_view_row(s->w, i), y = fmb_view_row(s->w, k);
    if (fmb_view_int64(s->w, x) && fmb_view_int64(s->w, y))
        return;
    scale_of_gmp_row(s, x, s->scale_a);
    scale_of_gmp_row(s, y, s->scale_b);
}

/* The order of entry j of the i-th and the k-th row at equal scale, after set_scales. */
static int compare_entries(parallel_search *s, size_t i, size_t k, int j)
{
    size_t x = fmb_view_row(s->w, i), y = fmb_view_row(s->w, k);
    const int64_t *u = fmb_view_int64(s->w, x), *v = fmb_view_int64(s->w, y);
    if (u && v) {
        return fmb_i128_compare(fmb_i128_product(u[j], (int64_t)s->scale[k]),
                                fmb_i128_product(v[j], (int64_t)s->scale[i]));
    }
    fmb_view_get(s->w, x, j, s->a);
    fmb_view_get(s->w, y, j, s->b);
    mpz_mul(s->a, s->a, s->scale_b);
    mpz_mul(s->b, s->b, s->scale_a);
    return mpz_cmp(s->a, s->b);
}

static bool are_int64_rows_like(const parallel_search *s, size_t i, size_t k, const int64_t *u,
                                const int64_t *v)
{
    bool like = true;
    for (int j = 0; like && j < s->entries; j++)
        like = s->scale[i] == s->scale[k]
                   ? u[j] == v[j]
                   : fmb_i128_compare(fmb_i128_product(u[j], (int64_t)s->scale[k]),
                                      fmb_i128_product(v[j], (int64_t)s->scale[i])) == 0;
    return like;
}

static bool are_rows_like(parallel_search *s, size_t i, size_t k)
{
    const int64_t *u = fmb_view_int64(s->w, fmb_view_row(s->w, i));
    const int64_t *v = fmb_view_int64(s->w, fmb_view_row(s->w, k));
    if (u && v)
        return are_int64_rows_like(s, i, k, u, v);
    set_scales_in_gmp(s, i, k);
    for (int j = 0; j < s->entries; j++)
        if (compare_entries(s, i, k, j) != 0)
            return false;
    return true;
}

/* The slot of a row parallel to the i-th, or the free slot for the i-th. */
static size_t *find_slot_of_like(parallel_search *s, size_t i)
{
    for (size_t at = (size_t)hash_of_row(s, i);; at++) {
        size_t *slot = &s->slot[at & (s->size - 1)];
        if (*slot == 0 || are_rows_like(s, i, *slot - 1))
            return slot;
    }
}

/* Is the bound of the i-th row tighter than that of the k-th, just found to be parallel? */
static bool is_bound_tighter(parallel_search *s, size_t i, size_t k)
{
    int order = compare_entries(s, i, k, fmb_view_dim(s->w));
    fmb_rel a = fmb_view_rel(s->w, fmb_view_row(s->w, i));
    fmb_rel b = fmb_view_rel(s->w, fmb_view_row(s->w, k));
    return order < 0 || (order == 0 && a == FMB_LT && b != FMB_LT);
}

static void mark_looser_rows(parallel_search *s, bool *drop)
{
    for (size_t i = 0; i < fmb_view_rows(s->w) && !fmb_view_stop(s->w); i++) {
        if (fmb_view_rel(s->w, fmb_view_row(s->w, i)) == FMB_EQ)
            continue;
        size_t *slot = find_slot_of_like(s, i);
        bool first = *slot == 0, better = !first && is_bound_tighter(s, i, *slot - 1);
        if (!first)
            drop[better ? *slot - 1 : i] = true;
        if (first || better)
            *slot = i + 1;
    }
}

static bool open_hash_table(parallel_search *s)
{
    size_t rows = fmb_view_rows(s->w);
    s->size = 16;
    while (s->size < 2 * rows)
        s->size *= 2;
    s->slot = fmb_view_scratch(s->w, s->size * sizeof *s->slot);
    s->scale = fmb_view_scratch(s->w, rows * sizeof *s->scale);
    if (!s->slot || !s->scale)
        return false;
    for (size_t k = 0; k < s->size; k++)
        s->slot[k] = 0;
    for (size_t i = 0; i < rows; i++) {
        const int64_t *v = fmb_view_int64(s->w, fmb_view_row(s->w, i));
        s->scale[i] = v ? scale_of_int64_row(v, s->entries) : 0;
    }
    return true;
}

fmb_status fmb_parallel_drop(const fmb_view *w, int entries, bool *drop)
{
    parallel_search s = {.w = w, .entries = entries};
    if (!open_hash_table(&s))
        return FMB_ERR_MEMORY;
    mpz_inits(s.a, s.b, s.scale_a, s.scale_b, NULL);
    mark_looser_rows(&s, drop);
    mpz_clears(s.a, s.b, s.scale_a, s.scale_b, NULL);
    return FMB_OK;
}
