/* article.c: see article.h. */
#include "study/rivals/article.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double epsilon = 1e-7; /* of the article: absolute, in units of the first frame */

enum { MOST_ROWS = 1 << 20, LEVELS = STUDY_ROWS_MOST_DIM + 1 };

/* The rows over the variables from a certain one on, the right side last. */
typedef struct level {
    double *a; /* [m][columns] */
    size_t m, capacity;
    int columns;
} level;

struct study_article {
    study_rows rows;
    level at[LEVELS]; /* at[k]: over the variables k, k + 1, ... */
};

fmb_status study_article_new(study_article **out)
{
    study_article *w = calloc(1, sizeof *w);
    if (!w)
        return FMB_ERR_MEMORY;
    *out = w;
    return FMB_OK;
}

void study_article_free(study_article *w)
{
    if (!w)
        return;
    for (int k = 0; k < LEVELS; k++)
        free(w->at[k].a);
    free(w);
}

/* ---- elimination ----------------------------------------------------------------------------- */

/* The article's inconsistency: no point of the unit box satisfies the row, by more than slack. */
static bool is_refuted(const double *row, int n, double slack)
{
    double least = 0;
    for (int j = 0; j < n; j++)
        least += fmin(row[j], 0);
    return row[n] < least - slack;
}

/* A new last row; NULL without memory. */
static double *push(level *to)
{
    if (to->m == to->capacity) {
        size_t more = to->capacity ? 2 * to->capacity : 256;
        double *grown = realloc(to->a, more * (size_t)LEVELS * sizeof *grown);
        if (!grown)
            return NULL;
        to->a = grown;
        to->capacity = more;
    }
    return to->a + to->m++ * (size_t)to->columns;
}

/* Add the pair of rows p and q, each over its |first coefficient|. UNKNOWN goes on. */
static fmb_status pair_rows(const double *p, const double *q, level *to, fmb_verdict *out)
{
    double *row = push(to), over_p = fabs(p[0]), over_q = fabs(q[0]);
    if (!row)
        return FMB_ERR_MEMORY;
    for (int j = 0; j < to->columns; j++)
        row[j] = p[j + 1] / over_p + q[j + 1] / over_q;
    if (is_refuted(row, to->columns - 1, epsilon))
        *out = FMB_INFEASIBLE;
    return FMB_OK;
}

/* The first variable goes: every pair of opposite signs in the order of the rows, then the rows
 * without it. */
static fmb_status eliminate(const level *from, level *to, fmb_verdict *out)
{
    const double *end = from->a + from->m * (size_t)from->columns;
    fmb_status st = FMB_OK;
    to->m = 0;
    to->columns = from->columns - 1;
    for (const double *p = from->a; p < end; p += from->columns)
        for (const double *q = p + from->columns; fabs(p[0]) > epsilon && q < end;
             q += from->columns) {
            if (fabs(q[0]) <= epsilon || (p[0] > 0) == (q[0] > 0))
                continue;
            st = pair_rows(p, q, to, out);
            if (st != FMB_OK || *out == FMB_INFEASIBLE || to->m > MOST_ROWS)
                return st;
        }
    for (const double *p = from->a; p < end; p += from->columns)
        if (fabs(p[0]) < epsilon) {
            double *row = push(to);
            if (!row)
                return FMB_ERR_MEMORY;
            memcpy(row, p + 1, (size_t)to->columns * sizeof *row);
        }
    return FMB_OK;
}

/* The rows as they are, unless one of the first frame is refuted. */
static fmb_status load(study_article *w, fmb_verdict *out)
{
    const study_rows *s = &w->rows;
    level *to = &w->at[0];
    to->m = 0;
    to->columns = s->n + 1;
    for (int i = 0; i < s->m; i++) {
        double *row = push(to);
        if (!row)
            return FMB_ERR_MEMORY;
        memcpy(row, s->a[i], (size_t)(s->n + 1) * sizeof *row);
        if (i < s->facets && is_refuted(row, s->n, 0))
            *out = FMB_INFEASIBLE;
    }
    return FMB_OK;
}

/* ---- boxes ----------------------------------------------------------------------------------- */

