/* options.h: every way to solve: methods, arithmetics, orders, sets of rules. */
#ifndef FMB_TEST_OPTIONS_H
#define FMB_TEST_OPTIONS_H

#include <fmb/options.h>

/* Combination i of 0..options_count(): evidence on, no limits. Combination 0 is the default. */
int options_count(void);
fmb_options options_at(int i);
/* "method=fm arith=int order=given rules=kohler rebase=auto presolve=none simd=auto" */
void options_text(const fmb_options *o, char *out, size_t size);

#endif
