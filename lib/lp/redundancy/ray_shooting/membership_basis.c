/* membership_basis.c: points whose hyperplanes meet in a vertex; see membership_private.h. */
#include "lp/redundancy/ray_shooting/membership_private.h"

#include <string.h>

size_t fmb_membership_name(const fmb_membership *g, size_t r)
{
    return fmb_membership_is_artificial(g->basis.basic[r]) ? SIZE_MAX : g->name[g->basis.basic[r]];
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* w is where all basic hyperplanes meet: w.q_j = 1. */
static void find_vertex(fmb_membership *g)
{
    size_t n = g->n;
    memset(g->w, 0, n * sizeof *g->w);
    for (size_t k = 0; k < n; k++)
        for (size_t r = 0; r < n; r++)
            g->w[k] += g->basis.inverse.at[k * n + r];
}

void fmb_membership_reduce_points(fmb_membership *g, size_t from)
{
    for (size_t j = from; j < g->basis.size; j++)
        g->reduced[j] = 1;
    for (size_t k = 0; k < g->n; k++)
        if (g->w[k] != 0)
            g->basis.kernels->accumulate(&g->reduced[from],
                                         &g->basis.at[k * g->basis.capacity + from],
                                         g->basis.size - from, -g->w[k]);
    for (size_t r = 0; r < g->n; r++)
        if (!fmb_membership_is_artificial(g->basis.basic[r]) && g->basis.basic[r] >= from)
            g->reduced[g->basis.basic[r]] = 0;
}

/* Four at a time, so that none waits for the other. */
static void measure_edges(fmb_membership *g)
{
    size_t n = g->n, r = 0;
    for (; r + 4 <= n; r += 4) {
        double sum[4] = {0};
        const double *at = &g->basis.inverse.at[r];
        for (size_t k = 0; k < n; k++, at += n)
            for (size_t i = 0; i < 4; i++)
                sum[i] += at[i] * at[i];
        memcpy(&g->length[r], sum, sizeof sum);
    }
    for (; r < n; r++) {
        g->length[r] = 0;
        for (size_t k = 0; k < n; k++)
            g->length[r] += g->basis.inverse.at[k * n + r] * g->basis.inverse.at[k * n + r];
    }
}

void fmb_membership_start_from_cube(fmb_membership *g, const double *q)
{
    fmb_dense_inverse_restart(&g->basis.inverse, g->n);
    for (size_t k = 0; k < g->n; k++) {
        bool mirrored = q && q[k] < 0;
        g->basis.basic[k] = FMB_MEMBERSHIP_ARTIFICIALS + 2 * k + mirrored;
        g->basis.inverse.at[k * g->n + k] = mirrored ? -g->cube : g->cube;
    }
    g->basis.pivots = 0;
    find_vertex(g);
    measure_edges(g);
    fmb_membership_reduce_points(g, 0);
}

void fmb_membership_write(fmb_membership *g, size_t j)
{
    if (fmb_membership_is_artificial(j)) {
        memset(g->basis.entry, 0, g->n * sizeof *g->basis.entry);
        fmb_dense_inverse_add_term(&g->basis.inverse, fmb_membership_artificial_axis(j),
                                   fmb_membership_artificial_coordinate(g, j), g->basis.entry);
        return;
    }
    fmb_basis_write(&g->basis, j);
}

void fmb_membership_find_values(fmb_membership *g, const double *q)
{
    fmb_dense_inverse_write(&g->basis.inverse, q, g->basis.value);
}

void fmb_membership_price(fmb_membership *g, size_t r)
{
    fmb_dense_inverse_edge(&g->basis.inverse, r, g->basis.edge);
    memset(g->basis.price, 0, g->basis.size * sizeof *g->basis.price);
    for (size_t k = 0; k < g->n; k++)
        if (g->basis.edge[k] != 0)
            g->basis.kernels->accumulate(g->basis.price, &g->basis.at[k * g->basis.capacity],
                                         g->basis.size, g->basis.edge[k]);
}

void fmb_membership_pivot(fmb_membership *g, size_t r, size_t j, double gap)
{
    size_t n = g->n, old = g->basis.basic[r];
    double pivot = g->basis.entry[r], way = gap / pivot, value = g->basis.value[r] / pivot;
    for (size_t k = 0; k < n; k++) {
        g->w[k] += way * g->basis.edge[k];
        g->basis.value[k] -= value * g->basis.entry[k];
    }
    g->basis.value[r] = value;
    g->basis.kernels->accumulate(g->reduced, g->basis.price, g->basis.size, -way);
    fmb_dense_inverse_replace(&g->basis.inverse, r, g->basis.entry);
    measure_edges(g);
    g->basis.basic[r] = j;
    if (!fmb_membership_is_artificial(j))
        g->reduced[j] = 0;
    if (!fmb_membership_is_artificial(old))
        g->reduced[old] = -way;
    g->basis.pivots++;
}

/* Members take their places afresh, perhaps others than before. False if they seem to be singular.
 */
static bool invert_basis(fmb_membership *g)
{
    fmb_dense_inverse_restart(&g->basis.inverse, g->n);
    memcpy(g->basis.old, g->basis.basic, g->n * sizeof *g->basis.old);
    for (size_t k = 0; k < g->n; k++) {
        fmb_membership_write(g, g->basis.old[k]);
        size_t r = fmb_dense_inverse_span(&g->basis.inverse, g->basis.entry,
                                          FMB_MEMBERSHIP_ROUNDING / g->cube);
        if (r == SIZE_MAX)
            return false;
        g->basis.basic[r] = g->basis.old[k];
    }
    return true;
}

void fmb_membership_refresh(fmb_membership *g)
{
    if (!invert_basis(g)) {
        fmb_membership_start_from_cube(g, NULL);
        return;
    }
    g->basis.pivots = 0;
    find_vertex(g);
    measure_edges(g);
    fmb_membership_reduce_points(g, 0);
}
