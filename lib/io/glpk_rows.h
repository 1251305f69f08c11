/* glpk_rows.h: rows from a problem that GLPK has read. */
#ifndef FMB_IO_GLPK_ROWS_H
#define FMB_IO_GLPK_ROWS_H

#include <glpk.h>

#include "io/glpk_decimals.h"

/* Bounds of this size mean infinity, as in most programs that write such files. */
#define FMB_GLPK_INFINITY 1e30

/* Variables and rows of p into s, with the numbers as the text has them. ranges (NULL: none) is the
 * same problem with the ranges as right sides. Errors: MEMORY, PARSE. */
fmb_status fmb_glpk_rows(fmb_cursor *c, fmb_decimals *numbers, glp_prob *p, glp_prob *ranges,
                         fmb_system *s);

#endif
