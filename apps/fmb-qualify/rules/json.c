/* json.c: the numbers of the study: counts of every class and way, times of them, and the lines of
 * the tables, which hold both.
 *
 * Counts depend on the plan alone, so they stand apart from times.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "fmb-qualify/numbers.h"
#include "fmb-qualify/rules/report.h"

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* By name, so that the order in which rules first appeared does not matter. */
static json_t *dropped_json(const qualify_plan *p, const study_digest *d)
{
    const char *name[STUDY_MOST_NAMES];
    const study_names *names = &p->grid.names;
    json_t *obj = json_object();
    memcpy(name, names->name, sizeof name);
    qsort(name, names->size, sizeof *name, compare_names);
    for (size_t i = 0; i < names->size; i++)
        for (size_t k = 0; k < names->size; k++)
            if (name[i] == names->name[k] && d->dropped[k] > 0)
                app_json_set(obj, name[i], json_real(d->dropped[k]));
    return obj;
}

static json_t *way_json(const qualify_plan *p, size_t way, const qualify_select *which)
{
    json_t *obj = json_object();
    char *name = qualify_select_text(which);
    app_json_set(obj, "systems", app_json_text(name));
    free(name);
    if (which->dim > 0) {
        app_json_set(obj, "dim", json_integer(which->dim));
        app_json_set(obj, "motion", json_string(which->moves ? "dynamic" : "static"));
    }
    app_json_set(obj, "rules", app_json_text(p->way[way].name));
    app_json_set(obj, "order", json_string(qualify_order_of(p, way)->name));
    return obj;
}

static void set_counts(json_t *obj, const qualify_plan *p, const study_digest *d)
{
    bool any = d->decided > 0;
    app_json_set(obj, "n", qualify_count_json(d->systems));
    app_json_set(obj, "decided", qualify_count_json(d->decided));
    app_json_set(obj, "stopped", qualify_count_json(d->stopped));
    app_json_set(obj, "refused", qualify_count_json(d->refused));
    app_json_set(obj, "wrong", qualify_count_json(d->wrong));
    app_json_set(obj, "pairs", app_json_real(any ? d->pairs : NAN));
    app_json_set(obj, "made", app_json_real(any ? d->made : NAN));
    app_json_set(obj, "kept", app_json_real(any ? d->kept : NAN));
    app_json_set(obj, "sum", app_json_real(any ? d->lived : NAN));
    app_json_set(obj, "peak", app_json_real(any ? d->peak : NAN));
    app_json_set(obj, "held", app_json_real(any ? d->held : NAN));
    app_json_set(obj, "both_decided", qualify_count_json(d->both));
    app_json_set(obj, "only_this_decided", qualify_count_json(d->only));
    app_json_set(obj, "kept_ratio", app_json_real(d->kept_ratio));
    app_json_set(obj, "sum_ratio", app_json_real(d->lived_ratio));
    app_json_set(obj, "dropped", dropped_json(p, d));
}

static void set_times(json_t *obj, const study_digest *d)
{
    app_json_set(obj, "timed", qualify_count_json(d->timed));
    app_json_set(obj, "none_gave_up", qualify_count_json(d->base_gave_up));
    app_json_set(obj, "this_gave_up", qualify_count_json(d->gave_up));
    app_json_set(obj, "bound",
                 json_string(d->base_gave_up > 0 && d->gave_up > 0 ? "~"
                             : d->base_gave_up > 0                 ? "<"
                             : d->gave_up > 0                      ? ">"
                                                                   : ""));
    app_json_set(obj, "time_median", qualify_ratio_json(d->median));
    app_json_set(obj, "time_total", qualify_ratio_json(d->total));
    app_json_set(obj, "sign_test", app_json_real(d->chance));
}

/* ---- every class, every line ----------------------------------------------------------------- */

static void add_class(void *self, const qualify_plan *p, const qualify_select *which)
{
    json_t *study = self;
    for (size_t w = 0; w < p->grid.ways; w++) {
        study_digest d = qualify_digest(p, w, which);
        json_t *counts = way_json(p, w, which), *times = way_json(p, w, which);
        set_counts(counts, p, &d);
        set_times(times, &d);
        app_json_append(json_object_get(study, "classes"), counts);
        app_json_append(json_object_get(study, "times"), times);
    }
}

/* Leaves out the ways that refuse these systems. */
static void add_line(void *self, const qualify_plan *p, const qualify_select *which)
{
    json_t *study = self;
    for (size_t w = 0; w < p->grid.ways; w++) {
        char key[PLAN_ORDER_KEY];
        study_digest d = qualify_digest(p, w, which);
        if (!p->grid.known[w] || (d.systems > 0 && d.refused == d.systems && d.timed == 0))
            continue;
        json_t *line = way_json(p, w, which);
        set_counts(line, p, &d);
        set_times(line, &d);
        qualify_order_key(qualify_order_of(p, w), key);
        app_json_append(json_object_get(study, key), line);
    }
}

void qualify_numbers(const qualify_plan *p, qualify_page *page)
{
    json_t *obj = qualify_page_json(page), *orders = json_array();
    app_json_set(obj, "family", json_string(study_family_text(p->family)));
    app_json_set(obj, "seed", qualify_count_json(p->grid.seed));
    app_json_set(obj, "pairs", qualify_count_json(p->grid.per_class));
    app_json_set(obj, "max_rows", qualify_count_json(p->grid.limits.max_rows));
    app_json_set(obj, "presolve", app_json_text(p->grid.limits.presolve));
    app_json_set(obj, "complete", json_boolean(p->grid.complete == p->grid.samples));
    app_json_set(obj, "classes", json_array());
    app_json_set(obj, "times", json_array());
    for (size_t k = 0; k < p->orders; k++) {
        char key[PLAN_ORDER_KEY];
        qualify_order_key(&p->order[k], key);
        app_json_append(orders, json_string(p->order[k].name));
        app_json_set(obj, key, json_array());
    }
    app_json_set(obj, "orders", orders);
    qualify_each(p, true, obj, add_class);
    qualify_each(p, p->detail, obj, add_line);
}
