/* article.c: see article.h. */
#include "study/rivals/article.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/rivals/seen_frame.h"

static const double epsilon = 1e-7; /* of the article: absolute, in units of the first frame */

enum { MOST_ROWS = 1 << 20, LEVELS = STUDY_ROWS_MOST_DIM + 1 };

/* Inlined, so that the common numbers of variables are constants, as in the article's program. */
#define ARTICLE_INLINE static inline __attribute__((always_inline))

/* The rows over the variables from some k on, the right side last. */
typedef struct level {
    double *a; /* [m][columns] */
    size_t m, capacity;
    int columns;
} level;

struct study_article {
    level at[LEVELS]; /* at[k]: over the variables k, k + 1, ... */
};

/* How far the test has come. */
typedef enum progress { GOES_ON, REFUTED, NO_INVERSE, TOO_MANY, NO_MEMORY } progress;

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

/* Room for `more` rows. */
static inline bool reserve(level *to, size_t more)
{
    if (to->m + more <= to->capacity)
        return true;
    size_t wanted = 2 * to->capacity + more + 256;
    double *grown = realloc(to->a, wanted * (size_t)(LEVELS + 1) * sizeof *grown);
    if (!grown)
        return false;
    to->a = grown;
    to->capacity = wanted;
    return true;
}

/* ---- the rows -------------------------------------------------------------------------------- */

/* min(x, 0): unpredictable, so without a branch, as in the article's program. */
ARTICLE_INLINE double negative_part(double x)
{
    return (x - fabs(x)) / 2;
}

/* The article's inconsistency: no point of the unit box satisfies the row, by more than slack. */
ARTICLE_INLINE bool is_refuted(const double *row, int n, double slack)
{
    double least = 0;
    for (int j = 0; j < n; j++)
        least += negative_part(row[j]);
    return row[n] < least - slack;
}

/* 0 <= coordinates of p (<= 1, or their sum <= 1); each row is tested as soon as it is there. */
ARTICLE_INLINE progress put_facets(int dim, int n, const fmb_frame *p, const study_rows_image *x,
                                   double *row)
{
    for (int i = 0; i < dim; i++, row += n + 1) {
        for (int k = 0; k < n; k++)
            row[k] = -x->to[i][k];
        row[n] = x->base[i];
        if (is_refuted(row, n, 0))
            return REFUTED;
    }
    for (int i = 0; p->shape == FMB_CUBOID && i < dim; i++, row += n + 1) {
        for (int k = 0; k < n; k++)
            row[k] = x->to[i][k];
        row[n] = 1 - x->base[i];
        if (is_refuted(row, n, 0))
            return REFUTED;
    }
    if (p->shape == FMB_CUBOID)
        return GOES_ON;
    memset(row, 0, (size_t)n * sizeof *row);
    row[n] = 1;
    for (int i = 0; i < dim; i++) {
        for (int k = 0; k < n; k++)
            row[k] += x->to[i][k];
        row[n] -= x->base[i];
    }
    return is_refuted(row, n, 0) ? REFUTED : GOES_ON;
}

/* c <= 1, or their sum <= 1; 0 <= c; 0 <= t <= 1. Returns the end of the rows. */
ARTICLE_INLINE double *put_bounds(int dim, int n, const fmb_frame *q, double *row)
{
    size_t size = (size_t)(n + 1) * sizeof *row;
    for (int i = 0; q->shape == FMB_CUBOID && i < dim; i++, row += n + 1) {
        memset(row, 0, size);
        row[i] = row[n] = 1;
    }
    if (q->shape == FMB_SIMPLEX) {
        for (int k = 0; k <= n; k++)
            row[k] = 1;
        if (n > dim)
            row[dim] = 0;
        row += n + 1;
    }
    for (int i = 0; i < dim; i++, row += n + 1) {
        memset(row, 0, size);
        row[i] = -1;
    }
    for (int side = 1; n > dim && side >= -1; side -= 2, row += n + 1) {
        memset(row, 0, size);
        row[dim] = side;
        row[n] = side == 1;
    }
    return row;
}

ARTICLE_INLINE progress put_rows(int dim, int n, const fmb_frame *p, const fmb_frame *q, level *to)
{
    study_rows_image x;
    int facets = p->shape == FMB_CUBOID ? 2 * dim : dim + 1;
    to->m = 0;
    to->columns = n + 1;
    if (!reserve(to, STUDY_ROWS_MOST))
        return NO_MEMORY;
    if (!study_rows_see(dim, p, q, epsilon, &x))
        return NO_INVERSE;
    progress at = put_facets(dim, n, p, &x, to->a);
    if (at != GOES_ON)
        return at;
    double *end = put_bounds(dim, n, q, to->a + facets * (n + 1));
    to->m = (size_t)(end - to->a) / (size_t)(n + 1);
    return GOES_ON;
}

static progress load(const fmb_frame *p, const fmb_frame *q, int n, level *to)
{
    if (n == 2 && p->dim == 2)
        return put_rows(2, 2, p, q, to);
    if (n == 3 && p->dim == 2)
        return put_rows(2, 3, p, q, to);
    if (n == 3)
        return put_rows(3, 3, p, q, to);
    if (n == 4 && p->dim == 3)
        return put_rows(3, 4, p, q, to);
    return put_rows(p->dim, n, p, q, to);
}

