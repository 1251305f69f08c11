/* cmd_image.c: fmb image FILE MAP. */
#include "fmb/commands.h"
#include "fmb/lifted.h"

static fmb_status find_image(fmb_solver *v, const app_polyhedra *p, fmb_system **lift,
                             fmb_system **out, fmb_result *res)
{
    return fmb_image(v, p->system[0], p->graph, lift, out, res);
}

int cmd_image(int argc, char **argv)
{
    static const app_lifted command = {
        .args = "FILE MAP",
        .doc =
            "The image of the polyhedron in FILE under the affine map in MAP, as an irredundant "
            "system. FILE is a system (if it asks for a projection, that is meant) or a "
            "V-representation (.ext). MAP has a line NAME = FORM for each coordinate of the image, "
            "with forms over the variables of FILE. Strict rows stay strict."
            "\v"
            "Exit codes: 0 done, 1 infeasible, 2 undecided: implied rows, perhaps not all.\n"
            "\n"
            "Examples:\n"
            "  printf 'u = x + y\\nv = x - 2y + 1\\n' | fmb image shape.fmb -\n"
            "  fmb image shape.ine turn.map --proof turn.proof --lifted turn.fmb\n",
        .map = true,
        .query = find_image,
    };
    return app_lifted_run(&command, argc, argv);
}
