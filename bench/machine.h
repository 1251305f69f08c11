/* machine.h: the machine of a benchmark, for its report; and the clock that all benchmarks use. */
#ifndef FMB_BENCH_MACHINE_H
#define FMB_BENCH_MACHINE_H

#include <stdio.h>

/* CPU time of this thread [s]. */
double thread_seconds(void);
/* Median of n times; sorts them. */
double median(double *times, int n);
/* "machine": "...", "compiler": "...", "flags": "...", "commit": "..." */
void print_machine_json(FILE *out);

#endif
