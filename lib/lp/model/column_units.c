/* column_units.c: see column_units.h. */
#include "lp/model/column_units.h"

#include <string.h>

#include "base/arrays.h"

/* Turns, after which units hardly change. */
#define TURNS 4

typedef struct turn {
    size_t n, m;
    fmb_row_exponents read;
    const void *rows;
    int *unit;              /* [n] */
    int *column, *exponent; /* [n] of a row */
    int *sum, *count;       /* [n] of a column */
} turn;

static fmb_status hold_turn(turn *t, fmb_mem *mem, bool get)
{
    return FMB_ARRAYS_IN_BLOCK(mem, get, FMB_ARRAY(t->column, t->n), FMB_ARRAY(t->exponent, t->n),
                               FMB_ARRAY(t->sum, t->n), FMB_ARRAY(t->count, t->n));
}

static void add_row(turn *t, size_t i)
{
    int size = (int)t->read(t->rows, i, t->column, t->exponent), total = 0;
    if (size < 2)
        return;
    for (int k = 0; k < size; k++)
        total += t->exponent[k] - t->unit[t->column[k]];
    for (int k = 0; k < size; k++) {
        t->sum[t->column[k]] += t->exponent[k] - total / size;
        t->count[t->column[k]]++;
    }
}

static void take_turn(turn *t)
{
    memset(t->sum, 0, t->n * sizeof *t->sum);
    memset(t->count, 0, t->n * sizeof *t->count);
    for (size_t i = 0; i < t->m; i++)
        add_row(t, i);
    for (size_t j = 0; j < t->n; j++)
        t->unit[j] = t->count[j] > 0 ? t->sum[j] / t->count[j] : 0;
}

fmb_status fmb_column_units(fmb_mem *mem, fmb_run *run, size_t n, size_t m, fmb_row_exponents read,
                            const void *rows, int *unit)
{
    turn t = {.n = n, .m = m, .read = read, .rows = rows, .unit = unit};
    if (n == 0)
        return FMB_OK;
    fmb_status st = hold_turn(&t, mem, true);
    for (int k = 0; st == FMB_OK && k < TURNS; k++) {
        take_turn(&t);
        st = fmb_poll_if_limited(run);
    }
    (void)hold_turn(&t, mem, false);
    return st;
}
