/* benchmark.h: the benchmark of the field: projections and verdicts of 40 families in five sizes.
 *
 *   study_projection p;
 *   if (study_benchmark_draw(family, size, instance, &p) == FMB_OK) ... fmb_system_free(p.s);
 *
 * A problem is named by its family, its size, 1 to 5, and its instance, 1, 2, ..., and is the same
 * system for ever, on every machine. If any problem changes, so must the version. Needs no GSL:
 * tests draw problems here, too.
 */
#ifndef FMB_STUDY_BENCHMARK_H
#define FMB_STUDY_BENCHMARK_H

#include "study/program/projection.h"

#define STUDY_BENCHMARK_VERSION "FMB-2026.1"

enum {
    STUDY_BENCHMARK_SIZES = 5,
    STUDY_BENCHMARK_INSTANCES = 3, /* of each family and size in the version; there are more */
    STUDY_BENCHMARK_NAME = 40      /* bytes of a name */
};

/* The families: their number, and of each its name, its field and a description of one line. */
int study_benchmark_families(void);
const char *study_benchmark_name(int family);
const char *study_benchmark_field(int family);
const char *study_benchmark_about(int family);
/* The family of that name, or -1. */
int study_benchmark_find(const char *name);

/* "relu-3-1": family, size, instance, in out[STUDY_BENCHMARK_NAME]. */
void study_benchmark_problem_name(int family, int size, int instance, char *out);

/* [give] The first `keep` variables are marked as kept; 0: the question is feasibility. Errors:
 * MEMORY. */
fmb_status study_benchmark_draw(int family, int size, int instance, study_projection *out);

#endif
