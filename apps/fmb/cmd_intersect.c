/* cmd_intersect.c: fmb intersect FILE. */
#include <argp.h>
#include <float.h>
#include <stdlib.h>

#include "common/decimal.h"
#include "common/file.h"
#include "common/message.h"
#include "common/options.h"
#include "common/value.h"
#include "fmb/ask.h"
#include "fmb/commands.h"
#include "fmb/intersect.h"
#include "fmb/stop.h"

enum {
    KEY_CONTACT = 0x200,
    KEY_BOXES,
    KEY_DISTANCE,
    KEY_DEPTH,
    KEY_WITHIN,
    KEY_NORM,
    KEY_COMMON,
    KEY_SEPARATE,
    KEY_NEAREST,
    KEY_THREADS,
    KEY_SECONDS,
    KEY_BYTES,
    KEY_MAX_INPUT
};

static const struct argp_option options[] = {
    {"contact", KEY_CONTACT, "closed|open", 0,
     "Does touching count as meeting? closed: yes, open: no (default closed)", 1},
    {"boxes", KEY_BOXES, "exact|outward|none", 0,
     "The box of the common points: in rationals, in doubles that are rounded outward (fast), or "
     "verdicts alone (faster) (default exact)",
     1},
    {"distance", KEY_DISTANCE, NULL, 0, "Of pairs that are apart: how far, and the nearest points",
     1},
    {"depth", KEY_DEPTH, NULL, 0,
     "Of pairs that meet: the length of the shortest translation of B out of A", 1},
    {"within", KEY_WITHIN, "LENGTH", 0,
     "Is the distance at most LENGTH? Exit code 0: of some pair it is", 1},
    {"norm", KEY_NORM, "euclidean|max", 0,
     "How lengths are measured; max: by the largest coordinate (default euclidean)", 1},
    {"separate", KEY_SEPARATE, NULL, 0,
     "Of pairs that are apart: a row that A satisfies, and B at most with equality", 1},
    {"common", KEY_COMMON, NULL, 0, "Of pairs that meet: the vertices of their intersection", 1},
    {"nearest", KEY_NEAREST, NULL, 0,
     "A number means the double nearest to it; without this, 0.1 is 1/10", 1},
    {"threads", KEY_THREADS, "N", 0,
     "Threads, at most 64; answers and their order do not depend on it (default 1)", 1},
    {"max-seconds", KEY_SECONDS, "SECONDS", 0,
     "Time limit of a verdict, and of a box; 0 is none (default 0)", 1},
    {"max-bytes", KEY_BYTES, "BYTES", 0,
     "Limit of memory of a verdict, of a box, and of their system of rows; 0 is none "
     "(default half of the memory)",
     1},
    {"max-input", KEY_MAX_INPUT, "BYTES", 0, "Refuse a line that is longer (default 1073741824)",
     1},
    {"json", 'j', NULL, 0, "Print one JSON object instead of text", 2},
    {"quiet", 'q', NULL, 0, "Nothing on standard error but errors", 2},
    {0}};

static fmb_contact contact_of(const char *word, struct argp_state *state)
{
    static const char *const WORD[] = {
        [FMB_CONTACT_CLOSED] = "closed", [FMB_CONTACT_OPEN] = "open", NULL};
    return (fmb_contact)app_value_choice("--contact", word, WORD, state);
}

static boxes boxes_of(const char *word, struct argp_state *state)
{
    static const char *const WORD[] = {
        [BOXES_EXACT] = "exact", [BOXES_OUTWARD] = "outward", [BOXES_NONE] = "none", NULL};
    return (boxes)app_value_choice("--boxes", word, WORD, state);
}

static fmb_norm norm_of(const char *word, struct argp_state *state)
{
    static const char *const WORD[] = {
        [FMB_NORM_EUCLIDEAN] = "euclidean", [FMB_NORM_MAX] = "max", NULL};
    return (fmb_norm)app_value_choice("--norm", word, WORD, state);
}

