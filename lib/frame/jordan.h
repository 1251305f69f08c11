/* jordan.h: Gauss and Jordan's elimination in whole numbers. */
#ifndef FMB_FRAME_JORDAN_H
#define FMB_FRAME_JORDAN_H

#include <gmp.h>

#include "trace/run.h"

/* Combine the rows of cell, [rows][width], until its first n columns are *det times the first n
 * unit vectors, det > 0. run: whose limits hold, or NULL. Errors: ARG (those columns are
 * dependent), LIMIT; cell is then anything. */
fmb_status fmb_jordan(mpz_t *cell, int rows, int width, int n, mpz_t det, fmb_run *run);

#endif
