/* options.c: the command line of fmb-qualify rules; see plan.h. */
#include <stdlib.h>
#include <string.h>

#include "common/json.h"
#include "common/message.h"
#include "common/parts.h"
#include "common/value.h"
#include "fmb-qualify/rules/plan.h"

enum {
    KEY_DIM = 0x100,
    KEY_MOTION,
    KEY_KINDS,
    KEY_MEETING,
    KEY_FAMILY,
    KEY_ORDERS,
    KEY_ROWS,
    KEY_SECONDS,
    KEY_PASSES,
    KEY_PRESOLVE,
    KEY_COUNTS,
    KEY_LIBRARY,
    KEY_SHARD,
    KEY_MERGE,
    KEY_DETAIL
};

static const struct argp_option options[] = {
    {NULL, 0, NULL, 0, "Systems:", 1},
    {"dim", KEY_DIM, "D,...", 0, "Dimensions of the space of the frames [2,3,4,5,6]", 1},
    {"motion", KEY_MOTION, "WORD,...", 0, "static, dynamic [both]", 1},
    {"kinds", KEY_KINDS, "AB,...", 0, "Pairs of cuboids C and simplices T [CC,CT,TC,TT]", 1},
    {"meeting", KEY_MEETING, "yes|no", 0, "Pairs that meet, or those that do not [both]", 1},
    {"family", KEY_FAMILY, "small|float", 0,
     "Whole numbers up to 3, or doubles up to 10 as in the article [small]", 1},
    {"pairs", 'n', "N", 0, "Pairs of each class [16]", 1},
    {"seed", 's', "S", 0, "Seed of the random numbers [1]", 1},
    {NULL, 0, NULL, 0, "Elimination:", 2},
    {"rules", 'r', "SET", 0,
     "A set of rules to study, such as kohler,box; repeatable. `none` is always "
     "there, `default` is the choice of the library; `fmplex`, timed only, tries bounds one by one",
     2},
    {"rule-library", KEY_LIBRARY, "FILE", 0,
     "A shared object with pruning rules and orders of one's own; --rules and --orders know them, "
     "too, and without --rules each rule is a set",
     2},
    {"orders", KEY_ORDERS, "WORD,...", 0,
     "pairs, given, min, fill [pairs,given]; a rule library may have others", 2},
    {"presolve", KEY_PRESOLVE, "STEPS", 0,
     "As `fmb solve` takes it; the box rule needs bounds [bounds]", 2},
    {NULL, 0, NULL, 0, "Limits:", 3},
    {"max-rows", KEY_ROWS, "N", 0, "Live rows at which a query is stopped [10000]", 3},
    {"max-seconds", KEY_SECONDS, "S", 0,
     "Time at which a query is stopped [20]: where that happens, counts depend on the machine", 3},
    {"passes", KEY_PASSES, "N", 0, "Timed passes over all systems; 0 measures no time [3]", 3},
    {NULL, 0, NULL, 0, "Report:", 4},
    {"shard", KEY_SHARD, "I/N", 0, "Only part I of N of the systems; the JSON holds its runs", 4},
    {"merge", KEY_MERGE, NULL, 0,
     "No study: report the FILEs, the --json of all shards of a run, as one", 4},
    {"out", 'o', "DIR", 0, "Write report.html, CSV, JSON and figures into this folder, too", 4},
    {"json", 'j', NULL, 0, "Print one JSON object instead of tables", 4},
    {"detail", KEY_DETAIL, NULL, 0, "A table for each class, not only for each dimension", 4},
    {"counts", KEY_COUNTS, NULL, 0, "Only counts on small frames: no rules, and the best histories",
     4},
    {"quiet", 'q', NULL, 0, "No progress bar", 4},
    {0}};

/* ---- values ---------------------------------------------------------------------------------- */

static void use_dim(const char *word, struct argp_state *state)
{
    qualify_plan *p = state->input;
    p->dim[app_value_whole("--dim", word, 1, PLAN_MOST_DIM, state)] = true;
}

static void use_motion(const char *word, struct argp_state *state)
{
    static const char *const MOTION[] = {"static", "dynamic", NULL};
    qualify_plan *p = state->input;
    p->motion[app_value_choice("--motion", word, MOTION, state)] = true;
}

static void use_kind(const char *word, struct argp_state *state)
{
    static const char *const KIND[] = {"CC", "CT", "TC", "TT", NULL};
    qualify_plan *p = state->input;
    int k = app_value_choice("--kinds", word, KIND, state);
    p->kind[k / 2][k % 2] = true;
}

/* Each word is an order; it is looked up after the rule library is loaded. */
static void use_orders(qualify_plan *p, const char *words, struct argp_state *state)
{
    char *rest, *word;
    free(p->order_words);
    p->order_words = app_need(strdup(words));
    p->orders = 0;
    word = strtok_r(p->order_words, ",", &rest);
    if (!word)
        argp_error(state, "--orders: expected words with a comma between, found '%s'", words);
    for (; word; word = strtok_r(NULL, ",", &rest)) {
        if (p->orders == PLAN_MOST_ORDERS)
            argp_error(state, "--orders: more than %d orders", PLAN_MOST_ORDERS);
        p->order[p->orders++] = (qualify_order){.name = word};
    }
}

