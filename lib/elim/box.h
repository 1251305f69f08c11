/* box.h: the box that rows with one variable make, and what it says about other rows.
 *
 * Where variables have one end only, a row that bounds their sum (as of a simplex, x >= 0, sum x <=
 * 1) takes the place of the other ends.
 */
#ifndef FMB_ELIM_BOX_H
#define FMB_ELIM_BOX_H

#include <fmb/base.h>

struct fmb_elim;
struct fmb_derived;

/* Ends are multiples of 1 / unit, so that a row is compared in integers. */
typedef struct fmb_box_rows {
    uint32_t *row[2]; /* [side][n]: the row that makes the end, FMB_NO_ROW where there is none */
    int64_t *end[2];  /* [side][n]: unit times the end */
    int64_t unit;
    int bits;        /* of every end, of unit and of room */
    bool any;        /* there is an end */
    uint32_t budget; /* a base row sum s_j x_j <= c over variables with an end where s_j x_j is
                        least, some without the other one; FMB_NO_ROW: there is none */
    int64_t room;    /* unit times (c - the least of sum s_j x_j) >= 0 */
    uint64_t *hard;  /* [words] base rows that make the ends and the budget */
} fmb_box_rows;

/* The only column of the row, or -1. */
int fmb_elim_single_column(const struct fmb_elim *e, const struct fmb_derived *r);

/* Make the box of the live rows; with it go rows with one variable that another one implies. */
fmb_status fmb_box_make(struct fmb_elim *e);

/* Note which rows of the base make the box: histories are about to start. */
fmb_status fmb_box_mark(struct fmb_elim *e);

/* The sign of the least of b - a.x over the box; -1 also if it is open where it matters, or if the
 * row itself makes the box, or is made of nothing but rows of a box with a budget. */
int fmb_box_slack(const struct fmb_elim *e, const struct fmb_derived *r);
/* Does no point of the box satisfy the row? */
bool fmb_box_refutes(const struct fmb_elim *e, const struct fmb_derived *r);

#endif
