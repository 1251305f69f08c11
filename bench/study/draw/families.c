/* families.c: the pairs of each family; see study/draw/pairs.h. */
#include "study/draw/draft.h"

#include <math.h>
#include <string.h>

typedef void drawing(study_draft *d, double *out, int n);

static void draw_hundreds(study_draft *d, double *out, int n)
{
    study_draw_even(d, 100, out, n);
}

static void draw_whole_hundreds(study_draft *d, double *out, int n)
{
    study_draw_whole(d, 100, out, n);
}

static void draw_whole_twos(study_draft *d, double *out, int n)
{
    study_draw_whole(d, 2, out, n);
}

static void draw_frame(study_draft *d, int f, drawing *draw)
{
    int dim = d->dim;
    draw(d, d->origin[f], dim);
    draw(d, d->axes[f], d->naxes[f] * dim);
    for (int j = 0; d->moves && j < dim; j++)
        d->speed[f][j] = 0;
    if (d->moves && f != d->still)
        draw(d, d->speed[f], dim);
}

/* The volume that the axes span: |det| if there are as many as dimensions. */
static double volume(const double *axes, int n, int dim)
{
    double v[STUDY_PAIR_MOST_DIM][STUDY_PAIR_MOST_DIM], squared = 1;
    for (int i = 0; i < n; i++) {
        memcpy(v[i], axes + i * dim, (size_t)dim * sizeof(double));
        for (int k = 0; k < i; k++) {
            double by = study_dot(v[i], v[k], dim) / study_dot(v[k], v[k], dim);
            for (int j = 0; j < dim; j++)
                v[i][j] -= by * v[k][j];
        }
        squared *= study_dot(v[i], v[i], dim);
    }
    return sqrt(squared);
}

static void draw_usual(study_draft *d, drawing *draw)
{
    for (int f = 0; f < 2; f++)
        do
            draw_frame(d, f, draw);
        while (!(volume(d->axes[f], d->naxes[f], d->dim) > 0.1));
}

