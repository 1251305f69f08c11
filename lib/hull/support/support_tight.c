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
    fmb_prime q;
    size_t words;  /* of a set of rows */
    uint64_t *set; /* [generators][words] rows that are tight there; none: not known */
    size_t generators, capacity;
    size_t gone;       /* columns that go: */
    int *place;        /* [n] the place among them, or -1 */
    uint64_t *residue; /* [n + 1] of a point, scratch */
};

struct fmb_tight_search {
    fmb_num num;
    fmb_modular_kernel few; /* one row for each column that goes */
    uint64_t *common;       /* [words] scratch */
    uint32_t *row;          /* [gone + 1] rows that are combined, */
    size_t rows;            /* so many of them, */
    fmb_i128 *sum;          /* [n + 1] and their sum, right side last */
    fmb_integers g;         /* [k + 1] the same over the columns that stay, right side first, */
    fmb_vec h;              /* [k + 1] and as a facet */
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
    t->q = fmb_prime_number(0);
    t->words = t->p->m / 64 + 1;
    t->gone = s->n - s->k;
    t->place = fmb_mem_get(mem, s->n, sizeof *t->place);
    t->residue = fmb_mem_get(mem, s->n + 1, sizeof *t->residue);
    if (!t->place || !t->residue)
        return fmb_mem_status(mem);
    for (size_t j = 0, kept = 0; j < s->n; j++) {
        bool stays = kept < s->k && s->kept[kept] == (int)j;
        t->place[j] = stays ? -1 : (int)(j - kept);
        kept += stays;
    }
    return FMB_OK;
}

void fmb_support_close_tight(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    fmb_tight *t = s->tight;
    if (!t)
        return;
    fmb_mem_put(mem, t->residue, s->n + 1, sizeof *t->residue);
    fmb_mem_put(mem, t->place, s->n, sizeof *t->place);
    fmb_mem_put(mem, t->set, t->capacity, sizeof *t->set);
    fmb_mem_put(mem, t, 1, sizeof *t);
    s->tight = NULL;
}

static fmb_status open_search(const fmb_support *s, fmb_support_worker *c)
{
    fmb_mem *mem = c->run->mem;
    const fmb_tight *t = s->tight;
    fmb_tight_search *e = fmb_mem_zero(mem, 1, sizeof *e);
    if (!e)
        return fmb_mem_status(mem);
    c->search = e;
    e->common = fmb_mem_get(mem, t->words, sizeof *e->common);
    e->row = fmb_mem_get(mem, t->gone + 1, sizeof *e->row);
    e->sum = fmb_mem_get(mem, s->n + 1, sizeof *e->sum);
    e->h.s = fmb_mem_zero(mem, s->k + 1, sizeof *e->h.s);
    fmb_status st = e->common && e->row && e->sum && e->h.s ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK)
        st = fmb_integers_init(&e->g, s->k + 1, mem);
    if (st == FMB_OK)
        st = fmb_modular_kernel_init(&e->few, mem, t->gone);
    return st == FMB_OK ? fmb_run_open_num(c->run, &e->num, s->k + 1, false) : st;
}

void fmb_support_close_search(fmb_support_worker *c, const fmb_support *s)
{
    fmb_mem *mem = c->run->mem;
    fmb_tight_search *e = c->search;
    if (!e)
        return;
    fmb_modular_kernel_clear(&e->few, mem);
    if (e->num.mem)
        fmb_num_clear(&e->num);
    fmb_integers_clear(&e->g, mem);
    fmb_vec_clear(&e->h, s->k + 1, mem);
    fmb_mem_put(mem, e->h.s, s->k + 1, sizeof *e->h.s);
    fmb_mem_put(mem, e->sum, s->n + 1, sizeof *e->sum);
    fmb_mem_put(mem, e->row, s->n - s->k + 1, sizeof *e->row);
    fmb_mem_put(mem, e->common, s->tight->words, sizeof *e->common);
    fmb_mem_put(mem, e, 1, sizeof *e);
    c->search = NULL;
}

/* ---- rows that are tight --------------------------------------------------------------------- */