/* ---- elimination ----------------------------------------------------------------------------- */

/* -1, 0, 1: computed for both rows of a pair, as in the article. */
ARTICLE_INLINE int sign_of(double x)
{
    return (0 < x) - (x < 0);
}

/* Writes the combinations of p with the later rows, each over its |first coefficient|, from `row`
 * on. Returns their end; NULL if one is refuted. */
ARTICLE_INLINE double *pair_rows(const double *p, const double *end, int columns, double *row)
{
    double over_p = fabs(p[0]), rest = p[columns] / over_p;
    int sign = sign_of(p[0]);
    for (const double *q = p + columns + 1; q < end; q += columns + 1) {
        double over_q = fabs(q[0]), least = 0;
        if (sign == sign_of(q[0]) || over_q <= epsilon)
            continue;
        for (int j = 0; j < columns - 1; j++) {
            double sum = p[j + 1] / over_p + q[j + 1] / over_q;
            row[j] = sum;
            least += sum < 0 ? sum : 0;
        }
        row[columns - 1] = rest + q[columns] / over_q;
        if (row[columns - 1] < least - epsilon)
            return NULL;
        row += columns;
    }
    return row;
}

/* Rows without the first variable, unless one of them is refuted. */
static size_t count_rows_of_next_level(int columns, const level *from)
{
    size_t above = 0, below = 0;
    for (size_t i = 0; i < from->m; i++) {
        double first = from->a[i * (size_t)(columns + 1)];
        above += first > epsilon;
        below += first < -epsilon;
    }
    return above * below + from->m - above - below;
}

/* Room for the next level. The article's program has arrays of fixed size: here the rows are
 * counted if m rows could make more than fit, at most m^2 / 4 + m. */
ARTICLE_INLINE progress make_room(int columns, const level *from, level *to)
{
    if (from->m * from->m / 4 + from->m <= to->capacity)
        return GOES_ON;
    size_t most = count_rows_of_next_level(columns, from);
    return most > MOST_ROWS ? TOO_MANY : reserve(to, most) ? GOES_ON : NO_MEMORY;
}

/* Eliminate the first variable: every pair of opposite signs in the order of the rows, then the
 * rows without it. */
ARTICLE_INLINE progress eliminate_into(int columns, const level *from, level *to)
{
    const double *end = from->a + from->m * (size_t)(columns + 1);
    progress at = make_room(columns, from, to);
    if (at != GOES_ON)
        return at;
    double *row = to->a;
    for (const double *p = from->a; p < end; p += columns + 1) {
        if (fabs(p[0]) <= epsilon)
            continue;
        row = pair_rows(p, end, columns, row);
        if (!row)
            return REFUTED;
    }
    for (const double *p = from->a; p < end; p += columns + 1) {
        if (fabs(p[0]) >= epsilon)
            continue;
        for (int j = 0; j < columns; j++)
            row[j] = p[j + 1];
        row += columns;
    }
    to->m = (size_t)(row - to->a) / (size_t)columns;
    return GOES_ON;
}

static progress eliminate(const level *from, level *to)
{
    to->m = 0;
    to->columns = from->columns - 1;
    switch (to->columns) {
    case 2:
        return eliminate_into(2, from, to);
    case 3:
        return eliminate_into(3, from, to);
    case 4:
        return eliminate_into(4, from, to);
    default:
        return eliminate_into(to->columns, from, to);
    }
}

/* ---- boxes ----------------------------------------------------------------------------------- */

/* The last variable: its rows bound it. */
static void bound_last(const level *rows, double *end)
{
    double least = 0, most = 1;
    for (const double *row = rows->a, *last = row + 2 * rows->m; row < last; row += 2) {
        if (row[0] > epsilon)
            most = row[1] / row[0] < most ? row[1] / row[0] : most;
        else if (row[0] < -epsilon)
            least = row[1] / row[0] > least ? row[1] / row[0] : least;
    }
    end[0] = least;
    end[1] = most;
}

/* The loosest bound that a row puts on its first variable while the others are in box[1...]. */
static double loosest(const double *row, int columns, const double (*box)[2])
{
    double rest = row[columns - 1];
    for (int j = 1; j < columns - 1; j++)
        rest -= row[j] * box[j][row[j] > epsilon ? 0 : 1];
    return rest / row[0];
}

/* The interval of a variable other than the last, box[0]. */
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

/* Eliminate down to one variable. */
static progress go_down(study_article *w, const fmb_frame *p, const fmb_frame *q, int n)
{
    progress at = load(p, q, n, &w->at[0]);
    for (int k = 0; at == GOES_ON && k < n - 1; k++)
        at = eliminate(&w->at[k], &w->at[k + 1]);
    return at;
}

fmb_status study_article_test(study_article *w, const fmb_frame *p, const fmb_frame *q,
                              study_article_box_kind kind, study_article_box *box, fmb_verdict *out)
{
    double ends[2];
    int n = p->dim + (p->speed || q->speed), last = n - 1;
    *out = FMB_UNKNOWN;
    progress at = go_down(w, p, q, n);
    if (at == REFUTED)
        *out = FMB_INFEASIBLE;
    if (at != GOES_ON)
        return at == NO_MEMORY ? FMB_ERR_MEMORY : FMB_OK;
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
