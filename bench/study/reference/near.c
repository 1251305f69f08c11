/* near.c: see near.h.
 *
 * Where both frames span the space, x alone tells its coordinates in both, but for the time: in
 * doubles. Those that are at an end stay there, and some of the others, which are as far from an
 * end as can be, solve the equations in whole numbers. What comes out is a common point, or not:
 * certificate.h looks.
 */
#include "study/reference/near.h"

#include <math.h>

#include "study/reference/basis.h"

enum { MOST = STUDY_PAIR_MOST_DIM };

/* What is linear in time. */
typedef struct moving {
    double still, speed;
} moving;

typedef struct place {
    study_proposer *w;
    const study_meeting *s;
    double least, most;   /* time */
    moving right[MOST];   /* what the axes of a frame have to add up to */
    moving z[COLUMNS];    /* also of slacks */
    double high[COLUMNS]; /* the other end; 0 is one */
} place;

/* x 2^-down */
static double scaled(const mpz_t x, int down)
{
    long exponent;
    double part = mpz_get_d_2exp(&exponent, x);
    return part == 0 ? 0 : ldexp(part, (int)exponent - down);
}

/* The coordinates in frame f of what is at `right` from its corner, by elimination. False: its axes
 * do not span the space. */
static bool find_coordinates(place *p, int f)
{
    const int n = p->s->dim, first = p->s->from[f];
    double a[MOST][MOST];
    moving b[MOST];
    for (int i = 0; i < n; i++) {
        b[i] = p->right[i];
        for (int j = 0; j < n; j++)
            a[i][j] = p->w->g->pair.m[(first + j) * n + i];
    }
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            best = fabs(a[i][k]) > fabs(a[best][k]) ? i : best;
        if (a[best][k] == 0)
            return false;
        for (int j = 0; j < n; j++) {
            double x = a[k][j];
            a[k][j] = a[best][j];
            a[best][j] = x;
        }
        moving x = b[k];
        b[k] = b[best];
        b[best] = x;
        for (int i = k + 1; i < n; i++) {
            double by = a[i][k] / a[k][k];
            for (int j = k; j < n; j++)
                a[i][j] -= by * a[k][j];
            b[i].still -= by * b[k].still;
            b[i].speed -= by * b[k].speed;
        }
    }
    for (int k = n; k-- > 0;) {
        for (int j = k + 1; j < n; j++) {
            b[k].still -= a[k][j] * p->z[first + j].still;
            b[k].speed -= a[k][j] * p->z[first + j].speed;
        }
        p->z[first + k] = (moving){b[k].still / a[k][k], b[k].speed / a[k][k]};
    }
    return true;
}

/* From the corner of A to x: x - origin - speed t; from x to that of B, in the same way. */
static bool find_both(place *p, const double *x)
{
    const study_meeting *s = p->s;
    const fmb_general_system *pair = &p->w->g->pair;
    for (int i = 0; i < s->dim; i++) {
        int down = p->w->row_bits[i];
        double at = ldexp(x[i], -s->unit[i] - down) - scaled(s->origin[i], down);
        p->right[i] = (moving){at, -scaled(s->speed[i], down + p->w->group_bits[2])};
    }
    if (!find_coordinates(p, 0))
        return false;
    for (int i = 0; i < s->dim; i++) {
        double drift = s->columns > s->from[2] ? pair->m[s->from[2] * s->dim + i] : 0;
        p->right[i].still = pair->h[i] - p->right[i].still;
        p->right[i].speed = -drift - p->right[i].speed;
    }
    return find_coordinates(p, 1);
}

/* The sum of a simplex leaves its slack. */
static void find_slacks(place *p)
{
    const study_meeting *s = p->s;
    int slack = s->columns;
    for (int f = 0; f < 2; f++) {
        double end = ldexp(1, p->w->group_bits[f]);
        for (int j = s->from[f]; j < s->from[f + 1]; j++)
            p->high[j] = end;
        if (s->shape[f] == FMB_CUBOID)
            continue;
        p->high[slack] = end;
        p->z[slack] = (moving){end, 0};
        for (int j = s->from[f]; j < s->from[f + 1]; j++) {
            p->z[slack].still -= p->z[j].still;
            p->z[slack].speed -= p->z[j].speed;
        }
        slack++;
    }
}

