/* prune.c: what the rules say at the end of a round; keeps history rules and the others apart. */
#include <string.h>

#include "elim/elim.h"

/* The live rows as a rule sees them, made primitive; belongs to run->mem. */
static fmb_status look(fmb_elim *e, fmb_live **out)
{
    fmb_live *w = fmb_mem_get(e->run->mem, e->lives, sizeof *w);
    fmb_status st = w ? FMB_OK : fmb_mem_status(e->run->mem);
    for (size_t i = 0; st == FMB_OK && i < e->lives; i++) {
        fmb_derived *r = &e->row[e->live[i]];
        st = fmb_vec_reduce(&r->v, (size_t)e->n + 1, &e->num);
        w[i] = (fmb_live){&r->v, r->history, r->strict, r->equality};
    }
    if (st == FMB_OK)
        *out = w;
    else
        fmb_mem_put(e->run->mem, w, e->lives, sizeof *w);
    return st;
}

/* A rule that breaks histories costs Kohler's count, which starts anew: worth it for many rows
 * only. */
static bool pays(const fmb_elim *e, const fmb_rule *rule, size_t marked)
{
    bool breaks = (rule->flags & FMB_RULE_BREAKS_HISTORY) != 0;
    return marked > 0 && (!breaks || !e->histories || 4 * marked >= e->lives);
}

/* With few rows it cannot: the rows are not even looked at. */
#define WORTH_LOOKING 32

static bool can_pay(const fmb_elim *e, const fmb_rule *rule)
{
    bool breaks = (rule->flags & FMB_RULE_BREAKS_HISTORY) != 0;
    return rule->end_round && e->lives > 0 &&
           (!breaks || !e->histories || e->lives >= WORTH_LOOKING);
}

static void drop_marked(fmb_elim *e, const bool *drop)
{
    size_t left = 0;
    for (size_t i = 0; i < e->lives; i++)
        if (!drop[i])
            e->live[left++] = e->live[i];
    e->run->stats.rows_dropped += e->lives - left;
    e->lives = left;
}

static fmb_status apply(fmb_elim *e, const fmb_rule *rule, const fmb_live *rows, int var)
{
    fmb_mem *mem = e->run->mem;
    size_t before = e->lives, marked = 0;
    fmb_view w = {e->n, e->since, e->words, e->lives, rows};
    bool *drop = fmb_mem_zero(mem, before, sizeof *drop);
    if (!drop)
        return fmb_mem_status(mem);
    fmb_status st = rule->end_round(rule->state, &w, mem, drop, &marked);
    if (st == FMB_OK && pays(e, rule, marked)) {
        drop_marked(e, drop);
        if (rule->flags & FMB_RULE_BREAKS_HISTORY)
            e->based = false;
        fmb_run_emit(e->run, (fmb_event){.kind = FMB_EVENT_RULE,
                                         .round = e->rounds,
                                         .var = var,
                                         .rows_in = before,
                                         .rows_out = e->lives,
                                         .name = rule->name});
    }
    fmb_mem_put(mem, drop, before, sizeof *drop);
    return st;
}

fmb_status fmb_elim_prune(fmb_elim *e, int var)
{
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < e->rules; k++) {
        if (!can_pay(e, e->rule[k]))
            continue;
        size_t seen = e->lives;
        fmb_live *rows;
        if ((st = look(e, &rows)) != FMB_OK)
            return st;
        st = apply(e, e->rule[k], rows, var);
        fmb_mem_put(e->run->mem, rows, seen, sizeof *rows);
    }
    return st;
}
