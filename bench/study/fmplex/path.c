/* path.c: nodes and their rows; see path.h. */
#include "study/fmplex/path.h"

#include <assert.h>
#include <string.h>

static bool is_constant(const study_plexpath *g, const study_plexrow *r)
{
    for (size_t j = 0; j < (size_t)g->n; j++)
        if (fmb_vec_sgn(&r->v, j) != 0)
            return false;
    return true;
}

/* Coefficient of d; systems without strict rows have no such column. */
static int delta_sgn(const study_plexpath *g, const study_plexrow *r)
{
    size_t at = (size_t)g->n + 1;
    return at < g->length ? fmb_vec_sgn(&r->v, at) : 0;
}

/* Is the constant row s d <= b false for all small d > 0? */
static bool is_false(const study_plexpath *g, const study_plexrow *r)
{
    int b = fmb_vec_sgn(&r->v, (size_t)g->n);
    return r->equality ? b != 0 : b < 0 || (b == 0 && delta_sgn(g, r) > 0);
}

void study_plexpath_cap(const study_plexpath *g, study_plexnode *at, const study_plexrow *r)
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

/* Room for new rows. No other node points into this one now. */
static fmb_status reserve(study_plexpath *g, study_plexnode *at, size_t rows)
{
    fmb_mem *mem = g->run->mem;
    size_t words;
    if (__builtin_mul_overflow(rows, g->length, &words))
        return FMB_ERR_MEMORY;
    fmb_status st =
        fmb_mem_reserve(mem, (void **)&at->made, &at->made_capacity, rows, sizeof *at->made);
    if (st == FMB_OK)
        st =
            fmb_mem_reserve(mem, (void **)&at->words, &at->word_capacity, words, sizeof *at->words);
    return st;
}

/* A row begins (by = 1) or ceases (by = -1) to be live in the current node. */
static void count(const study_plexpath *g, const study_plexrow *r, int by)
{
    for (size_t j = 0; j < (size_t)g->n; j++) {
        int sign = fmb_vec_sgn(&r->v, j);
        size_t *of = r->equality ? g->equal : sign < 0 ? g->lower : g->upper;
        if (sign != 0)
            of[j] += (size_t)by;
    }
}

static void empty(study_plexpath *g, study_plexnode *at)
{
    for (size_t i = 0; i < at->mades; i++)
        fmb_vec_clear(&at->made[i].v, g->length, g->run->mem);
    g->held -= at->mades;
    at->mades = at->lives = at->filled = 0;
    at->capped = false;
    at->via = NULL;
}

/* Back to the node above: restores its counts. */
static void ascend(study_plexpath *g)
{
    study_plexnode *at = &g->node[g->depth--], *above = &g->node[g->depth];
    for (size_t i = 0; i < at->filled; i++) {
        bool is_live = i<at->lives, is_own = at->live[i]->node> g->depth;
        if (is_live == is_own)
            count(g, at->live[i], is_live ? -1 : 1);
    }
    for (size_t i = 0; i < above->lives; i++)
        if (fmb_vec_sgn(&above->live[i]->v, (size_t)above->var) != 0)
            count(g, above->live[i], 1);
    empty(g, at);
}

void study_plexpath_leave(study_plexpath *g, int d)
{
    while (g->depth > d)
        ascend(g);
    g->clash = NULL;
}

static void enliven(study_plexnode *at, study_plexrow *r)
{
    at->live[at->lives++] = r;
    at->filled = at->lives;
}

void study_plexpath_drop(study_plexpath *g)
{
    study_plexnode *at = &g->node[g->depth];
    size_t i = 0;
    while (at->live[i] != at->via)
        i++;
    at->live[i] = at->live[--at->lives];
    at->live[at->lives] = at->via;
    count(g, at->via, -1);
}

/* A row of zeros at the end of a node's rows, not live yet. */
static study_plexrow *open_row(study_plexpath *g, study_plexnode *at)
{
    assert(at->mades < at->made_capacity);
    study_plexrow *r = &at->made[at->mades];
    *r = (study_plexrow){.node = g->depth, .v = {.s = at->words + at->mades * g->length}};
    memset(r->v.s, 0, g->length * sizeof *r->v.s);
    at->mades++;
    g->held++;
    return r;
}

/* A row that names a variable becomes live, a false one the clash; true ones are dropped. */
static void close_row(study_plexpath *g, study_plexnode *at, study_plexrow *r)
{
    if (!is_constant(g, r)) {
        enliven(at, r);
        count(g, r, 1);
        return;
    }
    if (is_false(g, r)) {
        g->clash = r;
        return;
    }
    study_plexpath_cap(g, at, r);
    if (r->p) {
        fmb_vec_clear(&r->v, g->length, g->run->mem);
        at->mades--;
        g->held--;
    }
}

