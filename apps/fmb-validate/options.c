/* options.c: the command line of fmb-validate; see plan.h. */
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/parts.h"
#include "common/value.h"
#include "fmb-validate/difference.h"
#include "fmb-validate/plan.h"
#include "fmb-validate/watch.h"

enum {
    KEY_DIM = 0x100,
    KEY_AXES,
    KEY_SAMPLE,
    KEY_TEXTBOOK,
    KEY_BOXES,
    KEY_CONTACT,
    KEY_SHARD,
    KEY_MERGE,
    KEY_SIMD,
    KEY_FAILURES
};

static const struct argp_option options[] = {
    {NULL, 0, NULL, 0, "Pairs:", 1},
    {"pairs", 'n', "N", 0, "Of each case and family [1000000]", 1},
    {"seed", 's', "S", 0, "Seed of the random numbers [1]", 1},
    {"families", 'f', "WORD,...", 0,
     "article, lattice, touching, near, flat, degenerate, tiny-A, tiny-B, far, denormal, swept, "
     "integer, scaled, spread, ragged, uneven, or all [article]",
     1},
    {"dim", KEY_DIM, "D,...", 0, "Cases D-static and D-dynamic, 1 to 16", 1},
    {"axes", KEY_AXES, "A,B", 0, "How many axes the frames have, for faces and edges [all]", 1},
    {NULL, 0, NULL, 0, "Questions:", 2},
    {"sample", KEY_SAMPLE, "SHARE", 0,
     "Share of the article's pairs whose verdicts are proved; those of other families always are "
     "[0.01]",
     2},
    {"textbook", KEY_TEXTBOOK, "SHARE", 0,
     "Share of these that the exact method and the textbook answer, too [0.01]", 2},
    {"boxes", KEY_BOXES, NULL, 0, "Hold boxes, times and witnesses against the exact ones", 2},
    {"contact", KEY_CONTACT, NULL, 0,
     "In two and three dimensions hold depths, distances, normals, nearest points and separating "
     "rows "
     "against exact ones, in four to eight exact depths and distances against proofs",
     2},
    {"simd", KEY_SIMD, "WORD", 0, "auto, plain, avx2, avx512: the kernels to use [auto]", 2},
    {NULL, 0, NULL, 0, "Work:", 3},
    {"threads", 't', "T", 0, "Number of threads [1]", 3},
    {"shard", KEY_SHARD, "I/N", 0, "Only part I of N [1/1]; the counts of all parts add up", 3},
    {"merge", KEY_MERGE, NULL, 0,
     "No questions: add the counts of the FILEs, the --json of all shards of a run", 3},
    {NULL, 0, NULL, 0, "Report:", 4},
    {"json", 'j', "FILE", 0, "Write the counts as JSON; - prints them instead of the table", 4},
    {"failures", KEY_FAILURES, "FILE", 0,
     "Write every disagreement as a line for `fmb intersect --nearest`", 4},
    {"quiet", 'q', NULL, 0, "No progress bar", 4},
    {0}};

/* ---- values ---------------------------------------------------------------------------------- */

static void use_family(const char *word, struct argp_state *state)
{
    validate_plan *p = state->input;
    study_pair_family family = STUDY_PAIR_ARTICLE;
    bool all = strcmp(word, "all") == 0;
    if (!all && !study_pair_family_parse(word, &family))
        argp_error(state,
                   "--families: expected article|lattice|touching|near|flat|degenerate|tiny-A|"
                   "tiny-B|far|denormal|swept|integer|scaled|spread|ragged|uneven|all, found "
                   "'%s'",
                   word);
    for (int i = 0; i < STUDY_PAIR_FAMILIES; i++)
        p->family[i] |= all || i == (int)family;
}

static void use_dim(const char *word, struct argp_state *state)
{
    validate_plan *p = state->input;
    uint64_t dim = app_value_whole("--dim", word, 1, STUDY_PAIR_MOST_DIM, state);
    p->wanted[dim][0] = p->wanted[dim][1] = true;
}

/* 3d-static, 4d-dynamic, ... */
static void use_case(validate_plan *p, const char *word, struct argp_state *state)
{
    char *rest;
    unsigned long dim = strtoul(word, &rest, 10);
    bool moves = strcmp(rest, "d-dynamic") == 0;
    if (dim < 1 || dim > STUDY_PAIR_MOST_DIM || *word < '1' || *word > '9' ||
        (!moves && strcmp(rest, "d-static") != 0))
        argp_error(state, "'%s' is not a case: 2d-static, 2d-dynamic, 3d-static, 3d-dynamic, ...",
                   word);
    p->wanted[dim][moves] = true;
}

static void use_axes(validate_plan *p, const char *text, struct argp_state *state)
{
    uint64_t n[2] = {0};
    if (!app_value_two(text, ',', STUDY_PAIR_MOST_DIM, n))
        argp_error(state, "--axes: expected A,B, each from 1 to %d, found '%s'",
                   STUDY_PAIR_MOST_DIM, text);
    for (int f = 0; f < 2; f++)
        p->usual.plan.naxes[f] = (int)n[f];
}

/* ---- options --------------------------------------------------------------------------------- */

