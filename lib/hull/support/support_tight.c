/* support_tight.c: facets that stand, without a linear program; see support.h.
 *
 * The multipliers that prove a facet belong to rows that are tight on all of it, hence on the
 * generators that are known on it. Mostly there is one way only to combine these so that the
 * columns that go vanish. The combination is a row of the projection if its multipliers are not
 * negative, and it is the facet if it looks the same. It is found modulo a prime
 * (lp/linalg/modular/modular_kernel.h), and then looked at in integers: where it does not fit, or
 * there are several, the oracle is asked, as always.
 */
#include <string.h>

#include "hull/support/support_private.h"
#include "lp/linalg/modular/modular_kernel.h"
#include "num/bitset.h"
#include "num/gcd.h"

/* Products of a multiplier and a coefficient of so many bits together, some of them added up. */
#define MULTIPLIER_BITS 60
#define SUM_BITS        126

struct fmb_tight {
    const fmb_program *p;
    size_t words;  /* of a set of rows */
    uint64_t *set; /* [generators][words] rows that are tight there; none: not known */
    size_t generators, capacity;
    size_t gone;            /* columns that go: */
    int *place;             /* [n] the place among them, or -1 */
    fmb_modular_kernel few; /* one row for each of them */
    uint64_t *common;       /* [words] scratch */
    uint32_t *row;          /* [gone + 1] rows that are combined, */
    size_t rows;            /* so many of them, */
    fmb_i128 *sum;          /* [n + 1] and their sum, right side last */
    fmb_vec h;              /* [k + 1] the same as a facet */
    uint64_t *residue;      /* [n + 1] of a point, scratch */
};

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status open_tight(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    fmb_tight *t = fmb_mem_zero(mem, 1, sizeof *t);
    if (!t)
        return fmb_mem_status(mem);
    s->tight = t;
    t->p = fmb_oracle_program(s->worker.oracle);
    t->words = t->p->m / 64 + 1;
    t->gone = s->n - s->k;
    t->place = fmb_mem_get(mem, s->n, sizeof *t->place);
    t->common = fmb_mem_get(mem, t->words, sizeof *t->common);
    t->row = fmb_mem_get(mem, t->gone + 1, sizeof *t->row);
    t->sum = fmb_mem_get(mem, s->n + 1, sizeof *t->sum);
    t->residue = fmb_mem_get(mem, s->n + 1, sizeof *t->residue);
    t->h.s = fmb_mem_zero(mem, s->k + 1, sizeof *t->h.s);
    if (!t->place || !t->common || !t->row || !t->sum || !t->residue || !t->h.s)
        return fmb_mem_status(mem);
    for (size_t j = 0, kept = 0; j < s->n; j++) {
        bool stays = kept < s->k && s->kept[kept] == (int)j;
        t->place[j] = stays ? -1 : (int)(j - kept);
        kept += stays;
    }
    return fmb_modular_kernel_init(&t->few, mem, t->gone);
}

void fmb_support_close_tight(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    fmb_tight *t = s->tight;
    if (!t)
        return;
    fmb_modular_kernel_clear(&t->few, mem);
    fmb_vec_clear(&t->h, s->k + 1, mem);
    fmb_mem_put(mem, t->h.s, s->k + 1, sizeof *t->h.s);
    fmb_mem_put(mem, t->residue, s->n + 1, sizeof *t->residue);
    fmb_mem_put(mem, t->sum, s->n + 1, sizeof *t->sum);
    fmb_mem_put(mem, t->row, t->gone + 1, sizeof *t->row);
    fmb_mem_put(mem, t->common, t->words, sizeof *t->common);
    fmb_mem_put(mem, t->place, s->n, sizeof *t->place);
    fmb_mem_put(mem, t->set, t->capacity, sizeof *t->set);
    fmb_mem_put(mem, t, 1, sizeof *t);
    s->tight = NULL;
}

/* ---- rows that are tight --------------------------------------------------------------------- */

