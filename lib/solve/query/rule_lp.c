/* rule_lp.c: redundancy by linear programs while eliminating; see rule_lp.h.
 *
 * Each row is tested against those still there, so what goes is implied by what stays. Not a rule
 * of histories: the engine re-bases after it. Source: Schrijver 1986.
 */
#include "solve/query/rule_lp.h"

#include "elim/rules/view.h"
#include "lp/redundancy/active_set/implied.h"
#include "lp/redundancy/irredundant.h"

typedef struct patience {
    size_t next; /* rows from which on it looks again; 0: it has not looked */
} patience;

/* Rows that still live, in lists for the oracle. */
typedef struct rows {
    fmb_lp_row *row;
    fmb_fate *fate;
    size_t *place; /* in the view */
    bool *gone;
    bool *kept; /* proved to be irredundant */
    size_t size, room;
} rows;

static void free_row_lists(rows *a, fmb_mem *mem)
{
    fmb_mem_put(mem, a->row, a->room, sizeof *a->row);
    fmb_mem_put(mem, a->fate, a->room, sizeof *a->fate);
    fmb_mem_put(mem, a->place, a->room, sizeof *a->place);
    fmb_mem_put(mem, a->gone, a->room, sizeof *a->gone);
    fmb_mem_put(mem, a->kept, a->room, sizeof *a->kept);
}

static fmb_status allocate_row_lists(rows *a, fmb_mem *mem, size_t room)
{
    *a = (rows){.room = room};
    a->row = fmb_mem_get(mem, room, sizeof *a->row);
    a->fate = fmb_mem_get(mem, room, sizeof *a->fate);
    a->place = fmb_mem_get(mem, room, sizeof *a->place);
    a->gone = fmb_mem_zero(mem, room, sizeof *a->gone);
    a->kept = fmb_mem_zero(mem, room, sizeof *a->kept);
    bool got = a->row && a->fate && a->place && a->gone && a->kept;
    return got ? FMB_OK : fmb_mem_status(mem);
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
        a->kept[a->size] = r->stays;
        a->row[a->size++] = (fmb_lp_row){&r->v, fmb_derived_rel(r)};
    }
}

static fmb_status drop_rows_exactly(const fmb_elim *e, rows *a, bool *drop)
{
    bool feasible; /* if they are not, a rule lied when that was decided */
    fmb_status st = fmb_redundant(e->run, (size_t)e->n, a->size, a->row, a->fate, &feasible);
    for (size_t i = 0; i < a->size; i++)
        drop[a->place[i]] |= a->fate[i] == FMB_FATE_REDUNDANT;
    return st;
}

/* Where numbers are long, to ask exactly takes longer than other ways than elimination do. */
static bool is_trial_of_long_numbers(const fmb_elim *e)
{
    return e->budget > 0 && fmb_elim_minor_bits(e) > FMB_LONG_MINOR;
}

/* The slice is over: the next call goes on with the rows that are not settled. */
static void note_pause(fmb_elim *e, const rows *a)
{
    e->at.pruning = true;
    for (size_t i = 0; i < a->size; i++)
        e->row[e->live.row[a->place[i]]].stays = a->kept[i];
}

/* What guesses of all rows together find is cheap; if they leave many doubts, each row is asked
 * about. */
static fmb_status drop_implied_rows(fmb_elim *e, rows *a, bool *drop)
{
    fmb_sorting sorting = {.gone = a->gone, .kept = a->kept, .known = true, .pauses = e->pauses};
    list_undropped_rows(a, e, drop);
    fmb_status st = fmb_lp_sort_rows(e->run, e->n, a->size, a->row, &sorting);
    for (size_t i = 0; i < a->size; i++)
        drop[a->place[i]] |= a->gone[i];
    if (sorting.paused)
        note_pause(e, a);
    if (st != FMB_OK || sorting.paused || 4 * sorting.doubtful < a->size ||
        is_trial_of_long_numbers(e))
        return st;
    list_undropped_rows(a, e, drop);
    return drop_rows_exactly(e, a, drop);
}

static fmb_status prune_doubled_rows(void *state, const fmb_view *w, bool *drop)
{
    patience *p = state;
    fmb_mem *mem = w->e->run->mem;
    size_t left = 0, size = fmb_view_rows(w);
    rows a;
    if (p->next == 0)
        p->next = 2 * fmb_view_bases(w) + 16;
    if (fmb_view_column(w) >= 0 && size < p->next)
        return FMB_OK;
    fmb_status st = allocate_row_lists(&a, mem, size);
    if (st == FMB_OK)
        st = drop_implied_rows(w->e, &a, drop);
    free_row_lists(&a, mem);
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