/* Parse an option of intersect_near.h; ARGP_ERR_UNKNOWN: it is none. */
static error_t parse_near(int key, const char *arg, near_ask *ask, struct argp_state *state)
{
    switch (key) {
    case KEY_DISTANCE:
        return ask->distance = true, 0;
    case KEY_DEPTH:
        return ask->depth = true, 0;
    case KEY_COMMON:
        return ask->common = true, 0;
    case KEY_SEPARATE:
        return ask->separate = true, 0;
    case KEY_NORM:
        return ask->norm = norm_of(arg, state), 0;
    case KEY_WITHIN:
        if (near_read_margin(ask, arg) != APP_YES)
            exit(APP_USAGE);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    intersect_ask *ask = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &ask->digits;
        return 0;
    case KEY_CONTACT:
        ask->contact = contact_of(arg, state);
        return 0;
    case KEY_BOXES:
        ask->boxes = boxes_of(arg, state);
        return 0;
    case KEY_NEAREST:
        ask->nearest = true;
        return 0;
    case KEY_THREADS:
        ask->threads = (int)app_value_whole("--threads", arg, 1, APP_MOST_THREADS, state);
        return 0;
    case KEY_SECONDS:
        ask->max_seconds = app_value_number("--max-seconds", arg, 0, DBL_MAX, state);
        return 0;
    case KEY_BYTES:
        ask->max_bytes = (size_t)app_value_whole("--max-bytes", arg, 0, SIZE_MAX, state);
        return 0;
    case KEY_MAX_INPUT:
        ask->max_input = (size_t)app_value_whole("--max-input", arg, 1, SIZE_MAX, state);
        return 0;
    case 'j':
        ask->json = true;
        return 0;
    case 'q':
        ask->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (ask->file)
            return ARGP_ERR_UNKNOWN;
        ask->file = arg;
        return 0;
    case ARGP_KEY_END:
        if (!ask->file)
            argp_error(state, "FILE is missing (- is standard input)");
        return 0;
    default:
        return parse_near(key, arg, &ask->near, state);
    }
}

static const char doc[] =
    "Do two frames meet, where, and when? FILE has a pair of frames a line, in JSON "
    "({\"A\": {\"type\": \"cuboid\", \"orig\": [0, 0], \"comp\": [[1, 0], [0, 1]]}, \"B\": ...}), "
    "or "
    "pairs in binary (fmb convert --to pairs). "
    "For a pair that meets, prints the tightest intervals of the common points (x), of their "
    "coordinates in B (c), and of the times of contact (t) if something moves; then a "
    "common point."
    "\v"
    "Exit codes: 0 some pair meets, 1 none does, 2 interrupted, or some pair is undecided. A line "
    "that is no pair ends the command with 65; the answers of the lines before it are printed.\n"
    "\n"
    "Examples:\n"
    "  fmb intersect rooms.jsonl\n"
    "  fmb intersect rooms.jsonl --contact open --json\n"
    "  fmb intersect - --boxes none --nearest < many.jsonl\n";

/* ---- the command ----------------------------------------------------------------------------- */

int cmd_intersect(int argc, char **argv)
{
    static const struct argp_child children[] = {{&app_decimal_argp, 0, NULL, 0},
                                                 {NULL, 0, NULL, 0}};
    static const struct argp whole = {
        .options = options, .parser = parse, .args_doc = "FILE", .doc = doc, .children = children};
    intersect_ask ask = {.threads = 1, .max_bytes = app_ask_half_of_memory()};
    app_options_parse(&whole, argc, argv, &ask);
    ask.near.digits = ask.digits;
    FILE *in;
    int code = app_file_open(ask.file, &in);
    if (code == APP_YES) {
        code = intersect_stream(&ask, in);
        app_file_close_input(in);
    }
    near_ask_clear(&ask.near);
    return code;
}