/* What is left of row i at the point, modulo the prime. */
static uint64_t slack_residue(const fmb_tight *t, size_t i, size_t n)
{
    const fmb_prime *q = &t->few.q;
    const fmb_program_row *row = &t->p->row[i];
    uint64_t sum = 0;
    for (size_t k = 0; k <= row->size; k++) {
        uint64_t a = fmb_prime_of_entry(q, row->value, k);
        uint64_t x = t->residue[k < row->size ? (size_t)row->column[k] : n];
        sum = fmb_prime_fold(q, fmb_u128_plus_product(fmb_u128_of(sum), a, x));
    }
    return sum;
}

/* A guess, as it is made modulo the prime. */
static void find_tight_rows(fmb_support *s, const fmb_support_worker *c, uint64_t *set)
{
    fmb_tight *t = s->tight;
    const fmb_prime *q = &t->few.q;
    for (size_t j = 0; j < s->n; j++)
        t->residue[j] = fmb_prime_of_integer(q, c->x.z[j]);
    t->residue[s->n] = fmb_prime_minus(q, 0, fmb_prime_of_integer(q, c->den));
    for (size_t i = 0; i < t->p->m; i++)
        if (!t->p->row[i].off && slack_residue(t, i, s->n) == 0)
            fmb_set_put(set, i);
}

fmb_status fmb_support_note_tight(fmb_support *s, const fmb_support_worker *c)
{
    fmb_status st = s->tight || s->n == s->k ? FMB_OK : open_tight(s);
    if (st != FMB_OK || !s->tight)
        return st;
    fmb_tight *t = s->tight;
    size_t size = s->hull.generators;
    st = fmb_mem_reserve(s->run->mem, (void **)&t->set, &t->capacity, size * t->words,
                         sizeof *t->set);
    if (st != FMB_OK)
        return st;
    memset(t->set + t->generators * t->words, 0,
           (size - t->generators) * t->words * sizeof *t->set);
    t->generators = size;
    find_tight_rows(s, c, t->set + (size - 1) * t->words);
    return FMB_OK;
}

/* Those tight on all generators of a facet, unless there are more than can be combined in one way
 * only. */
static bool list_rows_tight_on_facet(fmb_support *s, const fmb_facet *a)
{
    fmb_tight *t = s->tight;
    t->rows = 0;
    memset(t->common, 0xff, t->words * sizeof *t->common);
    for (size_t g = fmb_facet_next(a, 0, true); g < s->hull.generators;
         g = fmb_facet_next(a, g + 1, true)) {
        if (g >= t->generators)
            return false;
        for (size_t w = 0; w < t->words; w++)
            t->common[w] &= t->set[g * t->words + w];
    }
    for (size_t w = 0; w < t->words; w++)
        for (uint64_t set = t->common[w]; set != 0; set &= set - 1) {
            if (t->rows > t->gone)
                return false;
            t->row[t->rows++] = (uint32_t)(64 * w) + (uint32_t)__builtin_ctzll(set);
        }
    return t->rows > 0;
}

/* ---- their combination ----------------------------------------------------------------------- */

static bool find_multipliers(fmb_tight *t)
{
    fmb_modular_kernel_zero(&t->few, t->rows);
    for (size_t r = 0; r < t->rows; r++) {
        const fmb_program_row *row = &t->p->row[t->row[r]];
        if (row->value->z || row->value->bits + MULTIPLIER_BITS + fmb_bits64(t->rows) > SUM_BITS)
            return false;
        for (size_t k = 0; k < row->size; k++)
            if (t->place[row->column[k]] >= 0)
                fmb_modular_kernel_put(&t->few, (size_t)t->place[row->column[k]], r,
                                       row->value->s[k]);
    }
    return fmb_modular_kernel_find(&t->few);
}

/* Are they not negative, or else not positive? Then they become the former. *strict: a strict row
 * counts. */
