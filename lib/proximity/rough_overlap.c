/* rough_overlap.c: bounds in doubles for the overlap along a normal; see normal_search.h.
 *
 * Gaussian elimination. X has a row for each coordinate; its columns are the vectors of M (axes,
 * drift, difference of the origins) and then those of the unit matrix. A chosen direction v is one
 * column or a difference of two: its pivot row p, where |v| is largest, clears v in the other rows,
 * and is dropped. After D - 1 directions one row is left. It is a combination of the rows of X that
 * is 0 on all chosen directions: so its numbers in the columns of the unit matrix are a normal, and
 * those in the columns of vectors are their products with this normal. Rows and columns are scaled
 * by powers of 2 so that no number exceeds 1; what divides a coordinate multiplies the normal's.
 *
 * Errors. Let u = 2^-52. In each row `most` bounds the numbers, and `off` their errors; the numbers
 * v_r of a direction have errors of at most f_r. Row r loses m = v_r / v_p times row p, |m| <= 1.
 * With v' and m' the exact values of v and m,
 *
 *     |m - m'| <= |v_r v_p' - v_r' v_p| / |v_p v_p'| + u <= (f_r + |m| f_p) / (|v_p| - f_p) + u.
 *
 * Hence the error of x_r - m x_p is at most off_r + |m| off_p + |m - m'| (most_p + off_p), plus
 * u (most_r + 2 |m| most_p) for rounding, plus underflow. FMB_NORMAL_ROUNDING is 2 u: the second u
 * is far more than the rounding of these bounds themselves. If |v_p| > f_p then v_p' is not 0, and
 * the direction is independent of those chosen before it.
 */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "proximity/normal_search.h"

#define FMB_NORMAL_ROUNDING 0x1p-51
#define ABOVE               (1 + 0x1p-40)
#define BELOW               (1 - 0x1p-40)
#define LEAST               0x1p-1000 /* far above any underflow */

enum {
    MOST = FMB_NORMALS_MOST_DIM,
    DRIFT = 2 * MOST,
    AWAY,
    VECTORS, /* columns of vectors; those of coordinates follow */
    LONGEST =
        900 /* exponent of the largest length of a vector: far smaller ones do not underflow */
};

/* ---- numbers --------------------------------------------------------------------------------- */

/* Divide a direction by the largest power of 2 that divides all its numbers. */
static void shorten(fmb_normal_search *x, fmb_normal_direction *d)
{
    mpz_set_ui(x->t, 0);
    for (int j = 0; j < x->m->dim; j++)
        mpz_ior(x->t, x->t, d->exact[j]);
    d->power = mpz_sgn(x->t) == 0 ? 0 : mpz_scan1(x->t, 0);
    for (int j = 0; j < x->m->dim; j++)
        mpz_tdiv_q_2exp(d->exact[j], d->exact[j], d->power);
}

/* 0 on underflow, infinity on overflow */
static double power_of_two(long exponent)
{
    return exponent < -1100 ? 0 : exponent > 1023 ? INFINITY : ldexp(1, (int)exponent);
}

/* The number x 2^power; x = 0 for 0, whatever the power. */
typedef struct mantissa {
    double x;
    long power;
} mantissa;

static void read_vector(const fmb_normal_search *x, mpz_t *v, mp_bitcnt_t power,
                        mantissa row[MOST][VECTORS], int column)
{
    for (int j = 0; j < x->m->dim; j++) {
        row[j][column].x = mpz_get_d_2exp(&row[j][column].power, v[j]);
        row[j][column].power += (long)power;
    }
}

static void read_vectors(fmb_normal_search *x, mantissa row[MOST][VECTORS])
{
    for (int i = 0; i < x->directions; i++) {
        fmb_normal_direction *d = &x->direction[i];
        int first = d->side * MOST;
        shorten(x, d);
        d->from = d->group == 0 ? -1 : first + d->group - 1;
        d->to = first + d->end - 1;
        if (d->group == 0)
            read_vector(x, d->exact, d->power, row, d->to);
    }
    read_vector(x, x->away, 0, row, AWAY);
}

/* The largest power of n numbers that are `step` apart. */
static long top_power(const mantissa *x, int n, int step)
{
    long top = LONG_MIN;
    for (int i = 0; i < n; i++)
        top = x[i * step].x != 0 && x[i * step].power > top ? x[i * step].power : top;
    return top == LONG_MIN ? 0 : top;
}

