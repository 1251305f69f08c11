/* cmd_sum.c: fmb sum FILE.... */
#include "fmb/commands.h"
#include "fmb/lifted.h"

static fmb_status find_sum(fmb_solver *v, const app_polyhedra *p, fmb_system **lift,
                           fmb_system **out, fmb_result *res)
{
    return fmb_sum(v, (const fmb_system *const *)p->system, p->n, lift, out, res);
}

int cmd_sum(int argc, char **argv)
{
    static const app_lifted command = {
        .args = "FILE...",
        .doc =
            "The Minkowski sum of the polyhedra in the FILEs, all sums of a point of each, as an "
            "irredundant system. A FILE is a system (if it asks for a projection, that is meant) "
            "or a V-representation (.ext). Variables are matched by their names, coordinates of a "
            "V-representation by their places. Strict rows stay strict."
            "\v"
            "Exit codes: 0 done, 1 infeasible, 2 undecided: implied rows, perhaps not all.\n"
            "\n"
            "Examples:\n"
            "  fmb sum room.fmb robot.fmb\n"
            "  fmb sum a.ext b.ext c.ext --to fmb\n",
        .query = find_sum,
    };
    return app_lifted_run(&command, argc, argv);
}
