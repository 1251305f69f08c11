/* options.c: see options.h. */
#include "common/options.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/nearest.h"

static const struct argp_option always[] = {{"help", '?', NULL, 0, "Give this help list", 0},
                                            {"usage", 0, NULL, 0, "Give a short usage message", 0},
                                            {"version", 'V', NULL, 0, "Print program version", 0},
                                            {0}};
static const struct argp always_argp = {.options = always};

typedef void visit_option(const struct argp_option *o, void *self);

/* The options of a parser and of its children. */
static void visit_options(const struct argp *argp, visit_option *visit, void *self)
{
    for (const struct argp_option *o = argp->options; o && (o->name || o->key || o->doc); o++)
        if (o->name)
            visit(o, self);
    for (const struct argp_child *c = argp->children; c && c->argp; c++)
        visit_options(c->argp, visit, self);
}

static void list_option(const struct argp_option *o, void *self)
{
    (void)self;
    bool letter = o->key > 0 && o->key < 0x80 && isprint(o->key);
    bool maybe = o->flags & OPTION_ARG_OPTIONAL;
    printf("--%s\t%.*s\t%s%s%s\t%s\n", o->name, letter, (const char[]){(char)o->key, '\0'},
           maybe ? "[" : "", o->arg ? o->arg : "", maybe ? "]" : "", o->doc);
}

typedef struct search {
    char name[64]; /* as written, without "--" and "=VALUE" */
    const struct argp_option *found;
    app_nearest near;
} search;

/* A beginning of a name is enough for argp. */
static void compare_option(const struct argp_option *o, void *self)
{
    search *s = self;
    if (strncmp(o->name, s->name, strlen(s->name)) == 0)
        s->found = o;
}

static void try_option(const struct argp_option *o, void *self)
{
    app_nearest_try(&((search *)self)->near, o->name);
}

static void find_option(const struct argp *argp, const char *word, search *s)
{
    *s = (search){0};
    snprintf(s->name, sizeof s->name, "%.*s", (int)strcspn(word + 2, "="), word + 2);
    visit_options(&always_argp, compare_option, s);
    visit_options(argp, compare_option, s);
    if (s->found)
        return;
    s->near = app_nearest_to(s->name);
    visit_options(&always_argp, try_option, s);
    visit_options(argp, try_option, s);
}

/* Does a value stand in the word behind the option, if not in its own? */
static bool takes_next_word(const struct argp_option *o)
{
    return o->arg && !(o->flags & OPTION_ARG_OPTIONAL);
}

/* And -h is --help: argp's own letter is '?'. */
static void refuse_unknown_options(const struct argp *argp, int argc, char **argv)
{
    static char help[] = "--help";
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strcmp(argv[i], "-h") == 0)
            argv[i] = help;
        if (strncmp(argv[i], "--", 2) != 0)
            continue;
        search s;
        find_option(argp, argv[i], &s);
        if (!s.found && s.near.best)
            exit(app_error(APP_USAGE, "unknown option '--%s'; did you mean '--%s'?", s.name,
                           s.near.best));
        if (s.found && takes_next_word(s.found) && !strchr(argv[i], '='))
            i++;
    }
}

/* The option that a letter stands for; NULL: none. */
static void compare_letter(const struct argp_option *o, void *self)
{
    search *s = self;
    if (o->key == s->name[0])
        s->found = o;
}

/* The option of a word's first letter that takes a value, or is --json; NULL: neither. */
static const struct argp_option *find_letters(const struct argp *argp, const char *word)
{
    const struct argp_option *found = NULL;
    for (const char *c = word + 1; *c && !found; c++) {
        search s = {.name = {*c}};
        visit_options(argp, compare_letter, &s);
        if (s.found && (s.found->arg || strcmp(s.found->name, "json") == 0))
            found = s.found;
    }
    return found;
}

/* "-fine", where -f takes a value: is it in the word? */
static bool ends_with_value(const struct argp_option *o, const char *word)
{
    return strchr(word, o->key)[1] != '\0';
}

/* Is --json, without a value, among the options? Errors of the others are told in JSON then. */
static bool asks_for_json(const struct argp *argp, int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        search s = {0};
        bool is_long = strncmp(argv[i], "--", 2) == 0;
        if (is_long)
            find_option(argp, argv[i], &s);
        else if (argv[i][0] == '-')
            s.found = find_letters(argp, argv[i]);
        if (s.found && !s.found->arg && strcmp(s.found->name, "json") == 0)
            return true;
        if (s.found && takes_next_word(s.found) &&
            (is_long ? !strchr(argv[i], '=') : !ends_with_value(s.found, argv[i])))
            i++;
    }
    return false;
}

void app_options_parse(const struct argp *argp, int argc, char **argv, void *input)
{
    if (argc == 2 && strcmp(argv[1], "--list-options") == 0) {
        visit_options(&always_argp, list_option, NULL);
        visit_options(argp, list_option, NULL);
        exit(APP_YES);
    }
    if (asks_for_json(argp, argc, argv)) {
        app_errors_as_json();
        app_errors_capture(argv[0]);
    }
    refuse_unknown_options(argp, argc, argv);
    if (argp_parse(argp, argc, argv, 0, NULL, input) != 0) /* wrong words exit by themselves */
        exit(app_status_error(FMB_ERR_MEMORY));
    app_errors_release();
}
