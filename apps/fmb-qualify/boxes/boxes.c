/* boxes.c: how much larger than the tight box of the common points are the computed boxes, and what
 * do they cost? On meeting pairs of the article's generator. */
#include <math.h>
#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/boxes/boxes.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/study.h"
#include "fmb-qualify/watch.h"

typedef struct boxes_class {
    const char *name;
    int dim;
    bool moves;
    size_t share; /* one in `share` of the pairs is measured */
} boxes_class;

static const boxes_class CLASS[] = {{"2d-static", 2, false, 1},
                                    {"2d-dynamic", 2, true, 1},
                                    {"3d-static", 3, false, 1},
                                    {"3d-dynamic", 3, true, 1},
                                    {"4d-static", 4, false, 16}};
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
    json_t *sizes, *quantiles, *times;
    size_t wrong; /* our boxes that do not hold the exact one, or are too large */
} boxes_report;

/* ---- sizes ----------------------------------------------------------------------------------- */

static void add_size(boxes_report *r, const boxes_class *c, const boxes_sizes *s, int kind)
{
    study_spread spread = study_spread_of(s->ratio[kind], s->n);
    double sum = 0;
    for (size_t i = 0; i < s->n; i++)
        sum += s->ratio[kind][i];
    json_t *obj = json_object();
    app_json_set(obj, "case", json_string(c->name));
    app_json_set(obj, "box", json_string(TITLE[kind]));
    app_json_set(obj, "pairs", qualify_count_json(s->n));
    app_json_set(obj, "min", app_json_real(spread.least));
    app_json_set(obj, "median", app_json_real(spread.median));
    app_json_set(obj, "mean", app_json_real(sum / (double)s->n));
    app_json_set(obj, "max", app_json_real(spread.most));
    app_json_set(obj, "holds_percent", json_real(100 * (double)s->holds[kind] / (double)s->n));
    app_json_append(r->sizes, obj);
}

/* The ratios must be sorted. */
static void add_quantiles(boxes_report *r, const boxes_class *c, const boxes_sizes *s)
{
    enum { STEPS = 100 };
    json_t *obj = json_object(), *percent = json_array(), *ratio = json_object();
    for (size_t i = 0; i <= STEPS; i++)
        app_json_append(percent, qualify_count_json(100 * i / STEPS));
    for (int kind = 0; kind < BOXES_WORLD; kind++) {
        json_t *all = json_array();
        for (size_t i = 0; i <= STEPS; i++)
            app_json_append(all, app_json_real(s->ratio[kind][i * (s->n - 1) / STEPS]));
        app_json_set(ratio, TITLE[kind], all);
    }
    app_json_set(obj, "case", json_string(c->name));
    app_json_set(obj, "percent", percent);
    app_json_set(obj, "ratio", ratio);
    app_json_append(r->quantiles, obj);
}

static int report_sizes(boxes_report *r, const boxes_class *c, const study_pairs *pairs)
{
    boxes_sizes s;
    fmb_status st = boxes_measure(pairs, r->setup->simd, &s);
    if (st != FMB_OK)
        return app_status_error(st);
    r->wrong += s.wrong;
    if (!s.interrupted && s.n > 0) {
        for (int kind = 0; kind < BOXES_KINDS; kind++)
            add_size(r, c, &s, kind);
        add_quantiles(r, c, &s);
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
        json_t *obj = json_object();
        app_json_set(obj, "case", json_string(c->name));
        app_json_set(obj, "pairs", qualify_count_json(pairs->n));
        app_json_set(obj, "verdict_ns", json_real(study_clock_ns(&clock, 0).median));
        app_json_set(obj, "box_ns", json_real(study_clock_ns(&clock, 1).median));
        app_json_set(obj, "box_over_verdict", qualify_ratio_json(study_clock_ratio(&clock, 1, 0)));
        app_json_append(r->times, obj);
    }
    study_clock_clear(&clock);
    return APP_YES;
}

/* ---- the study ------------------------------------------------------------------------------- */

static int run_class(boxes_report *r, const boxes_class *c)
{
    study_pairs pairs;
    size_t n = r->setup->pairs / c->share + 1;
    fmb_status st = boxes_draw(c->dim, c->moves, r->setup->seed, n, &pairs);
    if (st != FMB_OK)
        return app_status_error(st);
    int code = report_sizes(r, c, &pairs);
    if (code == APP_YES)
        code = report_times(r, c, &pairs);
    study_pairs_free(&pairs);
    return code;
}

static const qualify_column SIZES[] = {{"case", "case", NULL},
                                       {"box", "box", NULL},
                                       {"pairs", "pairs", "%.0f"},
                                       {"min", "min", "%.4g"},
                                       {"median", "median", "%.4g"},
                                       {"mean", "mean", "%.4g"},
                                       {"max", "max", "%.4g"},
                                       {"holds_percent", "holds", "%.2f"},
                                       {0}};
static const qualify_column TIMES[] = {{"case", "case", NULL},
                                       {"pairs", "pairs", "%.0f"},
                                       {"verdict_ns", "verdict", "%.2f"},
                                       {"box_ns", "with boxes", "%.2f"},
                                       QUALIFY_RATIO("box_over_verdict", "ratio"),
                                       {0}};

static int conclude(boxes_report *r, qualify_page *page)
{
    json_t *obj = qualify_page_json(page);
    app_json_set(obj, "sizes", r->sizes);
    app_json_set(obj, "quantiles", r->quantiles);
    app_json_set(obj, "times", r->times);
    app_json_set(obj, "wrong", qualify_count_json(r->wrong));
    qualify_page_table(page, "sizes",
                       "Volume over that of the tight box; share of pairs whose box holds the "
                       "tight one (ours to the last bit, others but for rounding) [%]",
                       SIZES, "sizes");
    qualify_page_text(
        page,
        "\"Article\" is the box as its program makes it; \"clipped\" what is left of it "
        "within the boxes of both frames, as its README advises; \"mended\" takes each row as "
        "a bound and forgets no corner. \"Both AABBs\" is what the boxes of both frames have "
        "in common, for as long as they move. \"In B\": in B's coordinates.");
    qualify_page_table(page, "times",
                       "Verdict, and verdict with all boxes, times and a witness, on meeting pairs "
                       "[ns a pair]; their ratio and its 95 % interval",
                       TIMES, "times");
    if (r->wrong > 0)
        return app_error(APP_NO, "%zu boxes do not hold the exact one, or are too large", r->wrong);
    return APP_YES;
}

static int run(const qualify_setup *o, qualify_page *page)
{
    boxes_report r = {.setup = o,
                      .sizes = app_need(json_array()),
                      .quantiles = app_need(json_array()),
                      .times = app_need(json_array())};
    int code = APP_YES;
    for (int i = 0; code == APP_YES && i < CLASSES && !qualify_watch_interrupted(); i++) {
        qualify_watch_part((size_t)i, CLASSES);
        code = run_class(&r, &CLASS[i]);
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
