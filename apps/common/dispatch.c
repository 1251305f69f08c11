/* dispatch.c: choose a subcommand; see dispatch.h. */
#include "common/dispatch.h"

#include <argp.h>
#include <fmb/base.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"
#include "common/nearest.h"
#include "common/need.h"

/* Wide enough for every name, and a blank behind it. */
static int column_of_names(const app_program *p)
{
    size_t width = 11;
    for (size_t i = 0; i < p->commands; i++)
        width = strlen(p->command[i].name) < width ? width : strlen(p->command[i].name) + 1;
    return (int)width;
}

/* The table comes between the first line of the documentation and the text after the options. */
static char *help_text(int key, const char *text, void *input)
{
    const app_program *p = input;
    if (key != ARGP_KEY_HELP_PRE_DOC)
        return (char *)(uintptr_t)text;
    char *out = NULL;
    size_t size;
    FILE *f = app_need(open_memstream(&out, &size));
    int width = column_of_names(p);
    fprintf(f, "%s\n\n%s:\n", text, p->heading);
    for (size_t i = 0; i < p->commands; i++)
        fprintf(f, "  %-*s%s\n", width, p->command[i].name, p->command[i].summary);
    fclose(f);
    return app_need(out);
}

/* "; did you mean ...?" for a word that is no command. */
static const char *hint_at_command(const app_program *p, const char *word, char hint[APP_HINT_SIZE])
{
    app_nearest near = app_nearest_to(word);
    for (size_t i = 0; i < p->commands; i++)
        app_nearest_try(&near, p->command[i].name);
    return app_nearest_hint(&near, hint);
}

/* Parses a command line without a command: it is a request for help, or an error. */
static error_t parse(int key, char *arg, struct argp_state *state)
{
    const app_program *p = state->input;
    char hint[APP_HINT_SIZE];
    switch (key) {
    case ARGP_KEY_ARG:
        argp_error(state, "unknown %s '%s'%s", p->word, arg, hint_at_command(p, arg, hint));
        return 0;
    case ARGP_KEY_NO_ARGS: /* the first word of args names it */
        argp_error(state, "%.*s is missing", (int)strcspn(p->args, " "), p->args);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_version(FILE *out, struct argp_state *state)
{
    fprintf(out, "%s %s\n", state->name, fmb_version());
}

static const app_command *command_called(const app_program *p, const char *word)
{
    for (size_t i = 0; i < p->commands; i++)
        if (strcmp(word, p->command[i].name) == 0)
            return &p->command[i];
    return NULL;
}

/* Is that an option of the program as a whole? */
static bool is_about(const char *word)
{
    static const char *const ABOUT[] = {"--help",        "-h", "-?", "--usage", "--version", "-V",
                                        "--list-options"};
    for (size_t i = 0; i < sizeof ABOUT / sizeof *ABOUT; i++)
        if (strcmp(word, ABOUT[i]) == 0)
            return true;
    return false;
}

/* The command's own command line: its title, the options that came before it, and the rest. The
 * command is the first word that is one; so a file of that name cannot come before it. */
static const app_command *choose_command(const app_program *p, int argc, char **argv)
{
    for (int i = 1; i < argc && !is_about(argv[i]); i++) {
        const app_command *c = command_called(p, argv[i]);
        if (!c)
            continue;
        memmove(argv + 2, argv + 1, (size_t)(i - 1) * sizeof *argv);
        argv[1] = c->title;
        return c;
    }
    return NULL;
}

/* The word that was meant to be a command: one that is nearly one, else the first that is no
 * option; NULL if there is none. */
static char *mistaken_command(const app_program *p, int argc, char **argv)
{
    char *first = NULL, hint[APP_HINT_SIZE];
    for (int i = 1; i < argc; i++) {
        if (argv[i][0] == '-')
            continue;
        if (*hint_at_command(p, argv[i], hint))
            return argv[i];
        first = first ? first : argv[i];
    }
    return first;
}

/* Help and the like, or an error: does not return. */
static int explain(const app_program *p, int argc, char **argv)
{
    const struct argp whole = {
        .parser = parse, .args_doc = p->args, .doc = p->doc, .help_filter = help_text};
    char *word = mistaken_command(p, argc, argv), *line[] = {p->name, word, NULL};
    bool about = false;
    for (int i = 1; i < argc; i++)
        about |= is_about(argv[i]);
    if (about)
        argp_parse(&whole, argc, argv, ARGP_IN_ORDER, NULL, (void *)(uintptr_t)p);
    argp_parse(&whole, word ? 2 : 1, line, 0, NULL, (void *)(uintptr_t)p);
    return APP_USAGE;
}

/* For the completion of shells, in the form of app_options_parse. */
static int list_commands(const app_program *p)
{
    for (size_t i = 0; i < p->commands; i++)
        printf("%s\t\t\t%s\n", p->command[i].name, p->command[i].summary);
    return APP_YES;
}

/* Only options, none of them about the program, and something to do without a command. */
static bool means_otherwise(const app_program *p, int argc, char **argv)
{
    return p->otherwise && (argc == 1 || (argv[1][0] == '-' && !is_about(argv[1])));
}

static int run_otherwise(const app_command *c, int argc, char **argv)
{
    argv[0] = c->title;
    return c->run(argc, argv);
}

/* `help` and `help COMMAND`, unless help is a command, as --help and COMMAND --help; `-h` likewise.
 */
static void spell_out_help(const app_program *p, int argc, char **argv)
{
    static char option[] = "--help";
    if (argc > 1 && strcmp(argv[1], "-h") == 0)
        argv[1] = option;
    if (argc < 2 || argc > 3 || strcmp(argv[1], "help") != 0 || command_called(p, "help"))
        return;
    if (argc == 2) {
        argv[1] = option;
    } else if (command_called(p, argv[2])) {
        argv[1] = argv[2];
        argv[2] = option;
    } else {
        argv[1] = argv[2]; /* the hint is given where commands are looked up */
        argv[2] = NULL;
    }
}

int app_dispatch(const app_program *p, int argc, char **argv)
{
    argp_err_exit_status = APP_USAGE;
    argp_program_version_hook = print_version;
    app_file_guard_output();
    app_need_limbs();
    argv[0] = p->name;
    spell_out_help(p, argc, argv);
    while (argc > 1 && !argv[argc - 1])
        argc--;
    const app_command *c = choose_command(p, argc, argv);
    if (c)
        return c->run(argc - 1, argv + 1);
    if (means_otherwise(p, argc, argv))
        return run_otherwise(p->otherwise, argc, argv);
    if (argc == 2 && strcmp(argv[1], "--list-options") == 0)
        return list_commands(p);
    return explain(p, argc, argv);
}
