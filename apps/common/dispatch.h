/* dispatch.h: a program that is a table of subcommands. */
#ifndef APP_DISPATCH_H
#define APP_DISPATCH_H

#include <stddef.h>

typedef struct app_command {
    const char *name;
    char *title; /* argv[0] of the command */
    const char *summary;
    int (*run)(int argc, char **argv); /* an exit code */
} app_command;

typedef struct app_program {
    char *name;
    const char *word, *heading; /* the terms for a subcommand: "command", "Commands" */
    const char *args, *doc;     /* as for argp; the table comes after the first part of doc */
    const app_command *command;
    size_t commands;
    const app_command *otherwise; /* run for options without a subcommand, or NULL */
} app_program;

/* Run the subcommand that the command line names, with the options before and after it. Does not
 * return after an error. */
int app_dispatch(const app_program *p, int argc, char **argv);

#endif
