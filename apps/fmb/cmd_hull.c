/* cmd_hull.c: fmb hull FILE.... */
#include <stdlib.h>

#include <fmb/gmp.h>

#include "common/need.h"
#include "fmb/commands.h"
#include "fmb/lifted.h"

/* to and from have the same dimension. */
static fmb_status append_generators(fmb_generators *to, const fmb_generators *from)
{
    int n = fmb_generators_dim(from);
    fmb_status st = FMB_OK;
    mpq_t *x = app_need(malloc(((size_t)n + 1) * sizeof *x));
    for (int j = 0; j < n; j++)
        mpq_init(x[j]);
    for (size_t i = 0; st == FMB_OK && i < fmb_generators_size(from); i++) {
        for (int j = 0; j < n; j++)
            fmb_generators_coordinate_q(from, i, j, x[j]);
        st = fmb_generators_add_q(to, fmb_generators_kind(from, i), x);
    }
    for (int j = 0; j < n; j++)
        mpq_clear(x[j]);
    free(x);
    return st;
}

/* Has g a vertex? Generators without one, even with rays, generate the empty set. */
static bool has_vertex(const fmb_generators *g)
{
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        if (fmb_generators_kind(g, i) == FMB_VERTEX)
            return true;
    return false;
}

static fmb_status find_hull_of_generators(fmb_solver *v, const app_polyhedra *p, fmb_system **lift,
                                          fmb_system **out, fmb_result *res)
{
    (void)lift;
    fmb_generators *all = NULL;
    fmb_status st = fmb_generators_new(fmb_generators_dim(p->generator[0]), NULL, &all);
    for (size_t i = 0; st == FMB_OK && i < p->n; i++)
        if (has_vertex(p->generator[i]))
            st = append_generators(all, p->generator[i]);
    if (st == FMB_OK)
        st = fmb_hull(v, all, out, res);
    fmb_generators_free(all);
    return st;
}

static fmb_status find_hull(fmb_solver *v, const app_polyhedra *p, fmb_system **lift,
                            fmb_system **out, fmb_result *res)
{
    return fmb_hull_union(v, (const fmb_system *const *)p->system, p->n, lift, out, res);
}

int cmd_hull(int argc, char **argv)
{
    static const app_lifted command = {
        .args = "FILE...",
        .doc =
            "An irredundant system for the closure of the convex hull of the polyhedra in the "
            "FILEs. A FILE is a V-representation (.ext) of cddlib and lrslib, vertices, rays and "
            "lines, or a system (if it asks for a projection, that is meant). Variables are "
            "matched by their names, coordinates of a V-representation by their places. Empty "
            "polyhedra are ignored; rows with < are read as <=."
            "\v"
            "Exit codes: 0 done, 1 there is no point, 2 undecided: implied rows, perhaps not "
            "all.\n"
            "\n"
            "Examples:\n"
            "  fmb vertices cube.ine | fmb hull - --to fmb\n"
            "  fmb hull summer.fmb winter.fmb\n",
        .query = find_hull,
        .query_of_generators = find_hull_of_generators,
    };
    return app_lifted_run(&command, argc, argv);
}
