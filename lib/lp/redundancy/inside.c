/* inside.c: ray shooting from a point inside; see inside.h.
 *
 * The point is found by reflections: as long as a row is broken (or nearly), go to the mirror image
 * behind the one broken worst. If the polyhedron has inner points, that ends (Motzkin and
 * Schoenberg 1954). It is then rounded to multiples of 1 / UNIT, and checked in integers.
 *
 * A ray from there leaves the polyhedron through some row. If it meets that row alone first, then
 * behind it lies a point that breaks this row and no other: the row is irredundant. Directions are
 * rounded; what the rounded ray meets is computed exactly.
 */
#include "lp/redundancy/inside.h"

#include <math.h>

/* Sizes [bits], so that the slack (ROW + POINT + 6), the speed towards a row (ROW + WAY + 6), and a
 * product of both fit in 62, 62 and 127 bits. */
enum { ROW_BITS = 32, POINT_BITS = 24, WAY_BITS = 18, MOST_COLUMNS = 64 };
#define UNIT 4096

static double scaled_excess(const fmb_inside *p, size_t i)
{
    const int64_t *a = p->row[i].v->s;
    double sum = -(double)a[p->n];
    for (size_t j = 0; j < p->n; j++)
        sum += (double)a[j] * p->x[j];
    return sum * p->size[i];
}

/* The row broken worst, all of them moved inwards by margin; SIZE_MAX if none is. */
static size_t find_worst_broken_row(const fmb_inside *p, double margin, double *most)
{
    size_t worst = SIZE_MAX;
    *most = 0;
    for (size_t i = 0; i < p->m; i++) {
        double e = scaled_excess(p, i) + margin;
        if (e > *most) {
            *most = e;
            worst = i;
        }
    }
    return worst;
}

static fmb_status reflect_until_inside(fmb_inside *p, fmb_run *run, size_t steps, double margin,
                                       bool *inside)
{
    fmb_status st = FMB_OK;
    *inside = false;
    for (size_t k = 0; st == FMB_OK && k < steps; k++) {
        double most;
        size_t i = find_worst_broken_row(p, margin, &most);
        *inside = i == SIZE_MAX;
        if (*inside)
            break;
        for (size_t j = 0; j < p->n; j++)
            p->x[j] -= 2 * most * p->size[i] * (double)p->row[i].v->s[j];
        st = fmb_run_poll(run);
    }
    return st;
}

/* Round the point and compute the slacks; false if it is not strictly inside. */
static bool round_point_inside(fmb_inside *p)
{
    for (size_t j = 0; j < p->n; j++) {
        p->x[j] = nearbyint(p->x[j] * UNIT);
        if (!(fabs(p->x[j]) < (1 << POINT_BITS)))
            return false;
    }
    for (size_t i = 0; i < p->m; i++) {
        const int64_t *a = p->row[i].v->s;
        p->slack[i] = a[p->n] * UNIT;
        for (size_t j = 0; j < p->n; j++)
            p->slack[i] -= a[j] * (int64_t)p->x[j];
        if (p->slack[i] <= 0)
            return false;
    }
    for (size_t j = 0; j < p->n; j++)
        p->x[j] /= UNIT;
    return true;
}

static bool do_products_fit(int n, size_t m, const fmb_lp_row *row)
{
    for (size_t i = 0; i < m; i++)
        if (row[i].rel == FMB_EQ || row[i].v->z || row[i].v->bits > ROW_BITS)
            return false;
    return n <= MOST_COLUMNS;
}

static fmb_status open_inside_point(fmb_inside *p)
{
    p->x = fmb_mem_zero(p->mem, p->n, sizeof *p->x);
    p->slack = fmb_mem_get(p->mem, p->m, sizeof *p->slack);
    p->way = fmb_mem_get(p->mem, p->n, sizeof *p->way);
    p->size = fmb_mem_get(p->mem, p->m, sizeof *p->size);
    if (!p->x || !p->slack || !p->way || !p->size)
        return fmb_mem_status(p->mem);
    for (size_t i = 0; i < p->m; i++) {
        double square = 0;
        for (size_t j = 0; j < p->n; j++)
            square += (double)p->row[i].v->s[j] * (double)p->row[i].v->s[j];
        p->size[i] = 1 / sqrt(square);
    }
    return FMB_OK;
}

fmb_status fmb_inside_open(fmb_inside *p, fmb_mem *mem, int n, size_t m, const fmb_lp_row *row,
                           bool *possible)
{
    *p = (fmb_inside){.mem = mem, .n = (size_t)n, .m = m, .row = row};
    *possible = do_products_fit(n, m, row);
    return *possible ? open_inside_point(p) : FMB_OK;
}

static fmb_status try_margin(fmb_inside *p, fmb_run *run, size_t steps, double margin, bool *found)
{
    fmb_status st = reflect_until_inside(p, run, steps, margin, found);
    *found = st == FMB_OK && *found && round_point_inside(p);
    return st;
}

/* Most that have inner points show one after a few steps; a deep one if possible, from where rays
 * tell more rows apart. */
fmb_status fmb_inside_glance(fmb_inside *p, fmb_run *run, bool *found)
{
    fmb_status st = try_margin(p, run, 8 + 2 * p->n, 0.25, found);
    return st == FMB_OK && !*found ? try_margin(p, run, 8 + 2 * p->n, 1.0 / 64, found) : st;
}

fmb_status fmb_inside_find(fmb_inside *p, fmb_run *run, bool *found)
{
    fmb_status st = FMB_OK;
    *found = false;
    for (double margin = 0.25; st == FMB_OK && !*found && margin > 1.0 / UNIT; margin /= 16)
        st = try_margin(p, run, 50 + 16 * p->n, margin, found);
    return st;
}

void fmb_inside_clear(fmb_inside *p)
{
    fmb_mem_put(p->mem, p->x, p->n, sizeof *p->x);
    fmb_mem_put(p->mem, p->slack, p->m, sizeof *p->slack);
    fmb_mem_put(p->mem, p->way, p->n, sizeof *p->way);
    fmb_mem_put(p->mem, p->size, p->m, sizeof *p->size);
}

size_t fmb_inside_shoot(const fmb_inside *p, const double *way, const bool *gone)
{
    double most = 0;
    size_t first = SIZE_MAX;
    int64_t speed = 0;
    bool tie = false;
    for (size_t j = 0; j < p->n; j++)
        most = fabs(way[j]) > most ? fabs(way[j]) : most;
    if (!(most > 0 && most < HUGE_VAL))
        return SIZE_MAX;
    for (size_t j = 0; j < p->n; j++)
        p->way[j] = (int64_t)nearbyint(way[j] / most * ((1 << WAY_BITS) - 1));
    for (size_t i = 0; i < p->m; i++) {
        const int64_t *a = p->row[i].v->s;
        int64_t s = 0;
        if (gone[i])
            continue;
        for (size_t j = 0; j < p->n; j++)
            s += a[j] * p->way[j];
        if (s <= 0)
            continue;
        fmb_i128 mine = first == SIZE_MAX ? -1 : (fmb_i128)p->slack[i] * speed;
        fmb_i128 best = first == SIZE_MAX ? 0 : (fmb_i128)p->slack[first] * s;
        tie = mine == best || (tie && mine > best);
        if (mine < best) {
            first = i;
            speed = s;
        }
    }
    return tie ? SIZE_MAX : first;
}
