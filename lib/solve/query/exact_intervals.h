/* exact_intervals.h: the layout of an fmb_box, exact intervals of some variables. */
#ifndef FMB_SOLVE_EXACT_INTERVALS_H
#define FMB_SOLVE_EXACT_INTERVALS_H

#include <fmb/gmp.h>

#include "base/mem.h"

typedef struct fmb_exact_side {
    fmb_end_kind kind;
    bool attained;
    mpq_t value; /* if finite or outer */
} fmb_exact_side;

struct fmb_box {
    fmb_mem mem;
    int size;
    int *var;                  /* [size] */
    fmb_exact_side (*side)[2]; /* [size] by fmb_side */
};

/* The end as a double, rounded outward. Below: does it have a value? */
fmb_end fmb_exact_side_end(const fmb_exact_side *e, fmb_side side);
bool fmb_exact_side_has_value(const fmb_exact_side *e);
/* The end rounded to the nearest double, infinite where it has no value. Below: as text, "" where e
 * is NULL or has no value. */
double fmb_exact_side_nearest(const fmb_exact_side *e, fmb_side side);
size_t fmb_exact_side_print(const fmb_exact_side *e, char *text, size_t size);

/* [give] size intervals, all ends unknown, over var[0..size), or over 0, 1, ... if var is NULL. */
fmb_status fmb_box_new(const int *var, int size, const fmb_alloc *hook, fmb_box **out);

#endif