/* Scale rows, by the columns of directions only. */
static void scale_rows(fmb_normal_search *x, mantissa row[MOST][VECTORS])
{
    long top[MOST], finest = LONG_MAX;
    for (int j = 0; j < x->m->dim; j++) {
        top[j] = top_power(row[j], AWAY, 1);
        for (int c = 0; c < VECTORS; c++)
            row[j][c].power -= top[j];
        top[j] += (long)x->unit[j];
        finest = top[j] < finest ? top[j] : finest;
        x->coarsest = x->unit[j] > x->coarsest ? x->unit[j] : x->coarsest;
    }
    for (int j = 0; j < x->m->dim; j++)
        x->share[j] = power_of_two(finest - top[j]);
    x->scale += finest;
}

static void scale_columns(fmb_normal_search *x, mantissa row[MOST][VECTORS])
{
    long power[VECTORS], top = LONG_MIN;
    for (int c = 0; c < VECTORS; c++) {
        power[c] = top_power(&row[0][c], x->m->dim, VECTORS);
        top = power[c] > top ? power[c] : top;
    }
    x->scale += top - LONGEST;
    for (int c = 0; c < VECTORS; c++) {
        x->length[c] = power_of_two(power[c] - top + LONGEST);
        for (int j = 0; j < x->m->dim; j++)
            x->rest[0].x[j][c] =
                row[j][c].x == 0 ? 0 : row[j][c].x * power_of_two(row[j][c].power - power[c]);
    }
}

void fmb_normal_search_scale(fmb_normal_search *x)
{
    mantissa row[MOST][VECTORS] = {0};
    fmb_normal_rest *rest = &x->rest[0];
    read_vectors(x, row);
    scale_rows(x, row);
    scale_columns(x, row);
    for (int j = 0; j < x->m->dim; j++) {
        for (int c = 0; c < MOST; c++)
            rest->x[j][VECTORS + c] = c == j;
        rest->most[j] = 1;
        rest->off[j] = FMB_NORMAL_ROUNDING;
    }
}

void fmb_normal_search_take(fmb_normal_search *x, const fmb_least_overlap *least)
{
    long power, half;
    double overlap = mpz_get_d_2exp(&power, least->overlap);
    double size = mpz_get_d_2exp(&half, least->size);
    if (x->norm == FMB_NORM_EUCLIDEAN) {
        size = sqrt(half & 1 ? 2 * size : size);
        half = (half - (half & 1)) / 2;
    }
    double best = overlap / size * power_of_two(power - half - x->scale);
    x->best = (fmb_normal_bounds){best * BELOW - LEAST, best * ABOVE + LEAST};
}

/* ---- directions ------------------------------------------------------------------------------ */

/* The numbers of direction d in the rows left after `chosen` ones, and bounds of their errors. */
static void find_direction(const fmb_normal_search *x, int chosen, const fmb_normal_direction *d,
                           double *v, double *off)
{
    const fmb_normal_rest *rest = &x->rest[chosen];
    bool edge = d->from >= 0;
    int from = edge ? d->from : d->to;
    double longer = x->length[d->to] > x->length[from] ? x->length[d->to] : x->length[from];
    double plus = edge ? x->length[d->to] / longer : 1, minus = edge ? x->length[from] / longer : 0;
    for (int r = 0; r < x->m->dim - chosen; r++) {
        v[r] = plus * rest->x[r][d->to] - minus * rest->x[r][from];
        off[r] = edge ? 2 * rest->off[r] + FMB_NORMAL_ROUNDING * 2 * rest->most[r] : rest->off[r];
    }
}

static void clear_row(double *restrict to, const double *row, const double *pivot, double times)
{
    for (int c = 0; c < FMB_NORMAL_COLUMNS; c++)
        to[c] = row[c] - times * pivot[c];
}