/* What was left out, and what does not fit together. */
static void finish(validate_plan *p, struct argp_state *state)
{
    bool some_case = false, some_family = false;
    for (size_t i = 0; !p->merge && i < p->words; i++)
        use_case(p, p->word[i], state);
    int least = STUDY_PAIR_MOST_DIM;
    for (int dim = STUDY_PAIR_MOST_DIM; dim >= 1; dim--)
        if (p->wanted[dim][0] || p->wanted[dim][1]) {
            some_case = true;
            least = dim;
        }
    for (int dim = 2; !some_case && dim <= 3; dim++) {
        p->wanted[dim][0] = p->wanted[dim][1] = true;
        least = 2;
    }
    for (int f = 0; f < 2; f++)
        if (p->usual.plan.naxes[f] > least)
            argp_error(state, "--axes: %d axes are too many in %d dimensions",
                       p->usual.plan.naxes[f], least);
    for (int dim = 1; p->usual.contacts && dim <= STUDY_PAIR_MOST_DIM; dim++)
        if ((p->wanted[dim][0] || p->wanted[dim][1]) && (dim < 2 || dim > VALIDATE_MOST_DIM))
            argp_error(state, "--contact is for 2 to %d dimensions, not %d", VALIDATE_MOST_DIM,
                       dim);
    for (int i = 0; i < STUDY_PAIR_FAMILIES; i++)
        some_family |= p->family[i];
    p->family[STUDY_PAIR_ARTICLE] |= !some_family;
}

static error_t parse_pairs(int key, char *arg, struct argp_state *state)
{
    validate_plan *p = state->input;
    switch (key) {
    case 'n':
        p->pairs = app_value_whole("--pairs", arg, 1, UINT64_C(1000000000000), state);
        return 0;
    case 's':
        p->usual.seed = app_value_whole("--seed", arg, 0, INT64_MAX, state); /* as JSON has it */
        return 0;
    case 'f':
        app_value_each("--families", arg, use_family, state);
        return 0;
    case KEY_DIM:
        app_value_each("--dim", arg, use_dim, state);
        return 0;
    case KEY_AXES:
        use_axes(p, arg, state);
        return 0;
    case ARGP_KEY_ARG:
        p->word[p->words++] = arg;
        return 0;
    case ARGP_KEY_INIT:
        p->word = app_need(calloc((size_t)state->argc + 1, sizeof *p->word));
        return 0;
    case ARGP_KEY_END:
        finish(p, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    validate_plan *p = state->input;
    switch (key) {
    case KEY_SAMPLE:
        p->usual.sample = app_value_number("--sample", arg, 0, 1, state);
        return 0;
    case KEY_TEXTBOOK:
        p->usual.textbook = app_value_number("--textbook", arg, 0, 1, state);
        return 0;
    case KEY_BOXES:
        p->usual.boxes = true;
        return 0;
    case KEY_CONTACT:
        p->usual.contacts = true;
        return 0;
    case KEY_SIMD:
        p->usual.simd = app_value_simd(arg, state);
        return 0;
    case 't':
        p->threads = (int)app_value_whole("--threads", arg, 1, VALIDATE_MOST_THREADS, state);
        return 0;
    case KEY_SHARD:
        app_shard_parse(arg, &p->shard, &p->shards, state);
        return 0;
    case 'j':
        p->json = arg;
        return 0;
    case KEY_MERGE:
        p->merge = true;
        return 0;
    case KEY_FAILURES:
        p->failures = arg;
        return 0;
    case 'q':
        p->quiet = true;
        return 0;
    default:
        return parse_pairs(key, arg, state);
    }
}

static const char doc[] =
    "Ask whether random pairs of frames meet, by FMB, by separating axes and exactly, in both "
    "orders, open and closed, and report where two answers differ."
    "\v"
    "Cases: 2d-static 2d-dynamic 3d-static 3d-dynamic (all four, if neither a case nor --dim is "
    "given), and so on up to 16d-dynamic.\n"
    "Pair K depends on case, family, seed and K alone.\n"
    "\n"
    "Exit codes: 0 all agree, 1 some answers differ, 2 interrupted (the counts so far are "
    "printed), 64 usage, 70 internal error, 74 cannot write.\n"
    "\n"
    "Examples:\n"
    "  fmb-validate\n"
    "  fmb-validate 3d-static --families near,flat --pairs 10000 --boxes\n"
    "  fmb-validate --contact --families all --pairs 2000\n"
    "  fmb-validate --dim 4,5,6 --contact --families all --pairs 1000\n"
    "  fmb-validate --dim 6 --families all --pairs 100 --failures wrong.jsonl\n"
    "  fmb-validate --shard 1/2 --json a; fmb-validate --shard 2/2 --json b; fmb-validate --merge "
    "a b\n";

const struct argp validate_argp = {options, parse, "[CASE...]\n--merge FILE...", doc, NULL,
                                   NULL,    NULL};

void validate_plan_init(validate_plan *p)
{
    *p = (validate_plan){.pairs = 1000000, .shard = 1, .shards = 1, .threads = 1};
    p->usual = (study_validation){.seed = 1, .sample = 0.01, .textbook = 0.01};
    p->usual.plan.shape[0] = p->usual.plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
}
