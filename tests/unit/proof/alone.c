/* alone.c: `fmb check` as a program of its own, linked without the rooms of solvers. */
#include "fmb/commands.h"

int main(int argc, char **argv)
{
    return cmd_check(argc, argv);
}
