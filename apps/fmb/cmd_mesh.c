/* cmd_mesh.c: fmb mesh A [B]. */
#include <argp.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "common/bar.h"
#include "common/budget.h"
#include "common/decimal.h"
#include "common/file.h"
#include "common/json.h"
#include "common/message.h"
#include "common/options.h"
#include "common/ranks.h"
#include "common/signals.h"
#include "common/value.h"
#include "fmb/ask.h"
#include "fmb/commands.h"
#include "fmb/mesh_ask.h"
#include "fmb/show.h"
#include "fmb/stop.h"

enum {
    KEY_MOVE = 0x200,
    KEY_SCALE,
    KEY_MIRROR,
    KEY_MOTION,
    KEY_NEIGHBOURS,
    KEY_WHERE,
    KEY_COMMON,
    KEY_WITHIN,
    KEY_DISTANCE,
    KEY_MARKED,
    KEY_ALL_PAIRS,
    KEY_CSV,
    KEY_FORMAT,
    KEY_SECONDS,
    KEY_BYTES,
    KEY_MAX_INPUT,
    KEY_THREADS
};

static const struct argp_option options[] = {
    {"move", KEY_MOVE, "X,Y,Z", 0, "Translate B (A, if it is alone), after --scale", 1},
    {"scale", KEY_SCALE, "S[,T,U]", 0, "Scale its coordinates, by one factor or three", 1},
    {"mirror", KEY_MIRROR, "x|y|z", 0, "Negate this coordinate", 1},
    {"motion", KEY_MOTION, "X,Y,Z", 0,
     "B moves by this vector while t goes from 0 to 1: which cells meet at some time?", 1},
    {"neighbours", KEY_NEIGHBOURS, NULL, 0,
     "List cells, too, that meet only in their common vertices and what these span", 1},
    {"where", KEY_WHERE, NULL, 0,
     "With the box of the common points of each pair, and when they meet if B moves: each end "
     "rounded outward",
     1},
    {"common", KEY_COMMON, NULL, 0,
     "With the vertices of the intersection of each pair, a point, segment, polygon or "
     "polyhedron, exactly; as x, y, z, t if B moves",
     1},
    {"within", KEY_WITHIN, "LENGTH", 0,
     "List cells, too, that are at most LENGTH apart, a decimal or p/q, exactly", 1},
    {"distance", KEY_DISTANCE, NULL, 0,
     "How far A and B are apart, instead: the nearest cells, their nearest points, and a row that "
     "separates these cells",
     1},
    {"marked", KEY_MARKED, "FILE", 0, "Write both meshes as PLY with colours: listed cells are red",
     1},
    {"all-pairs", KEY_ALL_PAIRS, NULL, 0,
     "Test every pair of cells, without trees of boxes: slow, for checking; shared among the "
     "processes of mpirun",
     1},
    {"format", KEY_FORMAT, "auto|off|obj|ply|stl|mesh", 0,
     "Format of the files (default: by name, else by content)", 1},
    {"max-seconds", KEY_SECONDS, "SECONDS", 0,
     "Time limit of the search for cells that meet; 0 is none", 1},
    {"max-bytes", KEY_BYTES, "BYTES", 0,
     "Limit of memory of the search; 0 is none (default half of the memory)", 1},
    {"threads", KEY_THREADS, "N", 0, "Threads, at most 64 (default 1)", 1},
    {"max-input", KEY_MAX_INPUT, "BYTES", 0, "Refuse a longer file (default 1073741824)", 1},
    {"json", 'j', NULL, 0, "Print one JSON object instead of text", 2},
    {"csv", KEY_CSV, NULL, 0, "Print comma-separated values instead of text", 2},
    {"quiet", 'q', NULL, 0, "Nothing on standard error but errors", 2},
    {0}};

/* ---- options --------------------------------------------------------------------------------- */

