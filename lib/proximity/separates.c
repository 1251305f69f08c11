/* separates.c: does a row separate two frames? The check of separate.c, which shares nothing with
 * it but public headers.
 *
 * At time t the values w.x + k t of a frame's points are an interval, whose ends are affine in t.
 * So if the right side lies between the two intervals at t = 0 and at t = 1, it does at all times
 * between. Then the frames are apart if no common point lies on the plane. That holds if there is a
 * gap between the intervals at both times, and so at all times; or, with open contact, if one frame
 * has points off the plane: then its relative interior is off the plane, as a linear form that is
 * not constant on a convex set attains its maximum at no relative interior point.
 */
#include <fmb/proximity.h>

#include <gmp.h>

#include <fmb/gmp.h>

typedef struct interval {
    mpq_t low, high;
} interval;

/* Numbers of a frame in rationals, from either source: row i of the origin, edges and speed. */
typedef struct source {
    const fmb_frame *f;
    const fmb_frame_q *q;
} source;

static void read_number(const source *a, int i, int j, mpq_t out)
{
    int naxes = a->f ? a->f->naxes : a->q->naxes, dim = a->f ? a->f->dim : a->q->dim;
    size_t cell = (size_t)(i > 0 ? i - 1 : 0) * (size_t)dim + (size_t)j;
    if (a->f)
        mpq_set_d(out, i == 0 ? a->f->origin[j] : i <= naxes ? a->f->axes[cell] : a->f->speed[j]);
    else
        mpq_set(out, i == 0 ? a->q->origin[j] : i <= naxes ? a->q->axes[cell] : a->q->speed[j]);
}

/* out = w.(row i of the frame) */
static void apply_form(const source *a, const fmb_system *row, int i, mpq_t out)
{
    int dim = a->f ? a->f->dim : a->q->dim;
    size_t terms = fmb_system_terms(row, 0);
    mpq_t w, x;
    mpq_inits(w, x, NULL);
    mpq_set_ui(out, 0, 1);
    for (size_t k = 0; k < terms; k++) {
        int j = fmb_system_term_q(row, 0, k, w);
        if (j >= dim)
            continue;
        read_number(a, i, j, x);
        mpq_mul(x, x, w);
        mpq_add(out, out, x);
    }
    mpq_clears(w, x, NULL);
}

/* The coefficient of t, the variable behind the coordinates; 0 if there is none. */
static void read_time(const fmb_system *row, int dim, mpq_t out)
{
    size_t terms = fmb_system_terms(row, 0);
    if (terms == 0 || fmb_system_term_q(row, 0, terms - 1, out) != dim)
        mpq_set_ui(out, 0, 1);
}

/* The interval at t = 0: the value at the origin, plus what the edges add at either end. */
static void find_interval(const source *a, const fmb_system *row, interval *out)
{
    fmb_shape shape = a->f ? a->f->shape : a->q->shape;
    bool simplex = shape == FMB_SIMPLEX || shape == FMB_SIMPLEX_BY_CORNERS;
    bool corners = shape == FMB_CUBOID_BY_CORNERS || shape == FMB_SIMPLEX_BY_CORNERS;
    int naxes = a->f ? a->f->naxes : a->q->naxes;
    mpq_t origin, edge;
    mpq_inits(origin, edge, NULL);
    apply_form(a, row, 0, origin);
    mpq_set_ui(out->low, 0, 1);
    mpq_set_ui(out->high, 0, 1);
    for (int i = 1; i <= naxes; i++) {
        apply_form(a, row, i, edge);
        if (corners)
            mpq_sub(edge, edge, origin);
        mpq_ptr end = mpq_sgn(edge) < 0 ? out->low : out->high;
        if (!simplex)
            mpq_add(end, end, edge);
        else if (mpq_sgn(edge) < 0 ? mpq_cmp(edge, end) < 0 : mpq_cmp(edge, end) > 0)
            mpq_set(end, edge);
    }
    mpq_add(out->low, out->low, origin);
    mpq_add(out->high, out->high, origin);
    mpq_clears(origin, edge, NULL);
}

/* Change the interval at t = 0 to that at t = 1. */
static void move_interval(const source *a, const fmb_system *row, interval *of)
{
    int naxes = a->f ? a->f->naxes : a->q->naxes, dim = a->f ? a->f->dim : a->q->dim;
    bool moves = a->f ? a->f->speed != NULL : a->q->speed != NULL;
    mpq_t change, speed;
    mpq_inits(change, speed, NULL);
    read_time(row, dim, change);
    if (moves)
        apply_form(a, row, naxes + 1, speed);
    mpq_add(change, change, speed);
    mpq_add(of->low, of->low, change);
    mpq_add(of->high, of->high, change);
    mpq_clears(change, speed, NULL);
}

static bool has_width(const interval *a)
{
    return !mpq_equal(a->low, a->high);
}

/* Is the right side between the two intervals, with a gap between them if one is needed? */
static bool lies_between(const interval *first, const interval *second, const mpq_t right,
                         bool needs_gap)
{
    return mpq_cmp(first->high, right) <= 0 && mpq_cmp(right, second->low) <= 0 &&
           (!needs_gap || mpq_cmp(first->high, second->low) < 0);
}

static bool separates(const source *a, const source *b, fmb_contact contact, const fmb_system *row)
{
    interval first, second;
    mpq_t right;
    mpq_inits(first.low, first.high, second.low, second.high, right, NULL);
    fmb_system_rhs_q(row, 0, right);
    find_interval(a, row, &first);
    find_interval(b, row, &second);
    bool gap = contact == FMB_CONTACT_CLOSED || (!has_width(&first) && !has_width(&second));
    bool apart = lies_between(&first, &second, right, gap);
    move_interval(a, row, &first);
    move_interval(b, row, &second);
    apart = apart && lies_between(&first, &second, right, gap);
    mpq_clears(first.low, first.high, second.low, second.high, right, NULL);
    return apart;
}

/* One row <= over the coordinates and, perhaps, t. */
static bool is_one_row(const fmb_system *row, int dim)
{
    int vars = fmb_system_dim(row);
    return fmb_system_rows(row) == 1 && (vars == dim || vars == dim + 1) &&
           fmb_system_rel(row, 0) == FMB_LE;
}

bool fmb_separates(const fmb_frame *f, fmb_contact contact, const fmb_system *row)
{
    for (int k = 0; f && k < 2; k++)
        if (!f[k].origin || (!f[k].axes && f[k].naxes > 0))
            return false;
    return f && row && f[0].dim == f[1].dim && is_one_row(row, f[0].dim) &&
           separates(&(source){.f = &f[0]}, &(source){.f = &f[1]}, contact, row);
}

bool fmb_separates_q(const fmb_frame_q *f, fmb_contact contact, const fmb_system *row)
{
    for (int k = 0; f && k < 2; k++)
        if (!f[k].origin || (!f[k].axes && f[k].naxes > 0))
            return false;
    return f && row && f[0].dim == f[1].dim && is_one_row(row, f[0].dim) &&
           separates(&(source){.q = &f[0]}, &(source){.q = &f[1]}, contact, row);
}
