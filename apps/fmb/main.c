/* main.c: fmb, the command: a table of subcommands. */
#include <argp.h>
#include <fmb/base.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "fmb/commands.h"

typedef struct command {
    const char *name;
    char *title; /* argv[0] of the command */
    const char *summary;
    int (*run)(int argc, char **argv);
} command;

static const command commands[] = {
    {"solve", "fmb solve", "is it feasible? a point, or the rows in conflict", cmd_solve},
    {"bounds", "fmb bounds", "the tightest interval of every variable", cmd_bounds},
    {"project", "fmb project", "the projection on some variables", cmd_project},
    {"reduce", "fmb reduce", "the rows that matter; which others go, and why", cmd_reduce},
    {"check", "fmb check", "accept or reject the proof of an answer", cmd_check},
    {"convert", "fmb convert", "write the system in another format", cmd_convert},
};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

static const char doc[] =
    "Answer questions about systems of linear inequalities, exactly and with proofs."
    "\v"
    "FILE may be - for standard input. Formats: .fmb text, .ine, .ieq, .smt2, .mps, .lp.\n"
    "`fmb COMMAND --help` tells the options of a command.\n"
    "\n"
    "Exit codes: 0 yes or done, 1 no (infeasible, proof rejected), 2 undecided (a limit was "
    "reached), "
    "64 usage, 65 bad input, 66 cannot open, 70 internal error, 74 cannot write.\n"
    "\n"
    "Examples:\n"
    "  fmb solve diet.fmb\n"
    "  fmb bounds diet.fmb --vars bread,milk\n"
    "  fmb project shape.ine --keep x1,x2 --json\n"
    "  fmb solve plan.smt2 --proof plan.proof; fmb check plan.smt2 plan.proof\n";

/* The table stands between the first line of the documentation and what follows the options. */
static char *help_text(int key, const char *text, void *input)
{
    (void)input;
    if (key != ARGP_KEY_HELP_PRE_DOC)
        return (char *)(uintptr_t)text;
    char *out = NULL;
    size_t size;
    FILE *f = app_need(open_memstream(&out, &size));
    fprintf(f, "%s\n\nCommands:\n", text);
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(f, "  %-9s%s\n", commands[i].name, commands[i].summary);
    fclose(f);
    return app_need(out);
}

/* Options end at the first other word: what follows belongs to the command. */
static error_t parse(int key, char *arg, struct argp_state *state)
{
    const command **chosen = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        for (size_t i = 0; i < COMMANDS; i++)
            if (strcmp(arg, commands[i].name) == 0)
                *chosen = &commands[i];
        if (!*chosen)
            argp_error(state, "unknown command '%s'", arg);
        state->next = state->argc;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "COMMAND is missing");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_version(FILE *out, struct argp_state *state)
{
    (void)state;
    fprintf(out, "fmb %s\n", fmb_version());
}

/* Index of the first word that is no option. */
static int command_place(char **argv)
{
    int i = 1;
    while (argv[i] && argv[i][0] == '-')
        i++;
    return i;
}

int main(int argc, char **argv)
{
    static const struct argp whole = {.parser = parse,
                                      .args_doc = "COMMAND FILE [OPTION...]",
                                      .doc = doc,
                                      .help_filter = help_text};
    argp_err_exit_status = APP_USAGE;
    argp_program_version_hook = print_version;
    app_file_guard_output();
    const command *chosen = NULL;
    static char name[] = "fmb";
    argv[0] = name;
    argp_parse(&whole, argc, argv, ARGP_IN_ORDER, NULL, &chosen);
    int skip = command_place(argv);
    argv[skip] = chosen->title;
    return chosen->run(argc - skip, argv + skip);
}
