/* fmplex_path.c: nodes and their rows; see fmplex_path.h. */
#include "elim/fmplex_path.h"

#include <assert.h>
#include <string.h>

static bool is_constant(const fmb_plexpath *g, const fmb_plexrow *r)
{
    for (size_t j = 0; j < (size_t)g->n; j++)
        if (fmb_vec_sgn(&r->v, j) != 0)
            return false;
    return true;
}

/* Coefficient of d; systems without strict rows have no such column. */
static int delta_sgn(const fmb_plexpath *g, const fmb_plexrow *r)
{
    size_t at = (size_t)g->n + 1;
    return at < g->length ? fmb_vec_sgn(&r->v, at) : 0;
}

/* Is the constant row s d <= b false for all small d > 0? */
static bool is_false(const fmb_plexpath *g, const fmb_plexrow *r)
{
    int b = fmb_vec_sgn(&r->v, (size_t)g->n);
    return r->equality ? b != 0 : b < 0 || (b == 0 && delta_sgn(g, r) > 0);
}

void fmb_plexpath_cap(const fmb_plexpath *g, fmb_plexnode *at, const fmb_plexrow *r)
{
    mpq_t cap;
    int b = fmb_vec_sgn(&r->v, (size_t)g->n);
    if (b == 0 || delta_sgn(g, r) != b)
        return;
    mpq_init(cap);
    fmb_vec_get(&r->v, (size_t)g->n, mpq_numref(cap));
    fmb_vec_get(&r->v, (size_t)g->n + 1, mpq_denref(cap));
    mpq_canonicalize(cap);
    if (!at->capped || mpq_cmp(cap, at->cap) < 0)
        mpq_set(at->cap, cap);
    at->capped = true;
    mpq_clear(cap);
}

/* ---- nodes ----------------------------------------------------------------------------------- */

/* Room for `made` new rows, and `lives` live ones. No other node looks into this one now. */
static fmb_status reserve(fmb_plexpath *g, fmb_plexnode *at, size_t lives, size_t made)
{
    fmb_mem *mem = g->run->mem;
    size_t words;
    if (__builtin_mul_overflow(made, g->length, &words))
        return FMB_ERR_MEMORY;
    fmb_status st =
        fmb_mem_reserve(mem, (void **)&at->live, &at->live_capacity, lives, sizeof *at->live);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&at->made, &at->made_capacity, made, sizeof *at->made);
    if (st == FMB_OK)
        st =
            fmb_mem_reserve(mem, (void **)&at->words, &at->word_capacity, words, sizeof *at->words);
    return st;
}

static void empty(fmb_plexpath *g, fmb_plexnode *at)
{
    for (size_t i = 0; i < at->mades; i++)
        fmb_vec_clear(&at->made[i].v, g->length, g->run->mem);
    g->held -= at->mades;
    at->mades = at->lives = 0;
    at->capped = false;
    at->via = NULL;
}

void fmb_plexpath_leave(fmb_plexpath *g, int d)
{
    while (g->depth > d)
        empty(g, &g->node[g->depth--]);
    g->clash = NULL;
}

/* A row of zeros at the end of a node's rows, not live yet. */
static fmb_plexrow *open_row(fmb_plexpath *g, fmb_plexnode *at)
{
    assert(at->mades < at->made_capacity);
    fmb_plexrow *r = &at->made[at->mades];
    *r = (fmb_plexrow){.node = g->depth, .v = {.s = at->words + at->mades * g->length}};
    memset(r->v.s, 0, g->length * sizeof *r->v.s);
    at->mades++;
    g->held++;
    return r;
}

/* A row that names a variable becomes live, a false one the clash; others go. */
static void close_row(fmb_plexpath *g, fmb_plexnode *at, fmb_plexrow *r)
{
    if (!is_constant(g, r)) {
        at->live[at->lives++] = r;
        return;
    }
    if (is_false(g, r)) {
        g->clash = r;
        return;
    }
    fmb_plexpath_cap(g, at, r);
    if (r->p) {
        fmb_vec_clear(&r->v, g->length, g->run->mem);
        at->mades--;
        g->held--;
    }
}

/* Row r of the node above, with var cancelled by its via. */
static fmb_status combine(fmb_plexpath *g, fmb_plexnode *at, const fmb_plexnode *above,
                          fmb_plexrow *r)
{
    fmb_plexrow *made = open_row(g, at);
    made->p = r;
    made->q = above->via;
    made->equality = r->equality;
    fmb_status st =
        fmb_vec_cancel(&made->v, &r->v, &above->via->v, g->length, (size_t)above->var, &g->num);
    if (st != FMB_OK)
        return st;
    g->run->stats.rows_made++;
    close_row(g, at, made);
    st = fmb_run_rows(g->run, g->held);
    return st != FMB_OK ? st : fmb_run_poll(g->run);
}

