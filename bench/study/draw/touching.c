/* touching.c: pairs that touch; see draft.h.
 *
 * A normal n is drawn first. Some axes of A and of B are made perpendicular to it, perhaps parallel
 * to each other; they span the faces that touch. The others point away from the separating plane.
 * So A lies on one side of it and B on the other, and B is moved until a point of its face
 * coincides with one of A's face. When something moves, they meet at the first moment and part, or
 * are about to meet at the last one, or slide along the plane.
 */
#include "study/draw/draft.h"

#include <math.h>

#include <gsl/gsl_randist.h>

enum { SIXTEENTHS = 16 }; /* weights are multiples of 1/16: sums of products stay exact */

typedef struct maker {
    study_draft *d;
    bool whole;
    int most; /* bound of drawn numbers */
    double n[STUDY_PAIR_MOST_DIM], nn;
    double level[STUDY_PAIR_MOST_DIM][STUDY_PAIR_MOST_DIM]; /* A's directions in the plane */
    int levels;
    double c[2][STUDY_PAIR_MOST_DIM]; /* the point of each that touches */
} maker;

static void draw(maker *m, double *x)
{
    if (m->whole)
        study_draw_whole(m->d, m->most, x, m->d->dim);
    else
        study_draw_even(m->d, m->most, x, m->d->dim);
}

static void draw_normal(maker *m)
{
    int dim = m->d->dim;
    do {
        if (m->whole)
            study_draw_whole(m->d, 3, m->n, dim);
        else
            study_draw_even(m->d, 1, m->n, dim);
        m->nn = study_dot(m->n, m->n, dim);
    } while (m->nn < 0.01);
}

static void draw_level(maker *m, double *x)
{
    int dim = m->d->dim;
    draw(m, x);
    double nx = study_dot(m->n, x, dim);
    for (int j = 0; j < dim; j++)
        x[j] = m->whole ? m->nn * x[j] - nx * m->n[j] : x[j] - nx / m->nn * m->n[j];
}

/* A direction in the plane: a new one, or for B one of A's. */
static void draw_edge(maker *m, int f, double *x)
{
    int dim = m->d->dim;
    if (f == 1 && m->levels > 0 && study_choice(m->d, 3) == 0) {
        const double *same = m->level[study_choice(m->d, m->levels)];
        double by = study_coin(m->d) ? 1 : study_coin(m->d) ? -1 : 2;
        for (int j = 0; j < dim; j++)
            x[j] = by * same[j];
        return;
    }
    draw_level(m, x);
    for (int j = 0; f == 0 && j < dim; j++)
        m->level[m->levels][j] = x[j];
    m->levels += f == 0;
}

/* Scales x to the intended length of the axis in that place. */
static void stretch(const maker *m, int f, int place, double *x)
{
    for (int j = 0; j < m->d->dim; j++)
        x[j] *= m->d->factor[f][place];
}

/* Let x point to the side of B (side > 0) or of A. */
static void point(const maker *m, double *x, int side)
{
    int dim = m->d->dim;
    bool turn = side * study_dot(m->n, x, dim) < 0;
    for (int j = 0; turn && j < dim; j++)
        x[j] = -x[j];
}

/* The first `faces` axes in `order` lie in the plane. A cuboid's others may point either way: the
 * face is at their far or near end. */
static void make_cuboid(maker *m, int f, const int *order, int faces)
{
    study_draft *d = m->d;
    int toward = f == 0 ? 1 : -1;
    for (int k = 0; k < d->naxes[f]; k++) {
        double *axis = d->axes[f] + order[k] * d->dim, *c = &m->c[f][order[k]];
        if (k < faces) {
            draw_edge(m, f, axis);
            *c = study_choice(d, SIXTEENTHS + 1) / (double)SIXTEENTHS;
        } else {
            draw(m, axis);
            *c = toward * study_dot(m->n, axis, d->dim) > 0;
        }
        stretch(m, f, order[k], axis);
    }
}

/* A simplex touches with its origin, or with the end of the axis `tip` (which then is the first in
 * order), and with the ends of the next `faces` axes. */
static void make_simplex(maker *m, int f, const int *order, int faces)
{
    study_draft *d = m->d;
    int n = d->naxes[f], toward = f == 0 ? 1 : -1, left = SIXTEENTHS;
    bool on_tip = n > faces && study_coin(d);
    double *tip = d->axes[f] + (n > 0 ? order[0] * d->dim : 0);
    if (on_tip) {
        draw(m, tip);
        point(m, tip, toward);
        stretch(m, f, order[0], tip);
    }
    for (int k = on_tip; k < n; k++) {
        double *axis = d->axes[f] + order[k] * d->dim, *c = &m->c[f][order[k]];
        *c = 0;
        if (k < faces + on_tip) {
            draw_edge(m, f, axis);
            stretch(m, f, order[k], axis);
            for (int j = 0; on_tip && j < d->dim; j++)
                axis[j] += tip[j];
            int part = study_choice(d, left + 1);
            *c = part / (double)SIXTEENTHS;
            left -= part;
        } else {
            draw(m, axis);
            point(m, axis, -toward);
            stretch(m, f, order[k], axis);
        }
    }
    if (on_tip)
        m->c[f][order[0]] = left / (double)SIXTEENTHS;
}

static void make_frame(maker *m, int f)
{
    study_draft *d = m->d;
    int order[STUDY_PAIR_MOST_DIM], n = d->naxes[f];
    int most = n < d->dim ? n : d->dim - 1; /* more would be dependent */
    for (int i = 0; i < n; i++)
        order[i] = i;
    if (n > 1)
        gsl_ran_shuffle(d->g, order, (size_t)n, sizeof *order);
    int faces = study_choice(d, most + 1);
    if (d->shape[f] == FMB_CUBOID)
        make_cuboid(m, f, order, faces);
    else
        make_simplex(m, f, order, faces);
}

/* The time of the contact; B moves by `drift` against A. */
static double make_drift(maker *m, double *drift)
{
    int way = study_choice(m->d, 4);
    if (way > 1) {
        draw_level(m, drift);
        return study_choice(m->d, SIXTEENTHS + 1) / (double)SIXTEENTHS;
    }
    draw(m, drift);
    point(m, drift, way == 0 ? 1 : -1);
    return way;
}

static double make_speeds(maker *m)
{
    study_draft *d = m->d;
    double drift[STUDY_PAIR_MOST_DIM], t = make_drift(m, drift);
    for (int j = 0; j < d->dim; j++)
        drift[j] *= d->haste;
    draw(m, d->speed[0]);
    for (int j = 0; j < d->dim; j++) {
        if (d->still >= 0)
            d->speed[0][j] = d->still == 0 ? 0 : -drift[j];
        d->speed[1][j] = d->speed[0][j] + drift[j];
    }
    return t;
}

void study_draw_touching(study_draft *d, bool whole, double *normal)
{
    static const int MOST[] = {4, 100, 1 << 20};
    static const double NOWHERE[STUDY_PAIR_MOST_DIM];
    maker m = {.d = d, .whole = whole, .most = MOST[study_choice(d, 3)]};
    draw_normal(&m);
    make_frame(&m, 0);
    make_frame(&m, 1);
    double t = d->moves ? make_speeds(&m) : 0;
    draw(&m, d->origin[0]);
    study_place(d, m.c[0], m.c[1], t, NOWHERE);
    for (int j = 0; j < d->dim; j++)
        normal[j] = m.n[j] / sqrt(m.nn);
}
