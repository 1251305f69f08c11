/* prune.c: what the rules say at the end of a round; keeps history rules and the others apart. */
#include <string.h>

#include "elim/view.h"

static bool breaks_histories(const fmb_elim *e, const fmb_rule *rule)
{
    return e->histories && (rule->flags & FMB_RULE_BREAKS_HISTORY) != 0;
}

/* A rule that breaks histories costs Kohler's count, which starts anew: worth it for many rows
 * only. */
static bool pays(const fmb_elim *e, const fmb_rule *rule, size_t marked)
{
    bool always = !breaks_histories(e, rule) || e->rebase == FMB_REBASE_ALWAYS;
    return marked > 0 && (always || 4 * marked >= e->live.size);
}

/* With few rows it cannot: the rows are not even looked at. */
#define WORTH_LOOKING 32

static bool can_pay(const fmb_elim *e, const fmb_rule *rule)
{
    bool always = !breaks_histories(e, rule) || e->rebase == FMB_REBASE_ALWAYS;
    return rule->end_round && e->live.size > 0 && (always || e->live.size >= WORTH_LOOKING);
}

static size_t drop_marked(fmb_elim *e, const bool *drop)
{
    size_t left = 0, before = e->live.size;
    for (size_t i = 0; i < before; i++)
        if (!drop[i])
            e->live.row[left++] = e->live.row[i];
    e->run->stats.rows_dropped += before - left;
    e->live.size = left;
    return before - left;
}

static fmb_status apply(fmb_elim *e, fmb_worker *worker, int var)
{
    fmb_mem *mem = e->run->mem;
    size_t rows = e->live.size, marked = 0;
    fmb_window w;
    bool *drop = fmb_mem_zero(mem, rows, sizeof *drop);
    if (!drop)
        return fmb_mem_status(mem);
    fmb_window_open(&w, e, var);
    fmb_status said = worker->rule->end_round(worker->state, &w.view, drop);
    fmb_status st = fmb_window_close(&w);
    st = st != FMB_OK ? st : said;
    for (size_t i = 0; i < rows; i++)
        marked += drop[i];
    if (st == FMB_OK && pays(e, worker->rule, marked)) {
        worker->dropped += drop_marked(e, drop);
        if (worker->rule->flags & FMB_RULE_BREAKS_HISTORY)
            e->based = false;
    }
    fmb_mem_put(mem, drop, rows, sizeof *drop);
    return st;
}

static fmb_status reduce_rows(fmb_elim *e)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < e->live.size; i++) {
        st = fmb_vec_reduce(&e->row[e->live.row[i]].v, (size_t)e->n + 1, &e->num);
        if (st == FMB_OK)
            st = fmb_run_poll(e->run);
    }
    return st;
}

fmb_status fmb_elim_end_round(fmb_elim *e, int var)
{
    fmb_status st = FMB_OK;
    bool reduced = false;
    for (int k = 0; st == FMB_OK && k < e->workers; k++) {
        if (!can_pay(e, e->worker[k].rule))
            continue;
        st = reduced ? FMB_OK : reduce_rows(e);
        reduced = true;
        if (st == FMB_OK)
            st = apply(e, &e->worker[k], var);
    }
    return st;
}

fmb_status fmb_elim_prune(fmb_elim *e)
{
    return fmb_elim_end_round(e, -1);
}
