/* fmb-qualify.c: studies of the library: a table of subcommands, one a question. */
#include "common/dispatch.h"
#include "qualify/commands.h"

static const app_command commands[] = {
    {"rules", "fmb-qualify rules", "pruning rules x orders x systems: rows, time, errors",
     qualify_rules},
};

static const char doc[] =
    "Measure the library on random frames and on files, with seeds and against exact answers."
    "\v"
    "`fmb-qualify STUDY --help` tells the options of a study.\n"
    "\n"
    "Exit codes: 0 done, 1 a wrong answer was found, 2 interrupted, 64 usage, 65 bad input, 66 "
    "cannot open, 70 internal error, 74 cannot write.\n"
    "\n"
    "Example:\n"
    "  fmb-qualify rules --out report\n";

int main(int argc, char **argv)
{
    static char name[] = "fmb-qualify";
    const app_program program = {.name = name,
                                 .word = "study",
                                 .heading = "Studies",
                                 .args = "STUDY [OPTION...]",
                                 .doc = doc,
                                 .command = commands,
                                 .commands = sizeof commands / sizeof *commands};
    return app_dispatch(&program, argc, argv);
}
