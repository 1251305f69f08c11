/* csv.c: classes.csv, a line for each class and way, and runs.csv, a line for each run. */
#include <math.h>
#include <stdlib.h>

#include "qualify/rules/report.h"

static void put_ratio(FILE *f, double ratio)
{
    if (isnan(ratio))
        fputc(',', f);
    else
        fprintf(f, ",%.6g", ratio);
}

static void put_way(FILE *f, const qualify_plan *p, size_t way)
{
    fputc(',', f);
    qualify_csv_text(f, qualify_set_text(&p->way[way]));
    fprintf(f, ",%s", qualify_order_text(p->way[way].order));
}

static void put_class(void *self, const qualify_plan *p, const qualify_select *which)
{
    FILE *f = self;
    char *name = qualify_select_text(which);
    for (size_t w = 0; w < p->grid.ways; w++) {
        study_digest d = qualify_digest(p, w, which);
        qualify_csv_text(f, name);
        put_way(f, p, w);
        fprintf(f, ",%zu,%zu,%zu,%zu,%zu", d.systems, d.decided, d.stopped, d.refused, d.wrong);
        fprintf(f, ",%.6g,%.6g,%.6g,%.6g,%.6g,%.6g", d.pairs, d.made, d.kept, d.lived, d.peak,
                d.held);
        for (size_t i = 0; i < p->grid.names.size; i++)
            fprintf(f, ",%.6g", d.dropped[i]);
        fprintf(f, ",%zu,%zu", d.both, d.only);
        put_ratio(f, d.kept_ratio);
        put_ratio(f, d.lived_ratio);
        fprintf(f, ",%zu,%zu,%zu", d.timed, d.base_gave_up, d.gave_up);
        put_ratio(f, d.median_ratio);
        put_ratio(f, d.total_ratio);
        put_ratio(f, d.chance);
        fputc('\n', f);
    }
    free(name);
}

static void put_dropped_titles(FILE *f, const qualify_plan *p)
{
    for (size_t i = 0; i < p->grid.names.size; i++)
        fprintf(f, ",dropped_%s", p->grid.names.name[i]);
}

static void put_run(FILE *f, const qualify_plan *p, const char *name, size_t item, size_t way,
                    const study_run *r)
{
    static const char *const OUTCOME[] = {"not run", "decided", "stopped", "refused", "wrong"};
    qualify_csv_text(f, name);
    fprintf(f, ",%zu", item + 1);
    put_way(f, p, way);
    fprintf(f, ",%s,%s,%s", OUTCOME[r->outcome], fmb_stop_text(r->stop),
            fmb_verdict_text(r->verdict));
    const uint64_t count[] = {r->pairs, r->made, r->kept, r->lived, r->peak, r->held};
    for (size_t i = 0; i < sizeof count / sizeof *count; i++)
        fprintf(f, ",%llu", (unsigned long long)count[i]);
    for (size_t i = 0; i < p->grid.names.size; i++)
        fprintf(f, ",%llu", (unsigned long long)r->dropped[i]);
    fprintf(f, ",%s,%.9f\n", OUTCOME[r->solved], r->seconds);
}

static void put_runs(FILE *f, const void *plan)
{
    const qualify_plan *p = plan;
    const study_grid *g = &p->grid;
    fprintf(f, "systems,number,rules,order,outcome,stop,verdict,pairs,made,kept,sum,peak,held");
    put_dropped_titles(f, p);
    fprintf(f, ",solved,seconds\n");
    for (size_t k = 0; k < g->complete; k++) {
        const study_class *c = &g->sample[k].class;
        qualify_select which = {c->dim, c->moves, 2 * (int)c->shape[0] + (int)c->shape[1], c->meets,
                                g->sample[k].file};
        char *name = qualify_select_text(&which);
        for (size_t i = 0; i < g->sample[k].size; i++)
            for (size_t w = 0; w < g->ways; w++)
                put_run(f, p, name, i, w, study_grid_at(g, k, i, w));
        free(name);
    }
}

static void put_classes(FILE *f, const void *plan)
{
    const qualify_plan *p = plan;
    fprintf(f, "systems,rules,order,n,decided,stopped,refused,wrong,pairs,made,kept,sum,peak,held");
    put_dropped_titles(f, p);
    fprintf(f, ",both_decided,only_this_decided,kept_ratio,sum_ratio,timed,none_gave_up,"
               "this_gave_up,time_median_ratio,time_total_ratio,sign_test\n");
    qualify_each(p, true, f, put_class);
}

void qualify_csv_files(const qualify_plan *p, qualify_page *page)
{
    qualify_page_file(page, "classes.csv", put_classes, p);
    qualify_page_file(page, "runs.csv", put_runs, p);
}
