/* three.h: all systems of 3 variables and 4 rows over {-1, 0, 1}, relations <= and <, up to
 * symmetry: the order of rows, the order of variables, and x -> -x of each variable do not count.
 * The same row may come twice, and rows may be constant, so that fewer rows are in there, too. */
#ifndef FMB_TEST_THREE_H
#define FMB_TEST_THREE_H

#include <fmb/system.h>

/* Four rows by their codes, non-decreasing. */
typedef struct three {
    uint8_t row[4];
} three;

/* All of them; the caller frees the array. */
three *three_all(size_t *count);
fmb_system *three_system(three t);

#endif
