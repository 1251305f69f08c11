/* cells.c: see cells.h. The curve interleaves the bits of the coordinates (Morton 1966). */
#include "fmb-qualify/verdicts/cells.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    BITS = 20, /* of a coordinate on the curve */
    NEAR = 24  /* places along it: a triangle of a mesh has about twelve neighbours */
};

/* ---- frames ---------------------------------------------------------------------------------- */

void verdict_make_thick(double *axes, double thick)
{
    const double *a = axes, *b = axes + 3;
    double *normal = axes + 6;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = a[j] * b[k] - a[k] * b[j];
    }
    double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (int i = 0; i < 3; i++)
        normal[i] *= thick / length;
}

static void put_cell(const verdict_cells *c, size_t i, const verdict_draft *f)
{
    const double *p = c->point + 9 * i;
    for (int j = 0; j < 3; j++) {
        f->origin[j] = p[j];
        f->axes[j] = p[3 + j] - p[j];
        f->axes[3 + j] = p[6 + j] - p[j];
        if (f->speed)
            f->speed[j] *= 4 * c->edge / 100;
    }
    verdict_make_thick(f->axes, c->edge);
}

/* One of n, chosen by a number from -100 to 100. */
static size_t choose_by_number(double x, size_t n)
{
    size_t i = (size_t)((x + 100) / 200 * (double)n);
    return i < n ? i : n - 1;
}

void verdict_cells_put(const void *self, int dim, const verdict_draft f[2])
{
    const verdict_cells *c = self;
    (void)dim;
    size_t i = choose_by_number(f[0].origin[0], c->n), more = c->n - 1 < NEAR ? c->n - 1 : NEAR,
           step = 1 + choose_by_number(f[1].origin[0], more);
    put_cell(c, i, &f[0]);
    put_cell(c, (i + step) % c->n, &f[1]);
}

/* ---- the curve ------------------------------------------------------------------------------- */

typedef struct cell_on_curve {
    uint64_t place;
    double point[9];
} cell_on_curve;

static int compare_places(const void *x, const void *y)
{
    const cell_on_curve *p = x, *q = y;
    return (p->place > q->place) - (p->place < q->place);
}

/* centre: within 0 ... 1. */
static uint64_t place_on_curve(const double centre[3])
{
    uint64_t place = 0;
    for (int bit = BITS - 1; bit >= 0; bit--)
        for (int j = 0; j < 3; j++)
            place = place << 1 | ((uint64_t)(centre[j] * ((1 << BITS) - 1)) >> bit & 1);
    return place;
}

static void find_bounds(const fmb_mesh *m, double lower[3], double *size)
{
    const double *p = fmb_mesh_points(m);
    *size = 0;
    for (size_t j = 0; j < 3; j++) {
        double least = INFINITY, most = -INFINITY;
        for (size_t v = 0; v < fmb_mesh_vertices(m); v++) {
            least = fmin(least, p[3 * v + j]);
            most = fmax(most, p[3 * v + j]);
        }
        lower[j] = least;
        *size = fmax(*size, most - least);
    }
}

/* False: it has no area. Adds the lengths of its edges to *edges. */
static bool put_triangle(const fmb_mesh *m, size_t cell, const double lower[3], double size,
                         cell_on_curve *out, double *edges)
{
    double centre[3], axes[9], length = 0;
    for (int k = 0; k < 3; k++)
        memcpy(out->point + 3 * k,
               fmb_mesh_points(m) + 3 * (size_t)fmb_mesh_indices(m)[3 * cell + (size_t)k],
               3 * sizeof(double));
    const double *p = out->point;
    for (int j = 0; j < 3; j++) {
        centre[j] = ((p[j] + p[3 + j] + p[6 + j]) / 3 - lower[j]) / size;
        axes[j] = p[3 + j] - p[j];
        axes[3 + j] = p[6 + j] - p[j];
    }
    for (int k = 0; k < 3; k++) {
        const double *a = p + 3 * k, *b = p + 3 * ((k + 1) % 3);
        length += sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                       (a[2] - b[2]) * (a[2] - b[2]));
    }
    verdict_make_thick(axes, 1);
    if (!isfinite(axes[6] + axes[7] + axes[8]))
        return false;
    *edges += length;
    out->place = place_on_curve(centre);
    return true;
}

fmb_status verdict_cells_open(const fmb_mesh *m, verdict_cells *out)
{
    size_t all = fmb_mesh_cells(m);
    double lower[3], size, edges = 0;
    cell_on_curve *cell = malloc((all + 1) * sizeof *cell);
    *out = (verdict_cells){.point = malloc((all + 1) * 9 * sizeof *out->point)};
    fmb_status st = cell && out->point ? FMB_OK : FMB_ERR_MEMORY;
    find_bounds(m, lower, &size);
    for (size_t i = 0; st == FMB_OK && i < all; i++)
        out->n += put_triangle(m, i, lower, size, &cell[out->n], &edges);
    if (out->n > 0)
        qsort(cell, out->n, sizeof *cell, compare_places);
    for (size_t i = 0; i < out->n; i++)
        memcpy(out->point + 9 * i, cell[i].point, sizeof cell[i].point);
    out->edge = out->n > 0 ? edges / 3 / (double)out->n : 0;
    free(cell);
    if (st != FMB_OK)
        verdict_cells_close(out);
    return st;
}

void verdict_cells_close(verdict_cells *c)
{
    free(c->point);
    *c = (verdict_cells){0};
}
