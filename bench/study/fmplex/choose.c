/* choose.c: which variable to eliminate next, by which of its bounds. Any choice is correct. */
#include "study/fmplex/path.h"

/* The number of children, less 1: 0 for an equality or bounds of one sign. */
static size_t branches(const study_plexpath *g, int j)
{
    size_t least = g->lower[j] < g->upper[j] ? g->lower[j] : g->upper[j];
    return g->equal[j] > 0 || least == 0 ? 0 : least;
}

/* Is column j better than k: fewer children, then fewer rows to form? */
static bool is_better(const study_plexpath *g, int j, int k)
{
    size_t a = branches(g, j), b = branches(g, k);
    return a < b || (a == b && g->lower[j] + g->upper[j] + g->equal[j] <
                                   g->lower[k] + g->upper[k] + g->equal[k]);
}

static int choose_var(const study_plexpath *g)
{
    int best = -1;
    for (int j = 0; j < g->n; j++) {
        if (g->lower[j] + g->upper[j] + g->equal[j] == 0)
            continue;
        if (best >= 0 && !is_better(g, j, best))
            continue;
        best = j;
        if (g->order == FMB_ORDER_GIVEN)
            break;
    }
    return best;
}

/* With all other variables 0, is a's bound on var tighter than b's? */
static bool is_tighter(const study_plexpath *g, const study_plexrow *a, const study_plexrow *b,
                       size_t var)
{
    size_t rhs = (size_t)g->n;
    return fmb_vec_compare_products(&a->v, rhs, &b->v, var, &b->v, rhs, &a->v, var) < 0;
}

/* The tightest bound of that sign (0: the first equality). */
static study_plexrow *choose_bound(const study_plexpath *g, const study_plexnode *at, int sign)
{
    study_plexrow *best = NULL;
    size_t var = (size_t)at->var;
    for (size_t i = 0; i < at->lives; i++) {
        study_plexrow *r = at->live[i];
        int s = fmb_vec_sgn(&r->v, var);
        if (s == 0 || (sign == 0 ? !r->equality : s != sign))
            continue;
        if (!best || is_tighter(g, r, best, var))
            best = r;
        if (sign == 0)
            break;
    }
    return best;
}

bool study_plexpath_choose(study_plexpath *g)
{
    study_plexnode *at = &g->node[g->depth];
    int j = at->var = choose_var(g);
    if (j < 0)
        return false;
    if (g->equal[j] > 0)
        at->via = choose_bound(g, at, 0);
    else if (g->lower[j] == 0 || g->upper[j] == 0)
        at->via = NULL;
    else
        at->via = choose_bound(g, at, g->lower[j] <= g->upper[j] ? -1 : 1);
    return true;
}
