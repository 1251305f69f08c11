/* elim.c: the store and the rounds; see elim.h. */
#include "elim/elim.h"

#include <string.h>

fmb_status fmb_elim_init(fmb_elim *e, fmb_run *run, fmb_arena *arena, int n, const fmb_options *o,
                         const fmb_rule *const *rule, int rules)
{
    *e = (fmb_elim){.run = run, .arena = arena, .n = n, .order = o->order, .clash = FMB_NO_ROW};
    for (int i = 0; i < rules; i++) {
        e->rule[e->rules++] = rule[i];
        e->histories |= (rule[i]->flags & FMB_RULE_NEEDS_HISTORY) != 0;
    }
    e->round = fmb_arena_get(arena, (size_t)n, sizeof *e->round);
    if (!e->round)
        return fmb_mem_status(arena->mem);
    return fmb_num_init(&e->num, run->mem, (size_t)n + 1, o->arith == FMB_ARITH_GMP);
}

void fmb_elim_clear(fmb_elim *e)
{
    fmb_mem *mem = e->run->mem;
    for (size_t i = 0; i < e->rows; i++)
        fmb_vec_clear(&e->row[i].v, (size_t)e->n + 1, mem);
    e->run->stats.promotions += e->num.promotions;
    fmb_num_clear(&e->num);
}

/* An empty row at the end of the store, not counted yet. */
static fmb_status open_row(fmb_elim *e, fmb_derived **out)
{
    fmb_status st = fmb_arena_reserve(e->arena, (void **)&e->row, &e->row_capacity, e->rows + 1,
                                      sizeof *e->row);
    if (st != FMB_OK)
        return st;
    if (e->rows >= FMB_NO_ROW)
        return FMB_ERR_MEMORY;
    fmb_derived *r = &e->row[e->rows];
    *r = (fmb_derived){.p = FMB_NO_ROW, .q = FMB_NO_ROW, .col = -1};
    r->v.s = e->spare ? e->spare : fmb_arena_get(e->arena, (size_t)e->n + 1, sizeof *r->v.s);
    if (!r->v.s)
        return fmb_mem_status(e->arena->mem);
    e->spare = NULL;
    *out = r;
    return FMB_OK;
}

/* Does the row name no variable? */
static bool is_constant(const fmb_elim *e, const fmb_derived *r)
{
    for (int j = 0; j < e->n; j++)
        if (fmb_vec_sgn(&r->v, (size_t)j) != 0)
            return false;
    return true;
}

/* Is the constant row 0 REL b false? */
static bool is_false(const fmb_elim *e, const fmb_derived *r)
{
    int b = fmb_vec_sgn(&r->v, (size_t)e->n);
    return r->equality ? b != 0 : r->strict ? b <= 0 : b < 0;
}

/* Count the row at the end of the store: live or false; a combination that says nothing is dropped.
 */
static fmb_status close_row(fmb_elim *e, uint32_t **list, size_t *count, size_t *capacity)
{
    fmb_derived *r = &e->row[e->rows];
    if (is_constant(e, r)) {
        if (is_false(e, r))
            e->clash = (uint32_t)e->rows;
        if (is_false(e, r) || r->p == FMB_NO_ROW) {
            e->rows++;
            return FMB_OK;
        }
        fmb_vec_clear(&r->v, (size_t)e->n + 1, e->run->mem);
        e->spare = r->v.s;
        return FMB_OK;
    }
    fmb_status st = fmb_arena_reserve(e->arena, (void **)list, capacity, *count + 1, sizeof **list);
    if (st != FMB_OK) {
        fmb_vec_clear(&r->v, (size_t)e->n + 1, e->run->mem);
        return st;
    }
    (*list)[(*count)++] = (uint32_t)e->rows++;
    return FMB_OK;
}

fmb_status fmb_elim_add(fmb_elim *e, const fmb_vec *v, fmb_rel rel)
{
    fmb_derived *r = NULL;
    size_t n = (size_t)e->n + 1;
    fmb_status st = open_row(e, &r);
    if (st == FMB_OK)
        st = fmb_vec_copy(&r->v, v, n, e->run->mem);
    if (st == FMB_OK && e->num.wide_only)
        st = fmb_vec_widen(&r->v, n, e->run->mem);
    if (st != FMB_OK) {
        if (r)
            fmb_vec_clear(&r->v, n, e->run->mem);
        return st;
    }
    r->strict = rel == FMB_LT;
    r->equality = rel == FMB_EQ;
    return close_row(e, &e->live, &e->lives, &e->live_capacity);
}