/* Row r of the node above, with var cancelled by its via. */
static fmb_status combine(study_plexpath *g, study_plexnode *at, const study_plexnode *above,
                          study_plexrow *r)
{
    study_plexrow *made = open_row(g, at);
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

/* Rows without var are inherited. Returns the number of the others. */
static size_t inherit(study_plexpath *g, study_plexnode *at, const study_plexnode *above)
{
    size_t gone = 0;
    for (size_t i = 0; i < above->lives; i++) {
        study_plexrow *r = above->live[i];
        if (fmb_vec_sgn(&r->v, (size_t)above->var) == 0) {
            enliven(at, r);
        } else {
            count(g, r, -1);
            gone++;
        }
    }
    return gone;
}

fmb_status study_plexpath_descend(study_plexpath *g)
{
    study_plexnode *above = &g->node[g->depth], *at = above + 1;
    fmb_mem *mem = g->run->mem;
    fmb_status st = fmb_mem_reserve(mem, (void **)&at->live, &at->live_capacity, above->lives,
                                    sizeof *at->live);
    if (st != FMB_OK)
        return st;
    g->depth++;
    g->run->stats.rounds++;
    size_t gone = inherit(g, at, above);
    if (above->via)
        st = reserve(g, at, gone);
    for (size_t i = 0; above->via && st == FMB_OK && !g->clash && i < above->lives; i++) {
        study_plexrow *r = above->live[i];
        if (r == above->via || fmb_vec_sgn(&r->v, (size_t)above->var) == 0)
            continue;
        g->run->stats.pairs++;
        st = combine(g, at, above, r);
    }
    return st == FMB_OK ? fmb_run_poll(g->run) : st;
}

/* ---- the root -------------------------------------------------------------------------------- */

static fmb_status load_row(study_plexpath *g, const fmb_vec *row, fmb_rel rel)
{
    study_plexrow *r = open_row(g, &g->node[0]);
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
static fmb_status open_path(study_plexpath *g, fmb_arena *arena)
{
    size_t n = (size_t)g->n;
    g->lower = fmb_arena_get(arena, 3 * n, sizeof *g->lower);
    g->active = fmb_arena_get(arena, n + 3, sizeof *g->active);
    mpz_t *weight = fmb_arena_get(arena, n + 3, sizeof *weight);
    study_plexnode *node = fmb_arena_get(arena, n + 1, sizeof *node);
    if (!g->lower || !g->active || !weight || !node)
        return fmb_mem_status(arena->mem);
    memset(g->lower, 0, 3 * n * sizeof *g->lower);
    g->upper = g->lower + n;
    g->equal = g->upper + n;
    for (size_t i = 0; i < n + 3; i++)
        mpz_init(weight[i]);
    for (size_t d = 0; d <= n; d++) {
        node[d] = (study_plexnode){0};
        mpq_init(node[d].cap);
    }
    g->weight = weight;
    g->node = node;
    return FMB_OK;
}

fmb_status study_plexpath_init(study_plexpath *g, fmb_run *run, fmb_arena *arena, int n, size_t m,
                               const fmb_vec *row, const fmb_rel *rel, const fmb_options *o)
{
    *g = (study_plexpath){.run = run, .n = n, .length = (size_t)n + 1, .order = o->order};
    for (size_t i = 0; i < m && g->length == (size_t)n + 1; i++)
        g->length += rel[i] == FMB_LT;
    mpz_inits(g->alpha, g->beta, g->content, g->part, g->t, NULL);
    fmb_status st = fmb_num_init(&g->num, run->mem, g->length, o->arith == FMB_ARITH_GMP);
    if (st == FMB_OK)
        st = open_path(g, arena);
    if (st == FMB_OK)
        st = fmb_mem_reserve(run->mem, (void **)&g->node[0].live, &g->node[0].live_capacity, m,
                             sizeof *g->node[0].live);
    if (st == FMB_OK)
        st = reserve(g, &g->node[0], m);
    for (size_t i = 0; st == FMB_OK && !g->clash && i < m; i++)
        st = load_row(g, &row[i], rel[i]);
    return st != FMB_OK ? st : fmb_run_rows(run, g->held);
}

void study_plexpath_clear(study_plexpath *g)
{
    fmb_mem *mem = g->run->mem;
    for (int d = 0; g->node && d <= g->n; d++) {
        study_plexnode *at = &g->node[d];
        empty(g, at);
        fmb_mem_put(mem, at->live, at->live_capacity, sizeof *at->live);
        fmb_mem_put(mem, at->made, at->made_capacity, sizeof *at->made);
        fmb_mem_put(mem, at->words, at->word_capacity, sizeof *at->words);
        mpq_clear(at->cap);
    }
    for (size_t i = 0; g->weight && i < (size_t)g->n + 3; i++)
        mpz_clear(g->weight[i]);
    mpz_clears(g->alpha, g->beta, g->content, g->part, g->t, NULL);
    g->run->stats.promotions += g->num.promotions;
    fmb_num_clear(&g->num);
}
