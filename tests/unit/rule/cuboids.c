/* cuboids.c: see cuboids.h. */
#include "cuboids.h"

#include <fmb/frame.h>

#include "property/random/rows.h"
#include "support.h"

enum { D = 3, PAIRS = 100 };

/* Origin, axes, speed. */
typedef struct numbers {
    double origin[D], axes[D * D], speed[D];
} numbers;

static fmb_frame draw_frame(support_rng *g, numbers *n)
{
    for (int i = 0; i < D; i++)
        n->origin[i] = support_between(g, -3, 3);
    for (int i = 0; i < D * D; i++)
        n->axes[i] = support_between(g, -3, 3);
    for (int i = 0; i < D; i++)
        n->speed[i] = support_between(g, -1, 1);
    return (fmb_frame){FMB_CUBOID, D, D, n->origin, n->axes, n->speed};
}

/* Frames whose axes are dependent are drawn again. */
static fmb_system *draw_pair(support_rng *g)
{
    numbers n[2];
    fmb_system *s = NULL;
    do {
        fmb_frame a = draw_frame(g, &n[0]), b = draw_frame(g, &n[1]);
        if (fmb_system_from_frames((fmb_frame[]){a, b}, 2, FMB_COORDINATES_LAST, FMB_CONTACT_CLOSED,
                                   NULL, &s) == FMB_OK)
            return s;
    } while (true);
}

/* False if they do not meet. */
static bool count(fmb_solver *v, const fmb_system *s, double *sum)
{
    static const int keep = D;
    fmb_result r = {.size = sizeof r};
    fmb_system *out = NULL;
    must(fmb_project(v, s, &keep, 1, &out, &r));
    fmb_system_free(out);
    if (r.verdict == FMB_FEASIBLE)
        *sum += (double)r.stats.rows_made;
    return r.verdict == FMB_FEASIBLE;
}

double cuboids_rows_made(const char *rules, const char *presolve)
{
    support_rng g = {1};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    double sum = 0;
    o.method = FMB_METHOD_FM;
    o.rules = rules;
    o.presolve = presolve;
    o.evidence = FMB_EVIDENCE_NONE;
    must(fmb_solver_new(&o, NULL, &v));
    for (int meeting = 0; meeting < PAIRS;) {
        fmb_system *s = draw_pair(&g);
        meeting += count(v, s, &sum);
        fmb_system_free(s);
    }
    fmb_solver_free(v);
    return sum / PAIRS;
}
