/* cuboids.h: pairs of moving cuboids in 3D with small integers, as in the article that the rules
 * were made for; the number of rows that their elimination needs. */
#ifndef FMB_TEST_CUBOIDS_H
#define FMB_TEST_CUBOIDS_H

/* Rows combined until only the time is left, by least pairs: the mean over 100 pairs that meet, the
 * same ones every time. */
double cuboids_rows_made(const char *rules, const char *presolve);

#endif
