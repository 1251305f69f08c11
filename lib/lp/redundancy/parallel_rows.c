/* parallel_rows.c: see parallel_rows.h. Rows are compared as if divided by the greatest common
 * divisor of their coefficients, the scale. */
#include "lp/redundancy/parallel_rows.h"

#include "num/gcd.h"

typedef struct parallel_table {
    fmb_mem *mem;
    fmb_poll poll;
    size_t n;
    const fmb_lp_row *row;
    uint64_t *scale;              /* [m] of small rows */
    size_t *slot;                 /* [size] a row, SIZE_MAX: free; a table at most half full */
    size_t size;                  /* a power of two */
    mpz_t a, b, scale_a, scale_b; /* scratch; the scales of two loaded rows */
} parallel_table;

/* ---- directions ------------------------------------------------------------------------------ */

static uint64_t scale_of_small(const fmb_vec *v, size_t n)
{
    uint64_t g = 0;
    for (size_t j = 0; j < n && g != 1; j++)
        g = fmb_gcd64(fmb_abs64(v->s[j]), g);
    return g;
}

static fmb_status scale_of_any(const parallel_table *s, size_t i, mpz_t g)
{
    const fmb_vec *v = s->row[i].v;
    fmb_integer_set_u64(g, v->z ? 0 : s->scale[i]);
    for (size_t j = 0; v->z && j < s->n && mpz_cmp_ui(g, 1) != 0; j++)
        FMB_TRY(fmb_long_gcd(g, g, v->z[j], &s->poll));
    return FMB_OK;
}

/* Load the scales of rows i and k. */
static fmb_status load_scales(parallel_table *s, size_t i, size_t k)
{
    FMB_TRY(scale_of_any(s, i, s->scale_a));
    return scale_of_any(s, k, s->scale_b);
}

static uint64_t stir_word(uint64_t h, uint64_t low, bool negative)
{
    h = (h ^ (negative ? ~low : low)) * 0xff51afd7ed558ccdu;
    return h ^ h >> 32;
}

/* A hash that is equal for parallel rows, small or wide; scale_a is the scale of row i. */
static uint64_t hash_direction(parallel_table *s, size_t i)
{
    const fmb_vec *v = s->row[i].v;
    uint64_t h = 0;
    for (size_t j = 0; j < s->n; j++) {
        if (v->z) {
            mpz_divexact(s->a, v->z[j], s->scale_a);
            h = stir_word(h, fmb_integer_low(s->a), mpz_sgn(s->a) < 0);
            continue;
        }
        uint64_t size = fmb_abs64(v->s[j]);
        h = stir_word(h, s->scale[i] > 1 ? size / s->scale[i] : size, v->s[j] < 0);
    }
    return h;
}

/* The sign of entry j of row i over its scale minus that of row k over its scale; both are loaded.
 */
static int compare_scaled_entries(parallel_table *s, size_t i, size_t k, size_t j)
{
    const fmb_vec *u = s->row[i].v, *v = s->row[k].v;
    if (!u->z && !v->z && s->scale[i] < INT64_MAX && s->scale[k] < INT64_MAX) {
        return fmb_i128_compare(fmb_i128_product(u->s[j], (int64_t)s->scale[k]),
                                fmb_i128_product(v->s[j], (int64_t)s->scale[i]));
    }
    fmb_vec_get(u, j, s->a);
    fmb_vec_get(v, j, s->b);
    mpz_mul(s->a, s->a, s->scale_b);
    mpz_mul(s->b, s->b, s->scale_a);
    return mpz_cmp(s->a, s->b);
}

static bool are_parallel(parallel_table *s, size_t i, size_t k)
{
    for (size_t j = 0; j < s->n; j++)
        if (compare_scaled_entries(s, i, k, j) != 0)
            return false;
    return true;
}

/* ---- which row is redundant ------------------------------------------------------------------ */

/* Does row k imply the parallel row i? order: -1, 0 or 1 if the right side of i is less, equal or
 * greater.
 */
static bool does_parallel_imply(const parallel_table *s, size_t k, size_t i, int order)
{
    fmb_rel have = s->row[k].rel, want = s->row[i].rel;
    if (want == FMB_EQ)
        return have == FMB_EQ && order == 0;
    return order > 0 || (order == 0 && (want == FMB_LE || have == FMB_LT));
}

