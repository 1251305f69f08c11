/* scaling.c: the cost of more dimensions. */
#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/scaling/scaling.h"
#include "fmb-qualify/share.h"

enum { KINDS = 3, DIMS = SCALING_MOST_DIM - SCALING_LEAST_DIM + 1, LEAST_PAIRS = 16 };

static const char *const KIND[KINDS] = {"CC", "CT", "TT"};
static const char *const MOTION[2] = {"static", "dynamic"};

typedef struct scaling_report {
    scaling_cell cell[2][KINDS][DIMS]; /* [moves] */
} scaling_report;

/* ---- one cell -------------------------------------------------------------------------------- */

/* smaller: the same with one dimension less, or NULL. */
static json_t *cell_json(const scaling_cell *x, int kind, const scaling_cell *smaller)
{
    json_t *obj = json_object();
    app_json_set(obj, "dim", json_integer(x->class.dim));
    app_json_set(obj, "motion", json_string(MOTION[x->class.moves]));
    app_json_set(obj, "pair", json_string(KIND[kind]));
    app_json_set(obj, "queries", qualify_count_json(x->pairs));
    app_json_set(obj, "meeting", qualify_count_json(x->meeting));
    app_json_set(obj, "fmb_ns", app_json_real(x->ns.median));
    app_json_set(obj, "growth", app_json_real(smaller ? x->ns.median / smaller->ns.median : NAN));
    app_json_set(obj, "exact_share", app_json_real(x->exact_share));
    app_json_set(obj, "rows", app_json_real(x->rows));
    app_json_set(obj, "lp_queries", qualify_count_json(x->lp_pairs));
    app_json_set(obj, "lp_ns", app_json_real(x->lp_ns.median));
    app_json_set(obj, "fmb_beside_lp_ns", app_json_real(x->beside_lp_ns.median));
    app_json_set(obj, "fmb_over_lp", qualify_ratio_json(x->over_lp));
    app_json_set(obj, "lp_wrong", qualify_count_json(x->lp_wrong));
    app_json_set(obj, "checked", qualify_count_json(x->checked));
    app_json_set(obj, "wrong", qualify_count_json(x->wrong));
    app_json_set(obj, "boxes", qualify_count_json(x->boxes));
    app_json_set(obj, "bad_boxes", qualify_count_json(x->bad_boxes));
    return obj;
}

/* ---- tables ---------------------------------------------------------------------------------- */

#define CLASS                                                                                      \
    {"dim", "D", "%.0f"}, {"motion", "motion", NULL},                                              \
    {                                                                                              \
        "pair", "pair", NULL                                                                       \
    }

static const qualify_column CELLS[] = {CLASS,
                                       {"queries", "queries", "%.0f"},
                                       {"meeting", "meet", "%.0f"},
                                       {"fmb_ns", "ns", "%.0f"},
                                       {"growth", "growth", "%.1f"},
                                       {"exact_share", "exact", "%.2g"},
                                       {"rows", "rows", "%.0f"},
                                       {"checked", "checked", "%.0f"},
                                       {"wrong", "wrong", "%.0f"},
                                       {"boxes", "boxes", "%.0f"},
                                       {"bad_boxes", "wrong", "%.0f"},
                                       {0}};
static const qualify_column PROGRAMS[] = {CLASS,
                                          {"lp_queries", "queries", "%.0f"},
                                          {"fmb_beside_lp_ns", "ns", "%.0f"},
                                          {"lp_ns", "LP ns", "%.0f"},
                                          QUALIFY_RATIO("fmb_over_lp", "over LP"),
                                          {"lp_wrong", "LP wrong", "%.0f"},
                                          {0}};

