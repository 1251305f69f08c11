/* elim.c: the rounds; see elim.h. */
#include "elim/round/elim.h"

#include <string.h>

#include "base/ways.h"
#include "elim/history/filter.h"
#include "elim/round/round.h"
#include "elim/rules/prune.h"

static fmb_status hire_rules(fmb_elim *e, const fmb_elim_options *o)
{
    for (int k = 0; k < o->rules; k++) {
        const fmb_rule *rule = o->rule[k];
        fmb_worker w = {.rule = rule};
        if (rule->state_bytes > 0) {
            w.state = fmb_arena_get(e->arena, rule->state_bytes, 1);
            if (!w.state)
                return fmb_mem_status(e->arena->mem);
            memset(w.state, 0, rule->state_bytes);
        }
        e->worker[e->workers++] = w;
        e->histories |= (rule->flags & FMB_RULE_NEEDS_HISTORY) != 0;
    }
    return FMB_OK;
}

fmb_status fmb_elim_init(fmb_elim *e, fmb_run *run, fmb_arena *arena, int n,
                         const fmb_elim_options *o)
{
    *e = (fmb_elim){.run = run,
                    .arena = arena,
                    .n = n,
                    .order = o->order,
                    .rebase = o->rebase,
                    .steps = o->steps,
                    .chooser = o->chooser,
                    .clash = FMB_NO_ROW,
                    .var_words = fmb_set_words((size_t)n)};
    FMB_TRY(FMB_ARENA_GET(arena, e->round, (size_t)n));
    FMB_TRY(FMB_ARENA_GET(arena, e->candidate, (size_t)n));
    FMB_TRY(FMB_ARENA_GET(arena, e->candidates, e->var_words));
    FMB_TRY(FMB_ARENA_GET(arena, e->gone, e->var_words));
    FMB_TRY(FMB_ARENA_GET(arena, e->filter, 1));
    *e->filter = (fmb_filter){0};
    memset(e->gone, 0, e->var_words * sizeof *e->gone);
    FMB_TRY(hire_rules(e, o));
    return fmb_run_open_num(run, &e->num, (size_t)n + 1, o->wide_only);
}

void fmb_elim_clear(fmb_elim *e)
{
    fmb_mem *mem = e->run->mem;
    for (size_t i = 0; i < e->rows; i++)
        fmb_vec_clear(&e->row[i].v, (size_t)e->n + 1, mem);
    for (int k = 0; k < e->workers; k++)
        if (e->worker[k].rule->clear)
            e->worker[k].rule->clear(e->worker[k].state);
    if (e->at.look)
        e->at.close_look(e->at.look);
    if (e->filter)
        fmb_filter_clear(e->filter, mem);
    e->run->stats.promotions += e->num.promotions;
    fmb_num_clear(&e->num);
}

/* ---- by substitution ------------------------------------------------------------------------- */

/* The equality with var in it that is cheapest to substitute (fewest nonzeros), or FMB_NO_ROW. */
static uint32_t find_sparsest_equality(const fmb_elim *e, int var)
{
    uint32_t best = FMB_NO_ROW;
    int best_size = 0;
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        if (!r->equality || fmb_vec_sgn(&r->v, (size_t)var) == 0)
            continue;
        int size = fmb_elim_count_variables(e, r) + (r->v.z != NULL ? e->n : 0);
        if (best == FMB_NO_ROW || size < best_size) {
            best = e->live.row[i];
            best_size = size;
        }
    }
    return best;
}

/* Use the equality q to remove var from every other row. Histories start anew: the result is a
 * smaller system with the same solutions, whose rows are not combinations of pairs. */
static fmb_status substitute_equality(fmb_elim *e, uint32_t q, int var)
{
    fmb_round *round = &e->round[e->rounds];
    round->row[0] = q;
    round->rows = 1;
    round->equality = true;
    e->based = false;
    for (size_t i = 0; e->clash == FMB_NO_ROW && i < e->live.size; i++) {
        uint32_t p = e->live.row[i];
        if (p == q)
            continue;
        bool has = fmb_vec_sgn(&e->row[p].v, (size_t)var) != 0;
        FMB_TRY(has ? fmb_elim_combine(e, p, q, var) : fmb_list_push(e, &e->next, p));
    }
    return FMB_OK;
}

/* ---- by pairing ------------------------------------------------------------------------------ */

/* Is var in live rows with either sign? */
static bool stands_with_both_signs(const fmb_elim *e, int var)
{
    bool lower = false, upper = false;
    for (size_t i = 0; !(lower && upper) && i < e->live.size; i++) {
        int sign = fmb_vec_sgn(&e->row[e->live.row[i]].v, (size_t)var);
        lower |= sign < 0;
        upper |= sign > 0;
    }
    return lower && upper;
}

