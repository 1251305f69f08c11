/* counts.c: see counts.h. Sums are of rows alive after each round, all but the last variable
 * eliminated; peaks are the most rows alive between rounds. */
#include "qualify/rules/counts.h"

#include <stdlib.h>

#include "common/message.h"
#include "qualify/rules/report.h"
#include "qualify/watch.h"

typedef struct bar {
    int dim, moves, kind; /* kind: 2 * shape of A + shape of B */
    double sum, peak;     /* at most, on average */
    bool plain;           /* of no rules; else of the best set */
} bar;

static const bar BAR[] = {
    {3, 0, 0, 15, 12, false}, {3, 1, 0, 27, 15, false},  {4, 0, 0, 42, 20, false},
    {4, 0, 3, 35, 18, false}, {3, 1, 0, 400, 440, true},
};
enum { BARS = sizeof BAR / sizeof *BAR, PAIRS = 200 };

static const char *const SETS[] = {"none",
                                   "kohler",
                                   "chernikov",
                                   "imbert",
                                   "kohler,box",
                                   "chernikov,box",
                                   "imbert,box",
                                   "kohler,chernikov,box",
                                   "imbert,chernikov,box"};

/* The best is the one with the least sum; of those the one with the least peak. */
static size_t best_set(const qualify_plan *p, const qualify_select *which)
{
    size_t best = 0;
    study_digest b = qualify_digest(p, 0, which);
    for (size_t set = 1; set < p->sets; set++) {
        study_digest d = qualify_digest(p, set, which);
        bool better = d.lived < b.lived || (d.lived <= b.lived && d.peak < b.peak);
        if (p->grid.known[set] && d.decided == d.systems && (b.decided < b.systems || better)) {
            best = set;
            b = d;
        }
    }
    return best;
}

static void add_bar(app_table *t, const qualify_plan *p, const bar *goal)
{
    qualify_select which = {goal->dim, goal->moves, goal->kind, 1, NULL};
    size_t set = goal->plain ? 0 : best_set(p, &which);
    study_digest d = qualify_digest(p, set, &which);
    char *name = qualify_select_text(&which);
    qualify_cell(t, "%s", name);
    free(name);
    qualify_cell(t, "%s", p->set[set]);
    qualify_cell(t, "%zu", d.decided);
    qualify_cell(t, "%.1f", d.lived);
    qualify_cell(t, "%.1f", d.peak);
    qualify_cell(t, "%s %.0f", goal->plain ? "about" : "at most", goal->sum);
    qualify_cell(t, "%.0f", goal->peak);
    if (goal->plain)
        qualify_cell(t, "for scale");
    else
        qualify_cell(t, "%s", d.lived <= goal->sum && d.peak <= goal->peak ? "met" : "not met");
}

static void add_bars(const qualify_plan *p, qualify_page *page)
{
    app_table t = {.columns = 8, .align = "llrrrrrl"};
    static const char *const TITLE[] = {"systems", "rules",      "n",    "sum",
                                        "peak",    "sum wanted", "peak", "bar"};
    qualify_titles(&t, TITLE);
    for (int i = 0; i < BARS; i++)
        add_bar(&t, p, &BAR[i]);
    qualify_page_text(page, "Counts on small frames, all but the last variable eliminated: mean "
                            "sum and peak of the rows alive after a round, for the set of history "
                            "rules with the least sum.");
    qualify_page_table(page, "counts", "Counts wanted", &t);
}

static void make_plan(qualify_plan *c, const qualify_plan *p)
{
    qualify_plan_init(c);
    c->grid.seed = p->grid.seed;
    c->grid.limits = p->grid.limits;
    c->grid.per_class = p->pairs_asked ? p->grid.per_class : PAIRS;
    c->grid.passes = 0;
    c->orders = 1;
    c->grid.step = qualify_watch_step;
    c->grid.running = qualify_watch_solver();
    c->grid.limits.max_rows = 100000;
    for (size_t i = 0; i < sizeof SETS / sizeof *SETS; i++)
        c->set[c->sets++] = SETS[i];
    for (int i = 0; i < BARS; i++)
        if (!BAR[i].plain) {
            study_sample s = {
                .class = {.dim = BAR[i].dim,
                          .moves = BAR[i].moves,
                          .shape = {(fmb_shape)(BAR[i].kind >> 1), (fmb_shape)(BAR[i].kind & 1)},
                          .meets = true}};
            if (study_grid_add(&c->grid, &s) != FMB_OK)
                app_need(NULL);
        }
}

int qualify_counts(const qualify_plan *p, qualify_page *page)
{
    qualify_plan *c = app_need(malloc(sizeof *c));
    make_plan(c, p);
    qualify_plan_ways(c);
    fmb_status st = study_grid_run(&c->grid);
    if (st == FMB_OK && c->grid.complete == c->grid.samples)
        add_bars(c, page);
    size_t wrong = qualify_wrong(c);
    study_grid_clear(&c->grid);
    free(c);
    if (st != FMB_OK)
        return app_status_error(st);
    return wrong > 0 ? APP_NO : APP_YES;
}
