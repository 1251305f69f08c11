/* farther.c: see farther.h.
 *
 * Let X have the vectors of M as columns, and behind them those of the unit matrix, a row for each
 * coordinate. With each edge that is chosen one row of X, the one where the edge is largest, is
 * taken from the others, as often as the edge is 0 in them then. What is left are combinations of
 * rows that are 0 on all edges chosen: after D - 1 edges one row y, the normal, whose product with
 * each vector is in that vector's column, and y itself in the last ones. So neighbouring normals
 * share all but a row or two.
 *
 * Rows and columns are scaled by powers of 2, so that the largest number of each is near 1: what a
 * coordinate is divided by, its normal is multiplied by. No number is larger than 1 then, and off
 * by no more than 2^-52.
 *
 * Let u = 2^-52, and in each row no number be larger than `most`, as it is here, and none off by
 * more than `off`. An edge v is a column, or a difference of two, and its numbers are off by f_r. A
 * row r loses m = v_r / v_p times row p. As |v_r| <= |v_p| here, |m| <= 1; with v' and m' the exact
 * ones
 *
 *     |m - m'| <= |v_r v_p' - v_r' v_p| / |v_p v_p'| + u <= (f_r + |m| f_p) / (|v_p| - f_p) + u,
 *
 * and x_r - m x_p is off by off_r + |m| off_p + |m - m'| (most_p + off_p) and the rounding, at most
 * u (most_r + 2 |m| most_p) and what is lost below 2^-1022. Bounds are rounded themselves, but by
 * far less than the surplus that they are given here, 2 u for u. If |v_p| > f_p then v_p' is not 0,
 * and the edge is independent.
 */
#include "fmb-validate/farther.h"

#include <limits.h>
#include <math.h>

#define LONGEST  900 /* the largest length is this power of 2: far smaller ones are there, too */
#define LEAST    0x1p-1000
#define ROUNDING 0x1p-51
#define ABOVE    (1 + 0x1p-40)

enum { MOST = VALIDATE_MOST_DIM };

/* ---- numbers --------------------------------------------------------------------------------- */

/* A number x 2^power, of 0 x = 0. */
typedef struct part {
    double x;
    long power;
} part;

static part part_of(const mpz_t z)
{
    part p = {0, 0};
    p.x = mpz_get_d_2exp(&p.power, z);
    return p;
}

static double power_of_two(long exponent)
{
    return exponent < -1100 ? 0 : exponent > 1100 ? INFINITY : ldexp(1, (int)exponent);
}

static void read_columns(const validate_difference *m, part x[MOST][VALIDATE_AWAY + 1])
{
    for (int j = 0; j < m->dim; j++) {
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < MOST; i++)
                x[j][k * MOST + i] = i < m->naxes[k] ? part_of(m->axis[k][i][j]) : (part){0, 0};
        x[j][VALIDATE_DRIFT] = part_of(m->drift[j]);
        x[j][VALIDATE_AWAY] = part_of(m->away[j]);
    }
}

/* The largest power of n numbers that are `step` apart; 0 if they are 0. */
static long top_power(const part *x, int n, int step)
{
    long top = LONG_MIN;
    for (int i = 0; i < n; i++)
        if (x[i * step].x != 0 && x[i * step].power > top)
            top = x[i * step].power;
    return top == LONG_MIN ? 0 : top;
}

/* The root of the claim times 2^-power. */
static double root_of(const mpq_t square, long power)
{
    part n = part_of(mpq_numref(square)), d = part_of(mpq_denref(square));
    long exponent = n.power - d.power, odd = exponent & 1;
    return sqrt(ldexp(n.x / d.x, (int)odd)) * power_of_two((exponent - odd) / 2 - power);
}

/* Rows first, by what is edges, and then columns. */
void validate_farther_load(validate_farther *f, const validate_difference *m, const mpq_t square)
{
    part x[MOST][VALIDATE_AWAY + 1];
    long finest = LONG_MAX, row[MOST], column[VALIDATE_AWAY + 1], top = LONG_MIN;
    validate_rest *rest = &f->rest[0];
    f->m = m;
    read_columns(m, x);
    for (int j = 0; j < m->dim; j++) {
        row[j] = top_power(x[j], VALIDATE_AWAY, 1);
        for (int c = 0; c <= VALIDATE_AWAY; c++)
            x[j][c].power -= row[j];
        row[j] += m->finer[j];
        finest = row[j] < finest ? row[j] : finest;
    }
    for (int c = 0; c <= VALIDATE_AWAY; c++) {
        column[c] = top_power(&x[0][c], m->dim, VALIDATE_AWAY + 1);
        top = column[c] > top ? column[c] : top;
    }
    top -= LONGEST;
    for (int c = 0; c <= VALIDATE_AWAY; c++) {
        f->length[c] = power_of_two(column[c] - top);
        for (int j = 0; j < m->dim; j++)
            rest->x[j][c] = x[j][c].x * power_of_two(x[j][c].power - column[c]);
    }
    for (int j = 0; j < m->dim; j++) {
        for (int i = 0; i < MOST; i++)
            rest->x[j][VALIDATE_COORDINATES + i] = i == j;
        f->share[j] = power_of_two(finest - row[j]);
        rest->most[j] = 1;
        rest->off[j] = ROUNDING;
    }
    f->claim = root_of(square, finest + top) * ABOVE;
}

