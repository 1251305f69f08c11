/* inside.h: a point strictly inside, and which rows are seen from there. */
#ifndef FMB_LP_INSIDE_H
#define FMB_LP_INSIDE_H

#include "lp/lp.h"

typedef struct fmb_inside {
    fmb_mem *mem;
    size_t n, m;
    const fmb_lp_row *row;
    double *x;      /* [n] the point, exactly */
    int64_t *slack; /* [m] UNIT (b - a.x) > 0 */
    int64_t *way;   /* [n] scratch */
    double *size;   /* [m] 1 / |a| */
} fmb_inside;

/* Look for a point strictly inside all of the rows. *found false: none was found, there are
 * equalities, or the numbers are too large. Errors: MEMORY, LIMIT. In any case fmb_inside_clear it.
 */
fmb_status fmb_inside_find(fmb_inside *p, fmb_run *run, int n, size_t m, const fmb_lp_row *row,
                           bool *found);
void fmb_inside_clear(fmb_inside *p);
/* The row among those not gone that a ray from the point in direction way[n] (roughly) meets before
 * any other: it is irredundant. SIZE_MAX: it meets several at once, or none. Exact. */
size_t fmb_inside_shoot(const fmb_inside *p, const double *way, const bool *gone);

#endif