static void use_meeting(qualify_plan *p, const char *word, struct argp_state *state)
{
    static const char *const MEETING[] = {"no", "yes", NULL};
    p->meeting[app_value_choice("--meeting", word, MEETING, state)] = true;
}

/* ---- options --------------------------------------------------------------------------------- */

static error_t parse_systems(int key, char *arg, struct argp_state *state)
{
    qualify_plan *p = state->input;
    switch (key) {
    case KEY_DIM:
        memset(p->dim, 0, sizeof p->dim);
        app_value_each("--dim", arg, use_dim, state);
        p->frames_asked = true;
        return 0;
    case KEY_MOTION:
        memset(p->motion, 0, sizeof p->motion);
        app_value_each("--motion", arg, use_motion, state);
        return 0;
    case KEY_KINDS:
        memset(p->kind, 0, sizeof p->kind);
        app_value_each("--kinds", arg, use_kind, state);
        return 0;
    case KEY_MEETING:
        memset(p->meeting, 0, sizeof p->meeting);
        use_meeting(p, arg, state);
        return 0;
    case KEY_FAMILY:
        if (!study_family_parse(arg, &p->family))
            argp_error(state, "--family: expected small|float, found '%s'", arg);
        return 0;
    case 'n':
        p->grid.per_class = app_value_whole("--pairs", arg, 1, 1000000, state);
        p->pairs_asked = true;
        return 0;
    case 's':
        p->grid.seed = app_value_whole("--seed", arg, 0, 0xffffffffUL, state);
        return 0;
    case ARGP_KEY_ARG:
        if (p->files == PLAN_MOST_FILES)
            argp_error(state, "more than %d files", PLAN_MOST_FILES);
        p->file[p->files++] = arg;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse_ways(int key, char *arg, struct argp_state *state)
{
    qualify_plan *p = state->input;
    switch (key) {
    case 'r':
        if (p->sets == PLAN_MOST_SETS - 1)
            argp_error(state, "more than %d sets of rules", PLAN_MOST_SETS - 1);
        p->set[p->sets++] = arg;
        return 0;
    case KEY_ORDERS:
        use_orders(p, arg, state);
        return 0;
    case KEY_LIBRARY:
        p->rule_library = arg;
        return 0;
    case KEY_PRESOLVE:
        p->grid.limits.presolve = arg;
        return 0;
    case KEY_ROWS:
        p->grid.limits.max_rows = app_value_whole("--max-rows", arg, 1, 1000000000, state);
        return 0;
    case KEY_SECONDS:
        p->grid.limits.max_seconds = app_value_number("--max-seconds", arg, 0, 1e6, state);
        return 0;
    case KEY_PASSES:
        p->grid.passes = (int)app_value_whole("--passes", arg, 0, 9, state);
        return 0;
    default:
        return parse_systems(key, arg, state);
    }
}

/* Records the arguments with which another run repeats the study. */
static void note_argument(qualify_plan *p, int key, const char *arg)
{
    enum { LAST_GROUP = 3 };
    char *word = NULL;
    for (const struct argp_option *o = options; !word && (o->name || o->doc); o++)
        if (o->name && o->key == key && o->group <= LAST_GROUP &&
            asprintf(&word, "--%s=%s", o->name, arg) < 0)
            app_need(NULL);
    if (word || key == ARGP_KEY_ARG)
        app_json_append(p->arguments, app_json_text(word ? word : arg));
    free(word);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    qualify_plan *p = state->input;
    note_argument(p, key, arg);
    switch (key) {
    case KEY_SHARD:
        app_shard_parse(arg, &p->shard, &p->shards, state);
        return 0;
    case KEY_MERGE:
        p->merge = true;
        return 0;
    case 'o':
        p->out = arg;
        return 0;
    case 'j':
        p->json = true;
        return 0;
    case KEY_COUNTS:
        p->counts = true;
        return 0;
    case KEY_DETAIL:
        p->detail = true;
        return 0;
    case 'q':
        p->quiet = true;
        return 0;
    default:
        return parse_ways(key, arg, state);
    }
}

static const char doc[] =
    "Eliminate the variables of many systems with every set of rules and in every order, count "
    "rows, measure time against no rules, and compare every answer with the exact one."
    "\v"
    "Without FILE the systems are random pairs of frames; with FILE only those files, unless --dim "
    "asks for frames, too. Of a file, all but the last variable are eliminated, or all but those "
    "that it asks for (`project` lines, or a comment `* keep K`: the first K).\n"
    "The same seed gives the same counts.\n"
    "\n"
    "Examples:\n"
    "  fmb-qualify rules --out report\n"
    "  fmb-qualify rules --dim 3 --kinds CC --pairs 500 --rules kohler,box\n"
    "  fmb-qualify rules --rules kohler cases/*.ine\n"
    "  fmb-qualify rules --shard 1/2 --json >a; fmb-qualify rules --shard 2/2 --json >b\n"
    "  fmb-qualify rules --merge a b\n";

const struct argp qualify_plan_argp = {options, parse, "[FILE...]", doc, NULL, NULL, NULL};
