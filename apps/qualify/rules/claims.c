/* claims.c: from which D on each set of rules saves rows, and from which D it pays in time; and
 * what the article says of that.
 *
 * Saves: fewer rows than without rules, in this D and all larger ones. Pays: the median of the time
 * ratios is below 1 and a sign test would call it chance in fewer than 1 of 20 studies.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "qualify/rules/report.h"

static const double CHANCE = 0.05;

static bool saves(const study_digest *d)
{
    return isnan(d->kept_ratio) ? d->only > 0 : d->kept_ratio < 1;
}

static bool pays(const study_digest *d)
{
    return d->median_ratio < 1 && d->chance < CHANCE;
}

/* The least D from which on it always holds, 0 if there is none. */
static int from_which(const study_digest *of_dim, const bool *studied,
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
    return from;
}

static void add_dim(app_table *t, const study_digest *d)
{
    if (!isnan(d->kept_ratio))
        qualify_cell(t, "%+.0f %%", 100 * (d->kept_ratio - 1));
    else
        qualify_cell(t, "%s", d->only > 0 ? "decides" : "-");
    qualify_time_cell(t, d, d->median_ratio);
}

static void add_from(app_table *t, int from)
{
    if (from > 0)
        qualify_cell(t, "D = %d", from);
    else
        qualify_cell(t, "no D");
}

static void add_set(app_table *t, const qualify_plan *p, size_t set, int moves)
{
    study_digest d[PLAN_MOST_DIM + 1];
    for (int dim = 1; dim <= PLAN_MOST_DIM; dim++)
        if (p->dim[dim])
            d[dim] = qualify_digest(p, set, &(qualify_select){dim, moves, ANY, ANY, NULL});
    qualify_cell(t, "%s", qualify_set_text(&p->way[set]));
    for (int dim = 1; dim <= PLAN_MOST_DIM; dim++)
        if (p->dim[dim])
            add_dim(t, &d[dim]);
    add_from(t, from_which(d, p->dim, saves));
    add_from(t, from_which(d, p->dim, pays));
}

static void add_motion(const qualify_plan *p, int moves, qualify_page *page)
{
    char align[2 * PLAN_MOST_DIM + 4] = "l", name[40];
    app_table t = {.columns = 1, .align = align};
    qualify_cell(&t, "rules");
    for (int dim = 1; dim <= PLAN_MOST_DIM; dim++)
        if (p->dim[dim]) {
            qualify_cell(&t, "D%d rows", dim);
            qualify_cell(&t, "time");
            t.columns += 2;
        }
    qualify_cell(&t, "saves rows from");
    qualify_cell(&t, "pays in time from");
    t.columns += 2;
    memset(align + 1, 'r', t.columns - 1);
    for (size_t set = 1; set < p->sets; set++)
        if (p->grid.known[set])
            add_set(&t, p, set, moves);
    snprintf(name, sizeof name, "pays-%s", moves ? "dynamic" : "static");
    qualify_page_table(page, name, moves ? "Dynamic frames" : "Static frames", &t);
}

/* Of the set's rows in 2D and 3D static. */
static void add_article_line(app_table *t, const qualify_plan *p, size_t set)
{
    qualify_cell(t, "%s", qualify_set_text(&p->way[set]));
    for (int dim = 2; dim <= 3; dim++) {
        study_digest d = qualify_digest(p, set, &(qualify_select){dim, 0, ANY, ANY, NULL});
        if (!isnan(d.kept_ratio))
            qualify_cell(t, "%.0f %%", 100 * (1 - d.kept_ratio));
        else
            qualify_cell(t, "-");
        qualify_time_cell(t, &d, d.median_ratio);
    }
}

static void add_article(const qualify_plan *p, qualify_page *page)
{
    static const char *const TITLES[] = {"rules", "2D: fewer rows", "time x", "3D: fewer rows",
                                         "time x"};
    app_table t = {.columns = 5, .align = "lrrrr"};
    if (!p->motion[0] || !p->dim[2] || !p->dim[3])
        return;
    qualify_titles(&t, TITLES);
    for (size_t set = 1; set < p->sets; set++)
        if (p->grid.known[set])
            add_article_line(&t, p, set);
    qualify_page_text(page, "The article: pruning \"reduces by 15 %% in 2D and 40 %% in 3D "
                            "static\", and \"may turn in favour in higher dimensions\".");
    qualify_page_table(page, "article", "Here, 2D and 3D static", &t);
}

void qualify_claims(const qualify_plan *p, qualify_page *page)
{
    if (p->grid.complete == 0 || p->grid.sample[0].file)
        return;
    qualify_page_text(page,
                      "From which D on does a rule pay? (order %s) rows: change of the rows kept "
                      "against no rules; time: median ratio of the verdict's time. \"decides\": "
                      "no rules never came to an end where these did.",
                      qualify_order_text(p->order[0]));
    for (int moves = 0; moves < 2; moves++)
        if (p->motion[moves])
            add_motion(p, moves, page);
    add_article(p, page);
}
