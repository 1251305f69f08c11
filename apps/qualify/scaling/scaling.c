/* scaling.c: what do more dimensions cost? */
#include <math.h>
#include <stdlib.h>

#include "common/json.h"
#include "common/message.h"
#include "qualify/scaling/scaling.h"
#include "qualify/watch.h"

enum { KINDS = 3, DIMS = SCALING_MOST_DIM - SCALING_LEAST_DIM + 1, LEAST_PAIRS = 16 };

static const char *const KIND[KINDS] = {"CC", "CT", "TT"};
static const char *const MOTION[2] = {"static", "dynamic"};

typedef struct scaling_report {
    scaling_cell cell[2][KINDS][DIMS]; /* [moves] */
} scaling_report;

/* ---- one cell -------------------------------------------------------------------------------- */

static json_t *cell_json(const scaling_cell *x, int kind)
{
    json_t *obj = json_object();
    app_json_set(obj, "dim", json_integer(x->class.dim));
    app_json_set(obj, "motion", json_string(MOTION[x->class.moves]));
    app_json_set(obj, "pair", json_string(KIND[kind]));
    app_json_set(obj, "queries", json_integer((json_int_t)x->pairs));
    app_json_set(obj, "meeting", json_integer((json_int_t)x->meeting));
    app_json_set(obj, "fmb_ns", app_json_real(x->ns.median));
    app_json_set(obj, "exact_share", app_json_real(x->exact_share));
    app_json_set(obj, "rows", app_json_real(x->rows));
    app_json_set(obj, "lp_ns", app_json_real(x->lp_ns.median));
    app_json_set(obj, "fmb_over_lp", app_json_real(x->over_lp.median));
    app_json_set(obj, "lp_queries", json_integer((json_int_t)x->lp_pairs));
    app_json_set(obj, "lp_wrong", json_integer((json_int_t)x->lp_wrong));
    app_json_set(obj, "checked", json_integer((json_int_t)x->checked));
    app_json_set(obj, "wrong", json_integer((json_int_t)x->wrong));
    app_json_set(obj, "boxes", json_integer((json_int_t)x->boxes));
    app_json_set(obj, "bad_boxes", json_integer((json_int_t)x->bad_boxes));
    return obj;
}

static void add_line(app_table *t, const scaling_cell *x, int kind, const scaling_cell *smaller)
{
    qualify_cell(t, "%d", x->class.dim);
    qualify_cell(t, "%s", MOTION[x->class.moves]);
    qualify_cell(t, "%s", KIND[kind]);
    qualify_cell(t, "%zu", x->pairs);
    qualify_cell(t, "%.0f", 100 * (double)x->meeting / (double)x->pairs);
    qualify_number_cell(t, "%.3f", x->ns.median / 1000);
    qualify_number_cell(t, "%.1f", smaller ? x->ns.median / smaller->ns.median : NAN);
    qualify_number_cell(t, "%.2f", 100 * x->exact_share);
    qualify_number_cell(t, "%.0f", x->rows);
    qualify_number_cell(t, "%.3f", x->lp_ns.median / 1000);
    qualify_number_cell(t, "%.2f", x->over_lp.median);
    qualify_cell(t, "%zu/%zu", x->wrong, x->checked);
    qualify_cell(t, "%zu/%zu", x->bad_boxes, x->boxes);
}

/* ---- tables and figures ---------------------------------------------------------------------- */

static void report_table(const scaling_report *r, qualify_page *page)
{
    static const char *const TITLES[] = {"D",     "motion", "pair",  "queries", "meet",
                                         "us",    "growth", "exact", "rows",    "LP us",
                                         "us/LP", "wrong",  "boxes"};
    app_table t = {.columns = sizeof TITLES / sizeof *TITLES, .align = "rllrrrrrrrrrr"};
    json_t *cells = app_need(json_array());
    qualify_titles(&t, TITLES);
    for (int moves = 0; moves < 2; moves++)
        for (int kind = 0; kind < KINDS; kind++)
            for (int d = 0; d < DIMS; d++) {
                const scaling_cell *x = &r->cell[moves][kind][d];
                if (!x->complete)
                    continue;
                add_line(&t, x, kind, d > 0 ? x - 1 : NULL);
                app_json_append(cells, cell_json(x, kind));
            }
    qualify_page_table(page, "cells",
                       "Verdicts, about half of the pairs meeting: share that meets [%], time of a "
                       "query [us] and its growth from one dimension less, share decided exactly "
                       "[%], rows that exact elimination makes, time of a linear program and ours "
                       "over it on the same pairs, wrong verdicts and wrong boxes",
                       &t);
    app_json_set(qualify_page_json(page), "cells", cells);
}

