/* rows.c: see rows.h. */
#include "study/rivals/rows.h"

#include <math.h>
#include <string.h>

#include "study/rivals/seen_frame.h"

enum { D = STUDY_ROWS_MOST_DIM };

/* ---- the inverse ----------------------------------------------------------------------------- */

static void swap_rows(double *p, double *q, int n)
{
    for (int j = 0; j < n; j++) {
        double kept = p[j];
        p[j] = q[j];
        q[j] = kept;
    }
}

/* Any number of axes: Gauss-Jordan on (axes | 1), the largest pivot of each column; w becomes (1 |
 * inverse). Returns the determinant. */
static double reduce(int dim, double w[D][2 * D])
{
    double det = 1;
    for (int k = 0; k < dim; k++) {
        int best = k;
        for (int i = k + 1; i < dim; i++)
            if (fabs(w[i][k]) > fabs(w[best][k]))
                best = i;
        if (w[best][k] == 0)
            return 0;
        if (best != k) {
            swap_rows(w[k], w[best], 2 * dim);
            det = -det;
        }
        double pivot = w[k][k];
        det *= pivot;
        for (int j = k; j < 2 * dim; j++)
            w[k][j] /= pivot;
        for (int i = 0; i < dim; i++) {
            double times = w[i][k];
            for (int j = k; i != k && j < 2 * dim; j++)
                w[i][j] -= times * w[k][j];
        }
    }
    return det;
}

double study_rows_invert_by_elimination(int dim, const double *a, double *to)
{
    double w[D][2 * D] = {{0}};
    for (int i = 0; i < dim; i++) {
        memcpy(w[i], a + i * dim, (size_t)dim * sizeof *a);
        w[i][dim + i] = 1;
    }
    double det = reduce(dim, w);
    for (int i = 0; i < dim; i++)
        for (int j = 0; j < dim; j++)
            to[i * dim + j] = w[j][dim + i];
    return det;
}

/* ---- the rows -------------------------------------------------------------------------------- */

static double *next_row(study_rows *s)
{
    double *row = s->a[s->m++];
    memset(row, 0, (size_t)(s->n + 1) * sizeof *row);
    return row;
}

/* 0 <= coordinates of p (<= 1, or their sum <= 1). */
static void put_facets(const fmb_frame *p, const study_rows_image *x, study_rows *s)
{
    int dim = p->dim, n = s->n;
    for (int i = 0; i < dim; i++) {
        double *row = next_row(s);
        for (int k = 0; k < n; k++)
            row[k] = -x->to[i][k];
        row[n] = x->base[i];
    }
    double *row = NULL;
    for (int i = 0; i < dim; i++) {
        if (!row || p->shape == FMB_CUBOID) {
            row = next_row(s);
            row[n] = 1;
        }
        for (int k = 0; k < n; k++)
            row[k] += x->to[i][k];
        row[n] -= x->base[i];
    }
    s->facets = s->m;
}

/* 0 <= c (<= 1, or sum c <= 1), 0 <= t <= 1. */
static void put_bounds(const fmb_frame *q, study_rows *s)
{
    int dim = q->dim, n = s->n;
    double *row = NULL;
    for (int k = 0; k < dim; k++) {
        if (!row || q->shape == FMB_CUBOID)
            row = next_row(s);
        row[k] = 1;
        row[n] = 1;
    }
    for (int k = 0; k < dim; k++)
        next_row(s)[k] = -1;
    if (n > dim) {
        row = next_row(s);
        row[dim] = row[n] = 1;
        next_row(s)[dim] = -1;
    }
}

bool study_rows_make(const fmb_frame *p, const fmb_frame *q, double least, study_rows *out)
{
    study_rows_image x;
    if (!study_rows_see(p->dim, p, q, least, &x))
        return false;
    out->n = p->dim + (p->speed || q->speed);
    out->m = 0;
    put_facets(p, &x, out);
    put_bounds(q, out);
    return true;
}
