/* ask.c: see ask.h. The library's own table of options becomes options of the command line, so
 * that a new line there needs no change here. */
#include "fmb/ask.h"

#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/decimal.h"
#include "common/message.h"
#include "common/options.h"

enum {
    MOST_OPTIONS = 24,
    FIRST_KEY = 0x1000,
    KEY_JSON = 'j',
    KEY_TRACE = 0x100,
    KEY_LIBRARY,
    KEY_RELAX,
    KEY_PROOF = 'p'
};

static const struct argp_option report_options[] = {
    {"json", KEY_JSON, NULL, 0, "Print one JSON object instead of text", 2},
    {"proof", KEY_PROOF, "OUT", 0,
     "Write the evidence to OUT, for `fmb check`; - prints it instead of the report", 2},
    {"relax", KEY_RELAX, NULL, 0, "Treat integer variables as real ones", 2},
    {"trace", KEY_TRACE, "OUT", 0, "Write what the solver does to OUT, one JSON object a line", 2},
    {"rule-library", KEY_LIBRARY, "FILE", 0,
     "A shared object with pruning rules and orders: --rules and --order know them, too", 3},
    {0}};

static bool is_output(const char *path)
{
    return path && strcmp(path, "-") == 0;
}

/* A proof with anything else in it could not be checked, nor JSON be read. A trace may come before
 * the text of a report. */
static void check_outputs(const app_ask *ask, struct argp_state *state)
{
    if (ask->json && is_output(ask->proof))
        argp_error(state, "--json and --proof - both want standard output");
    if (ask->json && is_output(ask->trace))
        argp_error(state, "--json and --trace - both want standard output");
    if (ask->digits > 0 && is_output(ask->proof))
        argp_error(state, "--decimal and --proof -: a proof is exact, and nothing else is printed");
    if (ask->proof && ask->trace && strcmp(ask->proof, ask->trace) == 0)
        argp_error(state, "--proof and --trace both want '%s'", ask->proof);
}

