/* claims.c: from which D on each set of rules saves rows, and from which D it pays in time;
 * compared with the article's claims.
 *
 * Saves: fewer rows than without rules, in this D and all larger ones. Pays: the median of the time
 * ratios is below 1 and a sign test would call it chance in fewer than 1 of 20 studies.
 */
#include <math.h>

#include "fmb-qualify/numbers.h"
#include "fmb-qualify/rules/report.h"

static const double CHANCE = 0.05;

static bool saves_rows(const study_digest *d)
{
    return isnan(d->kept_ratio) ? d->only > 0 : d->kept_ratio < 1;
}

static bool pays_in_time(const study_digest *d)
{
    return d->median.ratio < 1 && d->chance < CHANCE;
}

/* The least D from which on it always holds; null if there is none. */
static json_t *from_which(const study_digest *of_dim, const bool *studied,
                          bool (*holds)(const study_digest *d))
{
    int from = 0;
    for (int dim = PLAN_MOST_DIM; dim >= 1; dim--) {
        if (!studied[dim])
            continue;
        if (!holds(&of_dim[dim]))
            break;
        from = dim;
    }
    return from > 0 ? json_integer(from) : json_null();
}

static json_t *claim_json(const qualify_plan *p, size_t set, int moves)
{
    study_digest d[PLAN_MOST_DIM + 1];
    json_t *obj = json_object();
    for (int dim = 1; dim <= PLAN_MOST_DIM; dim++)
        if (p->dim[dim])
            d[dim] = qualify_digest(p, set, &(qualify_select){dim, moves, ANY, ANY, NULL});
    app_json_set(obj, "motion", json_string(moves ? "dynamic" : "static"));
    app_json_set(obj, "rules", app_json_text(p->way[set].name));
    app_json_set(obj, "saves_from", from_which(d, p->dim, saves_rows));
    app_json_set(obj, "pays_from", from_which(d, p->dim, pays_in_time));
    return obj;
}

static const qualify_column CLAIM[] = {{"motion", "motion", NULL},
                                       {"rules", "rules", NULL},
                                       {"saves_from", "saves rows from D", "%.0f"},
                                       {"pays_from", "pays in time from D", "%.0f"},
                                       {0}};

void qualify_claims(const qualify_plan *p, qualify_page *page)
{
    json_t *claims = json_array();
    if (p->grid.complete > 0 && !p->grid.sample[0].file)
        for (int moves = 0; moves < 2; moves++)
            for (size_t set = 1; set < p->sets; set++)
                if (p->motion[moves] && p->grid.known[set])
                    app_json_append(claims, claim_json(p, set, moves));
    app_json_set(qualify_page_json(page), "claims", claims);
    if (json_array_size(claims) == 0)
        return;
    qualify_page_text(page,
                      "From which D on does a rule save rows, and from which does it pay? (order "
                      "%s; in that D and all larger ones studied; - where in none.) The article: "
                      "pruning \"reduces by 15 %% in 2D and 40 %% in 3D static\", and \"may turn "
                      "in favour in higher dimensions\".",
                      p->order[0].name);
    qualify_page_table(page, "claims", "Rules that pay", CLAIM, "claims");
}
