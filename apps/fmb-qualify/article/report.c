/* report.c: cells of the article's Table 1 as JSON, tables and texts; see article.h. */
#include <math.h>

#include "fmb-qualify/article/article.h"
#include "fmb-qualify/numbers.h"

static const char *const WAY[ARTICLE_WAYS] = {"listed", "asked", "packed"};

/* ---- cells ----------------------------------------------------------------------------------- */

static json_t *duel_json(const article_duel *d)
{
    json_t *obj = json_object();
    app_json_set(obj, "fmb_ns", app_json_real(d->fmb.median));
    app_json_set(obj, "sat_ns", app_json_real(d->sat.median));
    app_json_set(obj, "fmb_over_sat", qualify_ratio_json(d->fmb_sat));
    app_json_set(obj, "wrong", qualify_count_json(d->wrong));
    return obj;
}

static json_t *repeated_json(const article_repeated *r)
{
    json_t *obj = json_object();
    app_json_set(obj, "pairs", qualify_count_json(r->pairs));
    app_json_set(obj, "fmb_ns", app_json_real(r->fmb));
    app_json_set(obj, "sat_ns", app_json_real(r->sat));
    app_json_set(obj, "mean", app_json_real(r->mean));
    app_json_set(obj, "least", app_json_real(r->least));
    app_json_set(obj, "most", app_json_real(r->most));
    if (r->first[0] > 0 && r->first[1] > 0) { /* both orders */
        app_json_set(obj, "ct", app_json_real(r->first[0]));
        app_json_set(obj, "tc", app_json_real(r->first[1]));
    }
    return obj;
}

static json_t *cell_json(const article_cell *cell)
{
    json_t *obj = json_object();
    const verdict_class *c = &cell->class;
    app_json_set(obj, "case", json_string(verdict_case_text(c->dim, c->moves)));
    app_json_set(obj, "pair", json_string(verdict_kind_text(c->kind)));
    app_json_set(obj, "meeting", json_boolean(c->meets));
    app_json_set(obj, "queries", qualify_count_json(cell->queries));
    app_json_set(obj, "drawn", qualify_count_json((size_t)cell->drawn));
    app_json_set(obj, "published", json_real(article_published(c)));
    app_json_set(obj, "repeated", repeated_json(&cell->repeated));
    for (int i = 0; i < ARTICLE_WAYS; i++)
        app_json_set(obj, WAY[i], duel_json(&cell->duel[i]));
    return obj;
}

/* ---- choosing between the two ---------------------------------------------------------------- */

/* Mean times of a query of the article's generator [ns]. */
typedef struct choice {
    double fmb, sat;            /* always */
    double by_kind, by_verdict; /* the faster one for each kind; for each kind and verdict */
} choice;

/* How often the generator draws a pair of the cell: a kind, one pair in 4, 2, 4; then a verdict. */
static double share_of_cell(const article_cell *cell)
{
    static const double OF_KIND[] = {0.25, 0.5, 0.25};
    return OF_KIND[cell->class.kind] * (double)cell->queries / (double)cell->drawn;
}

/* cell: the two of each kind in turn, all of one case. */
static choice choose_between(const article_cell *cell, size_t kinds, article_way way)
{
    choice sum = {0};
    double all = 0;
    for (size_t i = 0; i < kinds; i++) {
        double fmb = 0, sat = 0;
        for (size_t j = 2 * i; j < 2 * i + 2; j++) {
            const article_duel *d = &cell[j].duel[way];
            double share = share_of_cell(&cell[j]);
            fmb += share * d->fmb.median;
            sat += share * d->sat.median;
            sum.by_verdict += share * fmin(d->fmb.median, d->sat.median);
            all += share;
        }
        sum.fmb += fmb;
        sum.sat += sat;
        sum.by_kind += fmin(fmb, sat);
    }
    return (choice){sum.fmb / all, sum.sat / all, sum.by_kind / all, sum.by_verdict / all};
}

/* The faster way pair by pair, on the repeated pairs. */
static double best_of_each_pair(const article_cell *cell, size_t cells)
{
    double fmb = 0, sat = 0, best = 0;
    for (size_t i = 0; i < cells; i++) {
        double share = share_of_cell(&cell[i]);
        fmb += share * cell[i].repeated.fmb;
        sat += share * cell[i].repeated.sat;
        best += share * cell[i].repeated.best;
    }
    return 100 * (1 - best / fmin(fmb, sat));
}

static json_t *choice_json(const article_cell *cell, size_t kinds, article_way way)
{
    choice c = choose_between(cell, kinds, way);
    double always = fmin(c.fmb, c.sat);
    json_t *obj = json_object();
    app_json_set(obj, "case", json_string(verdict_case_text(cell->class.dim, cell->class.moves)));
    app_json_set(obj, "way", json_string(WAY[way]));
    app_json_set(obj, "fmb_ns", app_json_real(c.fmb));
    app_json_set(obj, "sat_ns", app_json_real(c.sat));
    app_json_set(obj, "by_kind_percent", app_json_real(100 * (1 - c.by_kind / always)));
    app_json_set(obj, "by_verdict_percent", app_json_real(100 * (1 - c.by_verdict / always)));
    if (way == ARTICLE_LISTED)
        app_json_set(obj, "by_pair_percent", app_json_real(best_of_each_pair(cell, 2 * kinds)));
    return obj;
}

