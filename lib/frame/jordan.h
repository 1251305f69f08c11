/* jordan.h: Gauss and Jordan's elimination in whole numbers. */
#ifndef FMB_FRAME_JORDAN_H
#define FMB_FRAME_JORDAN_H

#include <gmp.h>
#include <stdbool.h>

/* Combine the rows of cell, [rows][width], until its first n columns are *det times the first n
 * unit vectors, det > 0. False if those columns are dependent; cell is then anything. */
bool fmb_jordan(mpz_t *cell, int rows, int width, int n, mpz_t det);

#endif