/* One number for all, if `one` allows that, or three with commas between. */
static void read_three_numbers(const char *option, const char *text, bool one, double out[3],
                               struct argp_state *state)
{
    const char *at = text;
    int n = 0;
    for (bool more = true; more && n < 3; n++) {
        char piece[64];
        size_t length = strcspn(at, ",");
        if (length >= sizeof piece)
            argp_error(state, "%s: expected shorter numbers, found '%s'", option, text);
        memcpy(piece, at, length);
        piece[length] = '\0';
        out[n] = app_value_number(option, piece, -DBL_MAX, DBL_MAX, state);
        more = at[length] == ',';
        at += length + more;
        if (n == 2 && more)
            argp_error(state, "%s: expected 3 numbers, found '%s'", option, text);
    }
    if (n == 1 && one)
        out[1] = out[2] = out[0];
    else if (n != 3)
        argp_error(state, "%s: expected 3 numbers, found '%s'", option, text);
}

static void use_number_of_place(mesh_ask *ask, int key, const char *arg, struct argp_state *state)
{
    static const char *const axis[] = {"x", "y", "z", NULL};
    switch (key) {
    case KEY_MOVE:
        read_three_numbers("--move", arg, false, ask->place.move, state);
        break;
    case KEY_SCALE:
        read_three_numbers("--scale", arg, true, ask->scale, state);
        break;
    case KEY_MOTION:
        read_three_numbers("--motion", arg, false, ask->motion, state);
        ask->moves = true;
        break;
    default:
        ask->mirror[app_value_choice("--mirror", arg, axis, state)] = true;
    }
}

static fmb_mesh_format format_of(const char *word, struct argp_state *state)
{
    fmb_mesh_format f = FMB_MESH_AUTO;
    if (!fmb_mesh_format_parse(word, &f))
        argp_error(state, "--format: expected auto, off, obj, ply, stl or mesh, found '%s'", word);
    return f;
}

static error_t check_arguments(const mesh_ask *ask, struct argp_state *state)
{
    if (!ask->file[0])
        argp_error(state, "A is missing (- is standard input)");
    if (ask->moves && !ask->file[1])
        argp_error(state, "--motion: expected a second mesh, which moves");
    if (ask->json && ask->csv)
        argp_error(state, "--json, --csv: expected one of them");
    if (ask->near.distance && !ask->file[1])
        argp_error(state, "--distance: expected a second mesh, which is apart");
    if (ask->near.distance && (ask->near.within || ask->neighbours || ask->where || ask->common ||
                               ask->marked || ask->all_pairs || ask->csv))
        argp_error(state, "--distance: expected no option about a list of cells");
    if (ask->digits > 0 && ask->csv)
        argp_error(state, "--decimal: --csv is for programs, and exact; --json has both");
    return 0;
}

