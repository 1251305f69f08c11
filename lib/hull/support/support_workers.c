/* support_workers.c: support queries, several at once; see support.h.
 *
 * Facets are asked about in rounds of a fixed size, the k-th of each by the k-th worker, which has
 * an oracle of its own, warm from the round before, and prefers facets near the point that it found
 * last. While they look the hull takes in what was seen in the round before, in order. Workers have
 * copies of their facets, and nothing that they read moves; so what is found does not depend on how
 * many threads there are. A facet that stands does so whatever comes; what was seen beyond another
 * that has gone by then was seen in vain.
 */
#include "hull/support/support_private.h"

/* A facet that is asked about, and the answer. */
typedef struct sighting {
    size_t facet;
    fmb_facet copy;      /* of the facet, in the memory of its worker, */
    fmb_num num;         /* to find its normal, */
    fmb_support_row row; /* as is this */
    fmb_support_answer answer;
    bool waits;              /* the point of the round before has not been taken in: */
    fmb_support_point point; /* it is beyond */
    size_t beyond;           /* that facet; SIZE_MAX: it is gone */
} sighting;

struct fmb_support_workers {
    fmb_support *of;
    const fmb_program *program;
    fmb_team team;
    fmb_facets view; /* what the hull was when the round began */
    fmb_support_worker worker[FMB_SUPPORT_WORKERS];
    sighting seen[FMB_SUPPORT_WORKERS];
    size_t hired; /* workers that are there */
};

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hire_worker(fmb_support_workers *w, size_t k)
{
    fmb_run *run = &w->team.share[k].run;
    w->hired++;
    fmb_status st = fmb_support_worker_init(&w->worker[k], run, NULL, w->of->n);
    fmb_status point = fmb_support_point_init(&w->seen[k].point, w->of->n, run->mem);
    return st == FMB_OK ? point : st;
}

fmb_status fmb_support_hire(fmb_support *s, const fmb_program *p)
{
    fmb_support_workers *w;
    FMB_TRY(FMB_GET_ZERO(s->run->mem, w, 1));
    s->workers = w;
    w->of = s;
    w->program = p;
    FMB_TRY(fmb_team_open(&w->team, s->run, FMB_SUPPORT_WORKERS));
    while (w->hired < FMB_SUPPORT_WORKERS)
        FMB_TRY(hire_worker(w, w->hired));
    return FMB_OK;
}

void fmb_support_dismiss(fmb_support *s)
{
    fmb_support_workers *w = s->workers;
    if (!w)
        return;
    for (size_t k = 0; k < w->hired; k++) {
        fmb_mem *mem = w->worker[k].run->mem;
        fmb_support_drop(&w->seen[k].row, mem);
        fmb_facets_clear_copy(&s->hull, &w->seen[k].copy, mem);
        if (w->seen[k].num.mem)
            fmb_num_clear(&w->seen[k].num);
        fmb_support_point_clear(&w->seen[k].point, mem);
        fmb_oracle_free(w->worker[k].oracle);
        fmb_support_worker_clear(&w->worker[k], s);
    }
    fmb_team_close(&w->team);
    fmb_mem_put(s->run->mem, w, 1, sizeof *w);
    s->workers = NULL;
}

/* ---- questions ------------------------------------------------------------------------------- */

/* An open facet that is no image of one that stands; SIZE_MAX if there is none. */
static fmb_status choose_facet(fmb_support *s, const fmb_support_near *near, size_t *at)
{
    for (bool known = true; known;) {
        *at = fmb_support_find_open_facet(s, near);
        if (*at == SIZE_MAX || !fmb_support_is_symmetric(s))
            return FMB_OK;
        FMB_TRY(fmb_facets_need_normal(&s->hull, *at));
        FMB_TRY(fmb_support_recall(s, *at, &known));
    }
    return FMB_OK;
}

/* *n of them, a copy for each worker. */
static fmb_status choose_facets(fmb_support *s, size_t *n)
{
    fmb_support_workers *w = s->workers;
    fmb_status st = FMB_OK;
    for (*n = 0; st == FMB_OK && *n < FMB_SUPPORT_WORKERS; ++*n) {
        sighting *g = &w->seen[*n];
        st = choose_facet(s, &w->worker[*n].near, &g->facet);
        if (st != FMB_OK || g->facet == SIZE_MAX)
            break;
        s->hull.facet[g->facet].note = FMB_FACET_ASKED;
        g->row = (fmb_support_row){0};
        st = fmb_facets_copy(&s->hull, g->facet, &g->copy, w->worker[*n].run->mem);
    }
    return st;
}

/* An oracle that has found a point, which there is. */
static fmb_status give_worker_an_oracle(fmb_support_worker *c, const fmb_program *p)
{
    bool feasible;
    FMB_TRY(fmb_oracle_new(c->run, p, &c->oracle));
    return fmb_oracle_feasible(c->oracle, &feasible);
}

