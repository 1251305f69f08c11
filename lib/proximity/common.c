/* common.c: the points that two frames have in common, as a polytope; see fmb/proximity.h. */
#include "proximity/angular_sort.h"
#include "proximity/proximity_private.h"

/* For dependent axes, such as those of a hull of many points: the coordinates along them are
 * variables of the system, and are eliminated. */
static fmb_status find_from_all(fmb_solver *v, const fmb_two *two, fmb_generators **out,
                                fmb_result *res)
{
    int dim = fmb_two_dim(two), n = dim + fmb_two_moves(two), *keep = NULL;
    fmb_system *all = NULL, *rows = NULL;
    fmb_status st = FMB_GET(&v->mem, keep, (size_t)n);
    FMB_THEN(st, fmb_two_system(two, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, &v->mem.alloc, &all));
    for (int j = 0; st == FMB_OK && j < n; j++)
        keep[j] = j < dim ? j : fmb_system_dim(all) - 1;
    FMB_THEN(st, fmb_project(v, all, keep, n, &rows, res));
    if (st == FMB_OK && rows && res->stop == FMB_STOP_DONE)
        st = fmb_generate(v, rows, out, res);
    fmb_system_free(rows);
    fmb_system_free(all);
    fmb_mem_put(&v->mem, keep, (size_t)n, sizeof *keep);
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
    if (st != FMB_OK || r.stop != FMB_STOP_DONE) { /* a partial list is no answer */
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
