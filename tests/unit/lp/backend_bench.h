/* backend_bench.h: a connected system as a linear program of its own, and what a basis of it proves
 * in rationals. */
#ifndef FMB_TEST_BACKEND_BENCH_H
#define FMB_TEST_BACKEND_BENCH_H

#include "lp/simplex/backend.h"
#include "solve/query/part.h"
#include "support/support.h"

/* A connected system as a program, and matrices to solve with. */
typedef struct backend_bench {
    support_case c;
    fmb_mem mem;
    fmb_arena arena;
    fmb_run run;
    atomic_int cancel;
    fmb_parts parts;
    const fmb_part *part; /* the first, or NULL */
    fmb_program p;        /* its rows */
    size_t n, *basis;
    bool *off;
    mpq_t *matrix; /* [n][n + 1] */
    mpq_t *x, *y;  /* [n] */
    double *cost;  /* [n] */
} backend_bench;

/* False: the system has no part, so there is nothing to ask. The struct must not move. */
bool backend_bench_open(backend_bench *b, support_family family, uint64_t seed,
                        const support_shape *shape);
/* Append rows of the part until there are that many. */
void backend_bench_append(backend_bench *b, size_t m);
/* Nothing may be left in memory. */
void backend_bench_close(backend_bench *b);

/* x = where the members of the basis meet. False: nowhere, or in more than a point. */
bool backend_bench_meet(backend_bench *b);
/* Do all rows that are on hold at x, strict ones as if they were not? With `flat`, along x. */
bool backend_bench_holds(const backend_bench *b, mpq_t *x, bool flat);
/* Row `odd` is a combination of the basis that says the contrary. */
bool backend_bench_proves_conflict(backend_bench *b, size_t odd);
/* x is a solution, and the cost a combination of rows of the basis. */
bool backend_bench_proves_optimum(backend_bench *b);
/* x is a solution, and along the edge that leaves the row at that place the cost grows for ever. */
bool backend_bench_proves_ray(backend_bench *b, size_t place);

#endif
