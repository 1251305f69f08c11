/* prove.c: proofs of guesses.
 *
 * u = 2^-53 below; a sum of n products is off by at most n u (1 + n u) times the sum of their
 * absolute values, which is itself summed up, and that sum is off by as small a share. Counting
 * each u twice covers all terms of higher order. What underflows is off by 2^-1074 at most each
 * time; as there are less than 2^14 operations on numbers below 2^10, or with R below 2^501, 2^-500
 * covers all of it.
 */
#include "pair/general/workspace.h"

#include <float.h>
#include <math.h>

#define UNDERFLOW 0x1p-500

/* ---- apart ----------------------------------------------------------------------------------- */

/* *size += sum |a_i b_i| */
static double dot_with_size(const double *a, const double *b, int n, double *size)
{
    double sum = 0, all = 0;
    for (int i = 0; i < n; i++) {
        sum += a[i] * b[i];
        all += fabs(a[i] * b[i]);
    }
    *size += all;
    return sum;
}

/* Over all z in their places, w (M z - h) lies between the sums of least and of greatest w m_j z_j,
 * less w h; where 0 does not, M z = h is impossible. Any w proves it, so it does not matter how it
 * was found.
 *
 * Errors: an entry of M or h is off by u of itself, its product with w_i by u more, and goes
 * through at most dim sums, the result through columns + 3. All that times size, the sum of the
 * absolute products; which end of its place a z takes changes nothing, as least and greatest are
 * off by no more than what they are taken of. If w has a NaN so has w h, and both comparisons fail.
 */
bool fmb_general_are_apart(const fmb_general_system *s, const double *direction)
{
    double w[FMB_GENERAL_MOST_ROWS], largest = 0, size = 0;
    double low[FMB_GENERAL_KINDS] = {0}, high[FMB_GENERAL_KINDS] = {0};
    for (int i = 0; i < s->rows; i++)
        largest = fmax(largest, fabs(direction[i]));
    for (int i = 0; i < s->rows; i++)
        w[i] = direction[i] / largest;
    for (int j = 0; j < s->columns; j++) {
        double d = dot_with_size(w, s->m + j * s->rows, s->rows, &size);
        fmb_general_kind kind = s->kind[j];
        bool is_unit = kind == FMB_GENERAL_UNIT;
        low[kind] = is_unit ? low[kind] + fmin(d, 0) : fmin(low[kind], d);
        high[kind] = is_unit ? high[kind] + fmax(d, 0) : fmax(high[kind], d);
    }
    double b = dot_with_size(w, s->h, s->rows, &size);
    double error = (s->rows + s->columns + 8) * DBL_EPSILON * size + UNDERFLOW;
    return b - (high[0] + high[1] + high[2]) > error || low[0] + low[1] + low[2] - b > error;
}

/* ---- together --------------------------------------------------------------------------------
 *
 * With P the columns of the pivots, let y solve (P R) y = h - M z. Then z + R y (added to the
 * pivots) is a solution. Let E = I - P R, e_i the sum of |E_ij| over j, and all e_i < 1/2: then y
 * is there, |y_i| <= |rest_i| + e_i 2 max |rest_j|, rest = h - M z. If no z leaves its place when
 * moved by |R| |y|, the solution is strictly inside both frames.
 */

/* |rest_i| plus its error bound: each product has errors u of its entry, u of itself, and u of each
 * of the at most `columns` sums. */
static void bound_rest(const fmb_general_system *s, const double *z, double *rest)
{
    double size[FMB_GENERAL_MOST_ROWS];
    for (int i = 0; i < s->rows; i++) {
        rest[i] = s->h[i];
        size[i] = fabs(s->h[i]);
    }
    for (int j = 0; j < s->columns; j++)
        for (int i = 0; i < s->rows; i++) {
            double product = s->m[j * s->rows + i] * z[j];
            rest[i] -= product;
            size[i] += fabs(product);
        }
    for (int i = 0; i < s->rows; i++)
        rest[i] = fabs(rest[i]) + (s->columns + 8) * DBL_EPSILON * size[i] + UNDERFLOW;
}

/* e_i. Each E_ij, a sum of dim products and 1 or 0, errs by at most (dim + 3) u times their
 * absolute values; what is added covers this for all j, and the rounding of the bound itself. */
static double bound_defect(const fmb_general_system *s, int i)
{
    double defect[FMB_GENERAL_MOST_ROWS] = {0}, size = 1, sum = 0;
    defect[i] = -1;
    for (int k = 0; k < s->rows; k++) {
        const double *r = fmb_general_inverse(s, k);
        double p = s->m[s->pivot[k] * s->rows + i];
        for (int j = 0; j < s->rows; j++) {
            defect[j] += p * r[j];
            size += fabs(p * r[j]);
        }
    }
    for (int j = 0; j < s->rows; j++)
        sum += fabs(defect[j]);
    return sum + (s->rows * s->rows + 8) * DBL_EPSILON * size;
}

