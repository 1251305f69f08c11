/* table.h: lines and bars on standard output, and all of them as JSON. */
#ifndef FMB_BENCH_TABLE_H
#define FMB_BENCH_TABLE_H

#include "bars.h"

void table_head(const char *title, const line_plan *plan);
void table_line(const line *l, const line_plan *plan);
/* Geometric means, largest ratios, undecided systems. */
void table_summary(const lines *all, const line_plan *plan);
void table_bars(const bar_result *r, int n);

/* The lines of one trial, for the JSON. */
typedef struct table_part {
    const char *name;
    line_plan plan;
    lines lines;
    bar_result bar[BARS_MOST];
    int bars;
} table_part;

bool table_json(const char *path, const table_part *part, int parts, uint64_t seed);

#endif
