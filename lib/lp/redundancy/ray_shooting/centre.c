/* centre.c: see centre.h.
 *
 * Newton's method with the barrier sum_i -log(b_i - a_i.x) and exact line search. If the first
 * point is outside, all rows are relaxed by t, which is then reduced against the barrier until the
 * rows themselves hold. An unbounded polyhedron has no centre: x is kept in a cube around the first
 * point inside.
 */
#include "lp/redundancy/ray_shooting/centre.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"

/* Most Newton steps, and the decrement below which x is near enough to the centre. */
#define MOST_PULLS    60
#define MOST_STEPS    16
#define NEAR_A_CENTRE 0.1
/* Rows per column from which these steps pay: with fewer rows any point inside serves as well. */
#define CROWDED 24
/* The weight of t grows by HARDER near each centre, up to HARDEST. */
#define HARDER  16.0
#define HARDEST 1e12
/* Cubes to search in: each is LARGER times the one before, up to LARGEST. */
#define LARGER  0x1p10
#define LARGEST 0x1p40
/* Half the cube's side, as a multiple of the rows' median distance. */
#define ROOMY 64.0

static fmb_status hold_arrays_of_centre(fmb_centre *c, bool get)
{
    const size_t n = c->n, m = c->m, wide = n + 1;
    return FMB_ARRAYS(c->mem, get, FMB_ARRAY(c->at, wide * m), FMB_ARRAY(c->right, m),
                      FMB_ARRAY_ZERO(c->x, wide), FMB_ARRAY(c->slack, m),
                      FMB_ARRAY(c->half, wide * wide), FMB_ARRAY(c->way, wide),
                      FMB_ARRAY(c->speed, m), FMB_ARRAY(c->middle, n));
}

fmb_status fmb_centre_init(fmb_centre *c, fmb_mem *mem, size_t n, size_t m)
{
    *c = (fmb_centre){.mem = mem, .n = n, .m = m};
    return hold_arrays_of_centre(c, true);
}

void fmb_centre_clear(fmb_centre *c)
{
    if (!c->mem)
        return;
    (void)hold_arrays_of_centre(c, false);
    c->mem = NULL;
}

/* ---- Newton's step --------------------------------------------------------------------------- */

/* slack = right - at.x over n columns. */
static void find_row_slacks(fmb_centre *c, size_t n, const fmb_kernels *kernels)
{
    memcpy(c->slack, c->right, c->m * sizeof *c->slack);
    for (size_t k = 0; k < n; k++)
        if (c->x[k] != 0)
            kernels->accumulate(c->slack, &c->at[k * c->m], c->m, -c->x[k]);
}