static bool is_inverse_moderate(const fmb_general_system *s)
{
    bool good = true;
    for (int i = 0; i < s->rows; i++)
        for (int j = 0; j < s->rows; j++)
            good &= fabs(fmb_general_inverse(s, i)[j]) < 0x1p500;
    return good;
}

static bool bound_y(const fmb_general_system *s, const double *z, double *y)
{
    double largest = 0;
    bool good = is_inverse_moderate(s);
    bound_rest(s, z, y);
    for (int i = 0; i < s->rows; i++)
        largest = fmax(largest, y[i]);
    for (int i = 0; good && i < s->rows; i++) {
        double e = bound_defect(s, i);
        good = e < 0.5;
        y[i] += e * 2 * largest;
    }
    return good;
}

/* A bound of the distance of each unknown from the solution, including the errors of the sums. */
static void bound_way(const fmb_general_system *s, const double *y, double *way)
{
    for (int j = 0; j < s->columns; j++)
        way[j] = 0;
    for (int i = 0; i < s->rows; i++) {
        const double *r = fmb_general_inverse(s, i);
        double sum = 0;
        for (int j = 0; j < s->rows; j++)
            sum += fabs(r[j]) * y[j];
        way[s->pivot[i]] = sum * (1 + (s->rows + 8) * DBL_EPSILON) + UNDERFLOW;
    }
}

/* z > way is an exact comparison; 1 - z has a relative error of u, less than the margin on way. */
static bool stays_inside_places(const fmb_general_system *s, const double *z, const double *way)
{
    bool good = true;
    for (int j = 0; j < s->columns; j++) {
        good &= z[j] > way[j];
        if (s->kind[j] == FMB_GENERAL_UNIT)
            good &= 1 - z[j] > way[j] * (1 + 8 * DBL_EPSILON);
    }
    return good;
}

bool fmb_general_is_near_common(const fmb_general_system *s, const double *z)
{
    double y[FMB_GENERAL_MOST_ROWS], way[FMB_GENERAL_MOST_COLUMNS];
    if (!bound_y(s, z, y))
        return false;
    bound_way(s, y, way);
    return stays_inside_places(s, z, way);
}

/* Only the pivots move; other unknowns stay at their bounds. Summed unknowns are at most 1, as none
 * of the others in the sum is negative. */
bool fmb_general_is_near_vertex(const fmb_general_system *s, const double *z)
{
    double y[FMB_GENERAL_MOST_ROWS], way[FMB_GENERAL_MOST_COLUMNS];
    bool good = bound_y(s, z, y);
    if (good)
        bound_way(s, y, way);
    for (int j = 0; good && j < s->columns; j++) {
        bool is_unit = s->kind[j] == FMB_GENERAL_UNIT;
        bool is_below = !is_unit || 1 - z[j] > way[j] * (1 + 8 * DBL_EPSILON);
        good = s->is_pivot[j] ? z[j] > way[j] && is_below : z[j] == 0 || (is_unit && z[j] == 1);
    }
    return good;
}

/* ---- ends ------------------------------------------------------------------------------------
 *
 * For any y, cost z = y h + (cost - y M) z where M z = h; so it is at most y h + the sum of all
 * positive d_j = cost_j - y m_j. At the vertex, where unknowns that are no pivots are at an end, it
 * is y h + the d_j of the high ones, and of the pivots something between their negative and
 * positive parts.
 *
 * Errors: d_j is off by (rows + 4) u times the absolute values it is made of (counted as above, but
 * once, with 2 u to spare for higher orders); y h likewise.
 */

bool fmb_general_bound_cost(const fmb_general *g, const double *cost, const double *y, double *most,
                            double *gap)
{
    const fmb_general_system *s = &g->program;
    const double each = (s->rows + 4) * 0x1p-53, all = (s->columns + 6) * DBL_EPSILON;
    double size = 0, b = dot_with_size(y, s->h, s->rows, &size), off = each * size, sum = 0,
           loss = 2 * off;
    bool good = true;
    for (int i = 0; i < s->rows; i++)
        good &= fabs(y[i]) < 0x1p500;
    for (int j = 0; j < s->columns; j++) {
        double part = fabs(cost[j]),
               d = cost[j] - dot_with_size(y, s->m + j * s->rows, s->rows, &part);
        double up = fmax(d + each * part, 0), down = d - each * part;
        if (s->is_pivot[j])
            loss += up - fmin(down, 0);
        else
            loss += g->basis.is_high[j] ? up - down : up;
        sum += up;
    }
    double rounding = all * (fabs(b) + sum) + UNDERFLOW;
    *most = b + off + sum + rounding;
    *gap = loss * (1 + all) + 2 * rounding;
    return good;
}