/* a + b t >= 0 */
static void cut_time(place *p, double a, double b)
{
    if (b > TINY)
        p->least = fmax(p->least, -a / b);
    else if (b < -TINY)
        p->most = fmin(p->most, -a / b);
}

/* Any time at which x is in both, and where everything is then. */
static void stop_time(place *p)
{
    const fmb_general_system *g = &p->w->g->program;
    const int time = p->s->from[2];
    const bool moves = p->s->columns > time;
    p->least = 0;
    p->most = moves ? ldexp(1, p->w->group_bits[2]) : 0;
    p->high[time] = moves ? p->most : p->high[time];
    for (int j = 0; j < g->columns; j++)
        if (!moves || j != time) {
            cut_time(p, p->z[j].still, p->z[j].speed);
            cut_time(p, p->high[j] - p->z[j].still, -p->z[j].speed);
        }
    double t = p->least / 2 + p->most / 2;
    if (moves)
        p->z[time] = (moving){t, 0};
    for (int j = 0; j < g->columns; j++)
        p->z[j] = (moving){p->z[j].still + p->z[j].speed * t, 0};
}

/* How far unknown j is from an end. */
static double room(const place *p, int j)
{
    return fmin(p->z[j].still, p->high[j] - p->z[j].still);
}

/* The pivots are those with the most room that are independent. */
static bool choose_pivots(place *p)
{
    fmb_general_system *g = &p->w->g->program;
    double a[COLUMNS][ROWS];
    bool done[COLUMNS] = {false};
    int filled = 0;
    for (int j = 0; j < g->columns; j++) {
        g->is_pivot[j] = false;
        for (int i = 0; i < g->rows; i++)
            a[j][i] = g->m[j * g->rows + i];
    }
    for (int step = 0; step < g->columns && filled < g->rows; step++) {
        int next = -1, row = 0;
        for (int j = 0; j < g->columns; j++)
            if (!done[j] && (next < 0 || room(p, j) > room(p, next)))
                next = j;
        done[next] = true;
        for (int i = 1; i < g->rows; i++)
            row = fabs(a[next][i]) > fabs(a[next][row]) ? i : row;
        if (fabs(a[next][row]) < TINY)
            continue;
        for (int j = 0; j < g->columns; j++) {
            double by = done[j] ? 0 : a[j][row] / a[next][row];
            for (int i = 0; by != 0 && i < g->rows; i++)
                a[j][i] = i == row ? 0 : a[j][i] - by * a[next][i];
        }
        g->is_pivot[next] = true;
        g->pivot[filled++] = next;
    }
    return filled == g->rows;
}

/* Unknowns that are as near to an end are at it. */
static bool prove_with(place *p, study_meeting *s, const double *x, double near, double end)
{
    const fmb_general_system *g = &p->w->g->program;
    double at[COLUMNS];
    for (int j = 0; j < g->columns; j++)
        at[j] = p->z[j].still < end ? 0 : p->high[j] - p->z[j].still < end ? 1 : p->z[j].still;
    return study_basis_solve_point(p->w, s, at) &&
           study_meeting_is_near(s, p->w->z, p->w->scale, x, near);
}

/* Where numbers are far from 0, rounding tells less of what is at an end. */
bool study_prove_near(study_proposer *w, study_meeting *s, const double *x, double near)
{
    place p = {.w = w, .s = s};
    if (s->from[1] != s->dim || s->from[2] != 2 * s->dim || !find_both(&p, x))
        return false;
    find_slacks(&p);
    stop_time(&p);
    return choose_pivots(&p) &&
           (prove_with(&p, s, x, near, TINY * TINY) || prove_with(&p, s, x, near, TINY));
}
