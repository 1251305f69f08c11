/* vertex_bench.h: a linear program in two variables and one of its vertices. */
#ifndef FMB_TEST_VERTEX_BENCH_H
#define FMB_TEST_VERTEX_BENCH_H

#include "lp/oracle/vertex.h"

typedef struct vertex_bench {
    fmb_mem mem;
    fmb_run run;
    fmb_options options;
    atomic_int cancel;
    fmb_program p; /* without rows at first */
    fmb_vertex v;  /* once it is stood up */
} vertex_bench;

/* The struct must not move. */
void vertex_bench_open(vertex_bench *b);
/* Once all rows are there. */
void vertex_bench_stand(vertex_bench *b);
/* Nothing may be left in memory. */
void vertex_bench_close(vertex_bench *b);

#endif
