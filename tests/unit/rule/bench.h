/* bench.h: an elimination by itself, with chosen rules and steps: rows in, rounds, rows out. Rows
 * are {a1, ..., an, b} and primitive. */
#ifndef FMB_TEST_BENCH_H
#define FMB_TEST_BENCH_H

#include "elim/round/elim.h"

enum { BENCH_DIM = 8 };

typedef struct bench {
    fmb_mem mem;
    fmb_arena arena;
    fmb_run run;
    atomic_int cancel;
    const fmb_rule *rule[FMB_MAX_RULES];
    fmb_elim_options how;
    fmb_elim e;
} bench;

/* Nothing but pairing: order given, equalities substituted, no rules. Change b->how, then start. */
void bench_open(bench *b, int n);
void bench_use(bench *b, const fmb_rule *rule);
void bench_start(bench *b);
/* Also checks that all memory came back. */
void bench_close(bench *b);

void bench_add(bench *b, const int64_t *row, fmb_rel rel);
/* Eliminate the columns below n. */
void bench_eliminate(bench *b, int n);
/* What the rules say between rounds. */
void bench_prune(bench *b);

/* |x1| + ... + |xn| <= 1 in 2^n rows. */
void bench_add_octahedron(bench *b);
/* |x_i - x_{i+1}| <= 1, |x_n| <= 1. */
void bench_add_sheared_cube(bench *b);

#endif
