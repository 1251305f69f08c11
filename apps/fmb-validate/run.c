/* run.c: the jobs of a validation, done by some threads. */
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "fmb-validate/plan.h"
#include "fmb-validate/watch.h"

/* One job at work: threads take lots of its pairs until none is left. */
typedef struct work {
    validate_job *job;
    uint64_t from, to; /* pairs */
    atomic_uint_least64_t next;
    atomic_int threads; /* so far */
    fmb_status status;
} work;

/* ---- findings -------------------------------------------------------------------------------- */

static fmb_status append(study_findings *to, const study_findings *more)
{
    if (more->n == 0)
        return FMB_OK;
    study_finding *item = realloc(to->item, (to->n + more->n) * sizeof *item);
    if (!item)
        return FMB_ERR_MEMORY;
    memcpy(item + to->n, more->item, more->n * sizeof *item);
    to->item = item;
    to->n = to->capacity = to->n + more->n;
    return FMB_OK;
}

static int by_number(const void *x, const void *y)
{
    const study_finding *a = x, *b = y;
    return (a->k > b->k) - (a->k < b->k);
}

/* ---- one thread ------------------------------------------------------------------------------ */

/* Take lots until there are no more, or a signal says so: then the lot at hand does not count. */
static fmb_status take_lots(work *w, study_validator *s, study_tally *tally, study_findings *found)
{
    fmb_status st = FMB_OK;
    while (st == FMB_OK && !validate_watch_interrupted()) {
        uint64_t first = atomic_fetch_add(&w->next, STUDY_VALIDATE_MOST);
        if (first >= w->to)
            break;
        uint64_t left = w->to - first;
        size_t n = left < STUDY_VALIDATE_MOST ? (size_t)left : STUDY_VALIDATE_MOST;
        size_t before = found->n;
        study_tally lot = {0};
        st = study_validator_run(s, first, n, &lot, found);
        if (validate_watch_interrupted())
            found->n = before;
        else
            study_tally_add(tally, &lot);
        validate_watch_step(n);
    }
    return st;
}

static void work_on(work *w)
{
    study_validator *s = NULL;
    study_tally tally = {0};
    study_findings found = {0};
    int thread = atomic_fetch_add(&w->threads, 1);
    fmb_status st = study_validator_open(&w->job->v, &s);
    if (st == FMB_OK) {
        validate_watch_set(thread, s);
        st = take_lots(w, s, &tally, &found);
        validate_watch_set(thread, NULL);
    }
#ifdef _OPENMP
#pragma omp critical
#endif
    {
        study_tally_add(&w->job->tally, &tally);
        if (st == FMB_OK)
            st = append(&w->job->findings, &found);
        if (st != FMB_OK)
            w->status = st;
    }
    study_validator_close(s);
    free(found.item);
}

/* ---- all jobs -------------------------------------------------------------------------------- */

static fmb_status do_job(validate_plan *p, validate_job *job)
{
    uint64_t part = p->pairs / p->shards, more = p->pairs % p->shards, i = p->shard - 1;
    work w = {.job = job, .from = i * part + (i < more ? i : more)};
    w.to = w.from + part + (i < more);
    atomic_init(&w.next, w.from);
#ifdef _OPENMP
#pragma omp parallel num_threads(p->threads)
#endif
    work_on(&w);
    if (job->findings.n > 0)
        qsort(job->findings.item, job->findings.n, sizeof *job->findings.item, by_number);
    return w.status;
}

static fmb_status make_jobs(validate_plan *p)
{
    p->job = calloc((STUDY_PAIR_MOST_DIM + 1) * 2 * STUDY_PAIR_FAMILIES, sizeof *p->job);
    if (!p->job)
        return FMB_ERR_MEMORY;
    for (int dim = 1; dim <= STUDY_PAIR_MOST_DIM; dim++)
        for (int moves = 0; moves < 2; moves++)
            for (int f = 0; p->wanted[dim][moves] && f < STUDY_PAIR_FAMILIES; f++) {
                if (!p->family[f])
                    continue;
                study_validation *v = &p->job[p->jobs++].v;
                *v = p->usual;
                v->plan.family = (study_pair_family)f;
                v->plan.dim = dim;
                v->plan.moves = moves;
            }
    return FMB_OK;
}

fmb_status validate_run(validate_plan *p)
{
    double start = app_now();
    fmb_status st = make_jobs(p);
    validate_watch_begin(p->quiet, (p->pairs / p->shards + 1) * p->jobs);
    for (size_t i = 0; st == FMB_OK && i < p->jobs && !validate_watch_interrupted(); i++)
        st = do_job(p, &p->job[i]);
    validate_watch_end();
    p->complete = !validate_watch_interrupted();
    p->seconds = app_now() - start;
    return st;
}

void validate_clear(validate_plan *p)
{
    for (size_t i = 0; i < p->jobs; i++)
        free(p->job[i].findings.item);
    free(p->job);
    free(p->word);
}

void validate_case_text(const validate_job *job, char text[16])
{
    const study_pair_plan *plan = &job->v.plan;
    snprintf(text, 16, "%dd-%s", plan->dim, plan->moves ? "dynamic" : "static");
}

uint64_t validate_disagreements(const validate_plan *p)
{
    uint64_t n = 0;
    for (size_t i = 0; i < p->jobs; i++)
        n += p->job[i].tally.disagreeing;
    return n;
}
