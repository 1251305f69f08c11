/* elimination.c: see elimination.h; part of the trusted base, as check.c is. */
#include "proof/elimination.h"

#include <stdlib.h>
#include <string.h>

#include "num/bitset.h"
#include "system/system_private.h"

/* A product of integers counts as this many operations on words of sets. */
#define WORK_OF_PRODUCT 16

/* Two rows that may be combined, and the size of the set where their sum is positive. */
typedef struct row_pair {
    size_t p, q;
    size_t size; /* of the union of both sets */
} row_pair;

typedef struct pair_list {
    row_pair *pair;
    size_t size, capacity;
} pair_list;

/* ---- rows ------------------------------------------------------------------------------------ */

static fmb_status append_empty_row(fmb_elimination *e, fmb_rel rel)
{
    FMB_TRY(FMB_RESERVE(e->mem, &e->row, &e->capacity, e->rows + 1));
    fmb_eliminated_row *r = &e->row[e->rows++];
    *r = (fmb_eliminated_row){.rel = rel, .of = fmb_mem_zero(e->mem, e->words, sizeof *r->of)};
    return r->of ? fmb_integers_init(&r->z, e->dim + 1, e->mem) : fmb_mem_status(e->mem);
}

static void clear_row(fmb_elimination *e, fmb_eliminated_row *r)
{
    fmb_integers_clear(&r->z, e->mem);
    fmb_mem_put(e->mem, r->of, e->words, sizeof *r->of);
}

fmb_status fmb_elimination_open(fmb_elimination *e, const fmb_system *s, uint64_t most,
                                fmb_mem *mem, const fmb_poll *poll)
{
    *e = (fmb_elimination){.s = s, .mem = mem, .poll = poll, .most = most};
    e->dim = (size_t)fmb_system_dim(s);
    e->words = fmb_set_words(fmb_system_rows(s));
    mpz_inits(e->p, e->q, NULL);
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        const fmb_sysrow *from = fmb_system_row(s, i);
        FMB_TRY(append_empty_row(e, from->rel));
        fmb_eliminated_row *to = &e->row[i];
        fmb_sysrow_expand(from, e->dim, to->z.z);
        if (from->rel != FMB_EQ)
            fmb_set_put(to->of, i);
        FMB_TRY(fmb_integers_settle(&to->z, mem));
        FMB_TRY(fmb_poll_ask(poll));
    }
    return FMB_OK;
}

void fmb_elimination_close(fmb_elimination *e)
{
    for (size_t i = 0; i < e->rows; i++)
        clear_row(e, &e->row[i]);
    fmb_mem_put(e->mem, e->row, e->capacity, sizeof *e->row);
    mpz_clears(e->p, e->q, NULL);
}

/* to = |b_v| to - sgn(b_v) to_v b, in lowest terms: v vanishes, and `to` has a positive factor; so
 * has b if the signs of v in both differ. */
static fmb_status cancel_variable(fmb_elimination *e, fmb_integers *to, const fmb_integers *b,
                                  size_t v)
{
    mpz_abs(e->p, b->z[v]);
    mpz_set(e->q, to->z[v]);
    if (mpz_sgn(b->z[v]) > 0)
        mpz_neg(e->q, e->q);
    for (size_t j = 0; j <= e->dim; j++) {
        if (mpz_sgn(to->z[j]) != 0)
            mpz_mul(to->z[j], to->z[j], e->p);
        if (mpz_sgn(b->z[j]) != 0)
            mpz_addmul(to->z[j], b->z[j], e->q);
    }
    e->work += WORK_OF_PRODUCT * e->dim;
    FMB_TRY(fmb_integers_reduce(to->z, to->size, e->p, e->poll));
    FMB_TRY(fmb_integers_settle(to, e->mem));
    return fmb_poll_ask(e->poll);
}

/* ---- by an equality -------------------------------------------------------------------------- */

static fmb_status substitute(fmb_elimination *e, size_t equality, size_t v)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < e->rows; i++)
        if (i != equality && mpz_sgn(e->row[i].z.z[v]) != 0)
            st = cancel_variable(e, &e->row[i].z, &e->row[equality].z, v);
    clear_row(e, &e->row[equality]);
    e->rows--;
    memmove(e->row + equality, e->row + equality + 1, (e->rows - equality) * sizeof *e->row);
    return st;
}

/* ---- by pairs -------------------------------------------------------------------------------- */

static size_t count_union(const fmb_elimination *e, size_t p, size_t q)
{
    size_t size = 0;
    for (size_t w = 0; w < e->words; w++)
        size += fmb_ones64(e->row[p].of[w] | e->row[q].of[w]);
    return size;
}

