/* tables.c: the cells of a study of verdicts as tables and as JSON. */
#include <math.h>

#include "common/json.h"
#include "qualify/verdicts/verdicts.h"

/* FMB is to be no slower than SAT; the least speed-up of SAT over the article's on pairs that meet,
 * in 2D and in 3D. */
static const double MOST_RATIO = 1.0, NOISE = 0.05, LEAST_SPEEDUP[] = {6, 20};

static void put_class(app_table *t, const verdict_class *c)
{
    qualify_cell(t, "%s", verdict_case_text(c->dim, c->moves));
    qualify_cell(t, "%s", verdict_kind_text(c->kind));
    qualify_cell(t, "%s", c->meets ? "yes" : "no");
}

static void put_spread(app_table *t, study_spread s, int digits)
{
    qualify_cell(t, "%.*f", digits, s.least);
    qualify_cell(t, "%.*f", digits, s.median);
    qualify_cell(t, "%.*f", digits, s.most);
}

/* All pairs in one call. */
static void add_cells(const verdict_study *s, qualify_page *page)
{
    static const char *const TITLE[] = {"case",         "pair",          "meets", "FMB ns",
                                        "SAT ns",       "FMB/SAT",       "least", "most",
                                        "sat-plain ns", "sat-plain/SAT", "exact"};
    app_table t = {.columns = 11, .align = "lllrrrrrrrr"};
    qualify_titles(&t, TITLE);
    for (size_t i = 0; i < s->duels; i++) {
        const verdict_duel *d = &s->duel[i];
        put_class(&t, &d->class);
        qualify_cell(&t, "%.1f", d->fmb.median);
        qualify_cell(&t, "%.1f", d->sat.median);
        qualify_cell(&t, "%.3f", d->fmb_sat.median);
        qualify_cell(&t, "%.3f", d->fmb_sat.least);
        qualify_cell(&t, "%.3f", d->fmb_sat.most);
        qualify_cell(&t, "%.0f", d->plain.median);
        qualify_cell(&t, "%.1f", d->plain_sat.median);
        qualify_cell(&t, "%.2g", d->exact_share);
    }
    qualify_page_table(page, "cells", "Distinct pairs, all in one call", &t);
}

static void add_single(const verdict_study *s, qualify_page *page)
{
    static const char *const TITLE[] = {"case",   "pair",    "meets", "FMB ns",
                                        "SAT ns", "FMB/SAT", "least", "most"};
    app_table t = {.columns = 8, .align = "lllrrrrr"};
    qualify_titles(&t, TITLE);
    for (size_t i = 0; i < s->duels; i++) {
        const verdict_duel *d = &s->duel[i];
        put_class(&t, &d->class);
        qualify_cell(&t, "%.1f", d->one_fmb.median);
        qualify_cell(&t, "%.1f", d->one_sat.median);
        qualify_cell(&t, "%.3f", d->one_fmb_sat.median);
        qualify_cell(&t, "%.3f", d->one_fmb_sat.least);
        qualify_cell(&t, "%.3f", d->one_fmb_sat.most);
    }
    qualify_page_table(page, "single", "Distinct pairs, a call for each", &t);
}

static void add_warm(const verdict_study *s, qualify_page *page)
{
    static const char *const TITLE[] = {
        "case",      "pair",   "meets",   "pairs",         "FMB least", "median", "most ns",
        "SAT least", "median", "most ns", "FMB/SAT least", "median",    "most"};
    app_table t = {.columns = 13, .align = "lllrrrrrrrrrr"};
    qualify_titles(&t, TITLE);
    for (size_t i = 0; i < s->duels; i++) {
        const verdict_duel *d = &s->duel[i];
        put_class(&t, &d->class);
        qualify_cell(&t, "%zu", d->warm_pairs);
        put_spread(&t, d->warm_fmb, 1);
        put_spread(&t, d->warm_sat, 1);
        put_spread(&t, d->warm_fmb_sat, 2);
    }
    qualify_page_table(page, "warm", "The article's method: one pair again and again", &t);
}

/* ---- what it comes to ------------------------------------------------------------------------ */

