/* run.c: the jobs of a validation, done by some threads of some processes (common/ranks.h): each
 * takes a chunk of pairs when it has done its last one. Counts do not depend on who did what. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "common/ranks.h"
#include "fmb-validate/contacts.h"
#include "fmb-validate/plan.h"
#include "fmb-validate/watch.h"

/* One job at work: threads take chunks of its pairs until none is left. */
typedef struct work {
    validate_job *job;
    size_t number;     /* of the job: its counter */
    uint64_t from, to; /* pairs */
    uint64_t chunk;    /* a multiple of STUDY_VALIDATE_MOST */
    int threads;       /* so far */
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

/* What asks about the pairs of one job. */
typedef struct asker {
    study_validator *s;
    validate_contacts *contacts; /* NULL: not wanted, or asked by s */
} asker;

static fmb_status open_asker(const study_validation *v, asker *a)
{
    study_validation rest = *v;
    bool many = v->plan.dim >= VALIDATE_LEAST_DIM;
    rest.contacts = v->contacts && !many;
    fmb_status st = study_validator_open(&rest, &a->s);
    if (st == FMB_OK && v->contacts && many)
        st = validate_contacts_open(v, &a->contacts);
    return st;
}

static void close_asker(asker *a)
{
    study_validator_close(a->s);
    validate_contacts_close(a->contacts);
}

/* Do a chunk, lot by lot, or less after a signal: then the lot at hand does not count. */
static fmb_status do_chunk(uint64_t first, uint64_t end, const asker *a, study_tally *tally,
                           study_findings *found)
{
    fmb_status st = FMB_OK;
    for (; st == FMB_OK && first < end && !validate_watch_interrupted();
         first += STUDY_VALIDATE_MOST) {
        uint64_t left = end - first;
        size_t n = left < STUDY_VALIDATE_MOST ? (size_t)left : STUDY_VALIDATE_MOST;
        size_t before = found->n;
        study_tally lot = {0};
        st = study_validator_run(a->s, first, n, &lot, found);
        if (st == FMB_OK && a->contacts)
            st = validate_contacts_run(a->contacts, first, n, &lot, found, before);
        if (validate_watch_interrupted())
            found->n = before;
        else
            study_tally_add(tally, &lot);
        validate_watch_step(n);
    }
    return st;
}

/* Until there are no more. */
static fmb_status take_chunks(work *w, const asker *a, study_tally *tally, study_findings *found)
{
    fmb_status st = FMB_OK;
    while (st == FMB_OK && !validate_watch_interrupted()) {
        uint64_t first;
#ifdef _OPENMP
#pragma omp critical(take)
#endif
        first = w->from + app_ranks_take(w->number, w->chunk);
        if (first >= w->to)
            break;
        uint64_t end = w->to - first < w->chunk ? w->to : first + w->chunk;
        st = do_chunk(first, end, a, tally, found);
    }
    return st;
}

static void work_on(work *w)
{
    asker a = {NULL, NULL};
    study_tally tally = {0};
    study_findings found = {0};
    int thread;
#ifdef _OPENMP
#pragma omp critical(number)
#endif
    thread = w->threads++;
    fmb_status st = open_asker(&w->job->v, &a);
    if (st == FMB_OK) {
        validate_watch_set(thread, a.s);
        st = take_chunks(w, &a, &tally, &found);
        validate_watch_set(thread, NULL);
    }
#ifdef _OPENMP
#pragma omp critical(add)
#endif
    {
        study_tally_add(&w->job->tally, &tally);
        if (st == FMB_OK)
            st = append(&w->job->findings, &found);
        if (st != FMB_OK)
            w->status = st;
    }
    close_asker(&a);
    free(found.item);
}

/* ---- all jobs -------------------------------------------------------------------------------- */

/* Many chunks for each thread of each process, and large ones where there are many pairs: rank 0 is
 * asked for each. */
static uint64_t chunk_of(uint64_t pairs, int threads)
{
    enum { CHUNKS = 256, MOST_LOTS = 64 };
    uint64_t lots =
        pairs / ((uint64_t)app_ranks() * (uint64_t)threads * CHUNKS) / STUDY_VALIDATE_MOST;
    lots = lots < 1 ? 1 : lots > MOST_LOTS ? MOST_LOTS : lots;
    return lots * STUDY_VALIDATE_MOST;
}

static fmb_status do_job(validate_plan *p, size_t number)
{
    uint64_t part = p->pairs / p->shards, more = p->pairs % p->shards, i = p->shard - 1;
    work w = {.job = &p->job[number], .number = number, .from = i * part + (i < more ? i : more)};
    w.to = w.from + part + (i < more);
    w.chunk = chunk_of(w.to - w.from, p->threads);
#ifdef _OPENMP
#pragma omp parallel num_threads(p->threads)
#endif
    work_on(&w);
    return w.status;
}

/* On rank 0: what all ranks counted and found, in the order of the pairs. */
static void collect_job(validate_job *job)
{
    study_tally *t = &job->tally;
    uint64_t *const count[] = {&t->tested,       &t->meeting,  &t->touching,    &t->exact,
                               &t->textbook,     &t->left,     &t->unknown[0],  &t->unknown[1],
                               &t->boxes,        &t->doubtful, &t->disagreeing, &t->contacts,
                               &t->contacts_open};
    for (size_t i = 0; i < sizeof count / sizeof *count; i++)
        app_ranks_sum(count[i], 1);
    app_ranks_sum(t->fault, STUDY_FAULTS);
    app_ranks_most(&t->excess, 1);
    study_findings *f = &job->findings;
    size_t all;
    study_finding *item = app_ranks_gather(f->item, f->n * sizeof *item, &all);
    free(f->item);
    *f = (study_findings){item, all / sizeof *item, all / sizeof *item};
    if (f->n > 0)
        qsort(f->item, f->n, sizeof *f->item, by_number);
}

static fmb_status make_jobs(validate_plan *p)
{
    p->job = calloc(VALIDATE_MOST_JOBS, sizeof *p->job);
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
    double start = fmb_monotonic_seconds();
    fmb_status st = make_jobs(p);
    validate_watch_begin(p->quiet, (p->pairs / p->shards + 1) * p->jobs);
    for (size_t i = 0; st == FMB_OK && i < p->jobs && !validate_watch_interrupted(); i++)
        st = do_job(p, i);
    for (size_t i = 0; st == FMB_OK && i < p->jobs; i++)
        collect_job(&p->job[i]);
    validate_watch_end();
    p->complete = !validate_watch_interrupted();
    p->seconds = fmb_monotonic_seconds() - start;
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
