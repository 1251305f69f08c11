/* support_workers.c: support queries, several at once; see support.h.
 *
 * Facets are asked about in batches of a fixed size, the k-th of each by the k-th worker, whose
 * oracle is warm from the batch before: so what is found does not depend on how many threads there
 * are. The hull takes in what was seen afterwards, in order. A facet that stands does so whatever
 * comes; what was seen beyond another may lie in the hull by then, and was seen in vain.
 */
#include "hull/support/support_private.h"

/* A facet that is asked about, and the answer. */
typedef struct sighting {
    size_t facet;
    fmb_support_row row; /* in the memory of its worker */
    bool stands;
} sighting;

struct fmb_support_workers {
    fmb_support *of;
    const fmb_program *program;
    fmb_team team;
    fmb_support_worker worker[FMB_SUPPORT_WORKERS];
    size_t hired; /* workers that are there */
    sighting seen[FMB_SUPPORT_WORKERS];
};

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_support_hire(fmb_support *s, const fmb_program *p)
{
    fmb_status st = FMB_OK;
    fmb_support_workers *w = fmb_mem_zero(s->run->mem, 1, sizeof *w);
    if (!w)
        return fmb_mem_status(s->run->mem);
    s->workers = w;
    w->of = s;
    w->program = p;
    st = fmb_team_open(&w->team, s->run, FMB_SUPPORT_WORKERS);
    while (st == FMB_OK && w->hired < FMB_SUPPORT_WORKERS) {
        size_t k = w->hired++;
        st = fmb_support_worker_init(&w->worker[k], &w->team.share[k].run, NULL, s->n);
    }
    return st;
}

void fmb_support_dismiss(fmb_support *s)
{
    fmb_support_workers *w = s->workers;
    if (!w)
        return;
    for (size_t k = 0; k < w->hired; k++) {
        fmb_support_drop(&w->seen[k].row, w->worker[k].run->mem);
        fmb_oracle_free(w->worker[k].oracle);
        fmb_support_worker_clear(&w->worker[k]);
    }
    fmb_team_close(&w->team);
    fmb_mem_put(s->run->mem, w, 1, sizeof *w);
    s->workers = NULL;
}

/* ---- a batch --------------------------------------------------------------------------------- */

/* An oracle that has found a point, which there is. */
static fmb_status give_worker_an_oracle(fmb_support_worker *c, const fmb_program *p)
{
    bool feasible;
    fmb_status st = fmb_oracle_new(c->run, p, &c->oracle);
    return st == FMB_OK ? fmb_oracle_feasible(c->oracle, &feasible) : st;
}

static fmb_status look_at_facet(void *self, size_t k, fmb_run *run)
{
    fmb_support_workers *w = self;
    fmb_support_worker *c = &w->worker[k];
    sighting *g = &w->seen[k];
    fmb_status st = fmb_run_poll_now(run);
    if (st == FMB_OK && !c->oracle)
        st = give_worker_an_oracle(c, w->program);
    if (st == FMB_OK)
        st = fmb_support_worker_look(c, w->of, &w->of->hull.facet[g->facet].normal, 1, &g->row,
                                     &g->stands);
    return st;
}

static fmb_status keep_row_seen(fmb_support *s, const sighting *g)
{
    fmb_support_row row;
    fmb_status st = fmb_support_copy_row(s, &g->row, &row);
    if (st != FMB_OK) {
        fmb_support_drop(&row, s->run->mem);
        return st;
    }
    st = fmb_support_stand(s, g->facet, &row);
    return st == FMB_OK ? fmb_support_note_images(s, &s->hull.facet[g->facet].normal) : st;
}

/* Rows first: as long as nothing is taken in, facets stay where they are. */
static fmb_status take_in_what_was_seen(fmb_support *s, size_t n)
{
    fmb_support_workers *w = s->workers;
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        if (w->seen[k].stands)
            st = keep_row_seen(s, &w->seen[k]);
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        if (!w->seen[k].stands)
            st = fmb_support_take(s, &w->worker[k], w->seen[k].facet);
    return st;
}

fmb_status fmb_support_ask_workers(fmb_support *s, size_t n, const size_t *facet)
{
    fmb_support_workers *w = s->workers;
    for (size_t k = 0; k < n; k++)
        w->seen[k] = (sighting){.facet = facet[k]};
    fmb_status st = fmb_team_do(&w->team, n, look_at_facet, w);
    if (st == FMB_OK)
        st = take_in_what_was_seen(s, n);
    for (size_t k = 0; k < n; k++)
        fmb_support_drop(&w->seen[k].row, w->worker[k].run->mem);
    return st;
}
