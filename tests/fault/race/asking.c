/* asking.c: see asking.h. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

#include <fmb/generators.h>

#include "asking.h"
#include "counted_clock.h"
#include "rows.h"

void asking_fail(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputc('\n', stderr);
    exit(1);
}

/* Cut short or not, what is claimed is proved. */
static void judge_evidence(const fmb_solver *v, const scene *c, const fmb_result *r)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(c->s, e, &j));
    if (!j.accepted && fmb_evidence_claims(e) > 0)
        asking_fail("%s: evidence rejected: %s", c->name, j.reason);
    if (r->verdict != FMB_UNKNOWN && j.verdict != r->verdict)
        asking_fail("%s: the evidence does not prove the verdict", c->name);
    fmb_evidence_free(e);
}

static void judge_result(const scene *c, const fmb_result *r)
{
    if (r->verdict != FMB_UNKNOWN && r->verdict != c->verdict)
        asking_fail("%s: %s", c->name, fmb_verdict_text(r->verdict));
    if (r->verdict == FMB_UNKNOWN && r->stop == FMB_STOP_DONE)
        asking_fail("%s: done without a verdict", c->name);
}

/* An end of a cone is 0 below, infinite above. One that is only outer cuts nothing off. */
static void judge_end(const scene *c, fmb_end end, fmb_side side, fmb_stop stop)
{
    bool cut = end.kind != FMB_END_FINITE && end.kind != FMB_END_INFINITE;
    if (cut && stop == FMB_STOP_DONE)
        asking_fail("%s: done without an end", c->name);
    if (!c->cone || end.kind == FMB_END_UNKNOWN)
        return;
    bool low = side == FMB_LOWER && end.value <= 0, tight = low && end.value >= 0;
    bool high = side == FMB_UPPER && isinf(end.value);
    if (!high && !(cut ? low : tight))
        asking_fail("%s: an end of %g", c->name, end.value);
}

static void project(fmb_solver *v, const scene *c, fmb_result *r, size_t *readings)
{
    fmb_system *p = NULL;
    must(fmb_project(v, c->s, c->keep, c->kept, &p, r));
    *readings = counted_clock_readings();
    if (!p && r->stop == FMB_STOP_DONE)
        asking_fail("%s: done without a projection", c->name);
    fmb_system_free(p);
}

static void bound(fmb_solver *v, const scene *c, fmb_result *r, size_t *readings)
{
    fmb_box *box = NULL;
    must(fmb_bound(v, c->s, NULL, 0, &box, r));
    *readings = counted_clock_readings();
    if (!box && r->verdict == FMB_FEASIBLE)
        asking_fail("%s: feasible without a box", c->name);
    for (int i = 0; box && i < fmb_box_size(box); i++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
            judge_end(c, fmb_box_end(box, i, (fmb_side)side), (fmb_side)side, r->stop);
    fmb_box_free(box);
}

static void reduce(fmb_solver *v, const scene *c, fmb_result *r, size_t *readings)
{
    fmb_system *p = NULL;
    must(fmb_reduce(v, c->s, NULL, &p, r));
    *readings = counted_clock_readings();
    if (!p && r->stop != FMB_STOP_BYTES) /* which may have no room for a copy */
        asking_fail("%s: no reduced system", c->name);
    fmb_system_free(p);
}

/* The sum of all variables, as large as it gets. */
static void optimize(fmb_solver *v, const scene *c, fmb_result *r, size_t *readings)
{
    enum { MOST_VARIABLES = 256 };
    double one[MOST_VARIABLES];
    fmb_optimum *o = NULL;
    if (fmb_system_dim(c->s) > MOST_VARIABLES)
        asking_fail("%s: too many variables", c->name);
    for (int j = 0; j < MOST_VARIABLES; j++)
        one[j] = 1;
    must(fmb_optimize(v, c->s, &(fmb_objective){FMB_SENSE_MAX, one, 0}, &o, r));
    *readings = counted_clock_readings();
    if (!o && r->verdict == FMB_FEASIBLE)
        asking_fail("%s: feasible without an optimum", c->name);
    if (o)
        judge_end(c, fmb_optimum_end(o), FMB_UPPER, r->stop);
    fmb_optimum_free(o);
}

static void vertices(fmb_solver *v, const scene *c, fmb_result *r, size_t *readings)
{
    fmb_generators *g = NULL;
    must(fmb_generate(v, c->s, &g, r));
    *readings = counted_clock_readings();
    if (!g && r->verdict == FMB_FEASIBLE && r->stop == FMB_STOP_DONE)
        asking_fail("%s: feasible without vertices", c->name);
    fmb_generators_free(g);
}

/* (t, t^2, ...): of each two neighbours in 4 to 7 dimensions some facet goes through. */
static void hull(fmb_solver *v, const scene *c, fmb_result *r, size_t *readings)
{
    enum { POINTS = 48, MOST_DIM = 7 };
    double x[MOST_DIM];
    int dim = 4 + c->kept % 4;
    fmb_generators *g = NULL;
    fmb_system *s = NULL;
    must(fmb_generators_new(dim, NULL, &g));
    for (int i = 0; i < POINTS; i++) {
        for (int j = 0; j < dim; j++)
            x[j] = (j == 0 ? 1 : x[j - 1]) * (i - POINTS / 2);
        must(fmb_generators_add(g, FMB_VERTEX, x));
    }
    must(fmb_hull(v, g, &s, r));
    *readings = counted_clock_readings();
    if (s ? r->verdict != FMB_FEASIBLE : r->stop == FMB_STOP_DONE)
        asking_fail("the hull: %s", fmb_verdict_text(r->verdict));
    fmb_system_free(s);
    fmb_generators_free(g);
}

fmb_result asking(fmb_solver *v, const scene *c, asking_kind kind, size_t *readings)
{
    fmb_result r = {.size = sizeof r};
    if (kind == ASKING_PROJECT)
        project(v, c, &r, readings);
    else if (kind == ASKING_BOUND)
        bound(v, c, &r, readings);
    else if (kind == ASKING_REDUCE)
        reduce(v, c, &r, readings);
    else if (kind == ASKING_OPTIMIZE)
        optimize(v, c, &r, readings);
    else if (kind == ASKING_VERTICES)
        vertices(v, c, &r, readings);
    else if (kind == ASKING_HULL) {
        hull(v, c, &r, readings);
        return r;
    } else {
        must(fmb_solve(v, c->s, &r));
        *readings = counted_clock_readings();
    }
    judge_result(c, &r);
    judge_evidence(v, c, &r);
    return r;
}
