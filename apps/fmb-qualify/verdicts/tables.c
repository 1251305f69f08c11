/* tables.c: the cells of a study of verdicts as JSON, and as tables of it. */
#include <math.h>

#include "common/json.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/verdicts/verdicts.h"

/* ---- JSON ------------------------------------------------------------------------------------ */

static json_t *times_json(study_spread fmb, study_spread sat, study_ratio over)
{
    json_t *obj = json_object();
    app_json_set(obj, "fmb_ns", app_json_real(fmb.median));
    app_json_set(obj, "sat_ns", app_json_real(sat.median));
    app_json_set(obj, "fmb_over_sat", qualify_ratio_json(over));
    return obj;
}

/* A cell has the times of both for all pairs in one call, and within it those of other calls. */
static json_t *cell_json(const verdict_duel *d)
{
    json_t *obj = json_object(), *times = times_json(d->fmb, d->sat, d->fmb_sat),
           *warm = times_json(d->warm_fmb, d->warm_sat, d->warm_fmb_sat);
    app_json_set(warm, "queries", qualify_count_json(d->warm_pairs));
    app_json_set(obj, "case", json_string(verdict_case_text(d->class.dim, d->class.moves)));
    app_json_set(obj, "pair", json_string(verdict_kind_text(d->class.kind)));
    app_json_set(obj, "meeting", json_boolean(d->class.meets));
    app_json_set(obj, "queries", qualify_count_json(d->queries));
    app_json_set(obj, "drawn", qualify_count_json(d->drawn));
    json_object_update(obj, times);
    json_decref(times);
    app_json_set(obj, "sat_plain_ns", app_json_real(d->plain.median));
    app_json_set(obj, "sat_plain_over_sat", qualify_ratio_json(d->plain_sat));
    app_json_set(obj, "exact_share", app_json_real(d->exact_share));
    app_json_set(obj, "different", qualify_count_json(d->wrong));
    app_json_set(obj, "sat_plain_wrong", qualify_count_json(d->plain_wrong));
    app_json_set(obj, "one_a_call", times_json(d->one_fmb, d->one_sat, d->one_fmb_sat));
    app_json_set(obj, "repeated", warm);
    return obj;
}

static json_t *mix_json(const verdict_mix *m)
{
    json_t *obj = json_object(), *shares = json_array();
    app_json_set(obj, "case", json_string(verdict_case_text(m->dim, m->moves)));
    app_json_set(obj, "queries", qualify_count_json(m->queries));
    app_json_set(obj, "groups", qualify_count_json(m->groups));
    for (int i = 0; i < VERDICT_SHARES; i++) {
        json_t *share = json_object();
        app_json_set(share, "percent_meeting", json_integer(i * 100 / (VERDICT_SHARES - 1)));
        app_json_set(share, "total", app_json_real(m->total[i]));
        app_json_set(share, "least", app_json_real(m->group[i].least));
        app_json_set(share, "most", app_json_real(m->group[i].most));
        app_json_append(shares, share);
    }
    app_json_set(obj, "fmb_over_sat", shares);
    return obj;
}

void verdict_numbers(const verdict_study *s, qualify_page *page)
{
    json_t *cells = json_array(), *mixes = json_array();
    for (size_t i = 0; i < s->duels; i++)
        app_json_append(cells, cell_json(&s->duel[i]));
    for (size_t i = 0; i < s->mixes; i++)
        app_json_append(mixes, mix_json(&s->mix[i]));
    app_json_set(qualify_page_json(page), "cells", cells);
    app_json_set(qualify_page_json(page), "mixes", mixes);
}

/* ---- tables ---------------------------------------------------------------------------------- */

#define CLASS                                                                                      \
    {"case", "case", NULL}, {"pair", "pair", NULL},                                                \
    {                                                                                              \
        "meeting", "meets", NULL                                                                   \
    }

static const qualify_column CELLS[] = {CLASS,
                                       {"queries", NULL, "%.0f"},
                                       {"fmb_ns", "FMB ns", "%.2f"},
                                       {"sat_ns", "SAT ns", "%.2f"},
                                       QUALIFY_RATIO("fmb_over_sat", "FMB/SAT"),
                                       {"sat_plain_ns", "sat-plain ns", "%.1f"},
                                       QUALIFY_RATIO("sat_plain_over_sat", "plain/SAT"),
                                       {"exact_share", "exact", "%.2g"},
                                       {"different", NULL, "%.0f"},
                                       {"sat_plain_wrong", NULL, "%.0f"},
                                       {0}};
static const qualify_column SINGLE[] = {CLASS,
                                        {"one_a_call.fmb_ns", "FMB ns", "%.2f"},
                                        {"one_a_call.sat_ns", "SAT ns", "%.2f"},
                                        QUALIFY_RATIO("one_a_call.fmb_over_sat", "FMB/SAT"),
                                        {0}};
static const qualify_column REPEATED[] = {CLASS,
                                          {"repeated.fmb_ns", "FMB ns", "%.2f"},
                                          {"repeated.sat_ns", "SAT ns", "%.2f"},
                                          QUALIFY_RATIO("repeated.fmb_over_sat", "FMB/SAT"),
                                          {"repeated.fmb_over_sat.least", "least", "%.2f"},
                                          {"repeated.fmb_over_sat.most", "most", "%.2f"},
                                          {0}};

/* ---- what it comes to ------------------------------------------------------------------------ */

static void say_ratios(const verdict_study *s, qualify_page *page)
{
    size_t faster = 0, slower = 0;
    double least = INFINITY, most = 0, plain = INFINITY;
    for (size_t i = 0; i < s->duels; i++) {
        const verdict_duel *d = &s->duel[i];
        faster += d->fmb_sat.high < 1;
        slower += d->fmb_sat.low > 1;
        least = fmin(least, d->fmb_sat.ratio);
        most = fmax(most, d->fmb_sat.ratio);
        plain = fmin(plain, d->plain_sat.ratio);
    }
    qualify_page_text(page,
                      "FMB over SAT is %.3f to %.3f; its interval lies below 1 in %zu of %zu cells "
                      "and above 1 in %zu. SAT is at least %.1f times as fast as sat-plain.",
                      least, most, faster, s->duels, slower, plain);
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
        "pass by pass; times are medians of passes, CPU time of the thread. A ratio is that of the "
        "medians beside it; from low to high reaches its 95 %% interval (bootstrap over the "
        "passes). FMB and SAT answer the same pairs with error bounds, and ask exactly where these "
        "do not suffice (exact: the share of FMB's). sat-plain projects all corners on each axis "
        "in the world, with a branch for each axis, as the article does.",
        s->duel[0].queries);
    qualify_page_table(page, "cells", "Distinct pairs, all in one call", CELLS, "cells");
    say_ratios(s, page);
    say_differences(s, page);
    qualify_page_table(page, "single", "Distinct pairs, a call for each", SINGLE, "cells");
    qualify_page_text(page,
                      "Repeating a pair hides half of the cost: branches are foreseen and all "
                      "numbers are in the nearest cache. Times are medians of %zu pairs, least and "
                      "most ratios over them, the interval by bootstrap over them.",
                      s->duel[0].warm_pairs);
    qualify_page_table(page, "repeated", "The article's method: one pair again and again", REPEATED,
                       "cells");
}