/* sum_i a_ij a_ik scale_i; in four independent sums, for parallel execution. */
static double weighted_product(const double *a, const double *b, const double *scale, size_t m)
{
    double sum[4] = {0};
    size_t i = 0;
    for (; i + 4 <= m; i += 4)
        for (size_t k = 0; k < 4; k++)
            sum[k] += a[i + k] * b[i + k] * scale[i + k];
    for (; i < m; i++)
        sum[0] += a[i] * b[i] * scale[i];
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

/* First and second derivatives of the cube's barrier along axis k. */
static double cube_pull(const fmb_centre *c, size_t k, double *bend)
{
    double up = c->room - (c->x[k] - c->middle[k]), down = 2 * c->room - up;
    *bend = 1 / (up * up) + 1 / (down * down);
    return 1 / up - 1 / down;
}

/* half = the second derivative, way = minus the gradient. */
static void differentiate_barrier(fmb_centre *c, size_t n, double pull)
{
    double *scale = c->speed;
    for (size_t i = 0; i < c->m; i++)
        scale[i] = 1 / c->slack[i];
    for (size_t j = 0; j < n; j++) {
        double sum = 0;
        for (size_t i = 0; i < c->m; i++)
            sum += c->at[j * c->m + i] * scale[i];
        c->way[j] = -sum;
    }
    for (size_t i = 0; i < c->m; i++)
        scale[i] *= scale[i];
    for (size_t j = 0; j < n; j++)
        for (size_t k = 0; k <= j; k++)
            c->half[j * (c->n + 1) + k] =
                weighted_product(&c->at[j * c->m], &c->at[k * c->m], scale, c->m);
    if (pull > 0)
        c->way[n - 1] -= pull;
    for (size_t k = 0; k < c->n && c->room > 0; k++) {
        double bend, slope = cube_pull(c, k, &bend);
        c->way[k] -= slope;
        c->half[k * (c->n + 1) + k] += bend;
    }
}

/* Cholesky factor in place; nearly zero diagonal entries are increased a little. */
static void factor_into_half(fmb_centre *c, size_t n)
{
    size_t wide = c->n + 1;
    for (size_t j = 0; j < n; j++) {
        double *row = &c->half[j * wide], was = row[j];
        for (size_t k = 0; k <= j; k++) {
            const double *other = &c->half[k * wide];
            double sum = row[k];
            for (size_t i = 0; i < k; i++)
                sum -= row[i] * other[i];
            if (k < j)
                row[k] = sum / other[k];
            else
                row[k] = sqrt(sum > 1e-12 * was ? sum : 1e-12 * was + 1e-300);
        }
    }
}

/* way = H^-1 way; returns the squared Newton decrement, the length of the step in the norm of H. */
static double solve_for_way(fmb_centre *c, size_t n)
{
    size_t wide = c->n + 1;
    double square = 0;
    for (size_t j = 0; j < n; j++) {
        for (size_t k = 0; k < j; k++)
            c->way[j] -= c->half[j * wide + k] * c->way[k];
        c->way[j] /= c->half[j * wide + j];
        square += c->way[j] * c->way[j];
    }
    for (size_t j = n; j-- > 0;) {
        for (size_t k = j + 1; k < n; k++)
            c->way[j] -= c->half[k * wide + j] * c->way[k];
        c->way[j] /= c->half[j * wide + j];
    }
    return square;
}

/* ---- how far along it ------------------------------------------------------------------------ */

static double way_to_nearest_row(const fmb_centre *c)
{
    double most = 0; /* largest speed over slack */
    for (size_t i = 0; i < c->m; i++)
        most = c->speed[i] > most * c->slack[i] ? c->speed[i] / c->slack[i] : most;
    for (size_t k = 0; k < c->n && c->room > 0; k++) {
        double left = c->room - (c->way[k] > 0 ? 1 : -1) * (c->x[k] - c->middle[k]);
        most = fabs(c->way[k]) > most * left ? fabs(c->way[k]) / left : most;
    }
    return most > 0 ? 1 / most : 1e30;
}

/* First and second derivatives of the barrier at that length. */
static double slope_at(const fmb_centre *c, double length, double *bend)
{
    double slope = *bend = 0;
    for (size_t i = 0; i < c->m; i++) {
        double ratio = c->speed[i] / (c->slack[i] - length * c->speed[i]);
        slope += ratio;
        *bend += ratio * ratio;
    }
    for (size_t k = 0; k < c->n && c->room > 0; k++) {
        double off = c->x[k] + length * c->way[k] - c->middle[k];
        double up = c->way[k] / (c->room - off), down = c->way[k] / (c->room + off);
        slope += up - down;
        *bend += up * up + down * down;
    }
    return slope;
}

/* The length that minimizes barrier and weighted t (the last of n columns) along the way. */
static double find_best_length(const fmb_centre *c, size_t n, double pull)
{
    double low = 0, high = 0.99 * way_to_nearest_row(c), length = high < 1 ? 0.9 * high : 1;
    for (int k = 0; k < 6; k++) {
        double bend, slope = slope_at(c, length, &bend) + pull * c->way[n - 1];
        if (slope > 0)
            high = length;
        else
            low = length;
        double next = length - slope / bend;
        length = next > low && next < high ? next : low + (high - low) / 2;
    }
    return length;
}

static double step_to_centre(fmb_centre *c, size_t n, double pull, const fmb_kernels *kernels)
{
    differentiate_barrier(c, n, pull);
    factor_into_half(c, n);
    double square = solve_for_way(c, n);
    memset(c->speed, 0, c->m * sizeof *c->speed);
    for (size_t k = 0; k < n; k++)
        kernels->accumulate(c->speed, &c->at[k * c->m], c->m, c->way[k]);
    double length = find_best_length(c, n, pull);
    for (size_t k = 0; k < n; k++)
        c->x[k] += length * c->way[k];
    find_row_slacks(c, n, kernels);
    return square;
}

/* ---- outside, inside ------------------------------------------------------------------------- */

static double least_row_slack(const fmb_centre *c)
{
    double least = INFINITY;
    for (size_t i = 0; i < c->m; i++)
        least = c->slack[i] < least ? c->slack[i] : least;
    return least;
}

/* Do the rows hold without t, by more than rounding errors? */
static bool is_inside_without_t(const fmb_centre *c)
{
    double least = least_row_slack(c) - c->x[c->n], size = 1e-300;
    for (size_t k = 0; k < c->n; k++)
        size = fmax(size, fabs(c->x[k]));
    return least > 1e-13 * size;
}

/* Reduce t until the rows themselves hold, in a cube with this `room`. */
static fmb_status pull_rows_back(fmb_centre *c, fmb_run *run, double room, bool *inside)
{
    size_t wide = c->n + 1;
    memset(c->x, 0, wide * sizeof *c->x);
    memset(c->middle, 0, c->n * sizeof *c->middle);
    c->room = room;
    for (size_t i = 0; i < c->m; i++)
        c->at[c->n * c->m + i] = -1;
    find_row_slacks(c, c->n, run->kernels);
    double most = c->x[c->n] = 1 - 2 * least_row_slack(c), pull = (double)c->m / most;
    find_row_slacks(c, wide, run->kernels);
    for (size_t k = 0; k < MOST_PULLS && pull * most < HARDEST; k++) {
        double square = step_to_centre(c, wide, pull, run->kernels);
        *inside = is_inside_without_t(c);
        if (*inside || !(square < INFINITY))
            return FMB_OK;
        pull *= square < 1 ? HARDER : 2;
        FMB_TRY(fmb_run_poll(run));
    }
    return FMB_OK;
}

/* Search a cube that contains all rows, then larger ones as long as x is near the walls. */
static fmb_status find_some_inside(fmb_centre *c, fmb_run *run, bool *inside)
{
    fmb_status st = FMB_OK;
    double room = 1, most = HUGE_VAL;
    for (size_t i = 0; i < c->m; i++)
        room = fmax(room, fabs(c->right[i]));
    for (room *= 4; st == FMB_OK && !*inside && 2 * most > room; room *= LARGER) {
        st = pull_rows_back(c, run, room, inside);
        most = 0;
        for (size_t k = 0; k < c->n; k++)
            most = fmax(most, fabs(c->x[k]));
        if (room > LARGEST)
            break;
    }
    return st;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The cube's size is a multiple of about the median distance of the rows. */
static void build_cube(fmb_centre *c)
{
    double some[64];
    size_t count = 0;
    for (size_t i = 0; i < c->m && count < 64; i += c->m / 64 + 1)
        some[count++] = c->slack[i];
    qsort(some, count, sizeof *some, compare_doubles);
    c->room = ROOMY * some[count / 2];
    memcpy(c->middle, c->x, c->n * sizeof *c->middle);
}

static fmb_status go_to_centre(fmb_centre *c, fmb_run *run)
{
    fmb_status st = FMB_OK;
    size_t most = c->m >= CROWDED * c->n ? MOST_STEPS : 0;
    build_cube(c);
    for (size_t k = 0; st == FMB_OK && k < most; k++) {
        if (step_to_centre(c, c->n, 0, run->kernels) < NEAR_A_CENTRE)
            break;
        st = fmb_run_poll(run);
    }
    differentiate_barrier(c, c->n, 0);
    factor_into_half(c, c->n);
    return st;
}

fmb_status fmb_centre_find(fmb_centre *c, fmb_run *run, bool *inside)
{
    *inside = false;
    c->room = 0;
    if (c->m == 0 || c->n == 0)
        return FMB_OK;
    memset(c->x, 0, (c->n + 1) * sizeof *c->x);
    find_row_slacks(c, c->n, run->kernels);
    *inside = least_row_slack(c) > 0;
    if (!*inside)
        FMB_TRY(find_some_inside(c, run, inside));
    if (!*inside)
        return FMB_OK;
    find_row_slacks(c, c->n, run->kernels);
    *inside = least_row_slack(c) > 0;
    return *inside ? go_to_centre(c, run) : FMB_OK;
}
