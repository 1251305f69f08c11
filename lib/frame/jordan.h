/* jordan.h: fraction-free Gauss-Jordan elimination in integers. */
#ifndef FMB_FRAME_JORDAN_H
#define FMB_FRAME_JORDAN_H

#include <gmp.h>

#include "trace/run.h"

/* Combine the rows of cell, [rows][width], until its first n columns are det times the first n unit
 * vectors, det > 0. run: its limits apply; or NULL. Errors: ARG (these columns are linearly
 * dependent), LIMIT; cell is then undefined. */
fmb_status fmb_jordan(mpz_t *cell, int rows, int width, int n, mpz_t det, fmb_run *run);

#endif
