/* crew.h: share numbered jobs among processes. */
#ifndef FMB_TEST_CREW_H
#define FMB_TEST_CREW_H

#include "agree.h"

/* What came of the jobs, added up over the processes. */
typedef struct crew_sum {
    uint64_t jobs, failures, questions, unjudged, by_proof, undecided;
} crew_sum;

/* Job number i; counts go to g and failures. Ends the process's work early by returning false. */
typedef bool crew_job(void *self, uint64_t i, agree *g, uint64_t *failures);

/* Run jobs first..first + count in `processes` processes; job i belongs to process i % processes. A
 * progress line is shown on terminals. False if a process died. */
bool crew_run(crew_job *job, void *self, uint64_t first, uint64_t count, int processes,
              size_t max_rows, crew_sum *sum);

/* "--count=7" for the name "--count=": true, and *out is 7. */
bool crew_number(const char *arg, const char *name, uint64_t *out);

#endif
