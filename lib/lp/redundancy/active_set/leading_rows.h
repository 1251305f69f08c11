/* leading_rows.h: a point strictly inside rows of numbers of any length, and which rows are seen
 * from there, by their leading bits.
 *
 * Divide row a.x <= b by a power of two, and round towards 0 to a'.x <= b': no number changes by 1
 * or more. So where b' - a'.x >= 1 + |x_1| + |x_2| + ..., a.x < b is proved; without the 1 where b
 * is 0. Rows of short numbers are multiplied, so that this asks little of them, too. Columns, and
 * right sides, are divided by powers of two of their own: so entries of most rows are about as
 * long, and points have coordinates of about 1, whatever the units of variables and rows.
 */
#ifndef FMB_LP_LEADING_ROWS_H
#define FMB_LP_LEADING_ROWS_H

#include "lp/redundancy/active_set/interior_point.h"

typedef struct fmb_leading_rows {
    fmb_mem *mem;
    size_t n, m;                    /* columns, rows so far */
    size_t most_columns, most_rows; /* room */
    size_t *column;                 /* [n] of the rows that are added */
    size_t right;                   /* the same of right sides, or SIZE_MAX: they are taken for 0 */
    int *shift;                     /* [n + 1] columns, last that of right sides, are divided by
                                       2^shift */
    fmb_lp_row *row;                /* [m] */
    fmb_vec *v;                     /* [m] */
    int64_t *entry;                 /* [m][n + 1] */
    bool rough;                     /* some number was rounded */
    bool possible;                  /* to look for a point inside */
    fmb_interior_point inside;      /* if a point was found */
} fmb_leading_rows;

/* Room for so many. Whoever adds rows first lists columns, and may have units chosen. In any case
 * fmb_leading_rows_close it. Errors: MEMORY, LIMIT. */
fmb_status fmb_leading_rows_open(fmb_leading_rows *t, fmb_mem *mem, size_t most_columns,
                                 size_t most_rows);
void fmb_leading_rows_close(fmb_leading_rows *t);
/* Those of m rows of n columns and a right side that some row names. */
void fmb_leading_rows_list_columns(fmb_leading_rows *t, size_t n, size_t m, const fmb_lp_row *row);
/* The units of the columns listed that fit such rows. Errors: MEMORY, LIMIT. */
fmb_status fmb_leading_rows_choose_units(fmb_leading_rows *t, size_t m, const fmb_lp_row *row);
/* Of a row's numbers in the units of their columns, the longest has so many bits; INT_MIN if all
 * are 0. */
int fmb_leading_rows_bits(const fmb_leading_rows *t, const fmb_vec *a);
/* a.x <= b or a.x < b. */
void fmb_leading_rows_add(fmb_leading_rows *t, const fmb_vec *a, mpz_t scratch);
/* Is there a point strictly inside? The first call takes a glance, and each a search if that takes
 * no more work (trace/run.h) than patience. *found false: none was found. Errors: MEMORY, LIMIT. */
fmb_status fmb_leading_rows_find_inside(fmb_leading_rows *t, fmb_run *run, double patience,
                                        bool *found);

#endif
