/* runs.c: runs.csv, a line for each run. */
#include <stdlib.h>

#include "fmb-qualify/rules/report.h"

static const char *const OUTCOME[] = {"not run", "decided", "stopped", "refused", "wrong"};

static void put_run(FILE *f, const qualify_plan *p, const char *name, size_t item, size_t way,
                    const study_run *r)
{
    qualify_csv_text(f, name);
    fprintf(f, ",%zu,", item + 1);
    qualify_csv_text(f, p->way[way].name);
    fprintf(f, ",%s,%s,%s,%s", qualify_order_of(p, way)->name, OUTCOME[r->outcome],
            fmb_stop_text(r->stop), fmb_verdict_text(r->verdict));
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
    for (size_t i = 0; i < g->names.size; i++)
        fprintf(f, ",dropped_%s", g->names.name[i]);
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

void qualify_runs_csv(const qualify_plan *p, qualify_page *page)
{
    qualify_page_file(page, "runs.csv", put_runs, p);
}
