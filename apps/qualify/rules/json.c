/* json.c: the numbers of the study, as keys of its JSON object. */
#include <stdlib.h>

#include "common/json.h"
#include "common/message.h"
#include "qualify/rules/report.h"

static json_t *count(size_t n)
{
    return json_integer((json_int_t)n);
}

static json_t *dropped(const qualify_plan *p, const study_digest *d)
{
    json_t *obj = json_object();
    for (size_t i = 0; i < p->grid.names.size; i++)
        if (d->dropped[i] > 0)
            app_json_set(obj, p->grid.names.name[i], json_real(d->dropped[i]));
    return obj;
}

static void set_counts(json_t *obj, const study_digest *d)
{
    app_json_set(obj, "n", count(d->systems));
    app_json_set(obj, "decided", count(d->decided));
    app_json_set(obj, "stopped", count(d->stopped));
    app_json_set(obj, "refused", count(d->refused));
    app_json_set(obj, "wrong", count(d->wrong));
    app_json_set(obj, "pairs", json_real(d->pairs));
    app_json_set(obj, "made", json_real(d->made));
    app_json_set(obj, "kept", json_real(d->kept));
    app_json_set(obj, "sum", json_real(d->lived));
    app_json_set(obj, "peak", json_real(d->peak));
    app_json_set(obj, "held", json_real(d->held));
}

static void set_ratios(json_t *obj, const study_digest *d)
{
    app_json_set(obj, "both_decided", count(d->both));
    app_json_set(obj, "only_this_decided", count(d->only));
    app_json_set(obj, "kept_ratio", app_json_real(d->kept_ratio));
    app_json_set(obj, "sum_ratio", app_json_real(d->lived_ratio));
    app_json_set(obj, "timed", count(d->timed));
    app_json_set(obj, "none_gave_up", count(d->base_gave_up));
    app_json_set(obj, "this_gave_up", count(d->gave_up));
    app_json_set(obj, "time_median_ratio", app_json_real(d->median_ratio));
    app_json_set(obj, "time_total_ratio", app_json_real(d->total_ratio));
    app_json_set(obj, "sign_test", app_json_real(d->chance));
}

static void add_class(void *self, const qualify_plan *p, const qualify_select *which)
{
    char *name = qualify_select_text(which);
    for (size_t w = 0; w < p->grid.ways; w++) {
        study_digest d = qualify_digest(p, w, which);
        json_t *obj = json_object();
        app_json_set(obj, "systems", app_json_text(name));
        app_json_set(obj, "rules", app_json_text(qualify_set_text(&p->way[w])));
        app_json_set(obj, "order", json_string(qualify_order_text(p->way[w].order)));
        set_counts(obj, &d);
        app_json_set(obj, "dropped", dropped(p, &d));
        set_ratios(obj, &d);
        app_json_append(self, obj);
    }
    free(name);
}

void qualify_numbers(const qualify_plan *p, qualify_page *page)
{
    json_t *obj = qualify_page_json(page), *classes = json_array();
    app_json_set(obj, "family", json_string(study_family_text(p->family)));
    app_json_set(obj, "seed", count(p->grid.seed));
    app_json_set(obj, "pairs", count(p->grid.per_class));
    app_json_set(obj, "max_rows", count(p->grid.limits.max_rows));
    app_json_set(obj, "presolve", app_json_text(p->grid.limits.presolve));
    app_json_set(obj, "complete", json_boolean(p->grid.complete == p->grid.samples));
    qualify_each(p, true, classes, add_class);
    app_json_set(obj, "classes", classes);
}
