/* rows.h: build one system from the rows of another, through the public API only. */
#ifndef FMB_TEST_ROWS_H
#define FMB_TEST_ROWS_H

#include <stdio.h>

#include <fmb/gmp.h>

#include "support/must.h"

/* What becomes of a row a.x REL b on its way. */
typedef enum row_change {
    ROW_SAME,
    ROW_BELOW, /* a.x < b: what an inequality <= leaves if it is not an equality; half of "not =" */
    ROW_ABOVE, /* a.x > b: not <=; the other half of "not =" */
    ROW_REACHED, /* a.x >= b: not < */
} row_change;

/* A system of that dimension without rows. */
fmb_system *rows_none(int dim);

/* Append row i of from, changed, to to. map[j] is the variable of to that stands for variable j of
 * from; NULL means the same one. */
void rows_append(fmb_system *to, const fmb_system *from, size_t i, row_change change,
                 const int *map);
/* All rows but one (SIZE_MAX: but none), unchanged. */
void rows_append_but(fmb_system *to, const fmb_system *from, size_t but, const int *map);

/* s without its row but, and with row i of from changed: rows_with(s, SIZE_MAX, s, i, ROW_ABOVE,
 * NULL) asks whether a row is implied. The caller frees it. */
fmb_system *rows_with(const fmb_system *s, size_t but, const fmb_system *from, size_t i,
                      row_change change, const int *map);

/* The same row, term for term. */
bool rows_equal(const fmb_system *a, size_t i, const fmb_system *b, size_t k);

/* The same rows in the same order. */
bool rows_all_equal(const fmb_system *a, const fmb_system *b);

/* Print s as .fmb text. */
void rows_print(const fmb_system *s, FILE *out);

#endif
