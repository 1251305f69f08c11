/* table.h: the cost of switching off each way of the library. */
#ifndef FMB_ABLATE_TABLE_H
#define FMB_ABLATE_TABLE_H

#include "base/ways.h"
#include "subjects.h"

/* One problem, with one way on and off. */
typedef struct table_cell {
    unsigned long long asked, answered; /* with the way on */
    double with, without;               /* [s]; without is a lower bound if unfinished */
    bool unfinished;
    double peak_with, peak_without; /* [bytes] */
} table_cell;

typedef struct table_row {
    unsigned problems, unfinished;
    unsigned long long asked, answered;
    double log_time, log_memory; /* sums of logarithms of ratios */
    unsigned memories;
    double worst; /* ratio of a problem of a millisecond or more on either side */
    char worst_name[64];
} table_row;

/* The last row compares two runs with all ways on: the noise. */
typedef struct table {
    table_row row[FMB_WAY_COUNT + 1];
} table;

const char *table_way_name(int way);
void table_add(table *t, int way, const char *where, const table_cell *cell);
/* As Markdown, on stdout: docs/ways.md. */
void table_print(const table *t, unsigned problems, const subject_plan *plan);
void table_clear(table *t);

#endif
