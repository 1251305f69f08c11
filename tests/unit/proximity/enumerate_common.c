/* enumerate_common.c: see enumerate.h: common points. A frame is rows over the coordinates and the
 * time: with independent edges e_i and vectors at right angles to them, x = o + t s + sum c_i e_i
 * has c = C (x - o - t s) / det, C the cofactors: at most 1.4e5 where there is one edge alone,
 * times 400 on the right side, 100 with the time. A point where four rows meet is a quotient of
 * determinants below 1e28, and a row of it below 1e36.
 */
#include <stdlib.h>
#include <string.h>

#include "enumerate.h"

/* a.x <= b, or =. */
typedef struct row {
    bool equal;
    wide a[4], b;
} row;

enum { MOST_ROWS = 16 };

typedef struct rows {
    int dim, space, n; /* variables, coordinates */
    row at[MOST_ROWS];
} rows;

/* ---- the rows of a frame --------------------------------------------------------------------- */

static void cross(const long *x, const long *y, long *out)
{
    for (int j = 0; j < 3; j++)
        out[j] = x[(j + 1) % 3] * y[(j + 2) % 3] - x[(j + 2) % 3] * y[(j + 1) % 3];
}

/* Fill w, whose first rows are the edges, with vectors at right angles to these and to each other;
 * those of one dimension less are in the plane of the first two coordinates. */
static void complete_with_normals(const solid *s, long w[3][3])
{
    static const long unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int have = s->naxes;
    if (s->dim == 2)
        memcpy(w[2], unit[2], sizeof w[2]);
    for (int j = 0; have == 1 && j < 3; j++) {
        cross(w[0], s->dim == 2 ? unit[2] : unit[j], w[1]);
        have += w[1][0] != 0 || w[1][1] != 0 || w[1][2] != 0;
    }
    if (s->naxes == 0)
        memcpy(w, unit, sizeof unit);
    else if (s->dim == 3 && s->naxes < 3)
        cross(w[0], w[1], w[2]);
}

/* factor (n.(x - o - t s)) <= (or =) b. */
static void add_row(rows *r, const solid *s, const long *n, long factor, long b, bool equal)
{
    row *to = &r->at[r->n++];
    memset(to, 0, sizeof *to);
    to->equal = equal;
    to->b = b;
    for (int j = 0; j < s->dim; j++) {
        to->a[j] = (wide)factor * n[j];
        to->b += to->a[j] * s->origin[j];
        if (r->dim > r->space)
            to->a[r->space] -= to->a[j] * s->speed[j];
    }
}

/* False if edges depend on each other. */
static bool add_frame(rows *r, const solid *s)
{
    long w[3][3] = {{0}}, c[3][3], sum[3] = {0};
    memcpy(w, s->edge, (size_t)s->naxes * sizeof *w);
    complete_with_normals(s, w);
    for (int i = 0; i < 3; i++)
        cross(w[(i + 1) % 3], w[(i + 2) % 3], c[i]);
    long det = w[0][0] * c[0][0] + w[0][1] * c[0][1] + w[0][2] * c[0][2];
    long sign = det < 0 ? -1 : 1;
    for (int i = 0; i < s->dim; i++) {
        if (i >= s->naxes) {
            add_row(r, s, c[i], 1, 0, true);
            continue;
        }
        add_row(r, s, c[i], -sign, 0, false);
        if (s->cuboid)
            add_row(r, s, c[i], sign, sign * det, false);
        for (int j = 0; j < 3; j++)
            sum[j] += c[i][j];
    }
    if (!s->cuboid && s->naxes > 0)
        add_row(r, s, sum, sign, sign * det, false);
    return det != 0;
}

static void add_time(rows *r)
{
    for (int side = -1; side <= 1; side += 2) {
        row *to = &r->at[r->n++];
        memset(to, 0, sizeof *to);
        to->a[r->space] = side;
        to->b = side > 0;
    }
}

/* ---- where rows meet ------------------------------------------------------------------------- */

/* By the first column. */
static wide determinant(int n, wide a[4][5])
{
    wide sum = n == 0;
    for (int i = 0; i < n; i++) {
        wide less[4][5];
        for (int k = 0; k < n - 1; k++)
            memcpy(less[k], a[k < i ? k : k + 1] + 1, (size_t)(n - 1) * sizeof **less);
        if (a[i][0] != 0)
            sum += (i % 2 ? -1 : 1) * a[i][0] * determinant(n - 1, less);
    }
    return sum;
}

/* The only solution of n equations, by Cramer's rule; false if there is none, or more. */
static bool solve_equations(int n, wide a[4][5], wide *p, wide *q)
{
    wide det = determinant(n, a), sign = det < 0 ? -1 : 1;
    *q = sign * det;
    for (int j = 0; j < n && det != 0; j++) {
        wide b[4][5];
        memcpy(b, a, sizeof b);
        for (int i = 0; i < n; i++)
            b[i][j] = a[i][n];
        p[j] = sign * determinant(n, b);
    }
    return det != 0;
}

static bool satisfies(const rows *r, const wide *p, wide q)
{
    for (int i = 0; i < r->n; i++) {
        wide excess = -r->at[i].b * q;
        for (int j = 0; j < r->dim; j++)
            excess += r->at[i].a[j] * p[j];
        if (excess > 0 || (r->at[i].equal && excess != 0))
            return false;
    }
    return true;
}

static wide divisor(wide x, wide y)
{
    while (y != 0) {
        wide rest = x % y;
        x = y;
        y = rest;
    }
    return x < 0 ? -x : x;
}

static void add_point(common_points *out, const wide *p, wide q)
{
    wide least[4] = {0}, g = q;
    for (int j = 0; j < out->dim; j++)
        g = divisor(g, p[j]);
    for (int j = 0; j < out->dim; j++)
        least[j] = p[j] / g;
    for (int i = 0; i < out->n; i++)
        if (out->q[i] == q / g && memcmp(out->p[i], least, sizeof least) == 0)
            return;
    if (out->n == ENUMERATE_MOST_POINTS)
        abort();
    memcpy(out->p[out->n], least, sizeof least);
    out->q[out->n++] = q / g;
}

/* Sets of rows as bits. */
static void try_rows(const rows *r, unsigned set, common_points *out)
{
    wide a[4][5], p[4], q;
    int k = 0;
    for (int i = 0; i < r->n; i++)
        if (set >> i & 1) {
            memcpy(a[k], r->at[i].a, sizeof r->at[i].a);
            a[k++][r->dim] = r->at[i].b;
        }
    if (solve_equations(r->dim, a, p, &q) && satisfies(r, p, q))
        add_point(out, p, q);
}

bool enumerate_common(const solid *a, const solid *b, common_points *out)
{
    bool moves = false, good;
    for (int j = 0; j < a->dim; j++)
        moves |= a->speed[j] != 0 || b->speed[j] != 0;
    rows r = {.dim = a->dim + moves, .space = a->dim};
    good = add_frame(&r, a);
    good &= add_frame(&r, b);
    if (moves)
        add_time(&r);
    out->dim = r.dim;
    out->n = 0;
    for (unsigned set = 0; good && set < 1U << r.n; set++)
        if (__builtin_popcount(set) == r.dim)
            try_rows(&r, set, out);
    return good;
}
