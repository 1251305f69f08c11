/* dispatch.c: choose a subcommand; see dispatch.h. */
#include "common/dispatch.h"

#include <argp.h>
#include <fmb/base.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"

typedef struct choice {
    const app_program *p;
    const app_command *chosen;
} choice;

/* The table stands between the first line of the documentation and what follows the options. */
static char *help_text(int key, const char *text, void *input)
{
    const app_program *p = ((const choice *)input)->p;
    if (key != ARGP_KEY_HELP_PRE_DOC)
        return (char *)(uintptr_t)text;
    char *out = NULL;
    size_t size;
    FILE *f = app_need(open_memstream(&out, &size));
    fprintf(f, "%s\n\n%s:\n", text, p->heading);
    for (size_t i = 0; i < p->commands; i++)
        fprintf(f, "  %-11s%s\n", p->command[i].name, p->command[i].summary);
    fclose(f);
    return app_need(out);
}

/* Options end at the first other word: what follows belongs to the subcommand. */
static error_t parse(int key, char *arg, struct argp_state *state)
{
    choice *c = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        for (size_t i = 0; i < c->p->commands; i++)
            if (strcmp(arg, c->p->command[i].name) == 0)
                c->chosen = &c->p->command[i];
        if (!c->chosen)
            argp_error(state, "unknown %s '%s'", c->p->word, arg);
        state->next = state->argc;
        return 0;
    case ARGP_KEY_NO_ARGS: /* the first word of args names it */
        argp_error(state, "%.*s is missing", (int)strcspn(c->p->args, " "), c->p->args);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_version(FILE *out, struct argp_state *state)
{
    fprintf(out, "%s %s\n", state->name, fmb_version());
}

/* Index of the first word that is no option. */
static int command_place(char **argv)
{
    int i = 1;
    while (argv[i] && argv[i][0] == '-')
        i++;
    return i;
}

int app_dispatch(const app_program *p, int argc, char **argv)
{
    const struct argp whole = {
        .parser = parse, .args_doc = p->args, .doc = p->doc, .help_filter = help_text};
    choice c = {.p = p};
    argp_err_exit_status = APP_USAGE;
    argp_program_version_hook = print_version;
    app_file_guard_output();
    argv[0] = p->name;
    argp_parse(&whole, argc, argv, ARGP_IN_ORDER, NULL, &c);
    int skip = command_place(argv);
    argv[skip] = c.chosen->title;
    return c.chosen->run(argc - skip, argv + skip);
}
