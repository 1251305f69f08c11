/* leading_rows.h: a point strictly inside rows of numbers of any length, and which rows are seen
 * from there, by their leading bits.
 *
 * Divide row a.x <= b by a power of two, and round towards 0 to a'.x <= b': no number changes by 1
 * or more. So where b' - a'.x >= 1 + |x_1| + |x_2| + ..., a.x < b is proved; without the 1 where b
 * is 0. Rows of short numbers are multiplied, so that this asks little of them, too. Right sides,
 * and with them points, are measured in a power of two of their own, so that in most rows they are
 * as long as coefficients, and points have coordinates of about 1.
 */
#ifndef FMB_LP_LEADING_ROWS_H
#define FMB_LP_LEADING_ROWS_H

#include "lp/redundancy/active_set/interior_point.h"

typedef struct fmb_leading_rows {
    fmb_mem *mem;
    size_t n, m;                    /* columns, rows so far */
    size_t most_columns, most_rows; /* room */
    size_t *column;                 /* [n] of the rows that are added */
    size_t right;              /* the same of right sides, or SIZE_MAX: they are taken for 0; */
    int unit;                  /* they are divided by 2^unit */
    fmb_lp_row *row;           /* [m] */
    fmb_vec *v;                /* [m] */
    int64_t *entry;            /* [m][n + 1] */
    bool rough;                /* some number was rounded */
    bool possible;             /* to look for a point inside */
    fmb_interior_point inside; /* if a point was found */
} fmb_leading_rows;

/* Room for so many. Whoever adds rows first fills in n, column, right and unit. In any case
 * fmb_leading_rows_close it. Errors: MEMORY, LIMIT. */
fmb_status fmb_leading_rows_open(fmb_leading_rows *t, fmb_mem *mem, size_t most_columns,
                                 size_t most_rows);
void fmb_leading_rows_close(fmb_leading_rows *t);
/* Fill them in for m rows of n columns and a right side: the columns that some of them names.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_leading_rows_measure(fmb_leading_rows *t, size_t n, size_t m, const fmb_lp_row *row);
/* Of a row's coefficients, and of its right side in the unit, the longest has so many bits; INT_MIN
 * if all are 0. */
int fmb_leading_rows_bits(const fmb_leading_rows *t, const fmb_vec *a);
/* a.x <= b or a.x < b. */
void fmb_leading_rows_add(fmb_leading_rows *t, const fmb_vec *a, mpz_t scratch);
/* Is there a point strictly inside? The first call takes a glance, and each a search if that takes
 * no more work (trace/run.h) than patience. *found false: none was found. Errors: MEMORY, LIMIT. */
fmb_status fmb_leading_rows_find_inside(fmb_leading_rows *t, fmb_run *run, double patience,
                                        bool *found);

#endif