static void report_tables(const scaling_report *r, qualify_page *page)
{
    json_t *cells = app_need(json_array());
    for (int moves = 0; moves < 2; moves++)
        for (int kind = 0; kind < KINDS; kind++)
            for (int d = 0; d < DIMS; d++) {
                const scaling_cell *x = &r->cell[moves][kind][d];
                if (x->complete)
                    app_json_append(cells, cell_json(x, kind, d > 0 ? x - 1 : NULL));
            }
    app_json_set(qualify_page_json(page), "cells", cells);
    qualify_page_table(page, "cells",
                       "Verdicts: pairs asked and those that meet, time of a query [ns] and its "
                       "growth from one dimension less, share decided exactly, rows that exact "
                       "elimination makes, verdicts and boxes checked and wrong",
                       CELLS, "cells");
    if (!scaling_lp_name()) {
        qualify_page_text(page, "Built without GLPK: no linear programs.");
        return;
    }
    qualify_page_text(page,
                      "A linear program on some of these pairs: %s's dual simplex on rows that "
                      "were made before, in doubles, without a proof; beside it ours, with the "
                      "rows and the proof.",
                      scaling_lp_name());
    qualify_page_table(page, "programs",
                       "Time of a query [ns], of the linear program's, their ratio and its 95 % "
                       "interval",
                       PROGRAMS, "cells");
}

/* ---- the study ------------------------------------------------------------------------------- */

/* The number of pairs: half as many in each further dimension. */
static size_t pairs_of(const qualify_setup *o, int d)
{
    size_t n = o->pairs >> d;
    return n < LEAST_PAIRS ? LEAST_PAIRS : n;
}

/* By dimension, and within it motion and kind: the quick ones first. */
static int measure_cell(size_t i, const qualify_setup *o, scaling_cell *out)
{
    static const fmb_shape SHAPE[KINDS][2] = {
        {FMB_CUBOID, FMB_CUBOID}, {FMB_CUBOID, FMB_SIMPLEX}, {FMB_SIMPLEX, FMB_SIMPLEX}};
    int d = (int)i / (2 * KINDS), kind = (int)i % KINDS;
    const scaling_class c = {
        SCALING_LEAST_DIM + d, (int)i / KINDS % 2, {SHAPE[kind][0], SHAPE[kind][1]}};
    return scaling_measure(&c, o, pairs_of(o, d), out);
}

/* Runs all cells; true on the rank that reports. */
static bool measure_all(scaling_report *r, const qualify_setup *o, int *code)
{
    scaling_cell cell[2 * KINDS * DIMS] = {0};
    qualify_share share = qualify_share_begin(o, sizeof cell / sizeof *cell);
    for (size_t i; *code == APP_YES && qualify_share_next(&share, &i);)
        *code = measure_cell(i, o, &cell[i]);
    if (*code == APP_YES)
        qualify_share_collect(&share, cell, sizeof *cell);
    for (size_t i = 0; i < share.cells; i++)
        r->cell[i / KINDS % 2][i % KINDS][i / (2 * KINDS)] = cell[i];
    return qualify_share_end(&share);
}

static size_t count_wrong(const scaling_report *r)
{
    const scaling_cell *all = &r->cell[0][0][0];
    size_t wrong = 0;
    for (int i = 0; i < 2 * KINDS * DIMS; i++)
        wrong += all[i].wrong + all[i].bad_boxes;
    return wrong;
}

static int run_study(const qualify_setup *o, qualify_page *page)
{
    scaling_report *r = app_need(calloc(1, sizeof *r));
    int code = APP_YES;
    bool reports = measure_all(r, o, &code);
    if (reports)
        report_tables(r, page);
    size_t wrong = reports ? count_wrong(r) : 0;
    if (code == APP_YES && wrong > 0)
        code = app_error(APP_NO, "%zu wrong answers", wrong);
    free(r);
    return code;
}

const qualify_study qualify_study_scaling = {
    .name = "scaling",
    .title = "what more dimensions cost",
    .doc =
        "Verdicts on pairs of cuboids and simplices of 2 to 8 dimensions, still and moving, "
        "placed so that about half of them meet: time, growth, the share that is decided "
        "exactly, rows of an exact elimination, a linear program on the same pairs. All verdicts "
        "are compared with an oracle whose evidence is checked, some boxes with the exact ones. "
        "--pairs is for two dimensions; it halves with each further one.",
    .shared = true,
    .alone = {16384, 5},
    .brief = {4096, 3},
    .run = run_study,
};
