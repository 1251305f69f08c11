/* bodies.c: see bodies.h. */
#include "bodies.h"

#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>

#include "../frame/meet.h"

/* ---- pairs ----------------------------------------------------------------------------------- */

static double draw_number(support_rng *g, bool coarse, int most)
{
    double x = (double)support_between(g, -most, most);
    return coarse ? x
                  : ldexp(x + (double)support_between(g, 1, 999) / 997, -support_between(g, 0, 2));
}

void bodies_draw(support_rng *g, int dim, bool coarse, int spread, bodies *b)
{
    for (int k = 0; k < 2; k++) {
        for (int j = 0; j < dim; j++) {
            b->origin[k][j] = draw_number(g, coarse, spread);
            b->speed[k][j] = draw_number(g, coarse, 3);
        }
        for (int j = 0; j < dim * dim; j++)
            b->axes[k][j] = draw_number(g, coarse, 3);
        b->f[k] = (fmb_frame){.shape = (fmb_shape)support_between(g, 0, 3),
                              .dim = dim,
                              .naxes = support_chance(g, 70) ? dim : support_between(g, 0, dim),
                              .origin = b->origin[k],
                              .axes = b->axes[k],
                              .speed = support_chance(g, 25) ? b->speed[k] : NULL};
    }
}

fmb_frame_q bodies_moved(const fmb_frame *f, mpq_t *shift)
{
    bool corners = f->shape == FMB_CUBOID_BY_CORNERS || f->shape == FMB_SIMPLEX_BY_CORNERS;
    fmb_frame_q q = rational_of(f);
    for (int j = 0; shift && j < f->dim; j++) {
        mpq_add(q.origin[j], q.origin[j], shift[j]);
        for (int i = 0; corners && i < f->naxes; i++)
            mpq_add(q.axes[i * f->dim + j], q.axes[i * f->dim + j], shift[j]);
    }
    return q;
}

/* ---- the difference -------------------------------------------------------------------------- */

static int corners_of(const fmb_frame *f)
{
    bool cuboid = f->shape == FMB_CUBOID || f->shape == FMB_CUBOID_BY_CORNERS;
    return cuboid ? 1 << f->naxes : f->naxes + 1;
}

/* Coordinate j of corner k: by bits of a cuboid, by number of a simplex. */
static void corner_of(const fmb_frame *f, int k, int j, mpq_t out)
{
    bool cuboid = f->shape == FMB_CUBOID || f->shape == FMB_CUBOID_BY_CORNERS;
    bool corners = f->shape == FMB_CUBOID_BY_CORNERS || f->shape == FMB_SIMPLEX_BY_CORNERS;
    mpq_t edge, origin;
    mpq_inits(edge, origin, NULL);
    mpq_set_d(origin, f->origin[j]);
    mpq_set(out, origin);
    for (int i = 0; i < f->naxes; i++) {
        if (cuboid ? !(k >> i & 1) : k != i + 1)
            continue;
        mpq_set_d(edge, f->axes[i * f->dim + j]);
        if (corners)
            mpq_sub(edge, edge, origin);
        mpq_add(out, out, edge);
    }
    mpq_clears(edge, origin, NULL);
}

static void drift_of(const fmb_frame *f, int j, mpq_t out)
{
    mpq_t speed;
    mpq_init(speed);
    mpq_set_d(out, f[0].speed ? f[0].speed[j] : 0);
    mpq_set_d(speed, f[1].speed ? f[1].speed[j] : 0);
    mpq_sub(out, out, speed);
    mpq_clear(speed);
}

difference *difference_new(const fmb_frame *f)
{
    difference *m = calloc(1, sizeof *m);
    cr_assert(m);
    int p = corners_of(&f[0]), q = corners_of(&f[1]), times = f[0].speed || f[1].speed ? 2 : 1;
    m->dim = f[0].dim;
    m->corners = p * q * times;
    mpq_t t;
    mpq_init(t);
    for (int c = 0; c < m->corners; c++)
        for (int j = 0; j < m->dim; j++) {
            mpq_ptr to = m->corner[c][j];
            mpq_init(to);
            corner_of(&f[0], c % p, j, to);
            corner_of(&f[1], c / p % q, j, t);
            mpq_sub(to, to, t);
            drift_of(f, j, t);
            if (c / (p * q) == 1)
                mpq_add(to, to, t);
        }
    mpq_clear(t);
    return m;
}

void difference_free(difference *m)
{
    for (int c = 0; c < m->corners; c++)
        for (int j = 0; j < m->dim; j++)
            mpq_clear(m->corner[c][j]);
    free(m);
}

void difference_least(const difference *m, mpq_t *u, mpq_t out)
{
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (int c = 0; c < m->corners; c++) {
        mpq_set_ui(sum, 0, 1);
        for (int j = 0; j < m->dim; j++) {
            mpq_mul(t, u[j], m->corner[c][j]);
            mpq_add(sum, sum, t);
        }
        if (c == 0 || mpq_cmp(sum, out) < 0)
            mpq_set(out, sum);
    }
    mpq_clears(sum, t, NULL);
}