/* ---- edges ----------------------------------------------------------------------------------- */

/* Numbers of an edge and bounds for what they are off by. */
static void find_edge(const validate_farther *f, int chosen, const validate_edge *e, double *v,
                      double *off)
{
    const validate_rest *rest = &f->rest[chosen];
    int to = e->side == 2 ? VALIDATE_DRIFT : e->side * MOST + e->to - 1;
    int from = e->side * MOST + e->corner - 1, rows = f->m->dim - chosen;
    if (e->side == 2 || e->corner == 0) {
        for (int r = 0; r < rows; r++) {
            v[r] = rest->x[r][to];
            off[r] = rest->off[r];
        }
        return;
    }
    double longer = f->length[to] > f->length[from] ? f->length[to] : f->length[from];
    double plus = f->length[to] / longer, minus = f->length[from] / longer;
    for (int r = 0; r < rows; r++) {
        v[r] = plus * rest->x[r][to] - minus * rest->x[r][from];
        off[r] = 2 * rest->off[r] + ROUNDING * 2 * rest->most[r];
    }
}

/* to = row - times pivot, in all columns */
static void take_row(double *restrict to, const double *row, const double *pivot, double times)
{
    for (int c = 0; c < VALIDATE_COLUMNS; c++)
        to[c] = row[c] - times * pivot[c];
}

bool validate_farther_choose(validate_farther *f, int chosen, const validate_edge *e)
{
    const validate_rest *old = &f->rest[chosen];
    validate_rest *rest = &f->rest[chosen + 1];
    double v[MOST] = {0}, off[MOST] = {0};
    int p = 0, rows = f->m->dim - chosen;
    find_edge(f, chosen, e, v, off);
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
        take_row(rest->x[to], old->x[r], old->x[p], times);
        double wrong = (off[r] + size * off[p]) * inverse + ROUNDING;
        rest->most[to] = old->most[r] + size * old->most[p] + 0x1p-1000;
        rest->off[to] = old->off[r] + size * old->off[p] + wrong * (old->most[p] + old->off[p]) +
                        ROUNDING * 2 * rest->most[to];
        to++;
    }
    return true;
}

/* ---- how far --------------------------------------------------------------------------------- */

/* Of what is in columns of one side: all of it, or of a simplex the largest. */
static double sum_up(const double *way, bool simplex)
{
    double sum = 0, most = 0;
    for (int c = 0; c < MOST; c++) {
        sum += way[c];
        most = way[c] > most ? way[c] : most;
    }
    return simplex ? most : sum;
}

/* M reaches no less far along sign times the normal, `off` being what that is off by: of columns
 * that surely go back, or not at all, nothing is off. */
static double sure_reach(const validate_farther *f, const double *x, double off, double sign)
{
    double way[VALIDATE_AWAY];
    for (int c = 0; c < VALIDATE_AWAY; c++) {
        double at = (sign * x[c] - off) * f->length[c];
        way[c] = at > 0 ? at : 0;
    }
    double end = way[VALIDATE_DRIFT];
    for (int k = 0; k < 2; k++)
        end += sum_up(way + k * MOST, f->m->simplex[k]);
    double away = (sign * x[VALIDATE_AWAY] - off) * f->length[VALIDATE_AWAY];
    return end + away - 32 * ROUNDING * (end + fabs(away));
}

/* Less than 20 numbers are summed; what is lost where doubles end is less than LEAST. The normal is
 * not longer than with all its numbers as large as they may be: of numbers of 2^-51 and more no
 * square that counts is lost. */
bool validate_is_farther(const validate_farther *f)
{
    const validate_difference *m = f->m;
    const validate_rest *rest = &f->rest[m->dim - 1];
    double norm = 0;
    for (int j = 0; j < m->dim; j++) {
        double size = (fabs(rest->x[0][VALIDATE_COORDINATES + j]) + rest->off[0]) * f->share[j];
        norm += size * size;
    }
    double beyond = ABOVE * f->claim * sqrt(norm) + LEAST;
    return sure_reach(f, rest->x[0], rest->off[0], 1) > beyond &&
           sure_reach(f, rest->x[0], rest->off[0], -1) > beyond;
}