static error_t parse_report(int key, char *arg, struct argp_state *state)
{
    app_ask *ask = state->input;
    switch (key) {
    case KEY_JSON:
        ask->json = true;
        return 0;
    case KEY_RELAX:
        ask->relax = true;
        return 0;
    case KEY_TRACE:
        ask->trace = arg;
        return 0;
    case KEY_PROOF:
        ask->proof = arg;
        return 0;
    case KEY_LIBRARY:
        ask->rule_library = arg;
        return 0;
    case ARGP_KEY_END:
        check_outputs(ask, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp report_argp = {.options = report_options, .parser = parse_report};

/* A command line asks for evidence by --proof, not by that option of the library. */
static bool is_public(const fmb_option_info *info)
{
    return strcmp(info->name, "evidence") != 0;
}

static bool is_memory(const fmb_option_info *info)
{
    return strcmp(info->name, "max_bytes") == 0;
}

size_t app_ask_half_of_memory(void)
{
    long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    size_t half = pages > 0 && size > 0 ? (size_t)pages / 2 * (size_t)size : 0;
    struct rlimit own;
    if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY &&
        (half == 0 || own.rlim_cur / 2 < half))
        half = (size_t)(own.rlim_cur / 2);
    return half;
}

/* A file in place of a word of the table. */
static bool is_file_of_symmetries(const app_ask *ask, const fmb_option_info *info, const char *arg)
{
    return ask->usage->takes_symmetries && strcmp(info->name, "symmetry") == 0 &&
           strcmp(arg, "auto") != 0 && strcmp(arg, "none") != 0;
}

enum { NAME_SIZE = 32 };

/* "max_rows" is --max-rows on a command line. */
static void spell(const fmb_option_info *info, char name[NAME_SIZE])
{
    snprintf(name, NAME_SIZE, "%s", info->name);
    for (char *c = name; (c = strchr(c, '_'));)
        *c = '-';
}

static const char *values_of(const char *name)
{
    const fmb_option_info *info;
    for (size_t i = 0; (info = fmb_options_describe(i)) != NULL; i++)
        if (strcmp(info->name, name) == 0)
            return info->values;
    return "";
}

/* A word of --order that is none of the library's may be one of --rule-library, which may come
 * behind it. */
static void set_option(app_ask *ask, const fmb_option_info *info, const char *name, const char *arg,
                       struct argp_state *state)
{
    bool is_order = strcmp(info->name, "order") == 0;
    bool known = fmb_options_set(&ask->options, info->name, arg) == FMB_OK;
    if (is_order)
        ask->order = known ? NULL : arg;
    else if (!known)
        argp_error(state, "--%s: expected %s, found '%s'", name, info->values, arg);
}

static error_t parse_option(int key, char *arg, struct argp_state *state)
{
    app_ask *ask = state->input;
    if (key == ARGP_KEY_END && ask->order && !ask->rule_library)
        argp_error(state, "--order: expected %s, found '%s'", values_of("order"), ask->order);
    if (key < FIRST_KEY || key >= FIRST_KEY + MOST_OPTIONS)
        return ARGP_ERR_UNKNOWN;
    const fmb_option_info *info = fmb_options_describe((size_t)(key - FIRST_KEY));
    char name[NAME_SIZE];
    spell(info, name);
    if (is_file_of_symmetries(ask, info, arg)) {
        ask->symmetry = arg;
        return 0;
    }
    set_option(ask, info, name, arg, state);
    return 0;
}

/* The library's table in argp's form; what argp points to lives here. */
typedef struct solver_table {
    struct argp_option option[MOST_OPTIONS + 1];
    char name[MOST_OPTIONS][NAME_SIZE];
    char meaning[MOST_OPTIONS][200];
} solver_table;

static void fill_table(solver_table *t, const app_usage *usage)
{
    *t = (solver_table){0};
    size_t n = 0;
    const fmb_option_info *info;
    for (size_t i = 0; n < MOST_OPTIONS && (info = fmb_options_describe(i)); i++) {
        if (!is_public(info))
            continue;
        bool takes_file = usage->takes_symmetries && strcmp(info->name, "symmetry") == 0;
        spell(info, t->name[n]);
        int length = (int)strcspn(info->meaning, ".");
        snprintf(t->meaning[n], sizeof t->meaning[n], "%.*s (default %s)", length, info->meaning,
                 is_memory(info) ? "half of the memory" : info->initial);
        t->option[n] = (struct argp_option){.name = t->name[n],
                                            .key = FIRST_KEY + (int)i,
                                            .arg = takes_file ? "auto|none|FILE" : info->values,
                                            .doc = t->meaning[n],
                                            .group = 3};
        n++;
    }
}

/* Give each child parser its part of app_ask. */
static error_t share_inputs(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    if (key != ARGP_KEY_INIT)
        return ARGP_ERR_UNKNOWN;
    app_ask *ask = state->input;
    state->child_inputs[0] = &ask->source;
    state->child_inputs[1] = ask;
    state->child_inputs[2] = ask;
    state->child_inputs[3] = &ask->digits;
    state->child_inputs[4] = ask->own_input;
    return 0;
}

void app_ask_parse(app_ask *ask, const app_usage *usage, void *own_input, int argc, char **argv)
{
    *ask = (app_ask){.options = (fmb_options){.size = sizeof(fmb_options)},
                     .own_input = own_input,
                     .usage = usage};
    ask->options.max_bytes = app_ask_half_of_memory();
    solver_table table;
    fill_table(&table, usage);
    const struct argp solver_argp = {.options = table.option, .parser = parse_option};
    const struct argp_child children[] = {
        {&app_source_argp, 0, NULL, 0},  {&report_argp, 0, NULL, 0}, {&solver_argp, 0, NULL, 0},
        {&app_decimal_argp, 0, NULL, 0}, {usage->own, 0, NULL, 0},   {NULL, 0, NULL, 0},
    };
    const struct argp whole = {
        .parser = share_inputs, .args_doc = usage->args, .doc = usage->doc, .children = children};
    app_options_parse(&whole, argc, argv, ask);
    if (!ask->proof && !usage->shows_claims)
        ask->options.evidence = FMB_EVIDENCE_VERDICT;
}

int app_ask_exact_rows(const app_ask *ask)
{
    if (ask->digits == 0 || ask->json)
        return APP_YES;
    return app_error(APP_USAGE, "--decimal: rows that programs read are written exactly; --json "
                                "has both");
}

bool app_ask_proof_only(const app_ask *ask)
{
    return is_output(ask->proof);
}
