/* interior_point.c: ray shooting from a point inside; see interior_point.h.
 *
 * The point is found by reflections: as long as a row is broken (or nearly), go to the mirror image
 * behind the one broken worst. If the polyhedron has inner points, that ends (Motzkin and
 * Schoenberg 1954). It is then rounded to so many bits, and checked in integers.
 *
 * A ray from there leaves the polyhedron through some row. If it meets that row alone first, then
 * behind it lies a point that breaks this row and no other: the row is irredundant. Directions are
 * rounded; what the rounded ray meets is computed exactly.
 */
#include "lp/redundancy/active_set/interior_point.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"

/* Sizes [bits], so that the slack (ROW + POINT + 6), the speed towards a row (ROW + WAY + 6), and a
 * product of both fit in 62, 53 and 127 bits: doubles add up speeds without rounding. */
enum { ROW_BITS = 29, POINT_BITS = 24, WAY_BITS = 18, MOST_COLUMNS = 64 };
/* Coordinates are multiples of 2^-precision. Below the least precision, or with right sides times
 * 2^precision above the most, slacks would be longer. */
enum { LEAST_PRECISION = -3, MOST_PRECISION = POINT_BITS + 6 };

static void find_excess_of_rows(fmb_interior_point *p)
{
    memcpy(p->excess, &p->unit[p->n * p->m], p->m * sizeof *p->excess);
    for (size_t j = 0; j < p->n; j++)
        p->run->kernels->accumulate(p->excess, &p->unit[j * p->m], p->m, p->x[j]);
}

/* The row broken worst, all of them moved inwards by margin; SIZE_MAX if none is. */
static size_t find_worst_broken_row(fmb_interior_point *p, double margin, double *most)
{
    size_t worst = SIZE_MAX;
    *most = 0;
    find_excess_of_rows(p);
    for (size_t i = 0; i < p->m; i++)
        if (p->excess[i] + margin > *most) {
            *most = p->excess[i] + margin;
            worst = i;
        }
    return worst;
}

/* Between the same two rows to and fro, equally far: there is no room between them. */
static bool is_to_and_fro(const double *most, const size_t *row)
{
    return row[0] == row[2] && row[1] == row[3] && row[0] != row[1] && most[3] >= most[2] &&
           most[2] >= most[1] && most[1] >= most[0];
}

static fmb_status reflect_until_inside(fmb_interior_point *p, size_t steps, double margin,
                                       bool *inside)
{
    double most[4] = {0};
    size_t row[4] = {SIZE_MAX, SIZE_MAX, SIZE_MAX, SIZE_MAX};
    *inside = false;
    for (size_t k = 0; k < steps; k++) {
        memmove(&most[0], &most[1], 3 * sizeof *most);
        memmove(&row[0], &row[1], 3 * sizeof *row);
        size_t i = row[3] = find_worst_broken_row(p, margin, &most[3]);
        *inside = i == SIZE_MAX;
        if (*inside || (k > 2 && is_to_and_fro(most, row)))
            break;
        for (size_t j = 0; j < p->n; j++)
            p->x[j] -= 2 * most[3] * p->unit[j * p->m + i];
        FMB_TRY(fmb_run_poll(p->run));
    }
    return FMB_OK;
}

/* The finest precision on which the coordinates have POINT_BITS bits; below LEAST_PRECISION: there
 * is none.
 */
static int choose_precision(const fmb_interior_point *p)
{
    double most = 0;
    int exponent;
    for (size_t j = 0; j < p->n; j++)
        most = fmax(most, fabs(p->x[j]));
    if (!isfinite(most))
        return LEAST_PRECISION - 1;
    (void)frexp(most * (1 + 0x1p-20), &exponent);
    return POINT_BITS - exponent < MOST_PRECISION ? POINT_BITS - exponent : MOST_PRECISION;
}

/* Round the point and compute the slacks; false if it is not strictly inside. */
static bool round_point_inside(fmb_interior_point *p)
{
    int precision = choose_precision(p);
    if (precision < LEAST_PRECISION)
        return false;
    p->precision = precision > 0 ? precision : 0;
    for (size_t j = 0; j < p->n; j++)
        p->x[j] = ldexp(nearbyint(ldexp(p->x[j], precision)), -precision);
    for (size_t i = 0; i < p->m; i++) {
        const int64_t *a = p->row[i].v->s;
        p->slack[i] = a[p->n] * ((int64_t)1 << p->precision);
        for (size_t j = 0; j < p->n; j++)
            p->slack[i] -= a[j] * (int64_t)ldexp(p->x[j], p->precision);
        if (p->slack[i] <= 0)
            return false;
    }
    return true;
}

static void write_unit_row(fmb_interior_point *p, size_t i)
{
    const int64_t *a = p->row[i].v->s;
    double square = 0;
    for (size_t j = 0; j < p->n; j++)
        square += (double)a[j] * (double)a[j];
    double size = 1 / sqrt(square);
    for (size_t j = 0; j < p->n; j++) {
        p->entry[j * p->m + i] = (double)a[j];
        p->unit[j * p->m + i] = (double)a[j] * size;
    }
    p->unit[p->n * p->m + i] = -(double)a[p->n] * size;
}

static fmb_status hold_arrays_of_point(fmb_interior_point *p, bool get)
{
    return FMB_ARRAYS_IN_BLOCK(p->run->mem, get, FMB_ARRAY_ZERO(p->x, p->n),
                               FMB_ARRAY(p->slack, p->m), FMB_ARRAY(p->unit, (p->n + 1) * p->m),
                               FMB_ARRAY(p->entry, p->n * p->m), FMB_ARRAY(p->excess, p->m));
}

