/* tables.c: the counts and times on standard output. */
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
    qualify_ratio_cell(t, d.lived_ratio, false);
    qualify_ratio_cell(t, d.median_ratio, d.timed_only > 0);
    qualify_ratio_cell(t, d.total_ratio, d.timed_only > 0);
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
        "pairs, made: pairs looked at and rows combined; kept: of those, rows that outlived the "
        "rules of\ntheir round; sum, peak: rows alive after a round, added up over the rounds, "
        "and at most. Means over\nthe systems decided. rows: sum against no rules, ratio of "
        "totals where both decided. time, total:\nverdict against no rules, median of ratios and "
        "ratio of totals; < where no rules gave up first.\n");
    print_unknown(p);
    for (size_t k = 0; k < p->orders; k++) {
        page g = {{.columns = COLUMNS, .align = "llrrrrrrrrrrrr"}, k};
        for (int c = 0; c < COLUMNS; c++)
            qualify_cell(&g.table, "%s", TITLE[c]);
        qualify_each(p, p->detail, &g, add_lines);
        printf("\nOrder %s\n\n", qualify_order_text(p->order[k]));
        app_table_print(&g.table, stdout);
    }
}
