/* box.h: the box that rows with one variable make, and what it says about other rows. */
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
    int bits; /* of every end and of unit */
    bool any; /* there is an end */
} fmb_box_rows;

/* Make the box of the live rows; with it go rows with one variable that another one implies. */
fmb_status fmb_box_make(struct fmb_elim *e);

/* The sign of the least of b - a.x over the box; -1 also if it is open where it matters. */
int fmb_box_slack(const struct fmb_elim *e, const struct fmb_derived *r);
/* Does no point of the box satisfy the row? */
bool fmb_box_refutes(const struct fmb_elim *e, const struct fmb_derived *r);

#endif