static fmb_status find_normal_of_copy(const fmb_support_workers *w, sighting *g, fmb_run *run)
{
    if (!g->copy.known && !g->num.mem)
        FMB_TRY(fmb_run_open_num(run, &g->num, w->view.d + 1, false));
    return fmb_facets_copy_need_normal(&w->view, &g->copy, &g->num);
}

static fmb_status look_at_facet(void *self, size_t k, fmb_run *run)
{
    fmb_support_workers *w = self;
    fmb_support_worker *c = &w->worker[k];
    sighting *g = &w->seen[k];
    FMB_TRY(fmb_run_poll_now(run));
    if (!c->oracle)
        FMB_TRY(give_worker_an_oracle(c, w->program));
    FMB_TRY(find_normal_of_copy(w, g, run));
    return fmb_support_worker_settle(c, w->of, &g->copy, &g->row, &g->answer);
}

/* ---- answers --------------------------------------------------------------------------------- */

/* Or is it gone, perhaps with another one in its place? */
static bool is_facet_there(const fmb_support *s, size_t at)
{
    const fmb_facet *a = &s->hull.facet[at];
    return a->alive && a->note == FMB_FACET_ASKED;
}

static fmb_status keep_row_seen(fmb_support *s, const sighting *g)
{
    fmb_support_row row;
    fmb_status st = fmb_support_copy_row(s, &g->row, &row);
    if (st != FMB_OK) {
        fmb_support_drop(&row, s->run->mem);
        return st;
    }
    st = fmb_support_keep_facet(s, g->facet, &row);
    return st == FMB_OK ? fmb_support_note_images(s, &s->hull.facet[g->facet].normal) : st;
}

static fmb_status hear_answer(fmb_support *s, size_t k)
{
    fmb_support_worker *c = &s->workers->worker[k];
    sighting *g = &s->workers->seen[k];
    bool there = is_facet_there(s, g->facet);
    fmb_status st = there ? fmb_facets_take_normal(&s->hull, g->facet, &g->copy) : FMB_OK;
    g->waits = g->answer == FMB_SUPPORT_BEYOND;
    if (g->waits) {
        fmb_support_point point = c->seen;
        c->seen = g->point;
        g->point = point;
        g->beyond = there ? g->facet : SIZE_MAX;
    } else if (there && st == FMB_OK) {
        if (g->answer == FMB_SUPPORT_ROW)
            st = keep_row_seen(s, g);
        else
            fmb_support_note_facet(s, g->facet, FMB_LE);
    }
    return st;
}

/* If the facet is gone, as points before this one were beyond it as well, the point may be inside
 * by now: to find out takes a look at all facets, which costs more than it gains (measured). */
static fmb_status take_in_point(fmb_support *s, size_t k)
{
    sighting *g = &s->workers->seen[k];
    bool there = g->beyond != SIZE_MAX && is_facet_there(s, g->beyond);
    g->waits = false;
    return there ? fmb_support_take(s, &s->workers->worker[k], &g->point, g->beyond) : FMB_OK;
}

static fmb_status take_in_points(fmb_support *s)
{
    for (size_t k = 0; k < FMB_SUPPORT_WORKERS; k++)
        if (s->workers->seen[k].waits)
            FMB_TRY(take_in_point(s, k));
    return FMB_OK;
}

/* ---- a round --------------------------------------------------------------------------------- */

static bool is_a_point_waiting(const fmb_support_workers *w)
{
    for (size_t k = 0; k < FMB_SUPPORT_WORKERS; k++)
        if (w->seen[k].waits)
            return true;
    return false;
}

/* Nothing that workers read moves while points are taken in. */
static fmb_status reserve_room(fmb_support *s)
{
    fmb_status st = fmb_facets_reserve(&s->hull, FMB_SUPPORT_WORKERS);
    s->workers->view = s->hull;
    return st;
}

/* With symmetries a point comes with many images: then nobody looks meanwhile. */
static fmb_status look_and_take_in(fmb_support *s, size_t n)
{
    fmb_support_workers *w = s->workers;
    fmb_status st = FMB_OK;
    fmb_team_start(&w->team, n, look_at_facet, w);
    if (!fmb_support_is_symmetric(s))
        st = take_in_points(s);
    fmb_status looked = fmb_team_finish(&w->team);
    st = st == FMB_OK ? looked : st;
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        st = hear_answer(s, k);
    return st == FMB_OK && fmb_support_is_symmetric(s) ? take_in_points(s) : st;
}

fmb_status fmb_support_ask_workers(fmb_support *s, bool *done)
{
    size_t n;
    fmb_support_workers *w = s->workers;
    fmb_status st = choose_facets(s, &n);
    FMB_THEN(st, reserve_room(s));
    *done = n == 0 && !is_a_point_waiting(w);
    if (st == FMB_OK && !*done)
        st = look_and_take_in(s, n);
    for (size_t k = 0; k < FMB_SUPPORT_WORKERS; k++)
        fmb_support_drop(&w->seen[k].row, w->worker[k].run->mem);
    return st;
}
