/* near_jordan.h: the inverse of a small matrix in doubles, by Gauss-Jordan elimination, with
 * rounding errors; jordan.h is exact. */
#ifndef FMB_FRAME_NEAR_JORDAN_H
#define FMB_FRAME_NEAR_JORDAN_H

#include <math.h>
#include <stdbool.h>

enum { FMB_NEAR_JORDAN_MOST = 8 }; /* the most rows */

/* Exchange the rows `from` and `to` of a. */
static inline void fmb_near_exchange_rows(int n, double (*a)[FMB_NEAR_JORDAN_MOST], int from,
                                          int to)
{
    for (int i = 0; from != to && i < n; i++) {
        double x = a[from][i];
        a[from][i] = a[to][i];
        a[to][i] = x;
    }
}

static inline void fmb_near_exchange_columns(int n, double (*a)[FMB_NEAR_JORDAN_MOST], int from,
                                             int to)
{
    for (int i = 0; from != to && i < n; i++) {
        double x = a[i][from];
        a[i][from] = a[i][to];
        a[i][to] = x;
    }
}

static inline void fmb_near_eliminate_column(int n, double (*a)[FMB_NEAR_JORDAN_MOST], int k)
{
    double pivot = 1 / a[k][k];
    a[k][k] = 1;
    for (int j = 0; j < n; j++)
        a[k][j] *= pivot;
    for (int i = 0; i < n; i++) {
        double by = a[i][k];
        if (i == k || by == 0)
            continue;
        a[i][k] = 0;
        for (int j = 0; j < n; j++)
            a[i][j] -= by * a[k][j];
    }
}

/* Invert a in place, with the largest entry of each column as its pivot. False: a column is 0. */
static inline bool fmb_near_invert(int n, double (*a)[FMB_NEAR_JORDAN_MOST])
{
    int from[FMB_NEAR_JORDAN_MOST];
    for (int k = 0; k < n; k++) {
        from[k] = k;
        for (int i = k + 1; i < n; i++)
            from[k] = fabs(a[i][k]) > fabs(a[from[k]][k]) ? i : from[k];
        if (!(fabs(a[from[k]][k]) > 0))
            return false;
        fmb_near_exchange_rows(n, a, from[k], k);
        fmb_near_eliminate_column(n, a, k);
    }
    for (int k = n - 1; k >= 0; k--)
        fmb_near_exchange_columns(n, a, from[k], k);
    return true;
}

#endif
