/* plan.c: see plan.h. */
#include "qualify/rules/plan.h"

#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "qualify/rules/files.h"

/* What each order is called: the words of the library's own option. */
static const char *const ORDER[] = {
    [FMB_ORDER_PAIRS] = "pairs",
    [FMB_ORDER_GIVEN] = "given",
    [FMB_ORDER_MIN] = "min",
    [FMB_ORDER_FILL] = "fill",
};
enum { ORDERS = sizeof ORDER / sizeof *ORDER };

/* Rules alone and the mixes that make sense: histories with each other and with the box. */
static const char *const SETS[] = {
    "duplicate",  "dominated", "kohler",     "chernikov",     "imbert",
    "box",        "lp",        "kohler,box", "chernikov,box", "kohler,chernikov,box",
    "imbert,box", "default"};
enum { DEFAULT_SETS = sizeof SETS / sizeof *SETS };

const char *qualify_order_text(fmb_order order)
{
    return ORDER[order];
}

bool qualify_order_parse(const char *word, fmb_order *out)
{
    for (int i = 0; i < ORDERS; i++)
        if (strcmp(word, ORDER[i]) == 0) {
            *out = (fmb_order)i;
            return true;
        }
    return false;
}

const char *qualify_set_text(const study_way *way)
{
    return way->rules ? way->rules : "default";
}

void qualify_plan_init(qualify_plan *p)
{
    *p = (qualify_plan){.motion = {true, true},
                        .kind = {{true, true}, {true, true}},
                        .meeting = {true, true},
                        .order = {FMB_ORDER_PAIRS, FMB_ORDER_GIVEN},
                        .orders = 2};
    for (int d = 2; d <= 6; d++)
        p->dim[d] = true;
    p->grid = (study_grid){.seed = 1, .per_class = 16, .passes = 3};
    p->grid.limits = (study_limits){.max_rows = 10000, .max_seconds = 20, .presolve = "bounds"};
}

/* ---- the grid -------------------------------------------------------------------------------- */

/* `none` in front of the sets that were asked for. */
static void make_sets(qualify_plan *p)
{
    const char *set[PLAN_MOST_SETS];
    size_t n = 0;
    set[n++] = "none";
    for (size_t i = 0; i < (p->sets > 0 ? p->sets : DEFAULT_SETS); i++) {
        const char *rules = p->sets > 0 ? p->set[i] : SETS[i];
        if (strcmp(rules, "none") != 0 && n < PLAN_MOST_SETS)
            set[n++] = rules;
    }
    memcpy(p->set, set, n * sizeof *set);
    p->sets = n;
}

void qualify_plan_ways(qualify_plan *p)
{
    make_sets(p);
    for (size_t k = 0; k < p->orders; k++)
        for (size_t i = 0; i < p->sets; i++) {
            const char *rules = strcmp(p->set[i], "default") == 0 ? NULL : p->set[i];
            p->way[k * p->sets + i] = (study_way){rules, p->order[k]};
        }
    p->grid.way = p->way;
    p->grid.ways = p->orders * p->sets;
}

static void add_class(qualify_plan *p, int dim, int moves, int kinds)
{
    for (int meets = 1; meets >= 0; meets--) {
        study_sample s = {.class = {.family = p->family,
                                    .dim = dim,
                                    .moves = moves,
                                    .shape = {(fmb_shape)(kinds >> 1), (fmb_shape)(kinds & 1)},
                                    .meets = meets}};
        if (p->meeting[meets] && study_grid_add(&p->grid, &s) != FMB_OK)
            app_need(NULL);
    }
}

int qualify_plan_make(qualify_plan *p)
{
    qualify_plan_ways(p);
    for (int dim = 0; dim <= PLAN_MOST_DIM; dim++)
        for (int moves = 0; moves < 2; moves++)
            for (int kinds = 0; kinds < 4; kinds++)
                if (p->dim[dim] && p->motion[moves] && p->kind[kinds >> 1][kinds & 1] &&
                    (p->files == 0 || p->frames_asked))
                    add_class(p, dim, moves, kinds);
    int code = APP_YES;
    for (size_t i = 0; code == APP_YES && i < p->files; i++)
        code = qualify_files_add(&p->grid, p->file[i]);
    return code;
}

/* Runs of which something is true. */
static size_t count_runs(const qualify_plan *p, bool (*is)(const study_run *r))
{
    const study_grid *g = &p->grid;
    size_t count = 0;
    for (size_t k = 0; k < g->complete; k++)
        for (size_t i = 0; i < g->sample[k].size; i++)
            for (size_t w = 0; w < g->ways; w++)
                count += is(study_grid_at(g, k, i, w));
    return count;
}

static bool is_wrong(const study_run *r)
{
    return r->outcome == STUDY_WRONG || r->solved == STUDY_WRONG;
}

static bool ran_out_of_time(const study_run *r)
{
    return r->outcome == STUDY_STOPPED && r->stop == FMB_STOP_TIME;
}

size_t qualify_wrong(const qualify_plan *p)
{
    return count_runs(p, is_wrong);
}

size_t qualify_stopped_by_time(const qualify_plan *p)
{
    return count_runs(p, ran_out_of_time);
}
