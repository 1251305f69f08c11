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
    const char *word, *heading; /* what a subcommand is called: "command", "Commands" */
    const char *args, *doc;     /* as argp takes them; the table stands after doc's first part */
    const app_command *command;
    size_t commands;
    const app_command *otherwise; /* what options without a subcommand mean, or NULL */
} app_program;

/* Run the subcommand that the command line names, with the options before it as well as those
 * behind. Does not return after a mistake. */
int app_dispatch(const app_program *p, int argc, char **argv);

#endif
