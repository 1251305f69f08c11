/* boxes.c: how much larger than the common points is the box that one is given, and what does it
 * cost? Over meeting pairs of the article's generator. */
#include <math.h>
#include <stdlib.h>

#include "common/json.h"
#include "common/message.h"
#include "qualify/boxes/boxes.h"
#include "qualify/study.h"
#include "qualify/watch.h"

typedef struct boxes_class {
    const char *name, *title;
    int dim;
    bool moves;
    size_t share; /* of the pairs: one in so many */
} boxes_class;

static const boxes_class CLASS[] = {{"2d-static", "2D static", 2, false, 1},
                                    {"2d-dynamic", "2D dynamic", 2, true, 1},
                                    {"3d-static", "3D static", 3, false, 1},
                                    {"3d-dynamic", "3D dynamic", 3, true, 1},
                                    {"4d-static", "4D static", 4, false, 16}};
enum { CLASSES = sizeof CLASS / sizeof *CLASS };

static const char *const TITLE[BOXES_KINDS] = {
    [BOXES_OURS] = "ours",
    [BOXES_ARTICLE] = "article",
    [BOXES_CLIPPED] = "article, clipped to both AABBs",
    [BOXES_MENDED] = "article, mended",
    [BOXES_AABBS] = "both AABBs",
    [BOXES_OURS_INSIDE] = "ours, in B",
    [BOXES_ARTICLE_INSIDE] = "article, in B",
    [BOXES_MENDED_INSIDE] = "article, mended, in B",
};

typedef struct boxes_report {
    const qualify_setup *setup;
    app_table sizes, times;
    json_t *size_cells, *time_cells;
    size_t wrong; /* boxes of ours that do not hold the exact one, or are too large */
} boxes_report;

/* ---- sizes ----------------------------------------------------------------------------------- */

static double mean(const double *x, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += x[i];
    return sum / (double)n;
}

static void add_size(boxes_report *r, const boxes_class *c, const boxes_sizes *s, int kind)
{
    double holds = 100 * (double)s->holds[kind] / (double)s->n,
           average = mean(s->ratio[kind], s->n);
    study_spread spread = study_spread_of(s->ratio[kind], s->n);
    json_t *obj = json_object();
    qualify_cell(&r->sizes, "%s", c->title);
    qualify_cell(&r->sizes, "%s", TITLE[kind]);
    qualify_cell(&r->sizes, "%.4g", spread.least);
    qualify_cell(&r->sizes, "%.4g", spread.median);
    qualify_cell(&r->sizes, "%.4g", average);
    qualify_cell(&r->sizes, "%.4g", spread.most);
    qualify_cell(&r->sizes, "%.2f", holds);
    app_json_set(obj, "case", json_string(c->name));
    app_json_set(obj, "box", json_string(TITLE[kind]));
    app_json_set(obj, "pairs", json_integer((json_int_t)s->n));
    app_json_set(obj, "min", json_real(spread.least));
    app_json_set(obj, "median", json_real(spread.median));
    app_json_set(obj, "mean", json_real(average));
    app_json_set(obj, "max", json_real(spread.most));
    app_json_set(obj, "holds_percent", json_real(holds));
    app_json_append(r->size_cells, obj);
}

/* Some curves nearly coincide: the wider ones are drawn first. One lies at 1: not on the frame. */
static void put_script(const boxes_class *c, FILE *f)
{
    static const struct {
        int kind, width;
    } CURVE[BOXES_WORLD] = {{BOXES_AABBS, 9},
                            {BOXES_CLIPPED, 5},
                            {BOXES_MENDED, 2},
                            {BOXES_ARTICLE, 2},
                            {BOXES_OURS, 2}};
    fprintf(f,
            "set title '%s'\nset logscale y\nset yrange [0.5:]\nset grid\nset key left top\n"
            "set xlabel 'pairs with at most that ratio [%%]'\n"
            "set ylabel 'volume of the box over the tight one'\nplot",
            c->title);
    for (int i = 0; i < BOXES_WORLD; i++)
        fprintf(f, "%s data using 1:%d with lines linetype %d linewidth %d title columnheader(%d)",
                i > 0 ? "," : "", CURVE[i].kind + 2, CURVE[i].kind + 1, CURVE[i].width,
                CURVE[i].kind + 2);
    fputc('\n', f);
}

/* Quantiles, once the ratios are sorted. */
static void draw_sizes(qualify_page *page, const boxes_class *c, const boxes_sizes *s)
{
    enum { STEPS = 200 };
    qualify_figure f;
    char *caption;
    qualify_figure_begin(&f);
    fputs("share", f.data);
    for (int kind = 0; kind < BOXES_WORLD; kind++)
        fprintf(f.data, " \"%s\"", TITLE[kind]);
    for (size_t i = 0; i <= STEPS; i++) {
        fprintf(f.data, "\n%g", 100.0 * (double)i / STEPS);
        for (int kind = 0; kind < BOXES_WORLD; kind++)
            fprintf(f.data, " %.6g", s->ratio[kind][i * (s->n - 1) / STEPS]);
    }
    fputc('\n', f.data);
    put_script(c, f.script);
    if (asprintf(&caption, "Volumes of boxes over the tight one, %s: quantiles", c->title) < 0)
        app_need(NULL);
    qualify_page_figure(page, c->name, caption, &f);
    free(caption);
}

