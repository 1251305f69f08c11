/* fmplex.c: FMplex, deciding a system by elimination without pairing everything.
 *
 * Source: Nalbach, Promies, Abraham, Kobialka, FMplex: a novel method for solving linear real
 * arithmetic problems, arXiv:2309.03138 (2023), key FMplex2023. From this paper are the branching
 * over the bounds of a variable and the signs of multipliers (global and local conflicts). A local
 * conflict is used for more here: the paper stores for each row a level to return to, here the
 * tried bound is dropped for good.
 *
 * Elimination. Take a node's system N (rows a.x <= b), a variable x, and one side of its bounds,
 * say the lower ones l_1 <= x, ..., l_p <= x. In a solution some l_i is largest. The child of i
 * requires this: l_k <= l_i for the other lower bounds, l_i <= u for each upper bound u, and the
 * rows without x as they are. It has fewer rows than N. A solution of a child gives one of N with x
 * = l_i, and a solution of N satisfies some child. A child's new row is alpha p + beta q, p a row
 * of N, q the bound tried, with alpha > 0; beta > 0 where p is an upper bound, but beta < 0 where
 * it is a lower one. An equality with x in it leaves one child (x is substituted; beta has any
 * sign), and so do bounds of one side only (they are dropped). Strict rows are a.x + d <= b with an
 * infinitesimal d > 0, the same d in all: everything here holds over any ordered field.
 *
 * Conflicts. Say that weights y refute N if y >= 0 but for equalities and the rows times y add up
 * to a false constant row. Claim: once the search leaves N without a solution, it has weights that
 * refute N. A false row made in N's child refutes the child by weight 1. Let weights refute the
 * child of bound i. Replace each new row by the rows it combines: that gives weights over the rows
 * of N, >= 0 (but for equalities) except perhaps for the weight y_i of the bound tried.
 *   y_i >= 0: they refute N. No other child is tried (the same test is made at the nodes above, so
 *     whole levels are left at once).
 *   y_i < 0: the others, with their weights, add up to |y_i| times row i with a smaller right side:
 *     row i follows from the others and is dropped from N. N has the same solutions as before, is
 *     smaller by a row, and is searched anew; weights that refute it refute N with row i, too.
 *     Of the bounds of its side that imply it, the one with the largest weight times coefficient is
 *     tried next, like a pivot: mostly far fewer nodes than in any fixed order.
 * A single bound on its side meets no bound of the same side: all beta > 0, and y_i >= 0. So N is
 * refuted at the latest then. By induction over depth (n at most) and rows the search ends, and
 * what it returns at the root are weights over the user's rows: a certificate. (A false row s d <=
 * b has b < 0, or b = 0 and s > 0, and there s is the sum of the weights of strict rows.)
 *
 * Memory: one path, so at most (n + 1) m rows. Time: a node with p bounds has at most p children,
 * so there are at most m^n nodes: singly exponential.
 */
#include "study/fmplex/path.h"

static fmb_status search(study_plexpath *g, bool *feasible, fmb_weights *w)
{
    bool global = false;
    fmb_status st = fmb_run_poll_now(g->run);
    *feasible = false;
    while (st == FMB_OK && !global && !*feasible) {
        if (g->clash)
            st = study_plexpath_retreat(g, &global, w);
        else
            *feasible = !study_plexpath_choose(g);
        if (st == FMB_OK && !global && !*feasible)
            st = study_plexpath_descend(g);
    }
    return st;
}

fmb_status study_fmplex_decide(fmb_run *run, fmb_arena *arena, int n, size_t m, const fmb_vec *row,
                               const fmb_rel *rel, const fmb_options *o, bool *feasible, mpq_t *x,
                               fmb_weights *w)
{
    study_plexpath g;
    bool found = false;
    fmb_status st = study_plexpath_init(&g, run, arena, n, m, row, rel, o);
    if (st == FMB_OK)
        st = search(&g, &found, w);
    if (st == FMB_OK && found && x)
        st = study_plexpath_point(&g, x);
    if (st == FMB_OK)
        *feasible = found;
    study_plexpath_clear(&g);
    return st;
}
