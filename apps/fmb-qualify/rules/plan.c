/* plan.c: see plan.h. */
#include "fmb-qualify/rules/plan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/parts.h"
#include "fmb-qualify/rules/files.h"

/* Single rules and the useful combinations: history rules with each other and with the box. */
static const char *const SETS[] = {
    "duplicate",  "dominated", "kohler",     "chernikov",     "imbert",
    "box",        "lp",        "kohler,box", "chernikov,box", "kohler,chernikov,box",
    "imbert,box", "default"};
enum { DEFAULT_SETS = sizeof SETS / sizeof *SETS };

const qualify_order *qualify_order_of(const qualify_plan *p, size_t way)
{
    return &p->order[way / p->sets];
}

void qualify_order_key(const qualify_order *order, char out[PLAN_ORDER_KEY])
{
    snprintf(out, PLAN_ORDER_KEY, "order-%s", order->name);
}

void qualify_plan_init(qualify_plan *p)
{
    *p = (qualify_plan){.motion = {true, true},
                        .kind = {{true, true}, {true, true}},
                        .meeting = {true, true},
                        .order = {{.name = "pairs"}, {.name = "given"}},
                        .orders = 2};
    p->arguments = app_need(json_array());
    for (int d = 2; d <= 6; d++)
        p->dim[d] = true;
    p->grid = (study_grid){.seed = 1, .per_class = 16, .passes = 3};
    p->grid.limits = (study_limits){.max_rows = 10000, .max_seconds = 20, .presolve = "bounds"};
}

/* ---- the grid -------------------------------------------------------------------------------- */

static void add_set(qualify_plan *p, const char *words)
{
    if (strcmp(words, "none") != 0 && p->sets < PLAN_MOST_SETS)
        p->set[p->sets++] = words;
}

/* `none` before the requested sets; by default the useful ones, and each rule of the user's
 * library. */
static void make_sets(qualify_plan *p)
{
    const char *asked[PLAN_MOST_SETS];
    size_t n = p->sets;
    memcpy(asked, p->set, n * sizeof *asked);
    p->sets = 0;
    p->set[p->sets++] = "none";
    for (size_t i = 0; i < n; i++)
        add_set(p, asked[i]);
    for (size_t i = 0; n == 0 && i < DEFAULT_SETS; i++)
        add_set(p, SETS[i]);
    for (size_t i = 0; n == 0 && p->library.rule && p->library.rule[i]; i++)
        add_set(p, p->library.rule[i]->name);
}

int qualify_order_find(const app_rule_library *l, const char *option, const char *name,
                       qualify_order *out)
{
    fmb_options o = {.size = sizeof o};
    const fmb_named_chooser *own = app_rule_library_order(l, name);
    if (!own && fmb_options_set(&o, "order", name) != FMB_OK)
        return app_rule_library_refuse_order(l, option, name);
    *out = (qualify_order){.name = name, .order = o.order};
    if (own)
        out->chooser = own->chooser;
    return APP_YES;
}

int qualify_plan_ways(qualify_plan *p)
{
    int code = APP_YES;
    if (p->rule_library)
        code = app_rule_library_open(p->rule_library, &p->library);
    for (size_t k = 0; code == APP_YES && k < p->orders; k++)
        code = qualify_order_find(&p->library, "--orders", p->order[k].name, &p->order[k]);
    make_sets(p);
    for (size_t i = 0; code == APP_YES && i < p->sets; i++) {
        bool usual = strcmp(p->set[i], "default") == 0;
        if (!usual)
            code = app_rule_library_split(&p->library, p->set[i], &p->rules[i]);
        for (size_t k = 0; k < p->orders; k++)
            p->way[k * p->sets + i] = (study_way){.name = p->set[i],
                                                  .rules = p->rules[i].words,
                                                  .added = p->rules[i].added,
                                                  .order = p->order[k].order,
                                                  .chooser = p->order[k].chooser};
    }
    p->grid.way = p->way;
    p->grid.ways = p->orders * p->sets;
    return code;
}

void qualify_plan_clear(qualify_plan *p)
{
    study_grid_clear(&p->grid);
    for (size_t i = 0; i < p->sets; i++)
        free(p->rules[i].words);
    app_rule_library_close(&p->library);
    free(p->order_words);
    json_decref(p->arguments);
    app_parts_free(p->part, p->parts);
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
    int code = qualify_plan_ways(p);
    p->grid.shard = p->shard;
    p->grid.shards = p->shards;
    for (int dim = 0; dim <= PLAN_MOST_DIM; dim++)
        for (int moves = 0; moves < 2; moves++)
            for (int kinds = 0; kinds < 4; kinds++)
                if (p->dim[dim] && p->motion[moves] && p->kind[kinds >> 1][kinds & 1] &&
                    (p->files == 0 || p->frames_asked))
                    add_class(p, dim, moves, kinds);
    for (size_t i = 0; code == APP_YES && i < p->files; i++)
        code = qualify_files_add(&p->grid, p->file[i], !p->part);
    return code;
}

/* The number of runs with a property. */
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
