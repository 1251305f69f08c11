/* samples.h: small systems that lead every query through as many of its paths as possible. */
#ifndef FMB_TEST_SAMPLES_H
#define FMB_TEST_SAMPLES_H

#include <fmb/gmp.h>

int samples_count(void);
/* [give] System i, allocated through mem. */
fmb_system *sample(int i, const fmb_alloc *mem);
/* [give] A system of n variables and m rows around the origin whose elimination takes far longer
 * than any test: dense rows, no rule helps. */
fmb_system *sample_hard(int n, int m, const fmb_alloc *mem);

#endif
