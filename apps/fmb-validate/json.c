/* json.c: counts and disagreements as JSON. */
#include "common/json.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmb-validate/report.h"

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

/* What is counted of a job, by its name; those of boxes and of contacts where they were asked for.
 */
static const struct {
    const char *key;
    size_t offset; /* in study_tally */
    enum { OF_ALL, OF_BOXES, OF_CONTACTS } of;
} COUNT[] = {
    {"tested", offsetof(study_tally, tested), OF_ALL},
    {"meeting", offsetof(study_tally, meeting), OF_ALL},
    {"touching", offsetof(study_tally, touching), OF_ALL},
    {"exact", offsetof(study_tally, exact), OF_ALL},
    {"by_solver", offsetof(study_tally, solved), OF_ALL},
    {"textbook", offsetof(study_tally, textbook), OF_ALL},
    {"textbook_left", offsetof(study_tally, left), OF_ALL},
    {"fmb_unknown", offsetof(study_tally, unknown[0]), OF_ALL},
    {"sat_unknown", offsetof(study_tally, unknown[1]), OF_ALL},
    {"disagreeing", offsetof(study_tally, disagreeing), OF_ALL},
    {"boxes", offsetof(study_tally, boxes), OF_BOXES},
    {"boxes_by_solver", offsetof(study_tally, boxes_solved), OF_BOXES},
    {"boxes_unknown", offsetof(study_tally, doubtful), OF_BOXES},
    {"contacts", offsetof(study_tally, contacts), OF_CONTACTS},
    {"contacts_unknown", offsetof(study_tally, contacts_open), OF_CONTACTS},
};
enum { COUNTS = sizeof COUNT / sizeof *COUNT };

static bool is_counted(const validate_job *job, int i)
{
    return COUNT[i].of == OF_ALL || (COUNT[i].of == OF_BOXES ? job->v.boxes : job->v.contacts);
}

static json_t *job_counts(const validate_job *job)
{
    const study_tally *t = &job->tally;
    json_t *obj = json_object();
    char text[16];
    validate_case_text(job, text);
    set_text(obj, "case", text);
    set_text(obj, "family", study_pair_family_text(job->v.plan.family));
    for (int i = 0; i < COUNTS; i++)
        if (is_counted(job, i))
            set_count(obj, COUNT[i].key, *(const uint64_t *)((const char *)t + COUNT[i].offset));
    set_count(obj, "not_meeting", t->tested - t->meeting);
    app_json_set(obj, "faults", faults_counted(t));
    if (job->v.boxes)
        app_json_set(obj, "excess", json_real(t->excess));
    return obj;
}

static bool read_count(const json_t *obj, const char *key, uint64_t *out)
{
    const json_t *n = json_object_get(obj, key);
    *out = (uint64_t)json_integer_value(n);
    return json_is_integer(n) && json_integer_value(n) >= 0;
}

bool validate_job_read(const json_t *obj, validate_job *out)
{
    const char *text = json_string_value(json_object_get(obj, "case"));
    const char *family = json_string_value(json_object_get(obj, "family"));
    const json_t *excess = json_object_get(obj, "excess");
    study_pair_plan *plan = &out->v.plan;
    char *rest = NULL;
    *out = (validate_job){.v.boxes = excess != NULL,
                          .v.contacts = json_object_get(obj, "contacts") != NULL};
    plan->dim = text ? (int)strtol(text, &rest, 10) : 0;
    plan->moves = rest && strcmp(rest, "d-dynamic") == 0;
    bool good = plan->dim >= 1 && plan->dim <= STUDY_PAIR_MOST_DIM &&
                (plan->moves || strcmp(rest, "d-static") == 0) && family &&
                study_pair_family_parse(family, &plan->family);
    for (int i = 0; good && i < COUNTS; i++)
        if (is_counted(out, i))
            good =
                read_count(obj, COUNT[i].key, (uint64_t *)((char *)&out->tally + COUNT[i].offset));
    for (int i = 0; good && i < STUDY_FAULTS; i++)
        good =
            read_count(json_object_get(obj, "faults"), study_fault_text(i), &out->tally.fault[i]);
    out->tally.excess = json_real_value(excess);
    return good;
}

json_t *validate_json(const validate_plan *p)
{
    json_t *obj = json_object(), *cases = json_array();
    app_json_set(obj, "complete", json_boolean(p->complete));
    set_count(obj, "pairs", p->pairs);
    set_count(obj, "seed", p->usual.seed);
    app_json_set(obj, "sample", json_real(p->usual.sample));
    app_json_set(obj, "textbook", json_real(p->usual.textbook));
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

/* What each way said of A, B and of B, A; and what is proved, closed and open. */
static json_t *verdicts(const study_verdicts *v)
{
    static const char *const TEXT[] = {
        [FMB_UNKNOWN] = "unknown", [FMB_FEASIBLE] = "feasible", [FMB_INFEASIBLE] = "infeasible"};
    json_t *obj = json_object();
    for (int i = 0; i < STUDY_PAIR_WAYS; i++)
        if (v->asked >> i & 1)
            app_json_set(obj, study_way_text((study_way_of_pairs)i),
                         json_pack("[s, s]", TEXT[v->said[i][0]], TEXT[v->said[i][1]]));
    app_json_set(obj, "proved", json_pack("[s, s]", TEXT[v->proved[0]], TEXT[v->proved[1]]));
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
