/* study.c: see study.h. */
#include "fmb-qualify/study.h"

#include <argp.h>
#include <stdlib.h>
#include <string.h>

#include "common/json.h"
#include "common/message.h"
#include "common/ranks.h"
#include "common/value.h"
#include "fmb-qualify/share.h"
#include "fmb-qualify/watch.h"
#include "study/clock/clock.h"

enum { KEY_PASSES = 0x100, KEY_SIMD, MOST_PAIRS = 10000000 };

static const struct argp_option options[] = {
    {"pairs", 'n', "N", 0, "Pairs of each class", 1},
    {"passes", KEY_PASSES, "N", 0, "Timed passes over all pairs", 1},
    {"seed", 's', "S", 0, "Seed of the random numbers [1]", 1},
    {"simd", KEY_SIMD, "LEVEL", 0, "auto, plain, avx2, avx512 [auto]", 1},
    {"out", 'o', "DIR", 0, "Write report.html, CSV, JSON and figures into this folder, too", 2},
    {"json", 'j', NULL, 0, "Print one JSON object instead of tables", 2},
    {"quiet", 'q', NULL, 0, "No progress bar", 2},
    {0}};

static error_t parse_report(int key, char *arg, struct argp_state *state)
{
    qualify_setup *o = state->input;
    switch (key) {
    case 'o':
        o->out = arg;
        return 0;
    case 'j':
        o->json = true;
        return 0;
    case 'q':
        o->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (o->takes_file && !o->file) {
            o->file = arg;
            return 0;
        }
        argp_error(state, "expected no more than one study, and that first, found '%s'", arg);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    qualify_setup *o = state->input;
    switch (key) {
    case 'n':
        o->pairs = (size_t)app_value_whole("--pairs", arg, 1, MOST_PAIRS, state);
        return 0;
    case 's':
        o->seed = app_value_whole("--seed", arg, 0, INT64_MAX, state); /* as JSON has it */
        return 0;
    case KEY_PASSES:
        o->passes = (int)app_value_whole("--passes", arg, 1, STUDY_CLOCK_MOST_PASSES, state);
        return 0;
    case KEY_SIMD:
        o->simd = app_value_simd(arg, state);
        return 0;
    default:
        return parse_report(key, arg, state);
    }
}

/* [give, free()] The help of a study, with its defaults. */
static char *doc_of(const qualify_study *s)
{
    char *doc;
    const char *more = strchr(s->doc, '\v');
    int length = more ? (int)(more - s->doc) : (int)strlen(s->doc);
    if (asprintf(&doc, "%.*s\v%s%sDefault: %zu pairs of each class, in %d passes.\n", length,
                 s->doc, more ? more + 1 : "", more ? "\n" : "", s->alone.pairs,
                 s->alone.passes) < 0)
        app_need(NULL);
    return doc;
}

static void read_options(const char *doc, bool takes_file, int argc, char **argv, qualify_setup *o)
{
    const struct argp whole_line = {
        .options = options, .parser = parse, .args_doc = takes_file ? "[FILE]" : NULL, .doc = doc};
    *o = (qualify_setup){.seed = 1, .takes_file = takes_file};
    argp_parse(&whole_line, argc, argv, 0, NULL, o);
}

/* Fills in the defaults of options that were not given. */
static qualify_setup with_effort(const qualify_setup *asked, const qualify_effort *usual)
{
    qualify_setup o = *asked;
    o.pairs = o.pairs > 0 ? o.pairs : usual->pairs;
    o.passes = o.passes > 0 ? o.passes : usual->passes;
    return o;
}

/* Other ranks than 0 write no files. */
static qualify_page *open_page(const qualify_setup *o)
{
    bool writes = app_rank() == 0;
    qualify_watch_begin(o->quiet || !writes);
    return qualify_page_open(writes ? o->out : NULL, writes && o->json);
}

/* Tells all ranks whether rank 0 could make its folder. */
static bool is_page_of_rank_0_good(const qualify_page *page)
{
    return app_ranks_agree(qualify_page_is_good(page) ? APP_YES : APP_CANNOT_WRITE) == APP_YES;
}

static int run_study(const qualify_study *s, const qualify_setup *asked,
                     const qualify_effort *usual, qualify_page *page)
{
    qualify_setup o = with_effort(asked, usual);
    qualify_page_begin(page, s->name, s->title);
    qualify_watch_name(s->name);
    app_json_set(qualify_page_json(page), "seed", json_integer((json_int_t)o.seed));
    app_json_set(qualify_page_json(page), "pairs", json_integer((json_int_t)o.pairs));
    app_json_set(qualify_page_json(page), "passes", json_integer(o.passes));
    app_json_set(qualify_page_json(page), "processes", json_integer(s->shared ? app_ranks() : 1));
    if (s->shared && app_ranks() > 1)
        qualify_page_text(page,
                          "Shared among %d processes: times are those of where each cell was "
                          "measured, beside the others.",
                          app_ranks());
    int code = s->shared || app_rank() == 0 ? s->run(&o, page) : APP_YES;
    if (code != APP_YES && code != APP_NO)
        app_ranks_fail(code);
    if (qualify_watch_interrupted())
        qualify_page_interrupted(page);
    qualify_page_end(page);
    return code;
}

/* The exit code: an error, else that of a Ctrl-C. */
static int end(qualify_page *page, int code)
{
    code = app_first_code(code, qualify_page_close(page));
    code = app_first_code(code, qualify_watch_interrupted() ? APP_UNDECIDED : APP_YES);
    qualify_watch_end();
    return code;
}

static int run_alone(const qualify_study *s, const qualify_setup *o)
{
    qualify_page *page = open_page(o);
    int code = APP_YES;
    if (is_page_of_rank_0_good(page))
        code = run_study(s, o, &s->alone, page);
    return end(page, code);
}

int qualify_study_main(const qualify_study *s, int argc, char **argv)
{
    qualify_setup o;
    char *doc = doc_of(s);
    read_options(doc, s->takes_file, argc, argv, &o);
    free(doc);
    int code = qualify_join_ranks();
    return code == APP_YES ? qualify_leave_ranks(run_alone(s, &o)) : code;
}

/* ---- all of them ----------------------------------------------------------------------------- */

static const char *const FOLDER = "fmb-report";

static const qualify_study *const STUDY[] = {
    &qualify_study_table1,  &qualify_study_article, &qualify_study_near,  &qualify_study_touching,
    &qualify_study_slender, &qualify_study_mesh,    &qualify_study_faces, &qualify_study_boxes,
    &qualify_study_scaling, &qualify_study_rules,   &qualify_study_peers, &qualify_study_bunny};
enum { STUDIES = sizeof STUDY / sizeof *STUDY };

static const char all_doc[] =
    "All studies, one after the other, with fewer pairs than each takes by itself: minutes. The "
    "report is in DIR/report.html; DIR is fmb-report unless --out names another.";

static int run_all(qualify_setup *o)
{
    int code = APP_YES;
    qualify_page *page = open_page(o);
    bool good = is_page_of_rank_0_good(page);
    for (int i = 0; good && i < STUDIES && !qualify_watch_interrupted(); i++) {
        o->counter = (size_t)i;
        code = app_first_code(code, run_study(STUDY[i], o, &STUDY[i]->brief, page));
    }
    return end(page, code);
}

int qualify_all(int argc, char **argv)
{
    qualify_setup o;
    read_options(all_doc, false, argc, argv, &o);
    o.out = o.out ? o.out : FOLDER;
    int code = qualify_join_ranks();
    return code == APP_YES ? qualify_leave_ranks(run_all(&o)) : code;
}