static int report_sizes(boxes_report *r, qualify_page *page, const boxes_class *c,
                        const study_pairs *pairs)
{
    boxes_sizes s;
    fmb_status st = boxes_measure(pairs, r->setup->simd, &s);
    if (st != FMB_OK)
        return app_status_error(st);
    r->wrong += s.wrong;
    if (!s.interrupted && s.n > 0) {
        for (int kind = 0; kind < BOXES_KINDS; kind++)
            add_size(r, c, &s, kind);
        draw_sizes(page, c, &s);
    }
    boxes_sizes_clear(&s);
    return APP_YES;
}

/* ---- times ----------------------------------------------------------------------------------- */

static int report_times(boxes_report *r, const boxes_class *c, const study_pairs *pairs)
{
    study_clock clock;
    fmb_status st = boxes_time(pairs, r->setup, &clock);
    if (st != FMB_OK)
        return app_status_error(st);
    if (clock.complete > 0) {
        study_spread ratio = study_clock_ratio(&clock, 1, 0);
        double verdict = study_clock_ns(&clock, 0).median, box = study_clock_ns(&clock, 1).median;
        json_t *obj = json_object();
        qualify_cell(&r->times, "%s", c->title);
        qualify_cell(&r->times, "%zu", pairs->n);
        qualify_cell(&r->times, "%.3g", verdict);
        qualify_cell(&r->times, "%.3g", box);
        qualify_cell(&r->times, "%.2f", ratio.median);
        qualify_cell(&r->times, "%.2f-%.2f", ratio.least, ratio.most);
        app_json_set(obj, "case", json_string(c->name));
        app_json_set(obj, "pairs", json_integer((json_int_t)pairs->n));
        app_json_set(obj, "verdict_ns", json_real(verdict));
        app_json_set(obj, "box_ns", json_real(box));
        app_json_set(obj, "ratio", json_real(ratio.median));
        app_json_append(r->time_cells, obj);
    }
    study_clock_clear(&clock);
    return APP_YES;
}

/* ---- the study ------------------------------------------------------------------------------- */

static int run_class(boxes_report *r, qualify_page *page, const boxes_class *c)
{
    study_pairs pairs;
    size_t n = r->setup->pairs / c->share + 1;
    fmb_status st = boxes_draw(c->dim, c->moves, r->setup->seed, n, &pairs);
    if (st != FMB_OK)
        return app_status_error(st);
    int code = report_sizes(r, page, c, &pairs);
    if (code == APP_YES)
        code = report_times(r, c, &pairs);
    study_pairs_free(&pairs);
    return code;
}

static int conclude(boxes_report *r, qualify_page *page)
{
    qualify_page_table(
        page, "sizes",
        "Volume over that of the tight box; share of pairs whose box holds the tight "
        "one (ours to the last bit, others but for rounding) [%]",
        &r->sizes);
    qualify_page_text(
        page,
        "\"Article\" is the box as its program makes it; \"clipped\" what is left of it "
        "within the boxes of both frames, as its README advises; \"mended\" takes each row as "
        "a bound and forgets no corner. \"Both AABBs\" is what the boxes of both frames have "
        "in common, for as long as they move. \"In B\": in B's coordinates.");
    qualify_page_table(page, "times",
                       "Verdict, and verdict with all boxes, times and a witness, on meeting pairs "
                       "[ns a pair]; the bar is 4.00 in 3D static",
                       &r->times);
    app_json_set(qualify_page_json(page), "sizes", r->size_cells);
    app_json_set(qualify_page_json(page), "times", r->time_cells);
    app_json_set(qualify_page_json(page), "wrong", json_integer((json_int_t)r->wrong));
    if (r->wrong > 0)
        return app_error(APP_NO, "%zu boxes do not hold the exact one, or are too large", r->wrong);
    return APP_YES;
}

static int run(const qualify_setup *o, qualify_page *page)
{
    static const char *const SIZES[] = {"case", "box", "min", "median", "mean", "max", "holds"};
    static const char *const TIMES[] = {"case",       "pairs", "verdict",
                                        "with boxes", "ratio", "passes"};
    boxes_report r = {.setup = o,
                      .sizes = {.columns = 7, .align = "llrrrrr"},
                      .times = {.columns = 6, .align = "lrrrrr"},
                      .size_cells = app_need(json_array()),
                      .time_cells = app_need(json_array())};
    int code = APP_YES;
    qualify_titles(&r.sizes, SIZES);
    qualify_titles(&r.times, TIMES);
    for (int i = 0; code == APP_YES && i < CLASSES && !qualify_watch_interrupted(); i++) {
        qualify_watch_part((size_t)i, CLASSES);
        code = run_class(&r, page, &CLASS[i]);
    }
    int last = conclude(&r, page);
    return code == APP_YES ? last : code;
}

const qualify_study qualify_study_boxes = {
    .name = "boxes",
    .title = "how large the boxes of the common points are",
    .doc =
        "Volumes of the box of the common points of meeting pairs: ours, the article's, and what "
        "the axis-parallel boxes of both frames have in common, each over the tight box, which "
        "is found exactly; and the time that ours takes.",
    .alone = {65536, 5},
    .brief = {16384, 3},
    .run = run,
};