/* What is left of row i at the point, modulo the prime. */
static uint64_t slack_residue(const fmb_tight *t, size_t i, size_t n)
{
    const fmb_prime *q = &t->q;
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
static void find_tight_rows(fmb_support *s, const fmb_support_point *seen, uint64_t *set)
{
    fmb_tight *t = s->tight;
    const fmb_prime *q = &t->q;
    for (size_t j = 0; j < s->n; j++)
        t->residue[j] = fmb_prime_of_integer(q, seen->x.z[j]);
    t->residue[s->n] = fmb_prime_minus(q, 0, fmb_prime_of_integer(q, seen->den));
    for (size_t i = 0; i < t->p->m; i++)
        if (!t->p->row[i].off && slack_residue(t, i, s->n) == 0)
            fmb_set_put(set, i);
}

static fmb_status reserve_sets(fmb_support *s, size_t generators)
{
    fmb_tight *t = s->tight;
    return fmb_mem_reserve(s->run->mem, (void **)&t->set, &t->capacity, generators * t->words,
                           sizeof *t->set);
}

fmb_status fmb_support_reserve_tight(fmb_support *s, size_t more)
{
    return s->tight ? reserve_sets(s, s->hull.generators + more) : FMB_OK;
}

size_t fmb_support_noted(const fmb_support *s)
{
    return s->tight ? s->tight->generators : 0;
}

fmb_status fmb_support_note_tight(fmb_support *s, const fmb_support_point *seen)
{
    fmb_status st = s->tight || s->n == s->k ? FMB_OK : open_tight(s);
    if (st != FMB_OK || !s->tight)
        return st;
    fmb_tight *t = s->tight;
    size_t size = s->hull.generators;
    st = reserve_sets(s, size);
    if (st != FMB_OK)
        return st;
    memset(t->set + t->generators * t->words, 0,
           (size - t->generators) * t->words * sizeof *t->set);
    t->generators = size;
    find_tight_rows(s, seen, t->set + (size - 1) * t->words);
    return FMB_OK;
}

/* Those tight on all generators of a facet, unless there are more than can be combined in one way
 * only. */
static bool list_rows_tight_on_facet(const fmb_tight *t, fmb_tight_search *e, const fmb_facet *a,
                                     size_t noted)
{
    e->rows = 0;
    memset(e->common, 0xff, t->words * sizeof *e->common);
    for (size_t g = fmb_facet_next(a, 0, true); g < 64 * a->words;
         g = fmb_facet_next(a, g + 1, true)) {
        if (g >= noted)
            return false;
        for (size_t w = 0; w < t->words; w++)
            e->common[w] &= t->set[g * t->words + w];
    }
    for (size_t w = 0; w < t->words; w++)
        for (uint64_t set = e->common[w]; set != 0; set &= set - 1) {
            if (e->rows > t->gone)
                return false;
            e->row[e->rows++] = (uint32_t)(64 * w) + (uint32_t)__builtin_ctzll(set);
        }
    return e->rows > 0;
}

/* ---- their combination ----------------------------------------------------------------------- */

static bool find_multipliers(const fmb_tight *t, fmb_tight_search *e)
{
    fmb_modular_kernel_zero(&e->few, e->rows);
    for (size_t r = 0; r < e->rows; r++) {
        const fmb_program_row *row = &t->p->row[e->row[r]];
        if (row->value->z || row->value->bits + MULTIPLIER_BITS + fmb_bits64(e->rows) > SUM_BITS)
            return false;
        for (size_t k = 0; k < row->size; k++)
            if (t->place[row->column[k]] >= 0)
                fmb_modular_kernel_put(&e->few, (size_t)t->place[row->column[k]], r,
                                       row->value->s[k]);
    }
    return fmb_modular_kernel_find(&e->few);
}

/* Are they not negative, or else not positive? Then they become the former. *strict: a strict row
 * counts. */
static bool turn_multipliers(const fmb_tight *t, fmb_tight_search *e, bool *strict)
{
    int sign = 0;
    *strict = false;
    for (size_t r = 0; r < e->rows; r++) {
        int64_t v = e->few.v[r];
        fmb_rel rel = t->p->row[e->row[r]].rel;
        *strict |= v != 0 && rel == FMB_LT;
        if (v == 0 || rel == FMB_EQ)
            continue;
        if (sign != 0 && (v > 0) != (sign > 0))
            return false;
        sign = v > 0 ? 1 : -1;
    }
    for (size_t r = 0; sign < 0 && r < e->rows; r++)
        e->few.v[r] = -e->few.v[r];
    return sign != 0;
}

/* Do the columns that go vanish? */
static bool combine_rows(const fmb_support *s, fmb_tight_search *e)
{
    const fmb_tight *t = s->tight;
    memset(e->sum, 0, (s->n + 1) * sizeof *e->sum);
    for (size_t r = 0; r < e->rows; r++) {
        const fmb_program_row *row = &t->p->row[e->row[r]];
        for (size_t k = 0; k <= row->size; k++) {
            fmb_i128 *sum = &e->sum[k < row->size ? (size_t)row->column[k] : s->n];
            *sum = fmb_i128_plus_product(*sum, e->few.v[r], row->value->s[k]);
        }
    }
    for (size_t j = 0; j < s->n; j++)
        if (t->place[j] >= 0 && fmb_i128_sign(e->sum[j]) != 0)
            return false;
    return true;
}

/* Is the sum a.x <= b the facet h0 + h.x >= 0? */
static fmb_status compare_with_facet(const fmb_support *s, fmb_tight_search *e,
                                     const fmb_vec *normal, bool *same)
{
    fmb_integer_set_128(e->g.z[0], e->sum[s->n]);
    for (size_t j = 0; j < s->k; j++)
        fmb_integer_set_128(e->g.z[j + 1], fmb_i128_negative(e->sum[s->kept[j]]));
    fmb_status st = fmb_vec_set_z(&e->h, s->k + 1, e->g.z, e->num.mem);
    if (st == FMB_OK)
        st = fmb_vec_reduce(&e->h, s->k + 1, &e->num);
    *same = st == FMB_OK && fmb_vec_equal(&e->h, normal, s->k + 1);
    return st;
}

/* The sum is e->g, the facet a part of that. */
static fmb_status write_multipliers(const fmb_tight_search *e, const fmb_vec *normal,
                                    fmb_support_row *row)
{
    size_t j = 0;
    fmb_status st = FMB_OK;
    mpq_t part, factor;
    mpq_inits(part, factor, NULL);
    while (fmb_vec_sgn(normal, j) == 0)
        j++;
    fmb_vec_get(normal, j, mpq_numref(factor));
    mpz_set(mpq_denref(factor), e->g.z[j]);
    mpq_canonicalize(factor);
    for (size_t r = 0; st == FMB_OK && r < e->rows; r++) {
        fmb_integer_set_i64(mpq_numref(part), e->few.v[r]);
        mpz_set_ui(mpq_denref(part), 1);
        mpq_mul(part, part, factor);
        if (mpq_sgn(part) != 0)
            st = fmb_weights_add(&row->proof, e->row[r], part, e->num.mem);
    }
    mpq_clears(part, factor, NULL);
    return st;
}

fmb_status fmb_support_try_tight_rows(const fmb_support *s, fmb_support_worker *c,
                                      const fmb_facet *a, size_t noted, fmb_support_row *row,
                                      bool *stands)
{
    bool strict;
    *stands = false;
    if (!s->tight)
        return FMB_OK;
    fmb_status st = c->search ? FMB_OK : open_search(s, c);
    if (st != FMB_OK)
        return st;
    fmb_tight_search *e = c->search;
    if (!list_rows_tight_on_facet(s->tight, e, a, noted) || !find_multipliers(s->tight, e) ||
        !turn_multipliers(s->tight, e, &strict) || strict != s->strict || !combine_rows(s, e))
        return FMB_OK;
    st = compare_with_facet(s, e, &a->normal, stands);
    if (st != FMB_OK || !*stands)
        return st;
    row->rel = strict ? FMB_LT : FMB_LE;
    st = fmb_support_write_row(s, &a->normal, row, c->run->mem);
    return st == FMB_OK && s->proves ? write_multipliers(e, &a->normal, row) : st;
}