/* List pairs of opposite sign that are positive in few enough places. *done false: too many. */
static fmb_status list_pairs(fmb_elimination *e, size_t v, pair_list *l, bool *done)
{
    for (size_t p = 0; p < e->rows; p++) {
        if (mpz_sgn(e->row[p].z.z[v]) <= 0)
            continue;
        for (size_t q = 0; q < e->rows; q++) {
            if (mpz_sgn(e->row[q].z.z[v]) >= 0)
                continue;
            row_pair pair = {p, q, count_union(e, p, q)};
            if (pair.size > e->pairings + 1)
                continue;
            FMB_TRY(FMB_RESERVE(e->mem, &l->pair, &l->capacity, l->size + 1));
            l->pair[l->size++] = pair;
        }
        e->work += e->rows * e->words;
        *done = e->work <= e->most;
        FMB_TRY(fmb_poll_ask(e->poll));
        if (!*done)
            return FMB_OK;
    }
    return FMB_OK;
}

/* Order by size of the union, smaller ones first. */
static int compare_pairs(const void *x, const void *y)
{
    const row_pair *a = x, *b = y;
    if (a->size != b->size)
        return a->size < b->size ? -1 : 1;
    if (a->p != b->p)
        return a->p < b->p ? -1 : 1;
    return (a->q > b->q) - (a->q < b->q);
}

/* Is some row without v, among all rows so far, positive only in places of this set? */
static bool covers_another(fmb_elimination *e, const uint64_t *set, size_t v)
{
    bool covers = false;
    for (size_t i = 0; !covers && i < e->rows; i++)
        covers = e->row[i].rel != FMB_EQ && mpz_sgn(e->row[i].z.z[v]) == 0 &&
                 fmb_set_is_inside(e->row[i].of, set, e->words);
    e->work += e->rows * e->words;
    return covers;
}

/* Append the sum of the pair as a new row unless it is not needed. */
static fmb_status add_pair(fmb_elimination *e, const row_pair *pair, size_t v, uint64_t *set)
{
    for (size_t w = 0; w < e->words; w++)
        set[w] = e->row[pair->p].of[w] | e->row[pair->q].of[w];
    if (covers_another(e, set, v))
        return FMB_OK;
    bool strict = e->row[pair->p].rel == FMB_LT || e->row[pair->q].rel == FMB_LT;
    FMB_TRY(append_empty_row(e, strict ? FMB_LT : FMB_LE));
    fmb_eliminated_row *sum = &e->row[e->rows - 1];
    memcpy(sum->of, set, e->words * sizeof *set);
    for (size_t j = 0; j <= e->dim; j++)
        if (mpz_sgn(e->row[pair->p].z.z[j]) != 0)
            mpz_set(sum->z.z[j], e->row[pair->p].z.z[j]);
    return cancel_variable(e, &sum->z, &e->row[pair->q].z, v);
}

static void drop_rows_with_variable(fmb_elimination *e, size_t v)
{
    size_t left = 0;
    for (size_t i = 0; i < e->rows; i++)
        if (mpz_sgn(e->row[i].z.z[v]) == 0)
            e->row[left++] = e->row[i];
        else
            clear_row(e, &e->row[i]);
    e->rows = left;
}

static fmb_status pair_rows(fmb_elimination *e, size_t v, bool *done)
{
    pair_list l = {0};
    uint64_t *set = fmb_mem_get(e->mem, e->words, sizeof *set);
    fmb_status st = set ? FMB_OK : fmb_mem_status(e->mem);
    e->pairings++;
    FMB_THEN(st, list_pairs(e, v, &l, done));
    if (l.size > 1)
        qsort(l.pair, l.size, sizeof *l.pair, compare_pairs);
    for (size_t i = 0; st == FMB_OK && *done && i < l.size; i++) {
        st = add_pair(e, &l.pair[i], v, set);
        *done = e->work <= e->most;
    }
    if (st == FMB_OK && *done)
        drop_rows_with_variable(e, v);
    fmb_mem_put(e->mem, l.pair, l.capacity, sizeof *l.pair);
    fmb_mem_put(e->mem, set, e->words, sizeof *set);
    return st;
}

fmb_status fmb_elimination_go_on(fmb_elimination *e, size_t variable, bool *done)
{
    size_t equality = 0;
    e->work += e->rows;
    *done = e->work <= e->most;
    while (equality < e->rows &&
           !(e->row[equality].rel == FMB_EQ && mpz_sgn(e->row[equality].z.z[variable]) != 0))
        equality++;
    if (!*done)
        return FMB_OK;
    return equality < e->rows ? substitute(e, equality, variable) : pair_rows(e, variable, done);
}
