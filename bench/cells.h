/* cells.h: the cells of the article's table for benchmarks of verdicts on pairs: 2D or 3D, still or
 * moving, two cuboids (CC), one of each (CT) or two simplices (TT), pairs that meet or do not. */
#ifndef FMB_BENCH_CELLS_H
#define FMB_BENCH_CELLS_H

#include "study/draw/pairs.h"

enum { CELLS = 12 };

/* Pairs of the article's generator, cell i of them. */
study_pair_plan cell_plan(int i);

/* [static] "2D still  CC" */
const char *cell_text(const study_pair_plan *plan);

/* The first n pairs of the plan for which k decides that verdict; seed 1. */
study_pairs cell_pairs(const study_pair_plan *plan, size_t n, fmb_pair *k, fmb_verdict verdict);

/* "--simd=plain", ...; false for any other word. */
bool parse_simd(const char *word, fmb_simd *out);

/* Stop the program unless st is FMB_OK. */
void must(fmb_status st);

#endif
