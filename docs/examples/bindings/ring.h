/* ring.h: the data of rows.c and rows.cpp, a matrix of compressed rows as a program of yours has
 * it, and the variables of its projection. Row i says that a variable is at most b beyond the next
 * one in a ring; the right side of the last row is an argument. */
#include <stdlib.h>

enum { ROWS = 20000, DIM = 100 };

static const int kept[] = {0, DIM / 2, DIM - 1};
static size_t start[ROWS + 1];
static int var[2 * ROWS];
static double coef[2 * ROWS], b[ROWS];

static void make_ring(int argc, char **argv)
{
    for (int i = 0; i < ROWS; i++) {
        start[i + 1] = 2 * (size_t)i + 2;
        var[2 * i] = i % DIM;
        var[2 * i + 1] = (i + 1) % DIM;
        coef[2 * i] = 1;
        coef[2 * i + 1] = -1;
        b[i] = i < DIM - 1 ? 0 : i;
    }
    b[ROWS - 1] = argc > 1 ? atof(argv[1]) : 5;
}