bool fmb_normal_is_independent(fmb_normal_search *x, int chosen)
{
    const fmb_normal_rest *old = &x->rest[chosen];
    fmb_normal_rest *rest = &x->rest[chosen + 1];
    double v[MOST] = {0}, off[MOST] = {0};
    int p = 0, rows = x->m->dim - chosen;
    find_direction(x, chosen, &x->direction[x->chosen[chosen]], v, off);
    for (int r = 1; r < rows; r++)
        p = fabs(v[r]) > fabs(v[p]) ? r : p;
    double sure = fabs(v[p]) - off[p];
    if (!(sure > 0x1p-40 * off[p]))
        return false;
    double inverse = 1 / sure;
    for (int r = 0, to = 0; r < rows; r++) {
        if (r == p)
            continue;
        double times = v[r] / v[p], size = fabs(times);
        double wrong = (off[r] + size * off[p]) * inverse + FMB_NORMAL_ROUNDING;
        clear_row(rest->x[to], old->x[r], old->x[p], times);
        rest->most[to] = old->most[r] + size * old->most[p] + LEAST;
        rest->off[to] = old->off[r] + size * old->off[p] + wrong * (old->most[p] + old->off[p]) +
                        FMB_NORMAL_ROUNDING * 2 * rest->most[to];
        to++;
    }
    return true;
}

/* ---- overlaps -------------------------------------------------------------------------------- */

typedef double two __attribute__((vector_size(16)));
typedef int64_t two_words __attribute__((vector_size(16)));

static two larger(two a, two b)
{
    two_words first = a > b;
    return (two)((first & (two_words)a) | (~first & (two_words)b));
}

/* What the columns of one frame, at y and `length`, contribute along sign times the normal: each
 * product is increased by `off`, and counts as 0 if it is negative then; a cuboid has the sum of
 * these, a simplex the largest.
 */
static double end_of(const double *y, const double *length, bool simplex, double sign, double off)
{
    two sum = {0, 0}, most = {0, 0}, at, size;
    for (int c = 0; c < MOST; c += 2) {
        memcpy(&at, y + c, sizeof at);
        memcpy(&size, length + c, sizeof size);
        at = larger((at * sign + off) * size, (two){0, 0});
        sum += at;
        most = larger(at, most);
    }
    return simplex ? (most[0] > most[1] ? most[0] : most[1]) : sum[0] + sum[1];
}

/* A bound, upper (up = 1) or lower (-1), of how far M reaches along sign times the normal: products
 * are moved by their error bounds, and negative ones count as 0; so columns that surely point back,
 * or are absent, add no error. Fewer than 20 numbers are summed.
 */
static double reach_of(const fmb_normal_search *x, double sign, double up)
{
    const double *y = x->rest[x->m->dim - 1].x[0], *length = x->length;
    double off = up * x->rest[x->m->dim - 1].off[0], end = (sign * y[DRIFT] + off) * length[DRIFT];
    double away = (sign * y[AWAY] + off) * length[AWAY];
    end = end > 0 ? end : 0;
    for (int k = 0; k < 2; k++)
        end += end_of(y + k * MOST, length + k * MOST, x->of[k].simplex, sign, off);
    return end + away + up * (32 * FMB_NORMAL_ROUNDING * (end + fabs(away)) + LEAST);
}

/* An upper (up = 1) or lower (-1) bound of the size of the normal. One share is 1, and `off` is at
 * least 2^-51: squares that underflow are negligible in the upper bound. */
static double size_of(const fmb_normal_search *x, double up)
{
    const fmb_normal_rest *rest = &x->rest[x->m->dim - 1];
    double sum = 0;
    for (int j = 0; j < x->m->dim; j++) {
        double size = fabs(rest->x[0][VECTORS + j]) + up * rest->off[0];
        size = size > 0 ? size * x->share[j] : 0;
        sum += x->norm == FMB_NORM_EUCLIDEAN ? size * size : size;
    }
    return (x->norm == FMB_NORM_EUCLIDEAN ? sqrt(sum) : sum) * (up > 0 ? ABOVE : BELOW);
}

bool fmb_normal_is_surely_more(const fmb_normal_search *x)
{
    double beyond = x->best.high * size_of(x, 1);
    return reach_of(x, 1, -1) > beyond && reach_of(x, -1, -1) > beyond;
}

fmb_normal_bounds fmb_normal_bound(const fmb_normal_search *x)
{
    double low = fmin(reach_of(x, 1, -1), reach_of(x, -1, -1));
    double high = fmin(reach_of(x, 1, 1), reach_of(x, -1, 1));
    return (fmb_normal_bounds){low * BELOW / size_of(x, 1) - LEAST, high * ABOVE / size_of(x, -1)};
}
