/* common.c: the points that two frames have in common, as a polytope; see fmb/proximity.h. */
#include "num/rationals.h"
#include "proximity/angular_sort.h"
#include "proximity/proximity_private.h"
#include "system/generators_private.h"

/* [give] The generators of g without all coordinates but the first few and, if asked for, the
 * last. */
static fmb_status drop_coordinates(const fmb_generators *g, int first, bool last,
                                   const fmb_alloc *mem, fmb_generators **out)
{
    int dim = fmb_generators_dim(g), n = first + last;
    fmb_generators *small = NULL;
    mpq_t *x = NULL;
    fmb_status st = fmb_generators_new(n, mem, &small);
    FMB_THEN(st, fmb_rationals_new(&x, (size_t)n, &small->mem));
    for (size_t i = 0; st == FMB_OK && i < fmb_generators_size(g); i++) {
        for (int j = 0; j < n; j++)
            fmb_generators_coordinate_q(g, i, j < first ? j : dim - 1, x[j]);
        st = fmb_generators_add_q(small, fmb_generators_kind(g, i), x);
    }
    if (small)
        fmb_rationals_free(x, (size_t)n, &small->mem);
    if (st == FMB_OK)
        *out = small;
    else
        fmb_generators_free(small);
    return st;
}

/* [give] Those of g that are vertices of their hull. NULL at a limit. */
static fmb_status keep_vertices(fmb_solver *v, const fmb_generators *g, fmb_generators **out,
                                fmb_result *res)
{
    fmb_system *hull = NULL;
    fmb_status st = fmb_hull(v, g, &hull, res);
    if (st == FMB_OK && hull && res->stop == FMB_STOP_DONE)
        st = fmb_generate(v, hull, out, res);
    fmb_system_free(hull);
    return st;
}

/* Where axes depend on each other: all coordinates are variables, and go. */
static fmb_status find_from_all(fmb_solver *v, const fmb_two *two, fmb_generators **out,
                                fmb_result *res)
{
    fmb_system *s = NULL;
    fmb_generators *all = NULL, *points = NULL;
    fmb_status st = fmb_two_system(two, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, &v->mem.alloc, &s);
    FMB_THEN(st, fmb_generate(v, s, &all, res));
    if (st == FMB_OK && all && res->stop == FMB_STOP_DONE)
        st = drop_coordinates(all, fmb_two_dim(two), fmb_two_moves(two), &v->mem.alloc, &points);
    if (st == FMB_OK && points)
        st = keep_vertices(v, points, out, res);
    fmb_generators_free(points);
    fmb_generators_free(all);
    fmb_system_free(s);
    return st;
}

static fmb_status find_common_points(fmb_solver *v, const fmb_two *two, fmb_generators **out,
                                     fmb_result *res)
{
    fmb_system *s = NULL;
    fmb_generators *found = NULL;
    fmb_result r = {.size = sizeof r};
    FMB_TRY(fmb_two_expect(v, two, out != NULL, res));
    fmb_status st =
        fmb_two_system(two, FMB_COORDINATES_WORLD, FMB_CONTACT_CLOSED, &v->mem.alloc, &s);
    if (st == FMB_ERR_ARG)
        st = find_from_all(v, two, &found, &r);
    else if (st == FMB_OK)
        st = fmb_generate(v, s, &found, &r);
    v->answered = false;
    fmb_system_free(s);
    if (st == FMB_OK && found)
        st = fmb_angular_sort(&found, &v->mem);
    if (st != FMB_OK || r.stop != FMB_STOP_DONE) { /* some are not the common points */
        fmb_generators_free(found);
        found = NULL;
    }
    if (st == FMB_OK) {
        *out = found;
        fmb_result_give(res, &r);
    }
    return st;
}

fmb_status fmb_common(fmb_solver *v, const fmb_frame *f, fmb_generators **out, fmb_result *res)
{
    return find_common_points(v, &(fmb_two){.f = f}, out, res);
}

fmb_status fmb_common_q(fmb_solver *v, const fmb_frame_q *f, fmb_generators **out, fmb_result *res)
{
    return find_common_points(v, &(fmb_two){.q = f}, out, res);
}