static fmb_status union_history(fmb_elim *e, fmb_derived *r, const fmb_derived *p,
                                const fmb_derived *q)
{
    if (!e->histories || !e->based)
        return FMB_OK;
    r->history = fmb_arena_get(e->arena, e->words, sizeof *r->history);
    if (!r->history)
        return fmb_mem_status(e->arena->mem);
    for (size_t i = 0; i < e->words; i++)
        r->history[i] = p->history[i] | q->history[i];
    return FMB_OK;
}

fmb_status fmb_elim_combine(fmb_elim *e, uint32_t p, uint32_t q, int col)
{
    fmb_derived *r = NULL;
    fmb_status st = open_row(e, &r);
    if (st != FMB_OK)
        return st;
    const fmb_derived *a = &e->row[p], *b = &e->row[q];
    r->p = p;
    r->q = q;
    r->col = col;
    r->strict = a->strict || b->strict;
    r->equality = a->equality && b->equality;
    st = union_history(e, r, a, b);
    if (st == FMB_OK)
        st = fmb_vec_cancel(&r->v, &a->v, &b->v, (size_t)e->n + 1, (size_t)col, &e->num);
    if (st == FMB_OK && e->budget > 0 && e->rows >= e->budget) {
        e->over_budget = true;
        st = FMB_LIMIT;
    }
    if (st != FMB_OK) {
        fmb_vec_clear(&r->v, (size_t)e->n + 1, e->run->mem);
        return st;
    }
    e->run->stats.rows_made++;
    st = close_row(e, &e->next, &e->nexts, &e->next_capacity);
    if (st == FMB_OK)
        st = fmb_run_rows(e->run, e->nexts);
    return st != FMB_OK ? st : fmb_run_poll(e->run);
}

static fmb_status keep(fmb_elim *e, uint32_t r)
{
    fmb_status st = fmb_arena_reserve(e->arena, (void **)&e->next, &e->next_capacity, e->nexts + 1,
                                      sizeof *e->next);
    if (st == FMB_OK)
        e->next[e->nexts++] = r;
    return st;
}

/* Live rows become their own histories: row i of the live list is base row i. */
static fmb_status rebase(fmb_elim *e)
{
    e->based = true;
    e->since = 0;
    if (!e->histories)
        return FMB_OK;
    e->words = (e->lives + 63) / 64;
    for (size_t i = 0; i < e->lives; i++) {
        uint64_t *h = fmb_arena_get(e->arena, e->words, sizeof *h);
        if (!h)
            return fmb_mem_status(e->arena->mem);
        memset(h, 0, e->words * sizeof *h);
        h[i / 64] = (uint64_t)1 << (i % 64);
        e->row[e->live[i]].history = h;
        fmb_status st = fmb_run_poll(e->run);
        if (st != FMB_OK)
            return st;
    }
    return FMB_OK;
}

/* ---- one round ------------------------------------------------------------------------------- */

/* The equality with var in it that is cheapest to substitute (fewest nonzeros), or FMB_NO_ROW. */
static uint32_t find_equality(const fmb_elim *e, int var)
{
    uint32_t best = FMB_NO_ROW;
    int best_size = 0;
    for (size_t i = 0; i < e->lives; i++) {
        const fmb_derived *r = &e->row[e->live[i]];
        if (!r->equality || fmb_vec_sgn(&r->v, (size_t)var) == 0)
            continue;
        int size = r->v.z != NULL ? e->n : 0;
        for (int j = 0; j < e->n; j++)
            size += fmb_vec_sgn(&r->v, (size_t)j) != 0;
        if (best == FMB_NO_ROW || size < best_size) {
            best = e->live[i];
            best_size = size;
        }
    }
    return best;
}

/* Use the equality q to remove var from every other row. Histories start anew: what follows is a
 * smaller system with the same solutions, whose rows are not combinations of pairs. */
static fmb_status substitute(fmb_elim *e, uint32_t q, int var)
{
    fmb_status st = FMB_OK;
    fmb_round *round = &e->round[e->rounds];
    round->row[0] = q;
    round->rows = 1;
    round->equality = true;
    e->based = false;
    for (size_t i = 0; st == FMB_OK && e->clash == FMB_NO_ROW && i < e->lives; i++) {
        uint32_t p = e->live[i];
        if (p == q)
            continue;
        bool has = fmb_vec_sgn(&e->row[p].v, (size_t)var) != 0;
        st = has ? fmb_elim_combine(e, p, q, var) : keep(e, p);
    }
    return st;
}