/* Report that row i, of scale `of`, is implied by the parallel row k, of scale `by`. */
static fmb_status tell_of_parallel(parallel_table *s, size_t i, const mpz_t of, size_t k,
                                   const mpz_t by, const fmb_verdicts *told)
{
    fmb_weights w = {0};
    mpq_t factor;
    if (!told || !told->redundant)
        return FMB_OK;
    mpq_init(factor);
    mpq_set_z(factor, of);
    fmb_status st = fmb_long_divide(factor, by, &s->poll);
    FMB_THEN(st, fmb_weights_add(&w, (uint32_t)k, factor, s->mem));
    FMB_THEN(st, told->redundant(told->self, i, &w));
    fmb_weights_clear(&w, s->mem);
    mpq_clear(factor);
    return st;
}

/* Compare row i with the parallel row in that slot, if there is one; then both are loaded. */
static fmb_status meet_parallel(parallel_table *s, size_t i, size_t *slot, fmb_fate *fate,
                                const fmb_verdicts *told)
{
    size_t k = *slot;
    if (k == SIZE_MAX) {
        *slot = i;
        return FMB_OK;
    }
    int order = compare_scaled_entries(s, i, k, s->n);
    if (does_parallel_imply(s, k, i, order)) {
        fate[i] = FMB_FATE_REDUNDANT;
        return tell_of_parallel(s, i, s->scale_a, k, s->scale_b, told);
    }
    if (!does_parallel_imply(s, i, k, -order))
        return FMB_OK;
    *slot = i;
    fate[k] = FMB_FATE_REDUNDANT;
    return tell_of_parallel(s, k, s->scale_b, i, s->scale_a, told);
}

/* The slot for row i: a free one, or that of a parallel row; then both are loaded. */
static fmb_status find_parallel_slot(parallel_table *s, size_t i, size_t **slot)
{
    FMB_TRY(scale_of_any(s, i, s->scale_a));
    for (size_t at = (size_t)hash_direction(s, i);; at++) {
        *slot = &s->slot[at & (s->size - 1)];
        if (**slot == SIZE_MAX)
            return FMB_OK;
        FMB_TRY(load_scales(s, i, **slot));
        if (are_parallel(s, i, **slot))
            return FMB_OK;
    }
}

static fmb_status open_parallel_table(parallel_table *s, size_t m)
{
    for (s->size = 16; s->size < 2 * m;)
        s->size *= 2;
    s->scale = fmb_mem_get(s->mem, m, sizeof *s->scale);
    s->slot = fmb_mem_get(s->mem, s->size, sizeof *s->slot);
    if (!s->scale || !s->slot)
        return fmb_mem_status(s->mem);
    for (size_t k = 0; k < s->size; k++)
        s->slot[k] = SIZE_MAX;
    for (size_t i = 0; i < m; i++)
        s->scale[i] = s->row[i].v->z ? 0 : scale_of_small(s->row[i].v, s->n);
    return FMB_OK;
}

fmb_status fmb_drop_parallel_rows(fmb_run *run, size_t n, size_t m, const fmb_lp_row *row,
                                  fmb_fate *fate, const fmb_verdicts *told)
{
    parallel_table s = {.mem = run->mem, .poll = fmb_run_asked(run), .n = n, .row = row};
    size_t *slot = NULL;
    mpz_inits(s.a, s.b, s.scale_a, s.scale_b, NULL);
    fmb_status st = open_parallel_table(&s, m);
    for (size_t i = 0; st == FMB_OK && i < m; i++) {
        if (fate[i] == FMB_FATE_UNKNOWN)
            st = find_parallel_slot(&s, i, &slot);
        if (st == FMB_OK && fate[i] == FMB_FATE_UNKNOWN)
            st = meet_parallel(&s, i, slot, fate, told);
        FMB_THEN(st, fmb_run_poll(run));
    }
    fmb_mem_put(s.mem, s.scale, m, sizeof *s.scale);
    fmb_mem_put(s.mem, s.slot, s.size, sizeof *s.slot);
    mpz_clears(s.a, s.b, s.scale_a, s.scale_b, NULL);
    return st;
}
