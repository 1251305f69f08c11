/* paused.c: rows that a paused engine proved are told if a limit comes while another one runs. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/fmb.h>

#include "study/program/projection.h"
#include "support/must.h"

typedef struct cut {
    fmb_solver *v;
    const char *engine, *ended; /* cancel where this engine ended like this */
    bool done;
} cut;

static void cancel_at_attempt(void *self, const fmb_event *e)
{
    cut *c = self;
    if (e->kind != FMB_EVENT_ENGINE || strcmp(e->attempt->engine, c->engine) != 0 ||
        strcmp(e->attempt->ended, c->ended) != 0)
        return;
    c->done = true;
    fmb_solver_cancel(c->v);
}

/* The rows of a projection that is cancelled then; *done false: it never came to that. */
static size_t count_rows_once_cancelled(const study_projection *x, const char *engine,
                                        const char *ended, bool *done)
{
    int keep[16];
    cut c = {.engine = engine, .ended = ended};
    fmb_system *p = NULL;
    fmb_result r = {.size = sizeof r};
    for (int k = 0; k < x->keep; k++)
        keep[k] = k;
    must(fmb_solver_new(NULL, NULL, &c.v));
    fmb_solver_set_sink(c.v, (fmb_sink){cancel_at_attempt, &c});
    must(fmb_project(c.v, x->s, keep, x->keep, &p, &r));
    *done = c.done && r.stop == FMB_STOP_CANCELLED;
    size_t rows = fmb_system_rows(p);
    fmb_system_free(p);
    fmb_solver_free(c.v);
    return rows;
}

/* What an elimination proved until it paused is told, though another engine ran when the query was
 * cancelled: more than was known before it began. */
Test(paused, elimination)
{
    int family = 0;
    bool paused, begun;
    study_projection x;
    while (strcmp(study_projection_name(family), "stages") != 0)
        family++;
    must(study_projection_draw(family, 430002, &x));
    size_t then = count_rows_once_cancelled(&x, "elimination", "paused", &paused);
    size_t before = count_rows_once_cancelled(&x, "bounded elimination", "gave up", &begun);
    cr_assert(paused && begun, "this problem takes another way now: see test-ways-taken");
    cr_expect_gt(then, before);
    fmb_system_free(x.s);
}
