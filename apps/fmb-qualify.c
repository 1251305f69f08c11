/* fmb-qualify.c: studies of the library: a table of subcommands, one a question. */
#include <argp.h>
#include <fmb/base.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "qualify/commands.h"

typedef struct command {
    const char *name;
    char *title; /* argv[0] of the command */
    const char *summary;
    int (*run)(int argc, char **argv);
} command;

static const command commands[] = {
    {"rules", "fmb-qualify rules", "pruning rules x orders x systems: rows, time, errors",
     qualify_rules},
};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

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

/* The table stands between the first line of the documentation and what follows the options. */
static char *help_text(int key, const char *text, void *input)
{
    (void)input;
    if (key != ARGP_KEY_HELP_PRE_DOC)
        return (char *)(uintptr_t)text;
    char *out = NULL;
    size_t size;
    FILE *f = app_need(open_memstream(&out, &size));
    fprintf(f, "%s\n\nStudies:\n", text);
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(f, "  %-9s%s\n", commands[i].name, commands[i].summary);
    fclose(f);
    return app_need(out);
}

/* Options end at the first other word: what follows belongs to the study. */
static error_t parse(int key, char *arg, struct argp_state *state)
{
    const command **chosen = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        for (size_t i = 0; i < COMMANDS; i++)
            if (strcmp(arg, commands[i].name) == 0)
                *chosen = &commands[i];
        if (!*chosen)
            argp_error(state, "unknown study '%s'", arg);
        state->next = state->argc;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "STUDY is missing");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_version(FILE *out, struct argp_state *state)
{
    (void)state;
    fprintf(out, "fmb-qualify %s\n", fmb_version());
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
    static const struct argp whole = {
        .parser = parse, .args_doc = "STUDY [OPTION...]", .doc = doc, .help_filter = help_text};
    argp_err_exit_status = APP_USAGE;
    argp_program_version_hook = print_version;
    app_file_guard_output();
    const command *chosen = NULL;
    static char name[] = "fmb-qualify";
    argv[0] = name;
    argp_parse(&whole, argc, argv, ARGP_IN_ORDER, NULL, &chosen);
    int skip = command_place(argv);
    argv[skip] = chosen->title;
    return chosen->run(argc - skip, argv + skip);
}
