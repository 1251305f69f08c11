/* lift_sum.c: lifts of images and of Minkowski sums: rows side by side, and linking rows; see
 * lift_private.h.
 *
 * A point y is in the image if some (x, y) is in the graph with x in the polyhedron, and in the sum
 * if it is the sum of one point of each: the lifts state exactly this, so strict rows stay strict.
 */
#include "lift/lift_private.h"
#include "system/system_private.h"

/* Add the variables of the graph after those that s keeps. */
fmb_status fmb_lift_add_answer_of_graph(fmb_system *lift, const fmb_system *s,
                                        const fmb_system *graph)
{
    lift->asks_projection = true;
    for (int i = fmb_lift_dim(s); i < fmb_system_dim(graph); i++) {
        int index;
        FMB_TRY(fmb_system_add_variable(lift, fmb_system_name(graph, i), &index));
        fmb_system_set_kept(lift, index, true);
    }
    return FMB_OK;
}

/* var[dim of graph], copy[dim of s] */
static fmb_status join_graph_and_copy(fmb_system *lift, const fmb_system *s,
                                      const fmb_system *graph, int *var, int *copy)
{
    int d = fmb_lift_dim(s);
    fmb_status st = fmb_lift_add_answer_of_graph(lift, s, graph);
    for (int i = d; i < fmb_system_dim(graph); i++)
        var[i] = i - d;
    FMB_THEN(st, fmb_lift_add_copies(lift, s, 0, copy));
    for (int j = 0, i = 0; st == FMB_OK && j < fmb_system_dim(s); j++)
        if (fmb_system_keeps(s, j))
            var[i++] = copy[j];
    FMB_THEN(st, fmb_system_join(lift, graph, var));
    return st == FMB_OK ? fmb_system_join(lift, s, copy) : st;
}

fmb_status fmb_lift_image(fmb_system *lift, const fmb_system *s, const fmb_system *graph)
{
    int d = fmb_lift_dim(s), places = fmb_system_dim(graph);
    if (places < d)
        return fmb_system_refuse(lift, "the graph has %d variables, but the system keeps %d",
                                 places, d);
    int *var = fmb_mem_get(&lift->mem, (size_t)places, sizeof *var);
    int *copy = fmb_mem_get(&lift->mem, (size_t)fmb_system_dim(s), sizeof *copy);
    fmb_status st =
        var && copy ? join_graph_and_copy(lift, s, graph, var, copy) : fmb_mem_status(&lift->mem);
    fmb_mem_put(&lift->mem, copy, (size_t)fmb_system_dim(s), sizeof *copy);
    fmb_mem_put(&lift->mem, var, (size_t)places, sizeof *var);
    return st;
}

fmb_status fmb_lift_sum(fmb_system *lift, const fmb_system *const *s, size_t n)
{
    fmb_lift_copies c;
    fmb_status st = fmb_lift_open_copies(&c, lift, s[0], s, n);
    FMB_THEN(st, fmb_lift_append_sums(&c, lift));
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        st = fmb_system_join(lift, s[k], c.var[k]);
    fmb_lift_close_copies(&c, lift);
    return st;
}
