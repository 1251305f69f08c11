/* counts.c: see counts.h. Sums are of rows alive after each round, all but the last variable
 * eliminated; peaks are the most rows alive between rounds. */
#include "fmb-qualify/rules/counts.h"

#include <stdlib.h>

#include "common/message.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/rules/report.h"
#include "fmb-qualify/watch.h"

/* Which pairs: kind is 2 * shape of A + shape of B. */
static const struct {
    int dim, moves, kind;
} SYSTEMS[] = {{3, 0, 0}, {3, 1, 0}, {4, 0, 0}, {4, 0, 3}};
enum { MANY = sizeof SYSTEMS / sizeof *SYSTEMS, PAIRS = 200 };

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

static json_t *line_json(const qualify_plan *p, const qualify_select *which, size_t set)
{
    study_digest d = qualify_digest(p, set, which);
    char *name = qualify_select_text(which);
    json_t *obj = json_object();
    app_json_set(obj, "systems", json_string(name));
    free(name);
    app_json_set(obj, "rules", json_string(p->set[set]));
    app_json_set(obj, "decided", qualify_count_json(d.decided));
    app_json_set(obj, "sum", json_real(d.lived));
    app_json_set(obj, "peak", json_real(d.peak));
    return obj;
}

static const qualify_column LINE[] = {{"systems", "systems", NULL}, {"rules", "rules", NULL},
                                      {"decided", "n", "%.0f"},     {"sum", "sum", "%.1f"},
                                      {"peak", "peak", "%.1f"},     {0}};

static void add_lines(const qualify_plan *p, qualify_page *page)
{
    json_t *lines = json_array();
    for (int i = 0; i < MANY; i++) {
        qualify_select which = {SYSTEMS[i].dim, SYSTEMS[i].moves, SYSTEMS[i].kind, 1, NULL};
        app_json_append(lines, line_json(p, &which, 0));
        app_json_append(lines, line_json(p, &which, best_set(p, &which)));
    }
    app_json_set(qualify_page_json(page), "counts", lines);
    qualify_page_text(page, "Counts on small frames, all but the last variable eliminated: mean "
                            "sum and peak of the rows alive after a round, without rules, and for "
                            "the set of history rules with the least sum.");
    qualify_page_table(page, "counts", "Counts of the best rules", LINE, "counts");
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
    for (int i = 0; i < MANY; i++) {
        int kind = SYSTEMS[i].kind;
        study_sample s = {.class = {.dim = SYSTEMS[i].dim,
                                    .moves = SYSTEMS[i].moves,
                                    .shape = {(fmb_shape)(kind >> 1), (fmb_shape)(kind & 1)},
                                    .meets = true}};
        if (study_grid_add(&c->grid, &s) != FMB_OK)
            app_need(NULL);
    }
}

int qualify_counts(const qualify_plan *p, qualify_page *page)
{
    qualify_plan *c = app_need(malloc(sizeof *c));
    make_plan(c, p);
    int code = qualify_plan_ways(c);
    fmb_status st = code == APP_YES ? study_grid_run(&c->grid) : FMB_OK;
    if (st == FMB_OK && c->grid.complete == c->grid.samples)
        add_lines(c, page);
    size_t wrong = qualify_wrong(c);
    qualify_plan_clear(c);
    free(c);
    if (st != FMB_OK)
        return app_status_error(st);
    return wrong > 0 ? APP_NO : code;
}
