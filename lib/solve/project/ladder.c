/* ladder.c: the projection of one part, and which way leads to it; see ladder.h. */
#include "solve/project/ladder.h"

#include "solve/limit/outer.h"
#include "solve/project/polygon.h"
#include "solve/project/rays.h"
#include "solve/project/support.h"
#include "solve/project/thin.h"
#include "solve/query/rule_lp.h"

/* One part on its way by elimination. */
typedef struct shadow {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for variables that go */
    fmb_system *out;
    fmb_elim e;
} shadow;

/* ---- by elimination -------------------------------------------------------------------------- */

/* Many rows for their variables are mostly redundant: then the rule looks before the first pairs,
 * whose number is the square of theirs. Else it waits until rows have doubled. */
static bool has_rows_in_plenty(const fmb_part *p)
{
    return p->m >= 64 && p->m / 8 >= (size_t)p->n;
}

/* budget > 0: *done false when the store outgrows it. */
static fmb_status eliminate_unkept_columns(shadow *h, bool feasible, size_t budget, bool *done)
{
    fmb_query *q = h->q;
    bool *drop = fmb_arena_get(&q->v->arena, (size_t)h->p->n, sizeof *drop);
    if (!drop)
        return fmb_mem_status(q->run.mem);
    for (int j = 0; j < h->p->n; j++)
        drop[j] = h->place[h->p->var[j]] < 0;
    fmb_status st = fmb_query_load(q, h->p, feasible, &h->e);
    h->e.budget = budget;
    if (st == FMB_OK && feasible && has_rows_in_plenty(h->p))
        st = fmb_elim_prune(&h->e);
    if (st == FMB_OK)
        st = fmb_elim_eliminate(&h->e, drop);
    *done = st == FMB_OK;
    return st == FMB_LIMIT && h->e.over_budget ? FMB_OK : st;
}

static fmb_status project_by_elimination(shadow *h, bool known, size_t budget, bool *feasible,
                                         bool *done)
{
    size_t rows = fmb_system_rows(h->out);
    fmb_status st = eliminate_unkept_columns(h, known, budget, done);
    if (st == FMB_OK && *done)
        *feasible = h->e.clash == FMB_NO_ROW;
    if (st == FMB_OK && *done && *feasible)
        st = fmb_thin_out(h->q, h->p, h->place, &h->e, known || h->q->decided, h->out, feasible);
    fmb_status saved = FMB_OK;
    bool room = h->q->run.stop != FMB_STOP_DONE && h->e.n > 0; /* else memory ran out, or no row
                                                                   was loaded */
    if (st == FMB_LIMIT && room && fmb_system_rows(h->out) == rows)
        saved = fmb_outer_rows(h->q, h->p, &h->e, h->place, h->out);
    fmb_elim_clear(&h->e);
    return saved != FMB_OK ? saved : st;
}

/* ---- which way ------------------------------------------------------------------------------- */

/* A few rows are eliminated faster than anything else is done. */
#define TRIAL_BUDGET(m) (128 + 4 * (m))

static fmb_status is_part_feasible(fmb_query *q, int part, bool *feasible)
{
    fmb_lp *lp;
    return fmb_query_dictionary(q, part, &lp, feasible);
}

static bool uses_lp_rule(const fmb_solver *v)
{
    for (int k = 0; k < v->rules; k++)
        if (v->rule[k] == &fmb_rule_lp)
            return true;
    return false;
}

/* A hull in so many dimensions mostly has few enough facets. */
#define FEW_KEPT 6

static int count_kept_columns(const fmb_part *p, const int *place)
{
    int kept = 0;
    for (int j = 0; j < p->n; j++)
        kept += place[p->var[j]] >= 0;
    return kept;
}

/* In the plane around it, in a few dimensions by asking how far it goes: both without elimination.
 */
static fmb_status project_by_looks(fmb_query *q, int part, const int *place, fmb_system *out,
                                   bool *feasible, bool *done)
{
    int kept = count_kept_columns(&q->parts.part[part], place);
    fmb_status st = FMB_OK;
    if (kept <= 2 && !q->decided)
        st = is_part_feasible(q, part, feasible);
    if (st == FMB_OK && kept <= 2 && *feasible)
        st = fmb_query_polygon_part(q, part, place, out, done);
    if (st != FMB_OK || *done || !*feasible || kept > FEW_KEPT)
        return st;
    *done = true;
    return fmb_query_support_part(q, part, place, out, feasible);
}

/* First a short elimination; if that grows, what the projection looks like; if it has too many
 * dimensions for that, the oracle finds out whether there is a solution, and what is left is
 * eliminated, and pruned by the oracle. With method fm there is no first try. */
fmb_status fmb_query_project_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible)
{
    const fmb_part *p = &q->parts.part[part];
    const shadow start = {.q = q, .p = p, .place = place, .out = out, .e.run = &q->run};
    bool fm = fmb_query_eliminates(q), known = q->decided, done = false;
    shadow h = start;
    fmb_status st = FMB_OK;
    *feasible = true;
    if (q->v->options.method == FMB_METHOD_HULL)
        return fmb_query_support_part(q, part, place, out, feasible);
    if (q->v->options.method == FMB_METHOD_DD)
        st = fmb_query_project_by_rays(q, part, place, out, feasible, &done);
    if (st == FMB_OK && !done && *feasible && !fm)
        st = project_by_elimination(&h, false, TRIAL_BUDGET(p->m), feasible, &done);
    if (st == FMB_OK && !done && *feasible && !fm)
        st = project_by_looks(q, part, place, out, feasible, &done);
    if (st == FMB_OK && !done && *feasible && !known && (!fm || uses_lp_rule(q->v))) {
        st = is_part_feasible(q, part, feasible);
        known = true;
    }
    if (st != FMB_OK || done || !*feasible)
        return st;
    h = start;
    return project_by_elimination(&h, known, 0, feasible, &done);
}
