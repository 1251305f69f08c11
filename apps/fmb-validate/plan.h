/* plan.h: what a run of fmb-validate asks, and what it found. */
#ifndef VALIDATE_PLAN_H
#define VALIDATE_PLAN_H

#include <argp.h>

#include "study/reference/validate.h"

/* The pairs of one case and one family: a line of the table. */
typedef struct validate_job {
    study_validation v;
    study_tally tally;
    study_findings findings; /* in the order of k */
} validate_job;

typedef struct validate_plan {
    bool wanted[STUDY_PAIR_MOST_DIM + 1][2]; /* case [dim][moves] */
    bool family[STUDY_PAIR_FAMILIES];
    uint64_t pairs;         /* of each job, over all shards */
    uint64_t shard, shards; /* shard = 1 ... shards */
    study_validation usual; /* what the jobs have in common */
    int threads;
    bool quiet;
    const char *json, *failures; /* files, or NULL */
    bool merge;                  /* take the counts of other runs together */
    char **word;                 /* [words] of the command line: cases, or files to merge */
    size_t words;

    validate_job *job;
    size_t jobs;
    bool complete;  /* not interrupted */
    double seconds; /* [s] on the clock on the wall */
} validate_plan;

/* The command line; exits after a mistake. */
extern const struct argp validate_argp;
void validate_plan_init(validate_plan *p);

/* So many jobs at most. */
enum { VALIDATE_MOST_JOBS = (STUDY_PAIR_MOST_DIM + 1) * 2 * STUDY_PAIR_FAMILIES };

/* [give, validate_clear] Make the jobs and do them, a counter of common/ranks.h for each; rank 0
 * has what came of it. Errors: ARG, MEMORY, of this rank alone. */
fmb_status validate_run(validate_plan *p);
/* [give, validate_clear] Make the jobs of the files' counts, those of all shards of one run. An
 * exit code, after a message unless it is APP_YES. */
int validate_merge(validate_plan *p);
void validate_clear(validate_plan *p);

/* "2d-static" */
void validate_case_text(const validate_job *job, char text[16]);
uint64_t validate_disagreements(const validate_plan *p);

#endif
