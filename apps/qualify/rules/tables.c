/* tables.c: the counts and times. */
#include <math.h>
#include <stdlib.h>

#include "qualify/rules/report.h"

static const char *const TITLE[] = {"systems", "rules", "n",    "decided", "stopped",
                                    "wrong",   "pairs", "made", "kept",    "sum",
                                    "peak",    "rows",  "time", "total"};
enum { COLUMNS = sizeof TITLE / sizeof *TITLE };

/* One table, of one order. */
typedef struct page {
    app_table table;
    size_t order;
} page;

static void add_line(page *g, const qualify_plan *p, size_t set, const qualify_select *which)
{
    app_table *t = &g->table;
    size_t way = g->order * p->sets + set;
    study_digest d = qualify_digest(p, way, which);
    char *name = qualify_select_text(which);
    if (!p->grid.known[way] || (d.systems > 0 && d.refused == d.systems)) {
        free(name);
        return;
    }
    qualify_cell(t, "%s", set == 0 ? name : "");
    free(name);
    qualify_cell(t, "%s", qualify_set_text(&p->way[way]));
    qualify_cell(t, "%zu", d.systems);
    qualify_cell(t, "%zu", d.decided);
    qualify_cell(t, "%zu", d.stopped);
    qualify_cell(t, "%zu", d.wrong);
    const double mean[] = {d.pairs, d.made, d.kept, d.lived, d.peak};
    for (size_t i = 0; i < sizeof mean / sizeof *mean; i++)
        if (d.decided > 0)
            qualify_cell(t, "%.1f", mean[i]);
        else
            qualify_cell(t, "-");
    if (isnan(d.kept_ratio))
        qualify_cell(t, "-");
    else
        qualify_cell(t, "%+.0f %%", 100 * (d.kept_ratio - 1));
    qualify_time_cell(t, &d, d.median_ratio);
    qualify_time_cell(t, &d, d.total_ratio);
}

static void add_lines(void *self, const qualify_plan *p, const qualify_select *which)
{
    for (size_t set = 0; set < p->sets; set++)
        add_line(self, p, set, which);
}

static void say_unknown(const qualify_plan *p, qualify_page *to)
{
    for (size_t i = 0; i < p->sets; i++)
        if (!p->grid.known[i])
            qualify_page_text(to, "Left out: %s (no such rules here).",
                              qualify_set_text(&p->way[i]));
}

static void add_order(const qualify_plan *p, size_t order, qualify_page *to)
{
    page g = {{.columns = COLUMNS, .align = "llrrrrrrrrrrrr"}, order};
    const char *word = qualify_order_text(p->order[order]);
    char caption[40], name[40];
    qualify_titles(&g.table, TITLE);
    qualify_each(p, p->detail, &g, add_lines);
    snprintf(caption, sizeof caption, "Order %s", word);
    snprintf(name, sizeof name, "order-%s", word);
    qualify_page_table(to, name, caption, &g.table);
}

void qualify_tables(const qualify_plan *p, qualify_page *to)
{
    qualify_page_text(
        to, "pairs, made: pairs looked at, rows combined; kept: of those, rows that outlived the "
            "rules of their round; sum, peak: rows alive after a round, added up over the rounds, "
            "and at most: means over the systems decided, of pairs that meet. rows: change of kept "
            "against no rules. time, total: of the verdict against no rules, median of ratios and "
            "ratio of totals; < where no rules gave up first, > where these did, ~ where both "
            "happened.");
    say_unknown(p, to);
    if (qualify_stopped_by_time(p) > 0)
        qualify_page_text(to, "The clock stopped %zu queries: their counts depend on the machine.",
                          qualify_stopped_by_time(p));
    for (size_t k = 0; k < p->orders; k++)
        add_order(p, k, to);
}
