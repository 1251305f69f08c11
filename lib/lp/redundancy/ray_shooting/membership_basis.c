/* membership_basis.c: points whose hyperplanes meet in a vertex; see membership_private.h. */
#include "lp/redundancy/ray_shooting/membership_private.h"

#include <math.h>
#include <string.h>

size_t fmb_membership_name(const fmb_membership *g, size_t r)
{
    return fmb_membership_is_artificial(g->basic[r]) ? SIZE_MAX : g->name[g->basic[r]];
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* w is where all basic hyperplanes meet: w.q_j = 1. */
static void find_vertex(fmb_membership *g)
{
    size_t n = g->n;
    memset(g->w, 0, n * sizeof *g->w);
    for (size_t r = 0; r < n; r++)
        for (size_t k = 0; k < n; k++)
            g->w[k] += g->inverse[r * n + k];
}

void fmb_membership_reduce_points(fmb_membership *g, size_t from)
{
    for (size_t j = from; j < g->size; j++)
        g->reduced[j] = 1;
    for (size_t k = 0; k < g->n; k++)
        if (g->w[k] != 0)
            g->kernels->accumulate(&g->reduced[from], &g->at[k * g->capacity + from],
                                   g->size - from, -g->w[k]);
    for (size_t r = 0; r < g->n; r++)
        if (!fmb_membership_is_artificial(g->basic[r]) && g->basic[r] >= from)
            g->reduced[g->basic[r]] = 0;
}

/* In four sums, so that none waits for the other. */
static double dot_product(const double *a, const double *b, size_t n)
{
    double sum[4] = {0};
    size_t k = 0;
    for (; k + 4 <= n; k += 4)
        for (size_t i = 0; i < 4; i++)
            sum[i] += a[k + i] * b[k + i];
    for (; k < n; k++)
        sum[0] += a[k] * b[k];
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

static void measure_edges(fmb_membership *g)
{
    for (size_t r = 0; r < g->n; r++)
        g->length[r] = dot_product(&g->inverse[r * g->n], &g->inverse[r * g->n], g->n);
}

void fmb_membership_start_from_cube(fmb_membership *g, const double *q)
{
    memset(g->inverse, 0, g->n * g->n * sizeof *g->inverse);
    for (size_t k = 0; k < g->n; k++) {
        bool mirrored = q && q[k] < 0;
        g->basic[k] = FMB_MEMBERSHIP_ARTIFICIALS + 2 * k + mirrored;
        g->inverse[k * g->n + k] = mirrored ? -g->cube : g->cube;
    }
    g->pivots = 0;
    find_vertex(g);
    measure_edges(g);
    fmb_membership_reduce_points(g, 0);
}

void fmb_membership_write(fmb_membership *g, size_t j)
{
    size_t n = g->n;
    double *point = g->work;
    if (fmb_membership_is_artificial(j)) {
        for (size_t r = 0; r < n; r++)
            g->entry[r] = g->inverse[r * n + fmb_membership_artificial_axis(j)] *
                          fmb_membership_artificial_coordinate(g, j);
        return;
    }
    for (size_t k = 0; k < n; k++)
        point[k] = g->at[k * g->capacity + j];
    for (size_t r = 0; r < n; r++)
        g->entry[r] = dot_product(&g->inverse[r * n], point, n);
}

void fmb_membership_find_values(fmb_membership *g, const double *q)
{
    for (size_t r = 0; r < g->n; r++)
        g->value[r] = dot_product(&g->inverse[r * g->n], q, g->n);
}

void fmb_membership_price(fmb_membership *g, size_t r)
{
    const double *row = &g->inverse[r * g->n];
    memset(g->along, 0, g->size * sizeof *g->along);
    for (size_t k = 0; k < g->n; k++)
        if (row[k] != 0)
            g->kernels->accumulate(g->along, &g->at[k * g->capacity], g->size, row[k]);
}

void fmb_membership_pivot(fmb_membership *g, size_t r, size_t j, double gap)
{
    size_t n = g->n, old = g->basic[r];
    double *row = &g->inverse[r * n], pivot = g->entry[r], way = gap / pivot;
    double value = g->value[r] / pivot;
    for (size_t k = 0; k < n; k++)
        g->w[k] += way * row[k];
    g->kernels->accumulate(g->reduced, g->along, g->size, -way);
    for (size_t k = 0; k < n; k++)
        row[k] /= pivot;
    g->length[r] /= pivot * pivot;
    for (size_t i = 0; i < n; i++) {
        double f = i == r ? 0 : g->entry[i];
        if (f == 0)
            continue;
        g->kernels->accumulate(&g->inverse[i * n], row, n, -f);
        g->length[i] = dot_product(&g->inverse[i * n], &g->inverse[i * n], n);
        g->value[i] -= f * value;
    }
    g->value[r] = value;
    g->basic[r] = j;
    if (!fmb_membership_is_artificial(j))
        g->reduced[j] = 0;
    if (!fmb_membership_is_artificial(old))
        g->reduced[old] = -way;
    g->pivots++;
}

/* ---- the inverse afresh ---------------------------------------------------------------------- */

static void load_basis_matrix(fmb_membership *g)
{
    size_t n = g->n, wide = 2 * n;
    memset(g->work, 0, n * wide * sizeof *g->work);
    for (size_t r = 0; r < n; r++) { /* points are the columns */
        size_t j = g->basic[r];
        if (fmb_membership_is_artificial(j))
            g->work[fmb_membership_artificial_axis(j) * wide + r] =
                fmb_membership_artificial_coordinate(g, j);
        for (size_t k = 0; !fmb_membership_is_artificial(j) && k < n; k++)
            g->work[k * wide + r] = g->at[k * g->capacity + j];
        g->work[r * wide + n + r] = 1;
    }
}

static void swap_work_rows(fmb_membership *g, size_t a, size_t b)
{
    size_t wide = 2 * g->n;
    for (size_t k = 0; a != b && k < wide; k++) {
        double t = g->work[a * wide + k];
        g->work[a * wide + k] = g->work[b * wide + k];
        g->work[b * wide + k] = t;
    }
}

static size_t find_pivot_row(const fmb_membership *g, size_t c)
{
    size_t best = c, wide = 2 * g->n;
    for (size_t r = c; r < g->n; r++)
        if (fabs(g->work[r * wide + c]) > fabs(g->work[best * wide + c]))
            best = r;
    return best;
}

/* Gauss and Jordan. False if the basis is singular. */
static bool invert_basis_matrix(fmb_membership *g)
{
    size_t n = g->n, wide = 2 * n;
    load_basis_matrix(g);
    for (size_t c = 0; c < n; c++) {
        swap_work_rows(g, c, find_pivot_row(g, c));
        double *row = &g->work[c * wide], pivot = row[c];
        if (!(fabs(pivot) > FMB_MEMBERSHIP_ROUNDING / g->cube))
            return false;
        for (size_t k = c; k < wide; k++)
            row[k] /= pivot;
        for (size_t r = 0; r < n; r++) {
            double f = r == c ? 0 : g->work[r * wide + c];
            if (f != 0)
                g->kernels->accumulate(&g->work[r * wide + c], row + c, wide - c, -f);
        }
    }
    for (size_t r = 0; r < n; r++)
        memcpy(&g->inverse[r * n], &g->work[r * wide + n], n * sizeof *g->inverse);
    return true;
}

void fmb_membership_refresh(fmb_membership *g)
{
    if (!invert_basis_matrix(g)) {
        fmb_membership_start_from_cube(g, NULL);
        return;
    }
    g->pivots = 0;
    find_vertex(g);
    measure_edges(g);
    fmb_membership_reduce_points(g, 0);
}
