/* main.c: fmb, the command: a table of subcommands. */
#include "common/dispatch.h"
#include "fmb/commands.h"
#include "fmb/kind.h"

static const app_command commands[] = {
    {"solve", "fmb solve", "is it feasible? a point, or the rows in conflict", cmd_solve},
    {"bounds", "fmb bounds", "the tightest interval of every variable", cmd_bounds},
    {"optimize", "fmb optimize", "the best value of a linear form", cmd_optimize},
    {"project", "fmb project", "the projection on some variables", cmd_project},
    {"reduce", "fmb reduce", "an irredundant system; which rows are redundant, and why",
     cmd_reduce},
    {"vertices", "fmb vertices", "its vertices, rays and lines", cmd_vertices},
    {"hull", "fmb hull", "the convex hull of polyhedra, or of vertices, rays and lines", cmd_hull},
    {"sum", "fmb sum", "the Minkowski sum of polyhedra", cmd_sum},
    {"image", "fmb image", "the image of a polyhedron under an affine map", cmd_image},
    {"check", "fmb check", "accept or reject the proof of an answer", cmd_check},
    {"intersect", "fmb intersect", "do two frames meet, where and when? for pairs of them",
     cmd_intersect},
    {"mesh", "fmb mesh", "which cells of one or two meshes meet, and how", cmd_mesh},
    {"convert", "fmb convert", "write the system in another format", cmd_convert},
};

static const char doc[] =
    "Answer questions about systems of linear inequalities, exactly and with proofs."
    "\v"
    "FILE may be - for standard input. Formats: .fmb text, .ine, .ieq, .smt2, .mps, .lp.\n"
    "`fmb COMMAND --help` lists the options of a command.\n"
    "\n"
    "Exit codes: 0 yes or done, 1 no (infeasible, proof rejected, apart), 2 undecided (a limit was "
    "reached), "
    "64 usage, 65 bad input, 66 cannot open, 70 internal error, 74 cannot write.\n"
    "\n"
    "Examples:\n"
    "  fmb solve diet.fmb\n"
    "  fmb bounds diet.fmb --vars bread,milk\n"
    "  fmb optimize diet.fmb --min '0.4 bread + 0.35 milk'\n"
    "  fmb project shape.ine --keep x1,x2 --json\n"
    "  fmb solve plan.smt2 --proof plan.proof; fmb check plan.smt2 plan.proof\n"
    "  fmb intersect rooms.jsonl\n";

int main(int argc, char **argv)
{
    static char name[] = "fmb";
    const app_program program = {.name = name,
                                 .word = "command",
                                 .heading = "Commands",
                                 .args = "COMMAND FILE [OPTION...]",
                                 .doc = doc,
                                 .command = commands,
                                 .commands = sizeof commands / sizeof *commands};
    app_source_kind = app_kind_of;
    return app_dispatch(&program, argc, argv);
}
