/* difference.c: see difference.h.
 *
 * Each coordinate has its own unit, and what all numbers of an edge share of powers of 2 goes out
 * of it: so whole numbers are short wherever doubles differ in size from frame to frame, or from
 * one coordinate to the next. A normal n of these numbers is n_j / 2^finer_j in one unit.
 */
#include "fmb-validate/difference.h"

#include <limits.h>
#include <math.h>

#include "study/reference/certificate.h"

enum { MOST = VALIDATE_MOST_DIM };

/* ---- life ------------------------------------------------------------------------------------ */

static void for_each_number(validate_difference *m, void (*what)(mpz_ptr))
{
    for (int j = 0; j < MOST; j++) {
        what(m->away[j]);
        what(m->drift[j]);
        for (int i = 0; i < 2 * MOST; i++)
            what(m->axis[i / MOST][i % MOST][j]);
        for (int i = 0; i < VALIDATE_MOST_EDGES; i++)
            what(m->edge[i].x[j]);
    }
}

static void start_number(mpz_ptr x)
{
    mpz_init(x);
}

static void end_number(mpz_ptr x)
{
    mpz_clear(x);
}

void validate_difference_init(validate_difference *m)
{
    for_each_number(m, start_number);
}

void validate_difference_clear(validate_difference *m)
{
    for_each_number(m, end_number);
}

/* ---- numbers --------------------------------------------------------------------------------- */

/* Of every step-th number. */
static int lowest_unit(const double *x, int n, int step, int unit)
{
    for (int i = 0; x && i < n; i += step) {
        double whole;
        int exponent;
        study_split(x[i], &whole, &exponent);
        if (whole != 0 && exponent < unit)
            unit = exponent;
    }
    return unit;
}

/* Add sign times x, a number of coordinate j. */
static void add_double(const validate_difference *m, int j, double x, int sign, mpz_t to)
{
    double whole;
    int exponent;
    mpz_t z;
    study_split(x, &whole, &exponent);
    mpz_init_set_d(z, sign * whole);
    if (mpz_sgn(z) != 0)
        mpz_mul_2exp(z, z, (mp_bitcnt_t)(exponent - m->unit - m->finer[j]));
    mpz_add(to, to, z);
    mpz_clear(z);
}

/* A direction stays what it is without the powers of 2 that its numbers share. */
static void shorten(const validate_difference *m, validate_edge *e)
{
    mp_bitcnt_t shared = ULONG_MAX;
    for (int j = 0; j < m->dim; j++)
        if (mpz_sgn(e->x[j]) != 0 && mpz_scan1(e->x[j], 0) < shared)
            shared = mpz_scan1(e->x[j], 0);
    for (int j = 0; j < m->dim; j++)
        if (mpz_sgn(e->x[j]) != 0)
            mpz_tdiv_q_2exp(e->x[j], e->x[j], shared);
}

/* An edge between two corners; 0 is the origin. */
static void add_edge(validate_difference *m, int side, int from, int to)
{
    validate_edge *e = &m->edge[m->edges++];
    e->side = side;
    e->corner = from;
    e->to = to;
    for (int j = 0; j < m->dim; j++) {
        mpz_set(e->x[j], m->axis[side][to - 1][j]);
        if (from > 0)
            mpz_sub(e->x[j], e->x[j], m->axis[side][from - 1][j]);
    }
    shorten(m, e);
}

static void list_edges(validate_difference *m)
{
    m->edges = 0;
    for (int side = 0; side < 2; side++)
        for (int from = 0; from == 0 || (m->simplex[side] && from < m->naxes[side]); from++)
            for (int to = from + 1; to <= m->naxes[side]; to++)
                add_edge(m, side, from, to);
    if (!m->moves)
        return;
    validate_edge *e = &m->edge[m->edges++];
    e->side = 2;
    for (int j = 0; j < m->dim; j++)
        mpz_set(e->x[j], m->drift[j]);
    shorten(m, e);
}

/* Of all coordinates, and of each; 0 where there is nothing but zeros. */
static void find_units(validate_difference *m, const fmb_frame *const f[2])
{
    int unit[MOST], dim = m->dim;
    m->unit = INT_MAX;
    for (int j = 0; j < dim; j++) {
        unit[j] = INT_MAX;
        for (int k = 0; k < 2; k++) {
            unit[j] = lowest_unit(f[k]->origin + j, 1, 1, unit[j]);
            unit[j] = lowest_unit(f[k]->axes + j, dim * f[k]->naxes - j, dim, unit[j]);
            unit[j] = lowest_unit(f[k]->speed ? f[k]->speed + j : NULL, 1, 1, unit[j]);
        }
        m->unit = unit[j] < m->unit ? unit[j] : m->unit;
    }
    m->unit = m->unit == INT_MAX ? 0 : m->unit;
    for (int j = 0; j < dim; j++)
        m->finer[j] = unit[j] == INT_MAX ? 0 : unit[j] - m->unit;
}

void validate_difference_load(validate_difference *m, const fmb_frame *p, const fmb_frame *q)
{
    const fmb_frame *const f[2] = {p, q};
    m->dim = p->dim;
    m->moves = p->speed || q->speed;
    for (int k = 0; k < 2; k++) {
        m->naxes[k] = f[k]->naxes;
        m->simplex[k] = f[k]->shape == FMB_SIMPLEX;
    }
    find_units(m, f);
    for (int j = 0; j < m->dim; j++) {
        mpz_set_ui(m->away[j], 0);
        mpz_set_ui(m->drift[j], 0);
        for (int k = 0; k < 2; k++) {
            int sign = k == 0 ? 1 : -1;
            add_double(m, j, f[k]->origin[j], sign, m->away[j]);
            if (f[k]->speed)
                add_double(m, j, f[k]->speed[j], sign, m->drift[j]);
            for (int i = 0; i < f[k]->naxes; i++) {
                mpz_set_ui(m->axis[k][i][j], 0);
                add_double(m, j, f[k]->axes[i * m->dim + j], sign, m->axis[k][i][j]);
            }
        }
    }
    list_edges(m);
}

/* ---- how far M reaches ----------------------------------------------------------------------- */

static void dot(validate_difference *m, mpz_t *a, mpz_t *b, mpz_t out)
{
    mpz_set_ui(out, 0);
    for (int j = 0; j < m->dim; j++)
        mpz_addmul(out, a[j], b[j]);
}

void validate_ends(validate_difference *m, mpz_t *y, mpz_t least, mpz_t most)
{
    mpz_t span[2], part;
    mpz_inits(span[0], span[1], part, NULL);
    dot(m, m->away, y, most);
    dot(m, m->drift, y, part);
    mpz_set(least, most);
    mpz_ptr end = mpz_sgn(part) > 0 ? most : least;
    mpz_add(end, end, part);
    for (int k = 0; k < 2; k++) {
        mpz_set_ui(span[0], 0);
        mpz_set_ui(span[1], 0);
        for (int i = 0; i < m->naxes[k]; i++) {
            dot(m, m->axis[k][i], y, part);
            mpz_ptr way = span[mpz_sgn(part) > 0];
            if (!m->simplex[k])
                mpz_add(way, way, part);
            else if (mpz_cmpabs(part, way) > 0)
                mpz_set(way, part);
        }
        mpz_add(least, least, span[0]);
        mpz_add(most, most, span[1]);
    }
    mpz_clears(span[0], span[1], part, NULL);
}