/* Parse an option that sets a limit; ARGP_ERR_UNKNOWN: it is none. */
static error_t parse_limit(int key, const char *arg, mesh_ask *ask, struct argp_state *state)
{
    switch (key) {
    case KEY_SECONDS:
        ask->max_seconds = app_value_number("--max-seconds", arg, 0, DBL_MAX, state);
        return 0;
    case KEY_BYTES:
        ask->max_bytes = (size_t)app_value_whole("--max-bytes", arg, 0, SIZE_MAX, state);
        return 0;
    case KEY_THREADS:
        ask->threads = (size_t)app_value_whole("--threads", arg, 1, 64, state);
        return 0;
    case KEY_MAX_INPUT:
        ask->max_input = (size_t)app_value_whole("--max-input", arg, 1, SIZE_MAX, state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    mesh_ask *ask = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &ask->digits;
        return 0;
    case KEY_MOVE:
    case KEY_SCALE:
    case KEY_MIRROR:
    case KEY_MOTION:
        use_number_of_place(ask, key, arg, state);
        return 0;
    case KEY_NEIGHBOURS:
        ask->neighbours = true;
        return 0;
    case KEY_WHERE:
        ask->where = true;
        return 0;
    case KEY_COMMON:
        ask->common = true;
        return 0;
    case KEY_WITHIN:
        if (near_read_margin(&ask->near, arg) != APP_YES)
            exit(APP_USAGE);
        return 0;
    case KEY_DISTANCE:
        ask->near.distance = ask->near.separate = true;
        return 0;
    case KEY_MARKED:
        ask->marked = arg;
        return 0;
    case KEY_ALL_PAIRS:
        ask->all_pairs = true;
        return 0;
    case KEY_FORMAT:
        ask->format = format_of(arg, state);
        return 0;
    case 'j':
        ask->json = true;
        return 0;
    case KEY_CSV:
        ask->csv = true;
        return 0;
    case 'q':
        ask->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (state->arg_num > 1)
            return ARGP_ERR_UNKNOWN;
        ask->file[state->arg_num] = arg;
        return 0;
    case ARGP_KEY_END:
        return check_arguments(ask, state);
    default:
        return parse_limit(key, arg, ask, state);
    }
}

static const char doc[] =
    "Which triangles or tetrahedra of two meshes meet, and how? Of one mesh: which of its own meet "
    "in more than their common vertices span? Exact for the coordinates as doubles. Formats: OFF, "
    "OBJ, PLY, STL, medit .mesh, TetGen .node, whose .ele stands beside it, and, by their names "
    "alone, "
    "glTF 2.0 (.gltf, .glb) and 3MF."
    "\v"
    "A line is: how they meet, the face (from 0) of A, that of B, their common vertices, and their "
    "groups, where a file has such: groups and objects of OBJ, nodes of glTF, objects of 3MF. "
    "cross: "
    "their interiors meet; coplanar: their interiors meet, in one plane (cross if one is flat, or "
    "some coordinate is beyond 2^200 or below 2^-200); share: they meet only in their common "
    "vertices and what these span; touch: they meet otherwise; apart: they do not meet, but are "
    "within --within.\n"
    "\n"
    "Exit codes: 0 some cells are listed, 1 none are, 2 beyond a limit or interrupted; with "
    "--distance 0 if it is found.\n"
    "\n"
    "Examples:\n"
    "  fmb mesh part.stl\n"
    "  fmb mesh bunny.ply bunny.ply --mirror x --move 0.05,-0.01,0\n"
    "  fmb mesh robot.obj room.obj --motion 0,0,-2 --json\n"
    "  fmb mesh robot.obj room.obj --distance\n"
    "  mpirun -n 64 fmb mesh large.ply --all-pairs\n";

/* ---- the command ----------------------------------------------------------------------------- */

static bool show_progress(void *self, double done)
{
    app_bar_show(self, (uint64_t)(done * 1000), 1000, NULL);
    return !app_stop_asked();
}

/* bar is to be begun, and ended. */
static fmb_mesh_options options_of(const mesh_ask *ask, app_bar *bar)
{
    fmb_mesh_options how = {.size = sizeof how,
                            .neighbours = ask->neighbours,
                            .motion = ask->moves ? ask->motion : NULL,
                            .max_seconds = ask->max_seconds,
                            .max_bytes = ask->max_bytes,
                            .threads = ask->threads,
                            .progress = show_progress,
                            .self = bar,
                            .within = ask->within};
    return how;
}

static fmb_status find_hits(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b,
                            fmb_mesh_answer *answer)
{
    app_bar bar = app_bar_begin(ask->quiet || app_rank() > 0);
    fmb_mesh_options how = options_of(ask, &bar);
    fmb_status st =
        ask->all_pairs ? mesh_meet_pairs(a, b, &how, answer) : fmb_mesh_meet(a, b, &how, answer);
    app_bar_end(&bar);
    return st;
}

static void forget_answer(const mesh_ask *ask, fmb_mesh_answer *answer)
{
    if (ask->all_pairs)
        free(answer->hit);
    else
        fmb_mesh_answer_clear(answer);
}

static void tell_undecided(const mesh_ask *ask, fmb_stop stop, const char *what)
{
    if (!ask->quiet)
        fprintf(stderr, "fmb: undecided (%s): %s\n",
                fmb_stop_text(stop != FMB_STOP_DONE ? stop : FMB_STOP_CANCELLED), what);
}

static int find_nearest(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b)
{
    fmb_mesh_nearest nearest = {.size = sizeof nearest};
    app_bar bar = app_bar_begin(ask->quiet);
    fmb_mesh_options how = options_of(ask, &bar);
    fmb_status st = fmb_mesh_distance(a, b, &how, &nearest);
    app_bar_end(&bar);
    if (st != FMB_OK)
        return app_status_error(st);
    int code = nearest.stop != FMB_STOP_DONE ? APP_UNDECIDED : APP_YES;
    code = mesh_report_nearest(ask, a, b, &nearest, code);
    if (code == APP_UNDECIDED)
        tell_undecided(ask, nearest.stop, "no distance");
    fmb_proximity_free(nearest.distance);
    return code;
}

static int meet(const mesh_ask *ask, const fmb_mesh *a, const fmb_mesh *b)
{
    fmb_mesh_answer answer = {.size = sizeof answer};
    fmb_status st = find_hits(ask, a, b, &answer);
    if (st != FMB_OK)
        return app_ranks_fail(app_status_error(st));
    int code = answer.stop != FMB_STOP_DONE ? APP_UNDECIDED : answer.hits > 0 ? APP_YES : APP_NO;
    if (app_rank() == 0)
        code = mesh_report(ask, a, b ? b : a, &answer, code);
    if (app_rank() == 0 && ask->marked)
        code = mesh_mark(ask, a, b, &answer, code);
    if (app_rank() == 0 && code == APP_UNDECIDED)
        tell_undecided(ask, answer.stop,
                       ask->within ? "cells that are near, perhaps not all"
                                   : "cells that meet, perhaps not all");
    forget_answer(ask, &answer);
    return code;
}

/* Rank 0 reads the meshes and sends them to all ranks. */
static int read_meshes(const mesh_ask *ask, int files, fmb_mesh *m[2])
{
    int code = APP_YES;
    for (int i = 0; app_rank() == 0 && code == APP_YES && i < files; i++)
        code = mesh_file_read(ask, ask->file[i], &m[i]);
    if (app_rank() == 0 && code == APP_YES)
        code = mesh_file_place(ask, &m[files - 1]);
    for (int i = 0; i < files; i++)
        code = mesh_share(code, &m[i]);
    return code;
}

/* Answer by several processes; Ctrl-C ends them without an answer. */
static int answer_as_ranks(const mesh_ask *ask)
{
    fmb_mesh *m[2] = {NULL, NULL};
    app_stop_begin(NULL);
    if (app_ranks() > 1)
        app_signals_set(app_file_abandon);
    app_budget_begin(ask->max_bytes);
    int code = read_meshes(ask, ask->file[1] ? 2 : 1, m);
    app_budget_end(); /* the search counts the meshes itself */
    if (code == APP_UNDECIDED && ask->json)
        app_json_print_unread();
    if (code == APP_YES)
        code = ask->near.distance ? find_nearest(ask, m[0], m[1]) : meet(ask, m[0], m[1]);
    app_stop_end();
    fmb_mesh_free(m[0]);
    fmb_mesh_free(m[1]);
    return app_rank() == 0 ? code : APP_YES;
}

int cmd_mesh(int argc, char **argv)
{
    static const struct argp_child children[] = {{&app_decimal_argp, 0, NULL, 0},
                                                 {NULL, 0, NULL, 0}};
    static const struct argp whole = {
        .options = options, .parser = parse, .args_doc = "A [B]", .doc = doc, .children = children};
    mesh_ask ask = {.max_bytes = app_ask_half_of_memory(), .scale = {1, 1, 1}};
    app_options_parse(&whole, argc, argv, &ask);
    int code = app_ranks_begin(1);
    if (code != APP_YES)
        return code;
    ask.near.digits = ask.digits;
    ask.within = ask.near.within ? app_print("%Qd", ask.near.margin) : NULL;
    if (app_ranks() > 1 && !ask.all_pairs)
        code = app_rank() > 0
                   ? APP_YES
                   : app_error(APP_USAGE, "%d processes share --all-pairs alone", app_ranks());
    else
        code = answer_as_ranks(&ask);
    free(ask.within);
    near_ask_clear(&ask.near);
    app_ranks_end();
    return code;
}
