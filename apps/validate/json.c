/* json.c: counts and disagreements as JSON. */
#include "common/json.h"

#include <stdio.h>

#include "validate/report.h"

static void set_count(json_t *obj, const char *key, uint64_t n)
{
    app_json_set(obj, key, json_integer((json_int_t)n));
}

static void set_text(json_t *obj, const char *key, const char *text)
{
    app_json_set(obj, key, json_string(text));
}

/* ---- counts ---------------------------------------------------------------------------------- */

static json_t *faults_counted(const study_tally *t)
{
    json_t *all = json_object();
    for (int i = 0; i < STUDY_FAULTS; i++)
        set_count(all, study_fault_text(i), t->fault[i]);
    return all;
}

static json_t *job_counts(const validate_job *job)
{
    const study_tally *t = &job->tally;
    json_t *obj = json_object();
    char text[16];
    validate_case_text(job, text);
    set_text(obj, "case", text);
    set_text(obj, "family", study_pair_family_text(job->v.plan.family));
    set_count(obj, "tested", t->tested);
    set_count(obj, "meeting", t->meeting);
    set_count(obj, "not_meeting", t->tested - t->meeting);
    set_count(obj, "touching", t->touching);
    set_count(obj, "exact", t->exact);
    set_count(obj, "fmb_unknown", t->unknown[0]);
    set_count(obj, "sat_unknown", t->unknown[1]);
    set_count(obj, "disagreeing", t->disagreeing);
    app_json_set(obj, "faults", faults_counted(t));
    if (job->v.boxes) {
        set_count(obj, "boxes", t->boxes);
        set_count(obj, "boxes_unknown", t->doubtful);
        app_json_set(obj, "excess", json_real(t->excess));
    }
    return obj;
}

json_t *validate_json(const validate_plan *p)
{
    json_t *obj = json_object(), *cases = json_array();
    app_json_set(obj, "complete", json_boolean(p->complete));
    set_count(obj, "pairs", p->pairs);
    set_count(obj, "seed", p->usual.seed);
    app_json_set(obj, "shard", json_pack("[I, I]", (json_int_t)p->shard, (json_int_t)p->shards));
    app_json_set(obj, "seconds", json_real(p->seconds));
    set_count(obj, "disagreements", validate_disagreements(p));
    for (size_t i = 0; i < p->jobs; i++)
        app_json_append(cases, job_counts(&p->job[i]));
    app_json_set(obj, "cases", cases);
    return obj;
}

/* ---- one disagreement ------------------------------------------------------------------------ */

static json_t *vector(const double *x, int n)
{
    json_t *all = json_array();
    for (int i = 0; i < n; i++)
        app_json_append(all, json_real(x[i]));
    return all;
}

static json_t *frame(const fmb_frame *f)
{
    json_t *obj = json_object(), *axes = json_array();
    set_text(obj, "type", f->shape == FMB_CUBOID ? "cuboid" : "simplex");
    app_json_set(obj, "orig", vector(f->origin, f->dim));
    for (int i = 0; i < f->naxes; i++)
        app_json_append(axes, vector(f->axes + i * f->dim, f->dim));
    app_json_set(obj, "comp", axes);
    if (f->speed)
        app_json_set(obj, "vel", vector(f->speed, f->dim));
    return obj;
}

static json_t *faults_named(unsigned faults)
{
    json_t *all = json_array();
    for (int i = 0; i < STUDY_FAULTS; i++)
        if (faults >> i & 1)
            app_json_append(all, json_string(study_fault_text(i)));
    return all;
}

/* What each way said of A, B and of B, A. */
static json_t *verdicts(const study_verdicts *v)
{
    static const char *const TEXT[] = {
        [FMB_UNKNOWN] = "unknown", [FMB_FEASIBLE] = "feasible", [FMB_INFEASIBLE] = "infeasible"};
    json_t *obj = json_object();
    for (int i = 0; i < STUDY_PAIR_WAYS; i++)
        if (v->asked >> i & 1)
            app_json_set(obj, study_way_text((study_way_of_pairs)i),
                         json_pack("[s, s]", TEXT[v->said[i][0]], TEXT[v->said[i][1]]));
    return obj;
}

json_t *validate_failure(const validate_job *job, const study_finding *finding)
{
    json_t *obj = json_object();
    study_pair pair;
    char text[16], id[96];
    validate_case_text(job, text);
    snprintf(id, sizeof id, "%s/%s/%llu/%llu", text, study_pair_family_text(job->v.plan.family),
             (unsigned long long)job->v.seed, (unsigned long long)finding->k);
    study_pair_draw(&job->v.plan, job->v.seed, finding->k, &pair);
    set_text(obj, "id", id);
    app_json_set(obj, "A", frame(&pair.p));
    app_json_set(obj, "B", frame(&pair.q));
    app_json_set(obj, "faults", faults_named(finding->faults));
    app_json_set(obj, "said", verdicts(&finding->verdicts));
    return obj;
}