/* May the combination of p and q be left out? */
static bool is_dropped(const fmb_elim *e, const fmb_view *w, uint32_t p, uint32_t q)
{
    for (int k = 0; k < e->rules; k++)
        if (e->rule[k]->drop_pair && e->rule[k]->drop_pair(w, e->row[p].history, e->row[q].history))
            return true;
    return false;
}

/* Combine every lower with every upper row of a round; lowers come first in it. */
static fmb_status pair_rows(fmb_elim *e, const fmb_round *round, size_t lowers)
{
    fmb_view w = {.n = e->n, .eliminated = e->since, .words = e->words};
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < lowers; i++) {
        for (size_t j = lowers; j < round->rows; j++) {
            uint32_t p = round->row[i], q = round->row[j];
            e->run->stats.pairs++;
            if (is_dropped(e, &w, p, q)) {
                e->run->stats.rows_dropped++;
                st = fmb_run_poll(e->run);
            } else {
                st = fmb_elim_combine(e, p, q, round->var);
            }
            if (st != FMB_OK || e->clash != FMB_NO_ROW)
                return st;
        }
    }
    return st;
}

/* Does no row of the round name another variable? */
static bool is_last(const fmb_elim *e, const fmb_round *round)
{
    for (size_t i = 0; i < round->rows; i++)
        for (int j = 0; j < e->n; j++)
            if (j != round->var && fmb_vec_sgn(&e->row[round->row[i]].v, (size_t)j) != 0)
                return false;
    return true;
}

/* Remove var by pairing. A column of one sign only makes no pairs: its rows go, and histories stay
 * as they are, since the rest is what the elimination of the other variables alone would give. */
static fmb_status pair(fmb_elim *e, int var)
{
    fmb_round *round = &e->round[e->rounds];
    fmb_status st = FMB_OK;
    size_t lowers = 0, rows = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        for (size_t i = 0; i < e->lives; i++)
            if (fmb_vec_sgn(&e->row[e->live[i]].v, (size_t)var) == sign)
                round->row[rows++] = e->live[i];
        lowers = sign < 0 ? rows : lowers;
    }
    round->rows = rows;
    round->equality = false;
    for (size_t i = 0; st == FMB_OK && i < e->lives; i++)
        if (fmb_vec_sgn(&e->row[e->live[i]].v, (size_t)var) == 0)
            st = keep(e, e->live[i]);
    if (st != FMB_OK || lowers == 0 || lowers == rows)
        return st;
    if (!e->based && (st = rebase(e)) != FMB_OK)
        return st;
    e->since++;
    e->run->stats.rounds++;
    return is_last(e, round) ? fmb_elim_squeeze(e, round, lowers) : pair_rows(e, round, lowers);
}

static fmb_status eliminate(fmb_elim *e, int var)
{
    fmb_round *round = &e->round[e->rounds];
    uint64_t pairs = e->run->stats.pairs;
    *round = (fmb_round){.var = var};
    round->row = fmb_arena_get(e->arena, e->lives, sizeof *round->row);
    if (!round->row)
        return fmb_mem_status(e->arena->mem);
    e->nexts = 0;
    uint32_t q = find_equality(e, var);
    fmb_status st = q != FMB_NO_ROW ? substitute(e, q, var) : pair(e, var);
    if (st != FMB_OK)
        return st;
    e->rounds++;
    fmb_run_emit(e->run, (fmb_event){.kind = FMB_EVENT_ROUND,
                                     .round = e->rounds,
                                     .var = var,
                                     .rows_in = e->lives,
                                     .rows_out = e->nexts,
                                     .pairs = e->run->stats.pairs - pairs});
    uint32_t *list = e->live;
    size_t capacity = e->live_capacity;
    e->live = e->next;
    e->lives = e->nexts;
    e->live_capacity = e->next_capacity;
    e->next = list;
    e->next_capacity = capacity;
    return e->clash == FMB_NO_ROW && round->rows > 1 ? fmb_elim_prune(e, var) : FMB_OK;
}

fmb_status fmb_elim_eliminate(fmb_elim *e, const bool *drop)
{
    fmb_status st = fmb_run_poll_now(e->run);
    for (int var; st == FMB_OK && e->clash == FMB_NO_ROW;) {
        var = fmb_elim_choose(e, drop);
        if (var < 0)
            break;
        st = eliminate(e, var);
    }
    return st;
}
