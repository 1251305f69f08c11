/* block.c: the systems of a block, and their runs. See experiment.h. */
#include <stdlib.h>
#include <string.h>

#include "common/machine.h"
#include "common/message.h"
#include "fmb-qualify/experiment/experiment.h"
#include "fmb-qualify/page.h"
#include "fmb-qualify/rules/files.h"
#include "fmb-qualify/watch.h"
#include "study/benchmark/benchmark.h"
#include "study/grid/wrong.h"
#include "study/program/program.h"

size_t qualify_block_size(const qualify_experiment *e, size_t block)
{
    return e->block[block].file ? 1 : e->seeds;
}

/* ---- systems --------------------------------------------------------------------------------- */

/* Replaces *s by its successor, unless that failed. */
static void replace(fmb_system **s, fmb_status st, fmb_system *const *by)
{
    if (st != FMB_OK)
        app_need(NULL);
    fmb_system_free(*s);
    *s = *by;
}

static void dress(const qualify_block *b, int seed, fmb_system **s)
{
    fmb_system *to = NULL;
    if (b->density < 100)
        replace(s, study_system_thin(*s, b->density, (uint64_t)seed, &to), &to);
    if (b->digits > 0)
        replace(s, study_system_fractions(*s, b->digits, (uint64_t)seed, &to), &to);
}

/* The first n variables, or NULL. */
static int *first_variables(int n)
{
    int *keep = n > 0 ? app_need(malloc((size_t)n * sizeof *keep)) : NULL;
    for (int j = 0; j < n; j++)
        keep[j] = j;
    return keep;
}

static void put_drawn(const qualify_experiment *e, const qualify_block *b, int seed,
                      study_sample *sample)
{
    study_projection p;
    if (study_benchmark_draw(b->family, b->size, seed, &p) != FMB_OK)
        app_need(NULL);
    dress(b, seed, &p.s);
    int keep = e->projects ? p.keep : 0;
    if (study_sample_put(sample, p.s, first_variables(keep), keep) != FMB_OK)
        app_need(NULL);
}

static int make_sample(const qualify_experiment *e, const qualify_block *b, study_grid *g)
{
    if (b->file) {
        int code = qualify_files_add(g, b->file, true);
        if (code == APP_YES)
            dress(b, 1, &g->sample[0].item[0].s);
        if (code == APP_YES && !e->projects) {
            free(g->sample[0].item[0].keep);
            g->sample[0].item[0].keep = NULL;
            g->sample[0].item[0].kept = 0;
        }
        return code;
    }
    study_sample sample = {.file = study_benchmark_name(b->family)};
    for (size_t i = 0; i < e->seeds; i++)
        put_drawn(e, b, e->seed[i], &sample);
    if (study_grid_add(g, &sample) != FMB_OK)
        app_need(NULL);
    return APP_YES;
}

/* ---- runs ------------------------------------------------------------------------------------ */

static bool go_on(void *self, size_t done, size_t all)
{
    (void)self, (void)done, (void)all;
    return !qualify_watch_interrupted();
}

int qualify_block_run(const qualify_experiment *e, size_t block, study_grid *g)
{
    *g = (study_grid){.limits = e->limits,
                      .way = e->way,
                      .ways = e->ways,
                      .passes = e->passes,
                      .projects = e->projects,
                      .turn = block + block / e->ways, /* varies for the same size, too */
                      .step = go_on,
                      .running = qualify_watch_solver()};
    int code = make_sample(e, &e->block[block], g);
    if (code != APP_YES)
        return code;
    fmb_status st = study_grid_run(g);
    if (st == FMB_ERR_ARG && e->library.chooser)
        return app_rule_library_refuse_choice(
            json_string_value(json_object_get(e->plan, "rule-library")));
    if (st != FMB_OK)
        return app_status_error(st);
    if (g->rejected > 0)
        return app_error(APP_INTERNAL, "an exact answer failed its check");
    return g->complete == 1 ? APP_YES : APP_UNDECIDED;
}

/* ---- lines ----------------------------------------------------------------------------------- */

const char qualify_experiment_header[] =
    "plan,block,family,size,seed,digits,density,rows,"
    "variables,kept,question,method,order,rules,evidence,outcome,"
    "stop,verdict,pairs,made,rows_kept,lived,peak,held,rounds,"
    "max_rows,max_seconds,timed,passes,seconds,version,commit,"
    "machine,system\n";