static void put_point(FILE *f, double ns)
{
    if (isfinite(ns) && ns > 0)
        fprintf(f, " %.6g", ns / 1000);
    else
        fputs(" -", f);
}

static void report_figure(const scaling_report *r, qualify_page *page, int moves)
{
    static const char *const CAPTION[2] = {"Time of a verdict by dimension, static frames",
                                           "Time of a verdict by dimension, dynamic frames"};
    qualify_figure f;
    qualify_figure_begin(&f);
    fputs("D", f.data);
    for (int kind = 0; kind < KINDS; kind++)
        fprintf(f.data, " %s \"%s, LP\"", KIND[kind], KIND[kind]);
    for (int d = 0; d < DIMS; d++) {
        fprintf(f.data, "\n%d", SCALING_LEAST_DIM + d);
        for (int kind = 0; kind < KINDS; kind++) {
            const scaling_cell *x = &r->cell[moves][kind][d];
            put_point(f.data, x->complete ? x->ns.median : NAN);
            put_point(f.data, x->complete ? x->lp_ns.median : NAN);
        }
    }
    fputc('\n', f.data);
    fprintf(f.script,
            "set title '%s frames'\nset logscale y\nset grid\nset key left top\nset xlabel 'D'\n"
            "set xrange [%d.8:%d.2]\nset ylabel 'time of a verdict [us]'\n"
            "plot for [k=0:%d] data using 1:(column(2+2*k)) with linespoints linewidth 2 "
            "linetype k+1 title columnheader(2+2*k), for [k=0:%d] data using 1:(column(3+2*k)) "
            "with linespoints linewidth 1 linetype k+1 dashtype 2 title columnheader(3+2*k)\n",
            MOTION[moves], SCALING_LEAST_DIM - 1, SCALING_MOST_DIM, KINDS - 1, KINDS - 1);
    qualify_page_figure(page, MOTION[moves], CAPTION[moves], &f);
}

static void report_bar(const scaling_report *r, qualify_page *page)
{
    const scaling_cell *x = &r->cell[1][0][6 - SCALING_LEAST_DIM];
    if (!x->complete)
        return;
    qualify_page_text(page, "D = 6, dynamic, CC: %.1f us a verdict; the bar is 100 us.",
                      x->ns.median / 1000);
    if (isfinite(x->lp_ns.median))
        qualify_page_text(page,
                          "There the linear program (%s's dual simplex on rows that were made "
                          "before, in doubles, without a proof) takes %.1f us: ours takes %.2f "
                          "times that, with the rows and the proof.",
                          scaling_lp_name(), x->lp_ns.median / 1000, x->over_lp.median);
}

/* ---- the study ------------------------------------------------------------------------------- */

/* Half as many in each further dimension. */
static size_t pairs_of(const qualify_setup *o, int d)
{
    size_t n = o->pairs >> d;
    return n < LEAST_PAIRS ? LEAST_PAIRS : n;
}

static int measure_all(scaling_report *r, const qualify_setup *o)
{
    static const fmb_shape SHAPE[KINDS][2] = {
        {FMB_CUBOID, FMB_CUBOID}, {FMB_CUBOID, FMB_SIMPLEX}, {FMB_SIMPLEX, FMB_SIMPLEX}};
    size_t part = 0;
    for (int d = 0; d < DIMS; d++)
        for (int moves = 0; moves < 2; moves++)
            for (int kind = 0; kind < KINDS; kind++) {
                const scaling_class c = {
                    SCALING_LEAST_DIM + d, moves, {SHAPE[kind][0], SHAPE[kind][1]}};
                qualify_watch_part(part++, (size_t)2 * KINDS * DIMS);
                if (qualify_watch_interrupted())
                    return APP_YES;
                int code = scaling_measure(&c, o, pairs_of(o, d), &r->cell[moves][kind][d]);
                if (code != APP_YES)
                    return code;
            }
    return APP_YES;
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
    int code = measure_all(r, o);
    report_table(r, page);
    if (!scaling_lp_name())
        qualify_page_text(page, "Built without GLPK: no linear programs.");
    for (int moves = 0; moves < 2; moves++)
        report_figure(r, page, moves);
    report_bar(r, page);
    size_t wrong = count_wrong(r);
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
    .alone = {16384, 5},
    .brief = {4096, 3},
    .run = run_study,
};