static double largest(const double *x, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

static void scale(double *x, int n, double by)
{
    for (int i = 0; i < n; i++)
        x[i] *= by;
}

static double draw_time(study_draft *d)
{
    return gsl_rng_uniform(d->g);
}

/* At some time, a boundary point of B is off one of A by at most `beside` in each coordinate. */
static void put_beside(study_draft *d, double beside)
{
    double cp[STUDY_PAIR_MOST_DIM], cq[STUDY_PAIR_MOST_DIM], off[STUDY_PAIR_MOST_DIM];
    study_draw_boundary(d, 0, cp);
    study_draw_boundary(d, 1, cq);
    study_draw_even(d, beside, off, d->dim);
    study_place(d, cp, cq, draw_time(d), off);
}

/* ---- one function a family ------------------------------------------------------------------- */

static void draw_article(study_draft *d)
{
    draw_usual(d, draw_hundreds);
}

static void draw_integer(study_draft *d)
{
    draw_usual(d, draw_whole_hundreds);
}

static void draw_lattice(study_draft *d)
{
    for (int f = 0; f < 2; f++)
        draw_frame(d, f, draw_whole_twos);
}

static void draw_touching(study_draft *d)
{
    double normal[STUDY_PAIR_MOST_DIM];
    study_draw_touching(d, true, normal);
}

/* Off contact by a share of 1e-6 ... 1e-15 of the longest axis, either way. */
static void draw_near(study_draft *d)
{
    double normal[STUDY_PAIR_MOST_DIM];
    study_draw_touching(d, study_coin(d), normal);
    double size = 0;
    for (int f = 0; f < 2; f++)
        size = fmax(size, largest(d->axes[f], d->naxes[f] * d->dim));
    double off = size * pow(10, -6 - 9 * gsl_rng_uniform(d->g));
    off = study_coin(d) ? off : -off;
    for (int j = 0; j < d->dim; j++)
        d->origin[1][j] += off * normal[j];
}

/* One in four pairs of some families touches, or nearly so. */
static bool draw_in_contact(study_draft *d)
{
    bool whole = study_coin(d);
    if (study_choice(d, 4) > 0)
        return false;
    double normal[STUDY_PAIR_MOST_DIM];
    study_draw_touching(d, whole, normal);
    return true;
}

/* A short axis in any direction, or a long one that is off the span of the others by as little. */
static double flatten(study_draft *d, int f)
{
    double thin = study_coin(d) ? 1e-6 : 1e-8;
    int dim = d->dim, n = d->naxes[f];
    if (n == 0)
        return thin;
    double *axis = d->axes[f] + study_choice(d, n) * dim;
    scale(axis, dim, thin / sqrt(study_dot(axis, axis, dim)));
    for (int i = 0; i < n && study_choice(d, 2); i++) {
        const double *other = d->axes[f] + i * dim;
        double by = 2 * gsl_rng_uniform(d->g) - 1;
        for (int j = 0; other != axis && j < dim; j++)
            axis[j] += by * other[j];
    }
    return thin;
}

static void draw_flat(study_draft *d)
{
    int which = study_choice(d, 3);
    double thin = 0;
    for (int f = 0; f < 2; f++)
        if (which != f && d->naxes[f] > 0)
            d->factor[f][study_choice(d, d->naxes[f])] = study_coin(d) ? 0x1p-20 : 0x1p-27;
    if (draw_in_contact(d))
        return;
    draw_article(d);
    for (int f = 0; f < 2; f++)
        if (which != f)
            thin = fmax(thin, flatten(d, f));
    if (study_choice(d, 4) > 0)
        put_beside(d, study_coin(d) ? thin : 100 * thin);
}

static void make_dependent(study_draft *d, int f)
{
    int dim = d->dim, n = d->naxes[f];
    if (n == 0)
        return;
    int which = study_choice(d, n), other = study_choice(d, n), third = study_choice(d, n);
    double *axis = d->axes[f] + which * dim;
    int by[2] = {study_choice(d, 5) - 2, study_choice(d, 3) - 1};
    for (int j = 0; j < dim; j++)
        axis[j] = (other == which ? 0 : by[0] * d->axes[f][other * dim + j]) +
                  (third == which ? 0 : by[1] * d->axes[f][third * dim + j]);
}

/* Coordinate j of frame f becomes 0, except perhaps that of its origin. */
static void lay_flat(study_draft *d, int f, int j, bool origin)
{
    for (int i = 0; i < d->naxes[f]; i++)
        d->axes[f][i * d->dim + j] = 0;
    if (origin)
        d->origin[f][j] = 0;
    if (d->moves && origin && study_coin(d))
        d->speed[f][j] = 0;
}

static void draw_degenerate(study_draft *d)
{
    drawing *draw = study_coin(d) ? draw_whole_twos : draw_whole_hundreds;
    for (int f = 0; f < 2; f++)
        draw_frame(d, f, draw);
    int which = study_choice(d, 3), last = d->dim - 1;
    bool planes = study_coin(d);
    for (int f = 0; f < 2; f++)
        if (which != f && planes)
            lay_flat(d, f, last, study_choice(d, 4) > 0);
        else if (which != f)
            make_dependent(d, f);
}

/* Frame f is the smaller one by 1e9. */
static void draw_tiny(study_draft *d, int f)
{
    bool small = study_coin(d);
    for (int i = 0; i < STUDY_PAIR_MOST_DIM; i++)
        d->factor[small ? f : 1 - f][i] = small ? 0x1p-30 : 0x1p30;
    if (draw_in_contact(d))
        return;
    draw_article(d);
    int n = d->naxes[f] * d->dim, m = d->naxes[1 - f] * d->dim;
    if (small)
        scale(d->axes[f], n, 1e-9);
    else
        scale(d->axes[1 - f], m, 1e9);
    if (!small && d->moves && study_coin(d))
        for (int i = 0; i < 2; i++)
            scale(d->speed[i], d->dim, 1e9);
    if (study_choice(d, 4) > 0)
        put_beside(d, small ? 1e-7 : 100);
}

static void draw_tiny_a(study_draft *d)
{
    draw_tiny(d, 0);
}

static void draw_tiny_b(study_draft *d)
{
    draw_tiny(d, 1);
}

static void draw_far(study_draft *d)
{
    double there[STUDY_PAIR_MOST_DIM];
    if (study_coin(d))
        draw_article(d);
    else
        draw_touching(d);
    study_draw_whole(d, 1, there, d->dim);
    there[study_choice(d, d->dim)] = 1;
    for (int f = 0; f < 2; f++)
        for (int j = 0; j < d->dim; j++)
            d->origin[f][j] += 1e9 * there[j];
}

static void shrink(study_draft *d, int f, double by)
{
    scale(d->axes[f], d->naxes[f] * d->dim, by);
    scale(d->origin[f], d->dim, by);
    if (d->moves)
        scale(d->speed[f], d->dim, by);
}

static void draw_denormal(study_draft *d)
{
    static const int DOWN[] = {-1074, -1070, -1050, -1022, -540, -360};
    if (study_coin(d))
        draw_integer(d);
    else
        draw_touching(d);
    double by = ldexp(1, DOWN[study_choice(d, 6)]);
    int which = study_choice(d, 4); /* mostly both; or one, beside a corner of the other */
    for (int f = 0; f < 2; f++)
        if (which != f)
            shrink(d, f, by);
    for (int j = 0; which < 2 && j < d->dim; j++)
        d->origin[which][j] = 0;
}

static void stretch(study_draft *d, double by)
{
    int f = study_choice(d, 2);
    if (d->moves)
        for (int i = 0; i < 2; i++)
            scale(d->speed[i], d->dim, by);
    else if (d->naxes[f] > 0)
        scale(d->axes[f] + study_choice(d, d->naxes[f]) * d->dim, d->dim, by);
}

/* A frame that does not move has one long axis instead. */
static void draw_swept(study_draft *d)
{
    int far = 3 + study_choice(d, 20);
    d->haste = ldexp(1, far);
    if (!d->moves && d->naxes[0] > 0)
        d->factor[0][study_choice(d, d->naxes[0])] = d->haste;
    if (draw_in_contact(d))
        return;
    draw_article(d);
    stretch(d, d->haste);
    put_beside(d, study_coin(d) ? 30 : 300);
}

/* Pairs of other families, whose numbers may then be multiplied by powers of 2. */
static void draw_any(study_draft *d)
{
    study_family_draw *const draw[] = {draw_article, draw_touching, draw_near};
    draw[study_choice(d, 3)](d);
}

/* No coordinate of a corner of frame f at any time is larger. */
static double reach(const study_draft *d, int f)
{
    double most = 0;
    for (int j = 0; j < d->dim; j++) {
        double far = fabs(d->origin[f][j]) + (d->moves ? fabs(d->speed[f][j]) : 0);
        for (int i = 0; i < d->naxes[f]; i++)
            far += fabs(d->axes[f][i * d->dim + j]);
        most = fmax(most, far);
    }
    return most;
}

/* One in two pairs has numbers near the largest or the smallest double. Coordinates of common
 * points are doubles; differences may overflow or underflow. */
static void draw_scaled(study_draft *d)
{
    draw_any(d);
    int size = ilogb(fmax(fmax(reach(d, 0), reach(d, 1)), 1));
    int least = -1074 - size, most = 1022 - size;
    int inward = study_choice(d, study_coin(d) ? 64 : most - least);
    int power = study_coin(d) ? most - inward : least + inward;
    for (int f = 0; f < 2; f++) /* in two steps, as 2^-1100 is no double */
        for (int half = 0; half < 2; half++)
            shrink(d, f, ldexp(1, half ? power - power / 2 : power / 2));
}

/* Coordinate j of both frames. */
static void scale_coordinate(study_draft *d, int j, double by)
{
    for (int f = 0; f < 2; f++) {
        d->origin[f][j] *= by;
        for (int i = 0; i < d->naxes[f]; i++)
            d->axes[f][i * d->dim + j] *= by;
        if (d->moves)
            d->speed[f][j] *= by;
    }
}

static void draw_spread(study_draft *d)
{
    static const int MOST[] = {10, 60, 300, 900};
    int most = MOST[study_choice(d, 4)];
    draw_any(d);
    for (int j = 0; j < d->dim; j++)
        scale_coordinate(d, j, ldexp(1, study_choice(d, 2 * most + 1) - most));
}

/* Scales every other number. */
static void tear(study_draft *d, double *x, int n, int most)
{
    for (int k = 0; k < n; k++)
        if (study_coin(d))
            x[k] = ldexp(x[k], -study_choice(d, most + 1));
}

/* The largest numbers are often about 1, which the kernels accept, and products of the others
 * underflow. */
static void draw_ragged(study_draft *d)
{
    static const int MOST[] = {20, 60, 400, 1080};
    int most = MOST[study_choice(d, 4)];
    draw_any(d);
    for (int f = 0; f < 2; f++) {
        tear(d, d->origin[f], d->dim, most);
        tear(d, d->axes[f], d->naxes[f] * d->dim, most);
        if (d->moves)
            tear(d, d->speed[f], d->dim, most);
    }
}

/* So that a simplex may have one far corner, and faces that are long one way alone. */
static void draw_uneven(study_draft *d)
{
    static const int MOST[] = {4, 12, 24, 40};
    int most = MOST[study_choice(d, 4)];
    for (int f = 0; f < 2; f++)
        for (int i = 0; i < d->naxes[f]; i++)
            if (study_choice(d, 3) == 0)
                d->factor[f][i] = ldexp(1, study_choice(d, 2 * most + 1) - most);
    if (study_coin(d))
        draw_near(d);
    else
        draw_touching(d);
}

study_family_draw *const study_family_draws[STUDY_PAIR_FAMILIES] = {
    [STUDY_PAIR_ARTICLE] = draw_article,   [STUDY_PAIR_LATTICE] = draw_lattice,
    [STUDY_PAIR_TOUCHING] = draw_touching, [STUDY_PAIR_NEAR] = draw_near,
    [STUDY_PAIR_FLAT] = draw_flat,         [STUDY_PAIR_DEGENERATE] = draw_degenerate,
    [STUDY_PAIR_TINY_A] = draw_tiny_a,     [STUDY_PAIR_TINY_B] = draw_tiny_b,
    [STUDY_PAIR_FAR] = draw_far,           [STUDY_PAIR_DENORMAL] = draw_denormal,
    [STUDY_PAIR_SWEPT] = draw_swept,       [STUDY_PAIR_INTEGER] = draw_integer,
    [STUDY_PAIR_SCALED] = draw_scaled,     [STUDY_PAIR_SPREAD] = draw_spread,
    [STUDY_PAIR_RAGGED] = draw_ragged,     [STUDY_PAIR_UNEVEN] = draw_uneven,
};