/* The last variable: its rows bound it. */
static void bound_last(const level *rows, double *end)
{
    end[0] = 0;
    end[1] = 1;
    for (size_t i = 0; i < rows->m; i++) {
        const double *row = rows->a + i * (size_t)rows->columns;
        if (row[0] > epsilon)
            end[1] = fmin(end[1], row[1] / row[0]);
        else if (row[0] < -epsilon)
            end[0] = fmax(end[0], row[1] / row[0]);
    }
}

/* The loosest bound that a row puts on its first variable while the others are in box[1...]. */
static double loosest(const double *row, int columns, const double (*box)[2])
{
    double rest = row[columns - 1];
    for (int j = 1; j < columns - 1; j++)
        rest -= row[j] * box[j][row[j] > epsilon ? 0 : 1];
    return rest / row[0];
}

/* Another variable, box[0]. */
static void bound_first(const level *rows, study_article_box_kind kind, double (*box)[2])
{
    double *end = box[0];
    end[0] = 0;
    end[1] = 1;
    for (size_t i = 0; i < rows->m; i++) {
        const double *row = rows->a + i * (size_t)rows->columns;
        if (fabs(row[0]) <= epsilon)
            continue;
        double bound = loosest(row, rows->columns, (const double(*)[2])box);
        if (kind == STUDY_ARTICLE_PUBLISHED) {
            end[0] = fmin(end[0], bound);
            end[1] = fmax(end[1], bound);
        } else if (row[0] > 0) {
            end[1] = fmin(end[1], bound);
        } else {
            end[0] = fmax(end[0], bound);
        }
    }
}

/* Coordinate j of the corner of the box that the bits choose: bit k is the end of variable k. */
static double corner(const fmb_frame *q, int n, const double (*box)[2], unsigned bits, int j)
{
    double x = q->origin[j];
    for (int k = 0; k < q->dim; k++)
        x += q->axes[k * q->dim + j] * box[k][bits >> k & 1];
    return n > q->dim && q->speed ? x + q->speed[j] * box[n - 1][bits >> (n - 1) & 1] : x;
}

/* The box around all corners; as published, without the first corner at the last moment. */
static void export_box(const fmb_frame *q, int n, study_article_box_kind kind,
                       study_article_box *box)
{
    const double(*inside)[2] = (const double(*)[2])box->inside;
    unsigned forgotten = n > q->dim && kind == STUDY_ARTICLE_PUBLISHED ? 1u << (n - 1) : 0;
    for (int j = 0; j < q->dim; j++) {
        double *end = box->world[j];
        end[0] = end[1] = corner(q, n, inside, 0, j);
        for (unsigned bits = 1; bits < 1u << n; bits++) {
            if (bits == forgotten)
                continue;
            double x = corner(q, n, inside, bits, j);
            end[0] = fmin(end[0], x);
            end[1] = fmax(end[1], x);
        }
    }
}

/* ---- the test -------------------------------------------------------------------------------- */

/* Down to one variable; *out is INFEASIBLE if a row was refuted, else UNKNOWN; *all: it got there.
 */
static fmb_status go_down(study_article *w, bool *all, fmb_verdict *out)
{
    fmb_status st = load(w, out);
    int last = w->rows.n - 1, k = 0;
    for (; st == FMB_OK && *out == FMB_UNKNOWN && k < last && w->at[k].m <= MOST_ROWS; k++)
        st = eliminate(&w->at[k], &w->at[k + 1], out);
    *all = st == FMB_OK && *out == FMB_UNKNOWN && k == last && w->at[k].m <= MOST_ROWS;
    return st;
}

fmb_status study_article_test(study_article *w, const fmb_frame *p, const fmb_frame *q,
                              study_article_box_kind kind, study_article_box *box, fmb_verdict *out)
{
    double ends[2];
    bool all;
    *out = FMB_UNKNOWN;
    if (!study_rows_make(p, q, epsilon, &w->rows))
        return FMB_OK;
    int n = w->rows.n, last = n - 1;
    fmb_status st = go_down(w, &all, out);
    if (!all)
        return st;
    bound_last(&w->at[last], ends);
    *out = ends[0] < ends[1] ? FMB_FEASIBLE : FMB_INFEASIBLE;
    if (!box || *out == FMB_INFEASIBLE)
        return FMB_OK;
    memcpy(box->inside[last], ends, sizeof ends);
    for (int k = last - 1; k >= 0; k--)
        bound_first(&w->at[k], kind, box->inside + k);
    export_box(q, n, kind, box);
    return FMB_OK;
}