/* ---- tables ---------------------------------------------------------------------------------- */

#define CLASS                                                                                      \
    {"case", "case", NULL}, {"pair", "pair", NULL},                                                \
    {                                                                                              \
        "meeting", "meets", NULL                                                                   \
    }

static const qualify_column RATIOS[] = {CLASS,
                                        {"published", "published", "%.2f"},
                                        {"repeated.mean", "listed, repeated", "%.2f"},
                                        {"repeated.ct", "as CT", "%.2f"},
                                        {"repeated.tc", "as TC", "%.2f"},
                                        {"repeated.least", "least", "%.2f"},
                                        {"repeated.most", "most", "%.2f"},
                                        {"listed.fmb_over_sat.ratio", "listed", "%.2f"},
                                        {"asked.fmb_over_sat.ratio", "ours", "%.3f"},
                                        {"packed.fmb_over_sat.ratio", "ours, packed", "%.3f"},
                                        {0}};
static const qualify_column TIMES[] = {CLASS,
                                       {"queries", NULL, "%.0f"},
                                       {"repeated.fmb_ns", "repeated FMB ns", "%.0f"},
                                       {"repeated.sat_ns", "SAT ns", "%.0f"},
                                       {"listed.fmb_ns", "listed FMB ns", "%.0f"},
                                       {"listed.sat_ns", "SAT ns", "%.0f"},
                                       {"listed.wrong", "wrong", "%.0f"},
                                       {"asked.fmb_ns", "our FMB ns", "%.1f"},
                                       {"asked.sat_ns", "SAT ns", "%.1f"},
                                       {"asked.wrong", "wrong", "%.0f"},
                                       {"packed.fmb_ns", "packed FMB ns", "%.1f"},
                                       {"packed.sat_ns", "SAT ns", "%.1f"},
                                       {"packed.wrong", "wrong", "%.0f"},
                                       {0}};
static const qualify_column CHOICES[] = {{"case", "case", NULL},
                                         {"way", "way", NULL},
                                         {"fmb_ns", "FMB ns", "%.1f"},
                                         {"sat_ns", "SAT ns", "%.1f"},
                                         {"by_kind_percent", "by kind %", "%.1f"},
                                         {"by_verdict_percent", "and verdict %", "%.1f"},
                                         {"by_pair_percent", "pair by pair %", "%.1f"},
                                         {0}};

static void put_numbers(const article_cell *cell, size_t n, json_t *obj)
{
    json_t *cells = json_array(), *choices = json_array();
    for (size_t i = 0; i < n; i++)
        app_json_append(cells, cell_json(&cell[i]));
    for (size_t i = 0; i + 6 <= n; i += 6)
        for (int way = 0; way < ARTICLE_WAYS; way++)
            app_json_append(choices, choice_json(&cell[i], 3, (article_way)way));
    app_json_set(obj, "cells", cells);
    app_json_set(obj, "choices", choices);
}

void article_report(const article_cell *cell, size_t n, qualify_page *page)
{
    put_numbers(cell, n, qualify_page_json(page));
    if (n == 0)
        return;
    qualify_page_text(
        page,
        "Published: the article's Table 1 (Intel i7-8700T, gcc 7.5, -O3). Listed: FMB and SAT as "
        "its program has them, written again: each costs what the original costs, within 15 %% "
        "(bench/article/beside). Repeated: its method, a pair again and again, the mean of the "
        "ratios of %zu pairs a cell, CT in both orders as well, the least and the most. All "
        "others: %zu distinct pairs a cell, one after the "
        "other, ratio of the medians of %s. Ours: from frames to verdicts, with error bounds. "
        "Packed: from sets of frames, so that little but the kernels is left.",
        cell[0].repeated.pairs, cell[0].queries, "the passes");
    qualify_page_table(page, "ratios", "Time of FMB over time of SAT", RATIOS, "cells");
    qualify_page_table(page, "times", "Times of a query, CPU time of the thread", TIMES, "cells");
    qualify_page_text(
        page,
        "Choosing between FMB and SAT, as the article suggests: what is saved against always "
        "asking the better one of them, over pairs as its generator draws them. By kind: whichever "
        "is faster for CC, CT, TT. And verdict: as if it were known beforehand whether they meet. "
        "Pair by pair: as if the faster one were known for each pair, measured on those that were "
        "repeated. None can save more.");
    qualify_page_table(page, "choices", "What a perfect choice saves", CHOICES, "choices");
}
