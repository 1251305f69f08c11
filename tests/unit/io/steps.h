/* steps.h: counts of the library's work, instead of times.
 *
 * A program that links steps.c, with the library compiled to call __sanitizer_cov_trace_pc in every
 * basic block and to leave functions of the C library calls, counts those blocks, the bytes that
 * functions of the C library look at, and those that GMP asks for. The same work makes the same
 * count on every machine, however busy.
 */
#ifndef FMB_TEST_STEPS_H
#define FMB_TEST_STEPS_H

#include <stdint.h>

/* From now on, from 0. */
void steps_start(void);
/* Steps since then, and no more of them. */
uint64_t steps_stop(void);

#endif