static void say_ratios(const verdict_study *s, qualify_page *page)
{
    size_t good = 0, within = 0;
    double most = 0;
    for (size_t i = 0; i < s->duels; i++) {
        double ratio = s->duel[i].fmb_sat.median;
        good += ratio <= MOST_RATIO;
        within += ratio <= MOST_RATIO + NOISE;
        most = fmax(most, ratio);
    }
    qualify_page_text(page,
                      "FMB over SAT is at most %.2f in %zu of %zu cells, and at most %.2f (noise) "
                      "in %zu; the largest ratio is %.3f.",
                      MOST_RATIO, good, s->duels, MOST_RATIO + NOISE, within, most);
}

static void say_speedups(const verdict_study *s, qualify_page *page)
{
    for (int dim = 2; dim <= 3; dim++) {
        size_t cells = 0;
        double least = INFINITY;
        for (size_t i = 0; i < s->duels; i++)
            if (s->duel[i].class.dim == dim && s->duel[i].class.meets) {
                least = fmin(least, s->duel[i].plain_sat.median);
                cells++;
            }
        if (cells > 0)
            qualify_page_text(page,
                              "On pairs in %dD that meet, SAT is at least %.1f times faster than "
                              "sat-plain (wanted: %.0f).",
                              dim, least, LEAST_SPEEDUP[dim - 2]);
    }
}

static void say_differences(const verdict_study *s, qualify_page *page)
{
    size_t wrong = 0, plain = 0, queries = 0;
    for (size_t i = 0; i < s->duels; i++) {
        queries += s->duel[i].queries;
        wrong += s->duel[i].wrong;
        plain += s->duel[i].plain_wrong;
    }
    qualify_page_text(page,
                      "Of %zu pairs, FMB and SAT differ on %zu; sat-plain, which knows no error "
                      "bounds, is wrong on %zu.",
                      queries, wrong, plain);
}

void verdict_tables(const verdict_study *s, qualify_page *page)
{
    if (s->duels == 0)
        return;
    qualify_page_text(
        page,
        "Each cell holds %zu distinct pairs. A pass asks all of them once; the ways take turns "
        "pass by pass; times are medians of passes, CPU time of the thread; least and most are of "
        "the passes. FMB and SAT answer the same pairs with error bounds, and ask exactly where "
        "these do not suffice (column exact: the share of FMB's). sat-plain projects all corners "
        "on each axis in the world, with a branch for each axis, as the article does.",
        s->duel[0].queries);
    add_cells(s, page);
    say_ratios(s, page);
    say_speedups(s, page);
    say_differences(s, page);
    add_single(s, page);
    qualify_page_text(page, "Repeating a pair hides half of the cost: branches are foreseen and "
                            "all numbers are in the nearest cache. Least, median and most of a "
                            "query's time, and of its ratio, are over the pairs.");
    add_warm(s, page);
}

/* ---- JSON ------------------------------------------------------------------------------------ */

static json_t *spread(study_spread s)
{
    json_t *obj = json_object();
    app_json_set(obj, "least", json_real(s.least));
    app_json_set(obj, "median", json_real(s.median));
    app_json_set(obj, "most", json_real(s.most));
    return obj;
}

static json_t *count(size_t n)
{
    return json_integer((json_int_t)n);
}

static json_t *cell(const verdict_duel *d)
{
    json_t *obj = json_object(), *single = json_object(), *warm = json_object();
    app_json_set(obj, "case", json_string(verdict_case_text(d->class.dim, d->class.moves)));
    app_json_set(obj, "pair", json_string(verdict_kind_text(d->class.kind)));
    app_json_set(obj, "meeting", json_boolean(d->class.meets));
    app_json_set(obj, "queries", count(d->queries));
    app_json_set(obj, "drawn", json_integer((json_int_t)d->drawn));
    app_json_set(obj, "fmb_ns", json_real(d->fmb.median));
    app_json_set(obj, "sat_ns", json_real(d->sat.median));
    app_json_set(obj, "sat_plain_ns", json_real(d->plain.median));
    app_json_set(obj, "fmb_over_sat", spread(d->fmb_sat));
    app_json_set(obj, "sat_plain_over_sat", spread(d->plain_sat));
    app_json_set(obj, "exact_share", json_real(d->exact_share));
    app_json_set(obj, "different", count(d->wrong));
    app_json_set(obj, "sat_plain_wrong", count(d->plain_wrong));
    app_json_set(single, "fmb_ns", json_real(d->one_fmb.median));
    app_json_set(single, "sat_ns", json_real(d->one_sat.median));
    app_json_set(single, "fmb_over_sat", spread(d->one_fmb_sat));
    app_json_set(obj, "one_a_call", single);
    app_json_set(warm, "queries", count(d->warm_pairs));
    app_json_set(warm, "fmb_ns", spread(d->warm_fmb));
    app_json_set(warm, "sat_ns", spread(d->warm_sat));
    app_json_set(warm, "fmb_over_sat", spread(d->warm_fmb_sat));
    app_json_set(obj, "repeated", warm);
    return obj;
}

