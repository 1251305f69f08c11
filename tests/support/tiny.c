/* tiny.c: all tiny systems up to symmetry; see support.h.
 *
 * A row is a code 0..53 = ((a1 + 1) * 3 + (a2 + 1)) * 6 + (b + 1) * 2 + strict, a system a
 * non-decreasing list of codes. Of the images of a list under the 8 symmetries, swaps of the
 * variables and changes of their signs, the smallest represents all.
 */
#include <stdlib.h>

#include "dense.h"
#include "support/must.h"

#define CODES 54

static int code_of(int a1, int a2, int rest)
{
    return ((a1 + 1) * 3 + (a2 + 1)) * 6 + rest;
}

/* Bit 0: change the sign of x1; bit 1: of x2; bit 2: then swap. */
static int image(int code, int symmetry)
{
    int a1 = code / 18 - 1, a2 = code / 6 % 3 - 1, rest = code % 6;
    a1 = symmetry & 1 ? -a1 : a1;
    a2 = symmetry & 2 ? -a2 : a2;
    return symmetry & 4 ? code_of(a2, a1, rest) : code_of(a1, a2, rest);
}

static int by_value(const void *x, const void *y)
{
    return *(const int *)x - *(const int *)y;
}

static bool is_first(const support_tiny *at)
{
    for (int symmetry = 1; symmetry < 8; symmetry++) {
        int other[4] = {0}, k = 0;
        for (int i = 0; i < at->rows; i++)
            other[i] = image(at->row[i], symmetry);
        qsort(other, (size_t)at->rows, sizeof *other, by_value);
        while (k < at->rows && other[k] == at->row[k])
            k++;
        if (k < at->rows && other[k] < at->row[k])
            return false;
    }
    return true;
}

/* The next non-decreasing list; after the last of a length the first of the next. */
static bool advance(support_tiny *at)
{
    int i = at->rows - 1;
    while (i >= 0 && at->row[i] == CODES - 1)
        i--;
    if (i < 0) {
        for (int k = 0; k < 4; k++)
            at->row[k] = 0;
        return ++at->rows <= 4;
    }
    int code = at->row[i] + 1;
    for (; i < at->rows; i++)
        at->row[i] = code;
    return true;
}

fmb_system *support_tiny_next(support_tiny *at)
{
    do {
        if (at->begun && !advance(at))
            return NULL;
        at->begun = true;
    } while (!is_first(at));
    fmb_system *s = NULL;
    must(fmb_system_new(2, NULL, &s));
    for (int i = 0; i < at->rows; i++) {
        int code = at->row[i];
        int64_t a[2] = {code / 18 - 1, code / 6 % 3 - 1};
        must(fmb_system_add_int(s, a, code % 2 ? FMB_LT : FMB_LE, code % 6 / 2 - 1));
    }
    return s;
}