/* Put the rows with var into the round, lower ones first, the others into the next live rows. */
static fmb_status sort_rows_by_sign(fmb_elim *e, fmb_round *round, size_t *lowers)
{
    FMB_TRY(FMB_ARENA_RESERVE(e->arena, &e->next.row, &e->next.capacity, e->live.size));
    for (size_t i = 0; i < e->live.size; i++) {
        int sign = fmb_vec_sgn(&e->row[e->live.row[i]].v, (size_t)round->var);
        if (sign <= 0)
            *(sign < 0 ? &round->row[round->rows++] : &e->next.row[e->next.size++]) =
                e->live.row[i];
    }
    *lowers = round->rows;
    for (size_t i = 0; i < e->live.size; i++)
        if (fmb_vec_sgn(&e->row[e->live.row[i]].v, (size_t)round->var) > 0)
            round->row[round->rows++] = e->live.row[i];
    return FMB_OK;
}

/* Does no row of the round contain another variable? */
static bool names_no_other_variable(const fmb_elim *e, const fmb_round *round)
{
    for (size_t i = 0; i < round->rows; i++)
        if (fmb_elim_count_variables(e, &e->row[round->row[i]]) > 1)
            return false;
    return true;
}

/* Remove var by pairing. A variable of one sign only makes no pairs: its rows are removed, and
 * histories stay valid, as the rest is the result of eliminating the other variables only.
 */
static fmb_status eliminate_by_pairs(fmb_elim *e, int var)
{
    fmb_round *round = &e->round[e->rounds];
    size_t *lowers = &e->at.lowers;
    if (!e->based && stands_with_both_signs(e, var))
        FMB_TRY(fmb_elim_start_histories(e));
    if (e->clash == FMB_NO_ROW)
        FMB_TRY(sort_rows_by_sign(e, round, lowers));
    if (e->clash != FMB_NO_ROW || *lowers == 0 || *lowers == round->rows)
        return FMB_OK;
    e->since++;
    fmb_set_put(e->gone, (size_t)var);
    e->run->stats.rounds++;
    bool last = names_no_other_variable(e, round) && fmb_way(FMB_WAY_SQUEEZE);
    fmb_way_answered(FMB_WAY_SQUEEZE, last);
    return last ? fmb_elim_squeeze(e, round, *lowers) : fmb_elim_pair(e, round);
}

/* ---- a round --------------------------------------------------------------------------------- */

static fmb_tally take_tally(const fmb_elim *e)
{
    const fmb_stats *s = &e->run->stats;
    return (fmb_tally){e->live.size, e->rows,         s->pairs,
                       s->rows_made, s->rows_dropped, e->num.promotions};
}

static void emit_rule_events(fmb_elim *e, int var)
{
    for (int k = 0; k < e->workers; k++) {
        if (e->worker[k].dropped > 0)
            fmb_run_emit(e->run, (fmb_event){.kind = FMB_EVENT_RULE,
                                             .round = e->rounds,
                                             .var = var,
                                             .dropped = e->worker[k].dropped,
                                             .name = e->worker[k].rule->name});
        e->worker[k].dropped = 0;
    }
    if (e->constants > 0)
        fmb_run_emit(e->run, (fmb_event){.kind = FMB_EVENT_RULE,
                                         .round = e->rounds,
                                         .var = var,
                                         .dropped = e->constants,
                                         .name = "constant"});
    e->constants = 0;
}

/* At the end of a round: count the rows kept of those that it made, and emit the events. */
static void close_round(fmb_elim *e, int var)
{
    const fmb_tally *before = &e->at.before;
    fmb_tally after = take_tally(e);
    uint64_t kept = 0;
    for (size_t i = after.live; i-- > 0 && e->live.row[i] >= before->rows;)
        kept++;
    e->run->stats.rows_kept += kept;
    if (!e->run->sink.put)
        return;
    emit_rule_events(e, var);
    fmb_run_emit(e->run, (fmb_event){.kind = FMB_EVENT_ROUND,
                                     .round = e->rounds,
                                     .var = var,
                                     .rows_in = before->live,
                                     .rows_out = after.live,
                                     .pairs = after.pairs - before->pairs,
                                     .made = after.made - before->made,
                                     .dropped = after.dropped - before->dropped,
                                     .widened = after.widened - before->widened});
}

/* Rules that test all rows need not test few new ones, except in rounds that can make many. */
static bool is_time_for_rules(const fmb_elim *e)
{
    bool careful = e->cheap_only || e->growth > 0;
    return !careful || 8 * (e->rows - e->judged) >= e->live.size;
}

