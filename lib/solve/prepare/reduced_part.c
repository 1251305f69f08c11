/* reduced_part.c: see reduced_part.h. */
#include "solve/prepare/reduced_part.h"

static fmb_status eliminate_cheap_columns(fmb_reduced_part *h)
{
    fmb_query *q = h->q;
    bool *drop = h->drop = fmb_arena_get(&q->v->arena, (size_t)h->p->n, sizeof *drop);
    if (!drop)
        return fmb_mem_status(q->run.mem);
    for (int j = 0; j < h->p->n; j++) {
        drop[j] = h->place[h->p->var[j]] < 0;
        h->kept += !drop[j];
    }
    fmb_status st = fmb_query_load(q, h->p, false, &h->e);
    h->e.order = FMB_ORDER_PAIRS;
    h->e.chooser = (fmb_chooser){0};
    h->e.cheap_only = true;
    FMB_THEN(st, fmb_elim_eliminate(&h->e, drop));
    for (size_t i = 0; st == FMB_OK && i < h->e.live.size; i++)
        h->rest |= fmb_sets_meet(h->e.row[h->e.live.row[i]].names, h->e.candidates, h->e.var_words);
    return st;
}

fmb_status fmb_reduced_part_open(fmb_reduced_part *h, fmb_query *q, int part, const int *place,
                                 bool *feasible)
{
    *h = (fmb_reduced_part){.q = q, .p = &q->parts.part[part], .place = place, .e.run = &q->run};
    fmb_status st = eliminate_cheap_columns(h);
    *feasible = st != FMB_OK || h->e.clash == FMB_NO_ROW;
    return st;
}

void fmb_reduced_part_close(fmb_reduced_part *h)
{
    fmb_elim_clear(&h->e);
}