static json_t *mixed(const verdict_mix *m)
{
    json_t *obj = json_object(), *shares = json_array();
    app_json_set(obj, "case", json_string(verdict_case_text(m->dim, m->moves)));
    app_json_set(obj, "queries", count(m->queries));
    app_json_set(obj, "groups", count(m->groups));
    for (int i = 0; i < VERDICT_SHARES; i++) {
        json_t *share = spread(m->group[i]);
        app_json_set(share, "percent_meeting", json_integer(i * 100 / (VERDICT_SHARES - 1)));
        app_json_set(share, "total", json_real(m->total[i]));
        app_json_append(shares, share);
    }
    app_json_set(obj, "fmb_over_sat", shares);
    return obj;
}

void verdict_numbers(const verdict_study *s, qualify_page *page)
{
    json_t *cells = json_array(), *mixes = json_array();
    for (size_t i = 0; i < s->duels; i++)
        app_json_append(cells, cell(&s->duel[i]));
    for (size_t i = 0; i < s->mixes; i++)
        app_json_append(mixes, mixed(&s->mix[i]));
    app_json_set(qualify_page_json(page), "cells", cells);
    app_json_set(qualify_page_json(page), "mixes", mixes);
}

/* ---- figures --------------------------------------------------------------------------------- */

/* The range of the ratios, half and double of 1 at least. */
static void put_range(const verdict_mix *m, FILE *script)
{
    double least = 0.5, most = 2;
    for (int i = 0; i < VERDICT_SHARES; i++) {
        least = fmin(least, 0.9 * m->group[i].least);
        most = fmax(most, 1.1 * m->group[i].most);
    }
    fprintf(script, "set logscale y\nset yrange [%.3g:%.3g]\n", least, most);
}

static void put_figure(const verdict_mix *m, const char *name, qualify_figure *f)
{
    for (int i = 0; i < VERDICT_SHARES; i++)
        fprintf(f->data, "%d %.6g %.6g %.6g\n", i * 100 / (VERDICT_SHARES - 1), m->group[i].least,
                m->total[i], m->group[i].most);
    put_range(m, f->script);
    fprintf(f->script,
            "set title 'FMB over SAT, %s'\nset xlabel 'pairs that meet [%%]'\n"
            "set ylabel 'time of FMB / time of SAT'\nset xrange [0:100]\n"
            "set ytics (0.05, 0.1, 0.2, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.5, 2, 3, 5, 10, "
            "100, 1000)\nset grid\nset key outside right\n"
            "plot 1 notitle linetype -1, data using 1:4 with linespoints title 'most', "
            "data using 1:3 with linespoints linewidth 2 title 'average', "
            "data using 1:2 with linespoints title 'least'\n",
            name);
}

void verdict_figures(const verdict_study *s, qualify_page *page)
{
    for (size_t i = 0; i < s->mixes; i++) {
        const verdict_mix *m = &s->mix[i];
        const char *name = verdict_case_text(m->dim, m->moves);
        char file[40], caption[300];
        qualify_figure f;
        snprintf(file, sizeof file, "ratio-%s", name);
        snprintf(caption, sizeof caption,
                 "FMB over SAT, %s: %zu distinct pairs of all kinds at each share, those that meet "
                 "at random places; average: ratio of totals; least and most: over %zu groups of "
                 "pairs, as they come.",
                 name, m->queries, m->groups);
        qualify_figure_begin(&f);
        put_figure(m, name, &f);
        qualify_page_figure(page, file, caption, &f);
    }
}
