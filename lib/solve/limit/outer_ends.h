/* outer_ends.h: ends of variables, each a row of a store that names its variable only.
 *
 * Rows with one variable are ends as they are. Another row bounds one of its variables by the ends
 * of the others; that end is made as a row, too: the combination with the rows of the others.
 * Repeated a few times, within a budget of work. Source: Davis, Constraint propagation with
 * interval labels, 1987.
 */
#ifndef FMB_SOLVE_LIMIT_OUTER_ENDS_H
#define FMB_SOLVE_LIMIT_OUTER_ENDS_H

#include "elim/round/elim.h"

typedef struct fmb_ends {
    fmb_elim *e;
    uint32_t *row[2]; /* [side][n]: FMB_NO_ROW where no end is known; an equality is both ends */
    mpq_t *value[2];  /* [side][n]: of the row */
    size_t work;      /* entries that may still be looked at */
} fmb_ends;

/* No ends yet; in any case fmb_ends_clear. Errors: MEMORY, LIMIT. */
fmb_status fmb_ends_open(fmb_ends *f, fmb_elim *e);
/* Find ends by all rows of e, base rows and others; rows made for it are not alive. Where there is
 * no memory for more, the ends are those so far. If the ends of a variable contradict each other,
 * e->clash says so. Errors: MEMORY. */
fmb_status fmb_ends_find(fmb_ends *f);
void fmb_ends_clear(fmb_ends *f);

/* The live row that is tightest on the upper (sign 1) or lower side (-1) of a column, all others
 * being gone; FMB_NO_ROW if none bounds it. A row that is an equality bounds both sides. Of equal
 * bounds a strict one counts. */
uint32_t fmb_end_tightest_row(const fmb_elim *e, int column, int sign);

/* What row v[n + 1], which names that column only, bounds it by: right side over coefficient. */
void fmb_end_of_row(const fmb_vec *v, int n, int column, mpq_t value);

#endif