static fmb_status open_inside_point(fmb_interior_point *p)
{
    FMB_TRY(hold_arrays_of_point(p, true));
    for (size_t i = 0; i < p->m; i++)
        write_unit_row(p, i);
    return FMB_OK;
}

fmb_status fmb_interior_point_open(fmb_interior_point *p, fmb_run *run, size_t n, size_t m,
                                   const fmb_lp_row *row, bool *possible)
{
    *p = (fmb_interior_point){.run = run, .n = n, .m = m, .row = row};
    *possible = n <= MOST_COLUMNS;
    return *possible ? open_inside_point(p) : FMB_OK;
}

static fmb_status try_slack(fmb_interior_point *p, size_t steps, double margin, bool *found)
{
    fmb_status st = reflect_until_inside(p, steps, margin, found);
    *found = st == FMB_OK && *found && round_point_inside(p);
    return st;
}

/* So far rows are moved inwards first, where most distances of rows from 0 are about 1; and how
 * many times less then. */
#define FIRST_MARGIN 0x1p-4
#define NEXT_MARGIN  16

/* Most that have inner points show one after a few steps; a deep one if possible, from where rays
 * tell more rows apart. */
fmb_status fmb_interior_point_find_quickly(fmb_interior_point *p, bool *found)
{
    FMB_TRY(try_slack(p, 8 + 2 * p->n, FIRST_MARGIN, found));
    return !*found ? try_slack(p, 8 + 2 * p->n, FIRST_MARGIN / NEXT_MARGIN, found) : FMB_OK;
}

enum { MARGINS = 3 };

static size_t steps_of_search(const fmb_interior_point *p)
{
    return 50 + 16 * p->n;
}

fmb_status fmb_interior_point_find(fmb_interior_point *p, bool *found)
{
    double margin = FIRST_MARGIN;
    *found = false;
    for (int k = 0; !*found && k < MARGINS; k++, margin /= NEXT_MARGIN)
        FMB_TRY(try_slack(p, steps_of_search(p), margin, found));
    return FMB_OK;
}

/* A reflection looks at each row once, and at its entries four at a time. */
double fmb_interior_point_most_work(const fmb_interior_point *p)
{
    double entries = (double)p->n * (double)p->m;
    return MARGINS * (double)steps_of_search(p) * (entries / 4 + (double)p->m + (double)p->n);
}

/* The slack of row a + d is the one of a, less 2^precision d.x, where |d.x| < |x_1| + ... unless x
 * is 0; and less 2^precision and less where the right side differs, too. The coordinates are
 * multiples of 2^-precision: there is no rounding. */
static int64_t slack_between_near_rows(const fmb_interior_point *p)
{
    double size = p->near_right ? 1 : 0;
    for (size_t j = 0; j < p->n; j++)
        size += fabs(p->x[j]);
    return (int64_t)ldexp(size, p->precision);
}

bool fmb_interior_point_sees_near_rows(const fmb_interior_point *p)
{
    int64_t least = slack_between_near_rows(p);
    for (size_t i = 0; i < p->m; i++)
        if (p->slack[i] < least)
            return false;
    return true;
}

void fmb_interior_point_clear(fmb_interior_point *p)
{
    (void)hold_arrays_of_point(p, false);
}

/* How fast the ray comes to each row, and its own speed, |d_1| + |d_2| + ...; 0: it goes nowhere.
 */
static double find_speeds_of_ray(const fmb_interior_point *p, const double *way, double *speed)
{
    double most = 0, own = 0;
    for (size_t j = 0; j < p->n; j++)
        most = fabs(way[j]) > most ? fabs(way[j]) : most;
    if (!(most > 0 && most < HUGE_VAL))
        return 0;
    memset(speed, 0, p->m * sizeof *speed);
    for (size_t j = 0; j < p->n; j++) {
        double step = nearbyint(way[j] / most * ((1 << WAY_BITS) - 1));
        own += fabs(step);
        p->run->kernels->accumulate(speed, &p->entry[j * p->m], p->m, step);
    }
    return own;
}

static size_t guess_first_row(const fmb_interior_point *p, const bool *gone, const double *speed)
{
    size_t first = SIZE_MAX;
    double soonest = HUGE_VAL;
    for (size_t i = 0; i < p->m; i++)
        if (speed[i] > 0 && (double)p->slack[i] < soonest * speed[i] && !(gone && gone[i])) {
            soonest = (double)p->slack[i] / speed[i];
            first = i;
        }
    return first;
}

/* Along d the speed towards row a + c differs by less than |d_1| + ... from that towards a. */
size_t fmb_interior_point_shoot(const fmb_interior_point *p, const double *way, const bool *gone,
                                double *speed)
{
    int64_t own = (int64_t)find_speeds_of_ray(p, way, speed);
    size_t first = own > 0 ? guess_first_row(p, gone, speed) : SIZE_MAX;
    int64_t apart = p->near ? own : 0, near = p->near ? slack_between_near_rows(p) : 0;
    int64_t least_speed = first < SIZE_MAX ? (int64_t)speed[first] - apart : 0;
    if (least_speed <= 0)
        return SIZE_MAX;
    for (size_t i = 0; i < p->m; i++) {
        int64_t fast = (int64_t)speed[i] + apart;
        if (i != first && fast > 0 && !(gone && gone[i]) &&
            fmb_i128_compare(fmb_i128_product(p->slack[first] + near, fast),
                             fmb_i128_product(p->slack[i] - near, least_speed)) >= 0)
            return SIZE_MAX;
    }
    return first;
}