static bool turn_multipliers(fmb_tight *t, bool *strict)
{
    int sign = 0;
    *strict = false;
    for (size_t r = 0; r < t->rows; r++) {
        int64_t v = t->few.v[r];
        fmb_rel rel = t->p->row[t->row[r]].rel;
        *strict |= v != 0 && rel == FMB_LT;
        if (v == 0 || rel == FMB_EQ)
            continue;
        if (sign != 0 && (v > 0) != (sign > 0))
            return false;
        sign = v > 0 ? 1 : -1;
    }
    for (size_t r = 0; sign < 0 && r < t->rows; r++)
        t->few.v[r] = -t->few.v[r];
    return sign != 0;
}

/* Do the columns that go vanish? */
static bool combine_rows(fmb_support *s)
{
    fmb_tight *t = s->tight;
    memset(t->sum, 0, (s->n + 1) * sizeof *t->sum);
    for (size_t r = 0; r < t->rows; r++) {
        const fmb_program_row *row = &t->p->row[t->row[r]];
        for (size_t k = 0; k <= row->size; k++) {
            fmb_i128 *sum = &t->sum[k < row->size ? (size_t)row->column[k] : s->n];
            *sum = fmb_i128_plus_product(*sum, t->few.v[r], row->value->s[k]);
        }
    }
    for (size_t j = 0; j < s->n; j++)
        if (t->place[j] >= 0 && fmb_i128_sign(t->sum[j]) != 0)
            return false;
    return true;
}

/* Is the sum a.x <= b the facet h0 + h.x >= 0? */
static fmb_status compare_with_facet(fmb_support *s, const fmb_vec *normal, bool *same)
{
    fmb_tight *t = s->tight;
    fmb_num *num = &s->hull.num;
    fmb_integer_set_128(s->g.z[0], t->sum[s->n]);
    for (size_t j = 0; j < s->k; j++)
        fmb_integer_set_128(s->g.z[j + 1], fmb_i128_negative(t->sum[s->kept[j]]));
    fmb_status st = fmb_vec_set_z(&t->h, s->k + 1, s->g.z, num->mem);
    if (st == FMB_OK)
        st = fmb_vec_reduce(&t->h, s->k + 1, num);
    *same = st == FMB_OK && fmb_vec_equal(&t->h, normal, s->k + 1);
    return st;
}

/* The sum is s->g, the facet a part of that. */
static fmb_status write_multipliers(fmb_support *s, const fmb_vec *normal, fmb_support_row *row)
{
    fmb_tight *t = s->tight;
    size_t j = 0;
    fmb_status st = FMB_OK;
    mpq_t part, factor;
    mpq_inits(part, factor, NULL);
    while (fmb_vec_sgn(normal, j) == 0)
        j++;
    fmb_vec_get(normal, j, mpq_numref(factor));
    mpz_set(mpq_denref(factor), s->g.z[j]);
    mpq_canonicalize(factor);
    for (size_t r = 0; st == FMB_OK && r < t->rows; r++) {
        fmb_integer_set_i64(mpq_numref(part), t->few.v[r]);
        mpz_set_ui(mpq_denref(part), 1);
        mpq_mul(part, part, factor);
        if (mpq_sgn(part) != 0)
            st = fmb_weights_add(&row->proof, t->row[r], part, s->run->mem);
    }
    mpq_clears(part, factor, NULL);
    return st;
}

fmb_status fmb_support_try_tight_rows(fmb_support *s, size_t at, fmb_support_row *row, bool *stands)
{
    const fmb_facet *a = &s->hull.facet[at];
    bool strict;
    *stands = false;
    if (!s->tight || !list_rows_tight_on_facet(s, a) || !find_multipliers(s->tight) ||
        !turn_multipliers(s->tight, &strict) || strict != s->strict || !combine_rows(s))
        return FMB_OK;
    fmb_status st = compare_with_facet(s, &a->normal, stands);
    if (st != FMB_OK || !*stands)
        return st;
    row->rel = strict ? FMB_LT : FMB_LE;
    st = fmb_support_write_row(s, &a->normal, row, s->run->mem);
    return st == FMB_OK && s->proves ? write_multipliers(s, &a->normal, row) : st;
}