static fmb_status let_rules_end_round(fmb_elim *e, int var)
{
    e->judged = e->rows;
    return fmb_rules_end_round(e, var);
}

/* Make the rows of the round live. */
static fmb_status end_round(fmb_elim *e)
{
    fmb_round *round = &e->round[e->rounds];
    fmb_status st = FMB_OK;
    e->at.running = false;
    e->rounds++;
    fmb_list list = e->live;
    e->live = e->next;
    e->next = list;
    e->based &= !e->broken; /* refused rows follow from the rows present now */
    e->broken = false;
    if (e->clash == FMB_NO_ROW && round->rows > 1 && is_time_for_rules(e))
        st = let_rules_end_round(e, round->var);
    close_round(e, round->var);
    return st;
}

static fmb_status eliminate_variable(fmb_elim *e, int var)
{
    fmb_round *round = &e->round[e->rounds];
    e->at = (fmb_pairing){.running = true, .before = take_tally(e)};
    *round = (fmb_round){.var = var};
    FMB_TRY(FMB_ARENA_GET(e->arena, round->row, e->live.size));
    e->next.size = 0;
    uint32_t q = find_sparsest_equality(e, var);
    FMB_TRY(q != FMB_NO_ROW ? substitute_equality(e, q, var) : eliminate_by_pairs(e, var));
    return end_round(e);
}

/* Continue the round in which the last call paused. */
static fmb_status go_on_with_round(fmb_elim *e)
{
    FMB_TRY(fmb_elim_pair(e, &e->round[e->rounds]));
    return end_round(e);
}

/* Is there a variable to eliminate, but none by substitution? */
static bool is_ready_to_pair(const fmb_elim *e)
{
    bool any = false;
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        bool named = fmb_sets_meet(r->names, e->candidates, e->var_words);
        if (named && r->equality)
            return false;
        any |= named;
    }
    return any;
}

/* If a variable has both ends, the box refuses most of its pairs: then the number of rows decides.
 */
static bool grows_too_much(const fmb_elim *e, int var, double growth)
{
    bool boxed = e->box.any && e->box.row[FMB_LOWER][var] != FMB_NO_ROW &&
                 e->box.row[FMB_UPPER][var] != FMB_NO_ROW;
    return (!boxed && growth > e->growth * (double)e->live.size) || e->live.size > 2 * e->flat;
}

/* The next variable, *var; -1: there is none, or it is not cheap. Histories start before the
 * choice, so that rows dropped then do not count in it. */
static fmb_status choose_next_variable(fmb_elim *e, const bool *drop, int *var)
{
    double growth;
    *var = -1;
    fmb_elim_note_candidates(e, drop);
    if (!e->based && is_ready_to_pair(e))
        FMB_TRY(fmb_elim_start_histories(e));
    if (e->clash == FMB_NO_ROW)
        FMB_TRY(fmb_elim_choose(e, var, &growth));
    if (e->clash != FMB_NO_ROW || *var < 0)
        return FMB_OK;
    if (e->cheap_only && growth > 0) {
        *var = -1;
    } else if (e->growth > 0 && grows_too_much(e, *var, growth)) {
        e->over_budget = true;
        return FMB_LIMIT;
    }
    return FMB_OK;
}

static fmb_status go_on_with_variables(fmb_elim *e, const bool *drop)
{
    fmb_status st = e->at.running ? go_on_with_round(e) : FMB_OK;
    while (st == FMB_OK && e->clash == FMB_NO_ROW) {
        int var;
        if (fmb_elim_is_slice_over(e))
            return FMB_LIMIT;
        if (e->at.pruning) {
            st = let_rules_end_round(e, -1);
            continue;
        }
        st = choose_next_variable(e, drop, &var);
        if (st == FMB_OK && var < 0)
            break;
        if (st == FMB_OK && e->clash == FMB_NO_ROW)
            st = eliminate_variable(e, var);
    }
    bool unseen = (e->cheap_only || e->growth > 0) && e->rounds > 0 && e->judged < e->rows;
    return st == FMB_OK && e->clash == FMB_NO_ROW && unseen ? let_rules_end_round(e, -1) : st;
}

fmb_status fmb_elim_eliminate(fmb_elim *e, const bool *drop)
{
    fmb_status st = fmb_run_poll_now(e->run);
    e->paused = false;
    FMB_THEN(st, go_on_with_variables(e, drop));
    return st;
}

fmb_status fmb_elim_prune(fmb_elim *e)
{
    return let_rules_end_round(e, -1);
}
