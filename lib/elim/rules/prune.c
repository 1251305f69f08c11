/* prune.c: calls the rules and counts what they refuse; see prune.h. */
#include "elim/rules/prune.h"

#include "elim/rules/view.h"

/* The rule has refused pairs or rows of this round. */
static void note_drop_of_rule(fmb_elim *e, int worker, uint64_t dropped)
{
    fmb_worker *w = &e->worker[worker];
    w->dropped += dropped;
    e->run->stats.rows_dropped += dropped;
    e->broken |= dropped > 0 && (w->rule->flags & FMB_RULE_BREAKS_HISTORY) != 0;
}

fmb_status fmb_rules_drop_base_rows(fmb_elim *e)
{
    fmb_window w;
    for (int k = 0; k < e->workers; k++) {
        const fmb_rule *rule = e->worker[k].rule;
        size_t left = 0;
        if (!rule->drop_row || (rule->flags & FMB_RULE_NEEDS_HISTORY))
            continue;
        fmb_window_open(&w, e, rule, -1);
        for (size_t i = 0; i < e->live.size; i++) {
            uint32_t r = e->live.row[i];
            if (e->row[r].equality || !rule->drop_row(e->worker[k].state, &w.view, r))
                e->live.row[left++] = r;
        }
        e->worker[k].dropped += e->live.size - left;
        e->run->stats.rows_dropped += e->live.size - left;
        e->live.size = left;
        FMB_TRY(fmb_window_close(&w));
    }
    return FMB_OK;
}

/* The bits that a rule adds to drop count for that rule. */
fmb_status fmb_rules_refuse_pairs(fmb_elim *e, const fmb_round *round, size_t lowers, size_t i,
                                  uint64_t *drop)
{
    size_t words = fmb_set_words(round->rows - lowers);
    uint64_t before = 0;
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < e->workers; k++) {
        const fmb_rule *rule = e->worker[k].rule;
        if (!rule->drop_pairs)
            continue;
        fmb_window w;
        fmb_window_open(&w, e, rule, round->var);
        w.view.lower = round->row;
        w.view.lowers = lowers;
        w.view.upper = round->row + lowers;
        w.view.uppers = round->rows - lowers;
        rule->drop_pairs(e->worker[k].state, &w.view, i, drop);
        st = fmb_window_close(&w);
        uint64_t after = fmb_set_size(drop, words);
        note_drop_of_rule(e, k, after - before);
        before = after;
    }
    return st;
}

/* Rows made by substitution are part of the next base: rules wait until it is complete. */
fmb_status fmb_rules_drop_row(fmb_elim *e, const fmb_rule **by)
{
    *by = NULL;
    if (!e->based || e->row[e->rows].equality)
        return FMB_OK;
    for (int k = 0; k < e->workers; k++) {
        const fmb_rule *rule = e->worker[k].rule;
        if (!rule->drop_row)
            continue;
        fmb_window w;
        fmb_window_open(&w, e, rule, e->row[e->rows].var);
        bool drop = rule->drop_row(e->worker[k].state, &w.view, e->rows);
        FMB_TRY(fmb_window_close(&w));
        if (drop) {
            *by = rule;
            note_drop_of_rule(e, k, 1);
            return FMB_OK;
        }
    }
    return FMB_OK;
}

/* ---- the end of a round ---------------------------------------------------------------------- */

static bool rebases_always(const fmb_elim *e, const fmb_rule *rule)
{
    return !e->histories || (rule->flags & FMB_RULE_BREAKS_HISTORY) == 0 ||
           e->rebase == FMB_REBASE_ALWAYS;
}

/* A rule that breaks histories restarts Kohler's count: that pays only if it drops many rows. */
static bool pays_for_rebase(const fmb_elim *e, const fmb_rule *rule, size_t marked)
{
    return marked > 0 && (rebases_always(e, rule) || 4 * marked >= e->live.size);
}

/* With fewer live rows than this it cannot pay: the rule is not even called. */
#define WORTH_LOOKING 32

static bool can_pay_for_rebase(const fmb_elim *e, const fmb_rule *rule)
{
    return rule->end_round && e->live.size > 0 &&
           (rebases_always(e, rule) || e->live.size >= WORTH_LOOKING);
}

static size_t drop_marked_rows(fmb_elim *e, const bool *drop)
{
    size_t left = 0, before = e->live.size;
    for (size_t i = 0; i < before; i++)
        if (!drop[i])
            e->live.row[left++] = e->live.row[i];
    e->run->stats.rows_dropped += before - left;
    e->live.size = left;
    return before - left;
}

static fmb_status ask_at_end_of_round(fmb_elim *e, fmb_worker *worker, int var)
{
    fmb_mem *mem = e->run->mem;
    size_t rows = e->live.size, marked = 0;
    fmb_window w;
    bool *drop;
    FMB_TRY(FMB_GET_ZERO(mem, drop, rows));
    fmb_window_open(&w, e, worker->rule, var);
    fmb_run_count(e->run, rows * (20 + 2 * (size_t)e->n));
    fmb_status said = worker->rule->end_round(worker->state, &w.view, drop);
    fmb_status st = fmb_window_close(&w);
    st = st != FMB_OK ? st : said;
    for (size_t i = 0; i < rows; i++)
        marked += drop[i];
    if (st == FMB_OK && pays_for_rebase(e, worker->rule, marked)) {
        worker->dropped += drop_marked_rows(e, drop);
        if (worker->rule->flags & FMB_RULE_BREAKS_HISTORY)
            e->based = false;
    }
    fmb_mem_put(mem, drop, rows, sizeof *drop);
    return st;
}

static fmb_status reduce_live_rows(fmb_elim *e)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < e->live.size; i++) {
        fmb_derived *r = &e->row[e->live.row[i]];
        if (r->lowest)
            continue;
        st = fmb_vec_reduce(&r->v, (size_t)e->n + 1, &e->num);
        r->lowest = st == FMB_OK;
        FMB_THEN(st, fmb_run_poll(e->run));
    }
    return st;
}

fmb_status fmb_rules_end_round(fmb_elim *e, int var)
{
    fmb_status st = FMB_OK;
    bool reduced = e->at.pruning;
    int k = e->at.pruning ? e->at.pruner : 0;
    e->at.pruning = false;
    for (; st == FMB_OK && !e->at.pruning && k < e->workers; k++) {
        if (!can_pay_for_rebase(e, e->worker[k].rule))
            continue;
        st = reduced ? FMB_OK : reduce_live_rows(e);
        reduced = true;
        FMB_THEN(st, ask_at_end_of_round(e, &e->worker[k], var));
        e->at.pruner = k;
    }
    return st;
}
