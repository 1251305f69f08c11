/* rule_lp.c: redundancy by linear programs while eliminating; see rule_lp.h.
 *
 * Each row is tested against the rows not yet dropped, so dropped rows are implied by the remaining
 * ones. This is no history rule: the engine re-bases after it. Source: Schrijver 1986.
 */
#include "solve/query/rule_lp.h"

#include "base/arrays.h"
#include "elim/rules/view.h"
#include "lp/redundancy/active_set/implied.h"
#include "lp/redundancy/irredundant.h"

/* The live rows, as lists for the oracle. */
typedef struct rows {
    fmb_lp_row *row;
    fmb_fate *fate;
    size_t *place; /* in the view */
    bool *gone;
    bool *kept; /* proved to be irredundant */
    size_t size, room;
} rows;

/* One test of all rows; between slices the elimination keeps it. */
typedef struct look {
    fmb_mem *mem;
    rows at;
    fmb_sorting sorting;
    bool sorted;        /* guesses are done, the oracle decides the rest */
    fmb_pruner *pruner; /* the oracle's state, once it was interrupted */
} look;

typedef struct patience {
    size_t next; /* the number of rows for the next test; 0: none so far */
} patience;

static fmb_status hold_row_lists(rows *a, fmb_mem *mem, bool get)
{
    return FMB_ARRAYS(mem, get, FMB_ARRAY(a->row, a->room), FMB_ARRAY(a->fate, a->room),
                      FMB_ARRAY(a->place, a->room), FMB_ARRAY_ZERO(a->gone, a->room),
                      FMB_ARRAY_ZERO(a->kept, a->room));
}

/* List the live rows that are not dropped yet. */
static void list_undropped_rows(rows *a, const fmb_elim *e, const bool *drop)
{
    a->size = 0;
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        if (drop[i])
            continue;
        a->place[a->size] = i;
        a->fate[a->size] = FMB_FATE_UNKNOWN;
        a->row[a->size++] = (fmb_lp_row){&r->v, fmb_derived_rel(r)};
    }
}

/* Decide exactly the rows that guesses left undecided, until the slice is used up: then *open rows
 * are undecided. */
static fmb_status decide_rows_exactly(const fmb_elim *e, look *l, size_t *open)
{
    rows *a = &l->at;
    bool feasible; /* false: the earlier decision used an unsound rule */
    for (size_t i = 0; !l->pruner && i < a->size; i++)
        if (a->fate[i] == FMB_FATE_UNKNOWN && (a->gone[i] || a->kept[i]))
            a->fate[i] = a->gone[i] ? FMB_FATE_REDUNDANT : FMB_FATE_KEPT;
    fmb_status st = fmb_redundant(e->run, (size_t)e->n, a->size, a->row,
                                  e->pauses ? &l->pruner : NULL, a->fate, &feasible);
    *open = 0;
    for (size_t i = 0; i < a->size; i++) {
        *open += feasible && a->fate[i] == FMB_FATE_UNKNOWN;
        a->gone[i] |= a->fate[i] == FMB_FATE_REDUNDANT;
    }
    return st;
}

/* Is this a trial, with numbers so long that exact tests take longer than other engines? */
static bool is_trial_of_long_numbers(const fmb_elim *e)
{
    return e->budget > 0 && fmb_elim_minor_bits(e) > FMB_LONG_MINOR;
}

/* Guesses about all rows together are cheap; only if they leave many rows undecided is each row
 * tested exactly. */
static bool leaves_doubts(const fmb_elim *e, const look *l)
{
    return 4 * l->sorting.doubtful >= l->at.size && !is_trial_of_long_numbers(e);
}

static void close_look(void *self)
{
    look *l = self;
    fmb_lp_sorting_clear(&l->sorting);
    fmb_pruner_close(l->pruner);
    (void)hold_row_lists(&l->at, l->mem, false);
    fmb_mem_put(l->mem, l, 1, sizeof *l);
}

static fmb_status open_look(const fmb_view *w, const bool *drop, look **opened)
{
    fmb_elim *e = w->e;
    fmb_mem *mem = e->run->mem;
    look *l;
    FMB_TRY(FMB_GET_ZERO(mem, l, 1));
    l->mem = mem;
    l->at.room = fmb_view_rows(w);
    fmb_status st = hold_row_lists(&l->at, mem, true);
    l->sorting =
        (fmb_sorting){.gone = l->at.gone, .kept = l->at.kept, .known = true, .pauses = e->pauses};
    if (st == FMB_OK)
        list_undropped_rows(&l->at, e, drop);
    *opened = l;
    return st;
}

/* *done false: the slice is used up. */
static fmb_status go_on_looking(const fmb_elim *e, look *l, bool *done)
{
    size_t open = 0;
    fmb_status st =
        l->sorted ? FMB_OK : fmb_lp_sort_rows(e->run, e->n, l->at.size, l->at.row, &l->sorting);
    *done = false;
    if (st != FMB_OK || l->sorting.paused)
        return st;
    l->sorted = true;
    if (leaves_doubts(e, l))
        st = decide_rows_exactly(e, l, &open);
    *done = open == 0;
    return st;
}

/* The callback of the rule. The live rows do not change between slices. */
static fmb_status look_at_rows(const fmb_view *w, bool *drop)
{
    fmb_elim *e = w->e;
    look *l = e->at.look;
    bool done = false;
    fmb_status st = l ? FMB_OK : open_look(w, drop, &l);
    FMB_THEN(st, go_on_looking(e, l, &done));
    e->at.pruning = st == FMB_OK && !done;
    e->at.look = e->at.pruning ? l : NULL;
    e->at.close_look = close_look;
    for (size_t i = 0; st == FMB_OK && !e->at.pruning && i < l->at.size; i++)
        drop[l->at.place[i]] |= l->at.gone[i];
    if (l && !e->at.pruning)
        close_look(l);
    return st;
}

static fmb_status prune_doubled_rows(void *state, const fmb_view *w, bool *drop)
{
    patience *p = state;
    size_t left = 0, size = fmb_view_rows(w);
    if (p->next == 0)
        p->next = 2 * fmb_view_bases(w) + 16;
    if (fmb_view_column(w) >= 0 && size < p->next)
        return FMB_OK;
    fmb_status st = look_at_rows(w, drop);
    if (w->e->at.pruning)
        return st;
    for (size_t i = 0; i < size; i++)
        left += !drop[i];
    p->next = 3 * left / 2 + 16;
    return st;
}

const fmb_rule fmb_rule_lp = {.name = "lp",
                              .source = "Schrijver1986",
                              .flags = FMB_RULE_BREAKS_HISTORY,
                              .state_bytes = sizeof(patience),
                              .end_round = prune_doubled_rows};
