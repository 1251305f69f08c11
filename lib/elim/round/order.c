/* order.c: the order of elimination. Each variant is a cost function; the least cost wins, ties go
 * to the lower index.
 *
 * Unless a caller chooses, a variable in an equality comes first (substitution adds no rows), then
 * one of one sign only (its rows are just removed).
 */
#include <string.h>

#include "elim/round/round.h"
#include "elim/rules/view.h"

/* The occurrences of a variable in the live rows. */
typedef struct occurrence {
    uint32_t lower, upper;         /* rows of negative, positive coefficient */
    size_t lower_size, upper_size; /* nonzeros in them */
    bool in_equality;
} occurrence;

/* Count the row for the candidates that are named, bits of the word from variable `from` on; only
 * the order by fill needs its length. */
static void count_row_occurrences(const fmb_derived *r, uint64_t named, size_t from, size_t size,
                                  occurrence *c)
{
    for (c += from; named != 0; named &= named - 1) {
        int j = __builtin_ctzll(named);
        bool lower = fmb_vec_sgn(&r->v, from + (size_t)j) < 0;
        c[j].in_equality |= r->equality;
        *(lower ? &c[j].lower : &c[j].upper) += 1;
        *(lower ? &c[j].lower_size : &c[j].upper_size) += size;
    }
}

static void count_all_occurrences(const fmb_elim *e, occurrence *c)
{
    const uint32_t *live = e->live.row;
    size_t rows = e->live.size;
    bool sizes = e->order == FMB_ORDER_FILL;
    for (size_t w = 0; w < e->var_words; w++) {
        uint64_t candidates = e->candidates[w];
        for (size_t i = 0; i < rows; i++) {
            const fmb_derived *r = &e->row[live[i]];
            size_t size = sizes ? (size_t)fmb_elim_count_variables(e, r) : 0;
            count_row_occurrences(r, r->names[w] & candidates, 64 * w, size, c);
        }
    }
}

static double cost_in_pairs(const occurrence *c)
{
    double p = (double)c->lower, q = (double)c->upper;
    return p * q - p - q;
}

static double cost_as_given(const occurrence *c)
{
    (void)c;
    return 0;
}

static double cost_of_smaller_side(const occurrence *c)
{
    return (double)(c->lower < c->upper ? c->lower : c->upper);
}

/* The nonzeros of all combinations if none overlapped. */
static double cost_in_nonzeros(const occurrence *c)
{
    return (double)c->lower * (double)c->upper_size + (double)c->upper * (double)c->lower_size;
}

static double (*const COST[])(const occurrence *) = {
    [FMB_ORDER_PAIRS] = cost_in_pairs,
    [FMB_ORDER_GIVEN] = cost_as_given,
    [FMB_ORDER_MIN] = cost_of_smaller_side,
    [FMB_ORDER_FILL] = cost_in_nonzeros,
};

static occurrence count_occurrences(const fmb_elim *e, int var)
{
    occurrence c = {0};
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        int sign = fmb_vec_sgn(&r->v, (size_t)var);
        c.in_equality |= sign != 0 && r->equality;
        c.lower += sign < 0;
        c.upper += sign > 0;
    }
    return c;
}

static double growth_of(const occurrence *c)
{
    return c->in_equality ? 0 : cost_in_pairs(c);
}

void fmb_elim_note_candidates(fmb_elim *e, const bool *drop)
{
    for (size_t w = 0; w < e->var_words; w++)
        e->candidates[w] = 0;
    for (int j = 0; j < e->n; j++)
        e->candidates[j / 64] |= (uint64_t)drop[j] << j % 64;
    for (int i = 0; i < e->rounds; i++)
        e->candidates[e->round[i].var / 64] &= ~((uint64_t)1 << e->round[i].var % 64);
}

static size_t list_candidates(fmb_elim *e)
{
    size_t n = 0;
    for (size_t w = 0; w < e->var_words; w++)
        for (uint64_t left = e->candidates[w]; left != 0; left &= left - 1)
            e->candidate[n++] = (int)(64 * w) + __builtin_ctzll(left);
    return n;
}

/* In every order equalities come first, then variables of one sign. */
static int priority_of(const fmb_elim *e, const occurrence *c)
{
    bool onesided = c->lower == 0 || c->upper == 0;
    if (c->in_equality)
        return 0;
    return onesided && fmb_elim_keeps(e, FMB_STEP_ONESIDED) ? 1 : 2;
}

static int find_cheapest_candidate(const fmb_elim *e, const occurrence *c, const int *candidate,
                                   size_t n)
{
    int best = -1, best_priority = 0;
    double best_cost = 0;
    for (size_t i = 0; i < n; i++) {
        int j = candidate[i], priority = priority_of(e, &c[j]);
        double cost = COST[e->order](&c[j]);
        if (best < 0 || priority < best_priority ||
            (priority == best_priority && cost < best_cost)) {
            best = j;
            best_priority = priority;
            best_cost = cost;
        }
    }
    return best;
}

/* Substitution starts histories anew: if that is not allowed, equalities must be used up before the
 * first pairs. Then, if candidates are in equalities, only these are kept. */
static size_t keep_candidates_in_equalities(const fmb_elim *e, int *candidate, size_t n)
{
    size_t left = 0;
    bool one_base = false;
    for (int k = 0; k < e->workers; k++)
        one_base |= (e->worker[k].rule->flags & FMB_RULE_ONE_BASE) != 0;
    for (size_t i = 0; one_base && i < n; i++)
        if (count_occurrences(e, candidate[i]).in_equality)
            candidate[left++] = candidate[i];
    return left > 0 ? left : n;
}

static fmb_status ask_chooser(fmb_elim *e, int *candidate, size_t n, int *var)
{
    fmb_window w;
    n = keep_candidates_in_equalities(e, candidate, n);
    fmb_window_open(&w, e, NULL, -1);
    int chosen = e->chooser.choose(e->chooser.self, &w.view, candidate, n);
    fmb_status st = fmb_window_close(&w);
    bool known = false;
    for (size_t i = 0; i < n; i++)
        known |= candidate[i] == chosen;
    if (st == FMB_OK && !known)
        st = FMB_ERR_ARG;
    *var = chosen;
    return st;
}

static fmb_status choose_cheapest(fmb_elim *e, size_t candidates, int *var, double *growth)
{
    fmb_arena_place place = fmb_arena_tell(e->arena);
    size_t n = (size_t)e->n;
    occurrence *c;
    FMB_TRY(FMB_ARENA_GET(e->arena, c, n));
    memset(c, 0, n * sizeof *c);
    fmb_run_count(e->run, 50 + e->live.size * (5 + 2 * n));
    count_all_occurrences(e, c);
    *var = find_cheapest_candidate(e, c, e->candidate, candidates);
    *growth = growth_of(&c[*var]);
    fmb_arena_rewind(e->arena, place);
    return FMB_OK;
}

fmb_status fmb_elim_choose(fmb_elim *e, int *var, double *growth)
{
    size_t candidates = list_candidates(e);
    *var = candidates > 0 ? e->candidate[0] : -1;
    if (candidates > 1 && !e->chooser.choose)
        return choose_cheapest(e, candidates, var, growth);
    if (candidates > 1)
        FMB_TRY(ask_chooser(e, e->candidate, candidates, var));
    if (candidates > 0) {
        occurrence c = count_occurrences(e, *var);
        *growth = growth_of(&c);
    }
    return FMB_OK;
}