fmb_status fmb_plexpath_descend(fmb_plexpath *g)
{
    fmb_plexnode *above = &g->node[g->depth], *at = above + 1;
    size_t column = (size_t)above->var, naming = 0;
    for (size_t i = 0; i < above->lives; i++)
        naming += fmb_vec_sgn(&above->live[i]->v, column) != 0;
    fmb_status st = reserve(g, at, above->lives, above->via ? naming : 0);
    g->depth++;
    g->run->stats.rounds++;
    for (size_t i = 0; st == FMB_OK && !g->clash && i < above->lives; i++) {
        fmb_plexrow *r = above->live[i];
        if (fmb_vec_sgn(&r->v, column) == 0) {
            at->live[at->lives++] = r;
        } else if (above->via && r != above->via) {
            g->run->stats.pairs++;
            st = combine(g, at, above, r);
        }
    }
    return st;
}

/* ---- the root -------------------------------------------------------------------------------- */

static fmb_status load_row(fmb_plexpath *g, const fmb_vec *row, fmb_rel rel)
{
    fmb_plexrow *r = open_row(g, &g->node[0]);
    size_t given = (size_t)g->n + 1;
    fmb_status st = FMB_OK;
    r->equality = rel == FMB_EQ;
    if (fmb_vec_is_wide(row) || g->num.wide_only) {
        st = fmb_vec_widen(&r->v, g->length, g->run->mem);
        for (size_t j = 0; st == FMB_OK && j < given; j++)
            fmb_vec_get(row, j, r->v.z[j]);
        if (st == FMB_OK && rel == FMB_LT)
            mpz_set_ui(r->v.z[given], 1);
        if (st == FMB_OK)
            st = fmb_vec_settle(&r->v, g->length, g->run->mem);
    } else {
        memcpy(r->v.s, row->s, given * sizeof *r->v.s);
        if (rel == FMB_LT)
            r->v.s[given] = 1;
        fmb_vec_measure(&r->v, g->length);
    }
    if (st == FMB_OK)
        close_row(g, &g->node[0], r);
    return st != FMB_OK ? st : fmb_run_poll(g->run);
}

/* The arrays whose size never changes. */
static fmb_status open_path(fmb_plexpath *g, fmb_arena *arena)
{
    size_t n = (size_t)g->n;
    g->lower = fmb_arena_get(arena, n, sizeof *g->lower);
    g->upper = fmb_arena_get(arena, n, sizeof *g->upper);
    g->equal = fmb_arena_get(arena, n, sizeof *g->equal);
    g->active = fmb_arena_get(arena, n + 3, sizeof *g->active);
    mpq_t *weight = fmb_arena_get(arena, n + 3, sizeof *weight);
    fmb_plexnode *node = fmb_arena_get(arena, n + 1, sizeof *node);
    if (!g->lower || !g->upper || !g->equal || !g->active || !weight || !node)
        return fmb_mem_status(arena->mem);
    for (size_t i = 0; i < n + 3; i++)
        mpq_init(weight[i]);
    for (size_t d = 0; d <= n; d++) {
        node[d] = (fmb_plexnode){0};
        mpq_init(node[d].cap);
    }
    g->weight = weight;
    g->node = node;
    return FMB_OK;
}

fmb_status fmb_plexpath_init(fmb_plexpath *g, fmb_run *run, fmb_arena *arena, int n, size_t m,
                             const fmb_vec *row, const fmb_rel *rel, const fmb_options *o)
{
    *g = (fmb_plexpath){.run = run, .n = n, .length = (size_t)n + 1, .order = o->order};
    for (size_t i = 0; i < m && g->length == (size_t)n + 1; i++)
        g->length += rel[i] == FMB_LT;
    mpz_inits(g->alpha, g->beta, g->t, g->u, NULL);
    mpq_inits(g->content, g->share, NULL);
    fmb_status st = fmb_num_init(&g->num, run->mem, g->length, o->arith == FMB_ARITH_GMP);
    if (st == FMB_OK)
        st = open_path(g, arena);
    if (st == FMB_OK)
        st = reserve(g, &g->node[0], m, m);
    for (size_t i = 0; st == FMB_OK && !g->clash && i < m; i++)
        st = load_row(g, &row[i], rel[i]);
    return st != FMB_OK ? st : fmb_run_rows(run, g->held);
}

void fmb_plexpath_clear(fmb_plexpath *g)
{
    fmb_mem *mem = g->run->mem;
    for (int d = 0; g->node && d <= g->n; d++) {
        fmb_plexnode *at = &g->node[d];
        empty(g, at);
        fmb_mem_put(mem, at->live, at->live_capacity, sizeof *at->live);
        fmb_mem_put(mem, at->made, at->made_capacity, sizeof *at->made);
        fmb_mem_put(mem, at->words, at->word_capacity, sizeof *at->words);
        mpq_clear(at->cap);
    }
    for (size_t i = 0; g->weight && i < (size_t)g->n + 3; i++)
        mpq_clear(g->weight[i]);
    mpz_clears(g->alpha, g->beta, g->t, g->u, NULL);
    mpq_clears(g->content, g->share, NULL);
    g->run->stats.promotions += g->num.promotions;
    fmb_num_clear(&g->num);
}
