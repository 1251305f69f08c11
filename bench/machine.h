/* machine.h: what a benchmark was run on, for its report; and the clock all benchmarks use. */
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
