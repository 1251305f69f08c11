/* tables.c: the counts and times on standard output. */
#include <math.h>
#include <stdlib.h>

#include "qualify/report.h"

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

static void print_unknown(const qualify_plan *p)
{
    for (size_t i = 0; i < p->sets; i++)
        if (!p->grid.known[i])
            printf("Left out: %s (no such rules here).\n", qualify_set_text(&p->way[i]));
}

void qualify_tables(const qualify_plan *p)
{
    printf(
        "pairs, made: pairs looked at, rows combined; kept: of those, rows that outlived the rules "
        "of their\nround; sum, peak: rows alive after a round, added up over the rounds, and at "
        "most: means over the\nsystems decided, of pairs that meet. rows: change of kept against "
        "no rules. time, total: of the verdict\nagainst no rules, median of ratios and ratio of "
        "totals; < where no rules gave up first, > where these\ndid, ~ where both happened.\n");
    print_unknown(p);
    if (qualify_stopped_by_time(p) > 0)
        printf("The clock stopped %zu queries: their counts depend on the machine.\n",
               qualify_stopped_by_time(p));
    for (size_t k = 0; k < p->orders; k++) {
        page g = {{.columns = COLUMNS, .align = "llrrrrrrrrrrrr"}, k};
        for (int c = 0; c < COLUMNS; c++)
            qualify_cell(&g.table, "%s", TITLE[c]);
        qualify_each(p, p->detail, &g, add_lines);
        printf("\nOrder %s\n\n", qualify_order_text(p->order[k]));
        app_table_print(&g.table, stdout);
    }
}
