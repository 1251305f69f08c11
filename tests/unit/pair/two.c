/* two.c: see two.h. */
#include "two.h"

#include <math.h>

static double even(support_rng *g)
{
    return (double)(support_next(g) >> 11) * (200 * 0x1p-53) - 100;
}

static bool is_lattice(family of)
{
    return of == LATTICE || of == NEAR || of >= DENORMAL;
}

static void fill(support_rng *g, family of, double *x, int n)
{
    for (int i = 0; i < n; i++)
        x[i] = is_lattice(of) ? support_between(g, -2, 2) : even(g);
}

static void scale(double *x, int n, int step, double by)
{
    for (int i = 0; i < n; i += step)
        x[i] *= by;
}

/* The frames lie on either side of the plane x_1 = 0 with their origins and many axes in it, and
 * move along it; then all is turned. Rounding leaves them touching, just apart or just overlapping,
 * and those that were flat hardly so. */
static void graze(support_rng *g, int dim, bool first, double *x)
{
    for (int i = 0; i < dim + 2; i++) {
        double *v = x + i * dim;
        bool leaves = i > 0 && i <= dim && support_chance(g, 50);
        v[0] = !leaves ? 0 : first ? -fabs(v[0]) : fabs(v[0]);
        for (int j = 0; j + 1 < dim; j++) {
            double a = v[j], b = v[j + 1];
            v[j] = 0.6 * a - 0.8 * b;
            v[j + 1] = 0.8 * a + 0.6 * b;
        }
    }
}

/* Numbers of one frame: origin, axes, speed. */
static void spoil(support_rng *g, family of, int dim, bool first, double *x)
{
    int all = dim * (dim + 2), j = support_between(g, 0, dim - 1);
    if (of == NEAR && first)
        x[j] += ldexp(support_between(g, -1, 1), -support_between(g, 10, 52));
    if (of == FLAT && first)
        scale(x + dim + dim * j, dim, 1, 1e-10);
    if (of == TINY && first)
        scale(x + dim, all - dim, 1, 1e-9);
    for (int i = 0; of == FAR && i < dim; i++)
        x[i] += i % 2 ? 1e9 : -1e9;
    if (of == DENORMAL || of == HUGE)
        scale(x, all, 1, of == HUGE ? 0x1p1021 : 0x1p-1074);
    for (int i = 0; of == MIXED && i < dim; i++)
        scale(x + i, all - i, dim, ldexp(1, 300 * (i % 5 - 2)));
    if (of == GRAZING)
        graze(g, dim, first, x);
}

void two_draw(support_rng *g, family of, int dim, bool moves, bool faces, double closer, two *out)
{
    for (int k = 0; k < 2; k++) {
        double *x = out->number[k];
        fill(g, of, x, dim * (dim + 2));
        scale(x, dim, 1, closer);
        spoil(g, of, dim, k == 0, x);
        out->f[k] = (fmb_frame){
            .shape = support_chance(g, 50) ? FMB_SIMPLEX : FMB_CUBOID,
            .dim = dim,
            .naxes = faces ? support_between(g, 0, dim) : dim,
            .origin = x,
            .axes = x + dim,
            .speed = moves && support_chance(g, 80) ? x + dim + dim * dim : NULL,
        };
    }
}
