/* merge.c: the counts of the shards of one run, taken together. */
#include <stdlib.h>
#include <string.h>

#include "common/json.h"
#include "common/message.h"
#include "common/parts.h"
#include "fmb-validate/report.h"

/* Add one part's jobs, which are those of the first part. */
static bool add_jobs(validate_plan *p, const json_t *cases, bool first)
{
    size_t n = json_array_size(cases);
    if (first) {
        p->job = app_need(calloc(n + 1, sizeof *p->job));
        p->jobs = n;
    }
    for (size_t i = 0; i < n; i++) {
        validate_job job;
        if (n != p->jobs || !validate_job_read(json_array_get(cases, i), &job))
            return false;
        const study_pair_plan *a = &p->job[i].v.plan, *b = &job.v.plan;
        if (first)
            p->job[i] = job;
        else if (a->dim != b->dim || a->moves != b->moves || a->family != b->family ||
                 p->job[i].v.boxes != job.v.boxes || p->job[i].v.contacts != job.v.contacts)
            return false;
        else
            study_tally_add(&p->job[i].tally, &job.tally);
    }
    return n > 0;
}

int validate_merge(validate_plan *p)
{
    static const char *const SAME[] = {"pairs", "seed", "sample", "textbook", NULL};
    json_t **part;
    int code = app_parts_read(p->word, p->words, SAME, &part);
    if (code != APP_YES)
        return code;
    p->complete = true;
    p->seconds = 0;
    for (size_t i = 0; code == APP_YES && i < p->words; i++) {
        if (!add_jobs(p, json_object_get(part[i], "cases"), i == 0))
            code = app_error(APP_BAD_INPUT, "%s: not the counts of the same run", p->word[i]);
        p->complete &= json_is_true(json_object_get(part[i], "complete"));
        p->seconds += json_number_value(json_object_get(part[i], "seconds"));
    }
    p->pairs = (uint64_t)json_integer_value(json_object_get(part[0], "pairs"));
    p->usual.seed = (uint64_t)json_integer_value(json_object_get(part[0], "seed"));
    p->usual.sample = json_real_value(json_object_get(part[0], "sample"));
    p->usual.textbook = json_real_value(json_object_get(part[0], "textbook"));
    p->usual.boxes = p->jobs > 0 && p->job[0].v.boxes;
    p->usual.contacts = p->jobs > 0 && p->job[0].v.contacts;
    app_parts_free(part, p->words);
    return code;
}
