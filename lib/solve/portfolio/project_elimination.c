/* project_elimination.c: rows of a projection from an elimination; see project_elimination.h. */
#include "solve/portfolio/project_elimination.h"

#include "solve/limit/outer.h"
#include "solve/prepare/irredundant_rows.h"

bool fmb_has_rows_in_plenty(const fmb_part *p)
{
    return p->m >= 64 && p->m / 8 >= (size_t)p->n;
}

static fmb_status eliminate_dropped_columns(fmb_part_elimination *h, bool feasible)
{
    fmb_query *q = h->q;
    bool *drop;
    FMB_TRY(FMB_ARENA_GET(&q->v->arena, drop, (size_t)h->p->n));
    for (int j = 0; j < h->p->n; j++)
        drop[j] = h->place[h->p->var[j]] < 0;
    fmb_status st = fmb_query_load(q, h->p, feasible, &h->e);
    if (st == FMB_OK && feasible && fmb_has_rows_in_plenty(h->p))
        st = fmb_elim_prune(&h->e);
    return st == FMB_OK ? fmb_elim_eliminate(&h->e, drop) : st;
}

fmb_status fmb_put_rows_of_elimination(fmb_part_elimination *h, fmb_elim *e, fmb_status st,
                                       bool known, bool *feasible, bool *done)
{
    size_t rows = fmb_system_rows(h->out);
    *done = st == FMB_OK;
    if (st == FMB_LIMIT && (e->over_budget || e->paused))
        return FMB_OK;
    if (st == FMB_OK)
        *feasible = e->clash == FMB_NO_ROW;
    if (st == FMB_OK && *feasible)
        st = fmb_irredundant_rows_append(h->q, h->p, h->place, e, known || h->q->decided, h->out,
                                         feasible);
    fmb_status saved = FMB_OK;
    bool room = h->q->run.stop != FMB_STOP_DONE && e->n > 0; /* else memory ran out, or no row was
                                                                loaded */
    if (st == FMB_LIMIT && room && fmb_system_rows(h->out) == rows)
        saved = fmb_outer_rows(h->q, h->p, e, h->place, h->out);
    return saved != FMB_OK ? saved : st;
}

fmb_status fmb_project_by_elimination(fmb_part_elimination *h, bool known, bool *feasible,
                                      bool *done)
{
    fmb_status st = eliminate_dropped_columns(h, known);
    st = fmb_put_rows_of_elimination(h, &h->e, st, known, feasible, done);
    fmb_elim_clear(&h->e);
    return st;
}
