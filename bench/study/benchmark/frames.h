/* frames.h: collision problems of the benchmark: two bodies in size + 1 dimensions. Source of the
 * setting: Baillehache 2020. */
#ifndef FMB_STUDY_BENCHMARK_FRAMES_H
#define FMB_STUDY_BENCHMARK_FRAMES_H

#include "study/program/projection.h"

/* [give] Errors: MEMORY. */
typedef fmb_status study_benchmark_bodies(int size, int instance, study_projection *out);

study_benchmark_bodies study_benchmark_cuboids, study_benchmark_moving_cuboids,
    study_benchmark_moving_simplices;

#endif
