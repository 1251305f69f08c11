/* bars.h: the limits that the results of a trial must keep. */
#ifndef FMB_BENCH_BARS_H
#define FMB_BENCH_BARS_H

#include "trial.h"

typedef struct bar_result {
    const char *about; /* static */
    double value, limit;
    bool least; /* the value must be at least the limit, not at most */
    bool good, known;
    char worst[96]; /* the system that decides, or "" */
} bar_result;

enum { BARS_MOST = 16 };

/* The bars of the trial, judged on its lines; their number. */
int bars_judge(const trial *t, const lines *all, const line_plan *plan, bar_result out[BARS_MOST]);

#endif
