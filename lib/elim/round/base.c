/* base.c: the start of a base. */
#include <string.h>

#include "elim/history/filter.h"
#include "elim/history/history.h"
#include "elim/round/round.h"
#include "elim/rules/box_rule.h"
#include "elim/rules/prune.h"

/* If the box refutes a base row, end the elimination with a clash. */
static fmb_status refute_base_rows(fmb_elim *e)
{
    if (!fmb_elim_keeps(e, FMB_STEP_REFUTE))
        return FMB_OK;
    for (size_t i = 0; i < e->live.size; i++) {
        if (fmb_box_refutes(e, &e->row[e->live.row[i]]))
            return fmb_box_refute(e, e->live.row[i]);
        FMB_TRY(fmb_run_poll(e->run));
    }
    return FMB_OK;
}

fmb_status fmb_elim_start_histories(fmb_elim *e)
{
    FMB_TRY(fmb_box_make(e));
    FMB_TRY(refute_base_rows(e));
    if (e->clash == FMB_NO_ROW)
        FMB_TRY(fmb_rules_drop_base_rows(e));
    if (e->clash != FMB_NO_ROW)
        return FMB_OK;
    e->bases = e->live.size;
    FMB_TRY(FMB_ARENA_GET(e->arena, e->base, e->bases));
    memcpy(e->base, e->live.row, e->bases * sizeof *e->base);
    memset(e->gone, 0, e->var_words * sizeof *e->gone);
    e->based = true;
    e->since = 0;
    fmb_filter_forget(e->filter);
    if (e->rounds > 0)
        fmb_run_emit(e->run, (fmb_event){.kind = FMB_EVENT_REBASE,
                                         .round = e->rounds,
                                         .var = -1,
                                         .rows_in = e->bases,
                                         .rows_out = e->bases});
    if (!e->histories)
        return FMB_OK;
    FMB_TRY(fmb_history_number_base(e));
    return fmb_box_mark(e);
}