static const char *outcome_text(study_outcome outcome)
{
    static const char *const TEXT[] = {[STUDY_NOT_RUN] = "unknown",
                                       [STUDY_DECIDED] = "decided",
                                       [STUDY_STOPPED] = "stopped",
                                       [STUDY_REFUSED] = "refused",
                                       [STUDY_WRONG] = "wrong"};
    return TEXT[outcome];
}

/* Rows alive after each round: "12 30 25", and "..." if there were more rounds than recorded. */
static void write_rounds(const study_run *r, FILE *f)
{
    for (size_t i = 0; i < r->rounds && i < STUDY_MOST_ROUNDS; i++)
        fprintf(f, "%s%llu", i > 0 ? " " : "", (unsigned long long)r->alive[i]);
    if (r->rounds > STUDY_MOST_ROUNDS)
        fputs(" ...", f);
}

static void write_counts(const study_run *r, FILE *f)
{
    const uint64_t count[] = {r->pairs, r->made, r->kept, r->lived, r->peak, r->held};
    for (size_t i = 0; i < sizeof count / sizeof *count; i++)
        fprintf(f, "%llu,", (unsigned long long)count[i]);
}

static void write_problem(const qualify_experiment *e, size_t block, const study_sample *sample,
                          size_t item, FILE *f)
{
    const qualify_block *b = &e->block[block];
    const study_case *c = &sample->item[item];
    fprintf(f, "%s,%zu,", e->name, block + 1);
    qualify_csv_text(f, sample->file);
    fprintf(f, ",%d,%d,%d,%d,%zu,%d,%d,%s,", b->size, b->file ? 1 : e->seed[item], b->digits,
            b->density, fmb_system_rows(c->s), fmb_system_dim(c->s), c->kept,
            c->kept > 0 ? "project" : "solve");
}

static void write_run(const qualify_experiment *e, const qualify_way_names *names,
                      const study_run *r, const app_machine *m, FILE *f)
{
    fprintf(f, "%s,%s,", names->method, names->order);
    qualify_csv_text(f, names->rules);
    fprintf(f, ",%s,%s,%s,%s,", names->evidence, outcome_text(r->outcome), fmb_stop_text(r->stop),
            fmb_verdict_text(r->verdict));
    write_counts(r, f);
    write_rounds(r, f);
    fprintf(f, ",%zu,%g,%s,%d,%.9f,%s,%s,", e->limits.max_rows, e->limits.max_seconds,
            e->passes > 0 ? outcome_text(r->solved) : "no", e->passes, r->seconds, fmb_version(),
            m->commit);
    qualify_csv_text(f, m->cpu);
    fputc(',', f);
}

static bool is_wrong(const study_run *r)
{
    return r->outcome == STUDY_WRONG || r->solved == STUDY_WRONG;
}

/* The minimal system of the first wrong answer of a way in this block, its rows separated by
 * semicolons. */
static void write_system(const qualify_experiment *e, const study_grid *g, size_t item, size_t way,
                         FILE *f)
{
    fmb_system *s = NULL;
    const study_case *c = &g->sample[0].item[item];
    bool first = is_wrong(study_grid_at(g, 0, item, way));
    for (size_t i = 0; i < item; i++)
        first = first && !is_wrong(study_grid_at(g, 0, i, way));
    if (!first || study_smallest_wrong(c, &e->way[way], &e->limits, &s) != FMB_OK || !s)
        return;
    char *text = qualify_system_text(s, c);
    for (char *end = strchr(text, '\n'); end; end = strchr(end, '\n'))
        *end = ';';
    qualify_csv_text(f, text);
    free(text);
    fmb_system_free(s);
}

void qualify_block_write(const qualify_experiment *e, size_t block, const study_grid *g, FILE *f)
{
    app_machine m = app_machine_find();
    for (size_t i = 0; i < g->sample[0].size; i++)
        for (size_t w = 0; w < e->ways; w++) {
            write_problem(e, block, &g->sample[0], i, f);
            write_run(e, &e->way_names[w], study_grid_at(g, 0, i, w), &m, f);
            write_system(e, g, i, w, f);
            fputc('\n', f);
        }
}
