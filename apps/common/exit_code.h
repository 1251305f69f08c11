/* exit_code.h: the exit codes of all commands. The numbers from 64 on are those of <sysexits.h>. */
#ifndef APP_EXIT_CODE_H
#define APP_EXIT_CODE_H

enum app_exit_code {
    APP_YES = 0,          /* feasible, accepted, or simply done */
    APP_NO = 1,           /* infeasible, or the check failed */
    APP_UNDECIDED = 2,    /* a limit was reached first, or the query was cancelled */
    APP_USAGE = 64,       /* unknown option, value, or variable */
    APP_BAD_INPUT = 65,   /* malformed file */
    APP_CANNOT_OPEN = 66, /* a file that is not there or cannot be read */
    APP_INTERNAL = 70,    /* out of memory, or a bug */
    APP_CANNOT_WRITE = 74 /* a full disk, a missing folder */
};

/* The first of two exit codes that is not APP_YES. */
static inline int app_first_code(int a, int b)
{
    return a != APP_YES ? a : b;
}

#endif
