/* outer_ends.h: ends of variables, each given by a row of a store that names this variable only.
 *
 * Rows with one variable are ends as they are. Any other row bounds one of its variables by the
 * ends of the others; that end becomes a row, too: the combination with the rows of those ends.
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

/* No end is known yet. fmb_ends_clear it, even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_ends_open(fmb_ends *f, fmb_elim *e);
/* Find ends from all rows of e, base rows and derived ones; the rows made here do not become live.
 * Without memory for more rows the ends found so far are kept. If the ends of a variable contradict
 * each other, e->clash names the row that shows it. Errors: MEMORY. */
fmb_status fmb_ends_find(fmb_ends *f);
void fmb_ends_clear(fmb_ends *f);

/* The live row that is tightest on the upper (sign 1) or lower side (-1) of a column, where all
 * other columns have been eliminated; FMB_NO_ROW if none bounds it. An equality bounds both sides.
 * Among equal bounds a strict one is taken. */
uint32_t fmb_end_tightest_row(const fmb_elim *e, int column, int sign);

/* The bound that row v[n + 1], which names that column only, sets: right side over coefficient. */
void fmb_end_of_row(const fmb_vec *v, int n, int column, mpq_t value);

#endif
