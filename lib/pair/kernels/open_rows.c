/* open_rows.c: see open_rows.h.
 *
 * First a common point is searched in the faces of a row (whole_point.c): closed frames that touch
 * have one. Otherwise rows are decided one by one. Along n the two are apart by
 *
 *     n (shift + finer (low corner of B - high corner of A))
 *
 * or by the same with A and B exchanged. Doubles decide which corners these are, or, if they are
 * not certain, the lowest words of n (one corner - another); likewise for the sign of the gap. This
 * requires errors of doubles, not all numbers, to be less than a quarter of the range of the words.
 *
 * Errors (normal.h): with a_i bounds of the vectors of all faces, p the product of the D - 1
 * largest of all a_i and a the largest, b that of the shift, n times an edge is off by m_D u D! p
 * a, and by that twice and a rounding between corners of a simplex, which is twice as large; the
 * gap, a sum of at most 2 D + 1 edges and the shift, by (m_D + 2 D + 2) u D! p ((2 D + 1) a finer +
 * b), and (2 D + 3) m_D is more than that. Vectors of a simplex lead from one of its corners to
 * others: each may be as large as the corner at its end and the largest corner of all together.
 *
 * If faces touch, many rows have the same n, and if edges are parallel, many have n = 0. So a row
 * is settled if its faces lie in those perpendicular to an n decided before (its own n is then that
 * one, or 0), or if its vectors include some that are known to be dependent.
 */
#include "pair/kernels/open_rows.h"

#include "pair/kernels/whole_point.h"

enum { MOST_SETTLED = 64 };

bool fmb_open_rows_are_short(const fmb_open_rows *x, unsigned l)
{
    return fmb_whole_pair_is_short(&x->of, l);
}

typedef struct decider {
    const fmb_open_rows *x;
    whole_pair pair;
    double error; /* of n times an edge, or between corners */
    normal n;
    whole_faces flat[MOST_SETTLED]; /* perpendicular to an n that was asked */
    whole_faces null[MOST_SETTLED]; /* with vectors that are dependent */
    int flats, nulls;
} decider;

/* ---- rows that are settled ------------------------------------------------------------------- */

static bool are_within(whole_faces a, whole_faces b)
{
    return !((a.of[0] & ~b.of[0]) | (a.of[1] & ~b.of[1]));
}

static bool is_settled(const decider *d, whole_faces f)
{
    for (int i = 0; i < d->flats; i++)
        if (are_within(f, d->flat[i]))
            return true;
    for (int i = 0; i < d->nulls; i++)
        if (are_within(d->null[i], f))
            return true;
    return false;
}

/* ---- directions ------------------------------------------------------------------------------ */

/* List bounds of the vectors of a body, returning how many. None of a simplex leads to its first
 * corner, which is 0. */
static int list_sizes(const whole_body *b, double *size)
{
    double most = 0;
    for (int i = 0; b->simplex && i < b->n; i++)
        most = fmax(most, b->edge[i].most);
    for (int i = b->simplex; i < b->n; i++)
        *size++ = b->edge[i].most + most;
    return b->n - b->simplex;
}

/* Set the error bounds, and the number of words. False: too many. */
static bool begin_normal(decider *d)
{
    const whole_pair *p = &d->pair;
    const int dim = p->dim;
    double left[2 * NORMAL_MOST_DIM + 2], product = 1, a = 0;
    int n = list_sizes(&p->body[0], left);
    n += list_sizes(&p->body[1], left + n);
    for (int i = 0; i < dim - 1; i++) {
        int best = 0;
        for (int j = 1; j < n; j++)
            best = left[j] > left[best] ? j : best;
        a = i == 0 ? left[best] : a;
        product *= left[best];
        left[best] = left[--n];
    }
    const double unit = 0x1p-53 * normal_error(dim) * product;
    const double all = (2 * dim + 1) * a * (double)p->finer + p->shift.most;
    d->error = 4 * unit * a;
    const double error = unit * all * (2 * dim + 3);
    const int words = normal_words(error);
    if (words > 0)
        fmb_normal_begin(words, dim, error, &d->n);
    return words > 0;
}

/* Put the vectors of a face, from place *at on. *put: those put. False: the last of them depends on
 * the others. */
static bool put_face(decider *d, int k, unsigned face, int *at, unsigned *put)
{
    const bool simplex = d->pair.body[k].simplex;
    const int first = simplex && face ? __builtin_ctz(face) : 0;
    unsigned left = simplex ? face & (face - 1) : face;
    *put = face & ~left;
    for (; left; left &= left - 1, (*at)++) {
        const int i = __builtin_ctz(left);
        normal_vector between;
        const normal_vector *v = fmb_whole_pair_edge(&d->pair, k, first, i, &between);
        *put |= left & -left;
        if (fmb_normal_put(*at, (k * 16 + first) * 16 + i, v, &d->n)) {
            d->n.known = *at;
            return false;
        }
    }
    return true;
}

/* False: vectors of the faces are dependent. */
static bool find_normal(decider *d, whole_faces faces, bool from_b)
{
    whole_faces put = {{0, 0}};
    int at = 0;
    for (int i = 0; i < 2; i++) {
        const int k = from_b ? 1 - i : i;
        if (!put_face(d, k, faces.of[k], &at, &put.of[k])) {
            d->null[d->nulls++] = put;
            return false;
        }
    }
    return true;
}

/* The extent of a cuboid along n; returns all edges perpendicular to n. */
static unsigned span_cuboid(const decider *d, const whole_body *b, unsigned face, whole_span *out)
{
    out->low = out->high = 0;
    for (int i = 0; i < b->n; i++) {
        const normal_vector *v = &b->edge[i];
        out->sign[i] = 0;
        if (face >> i & 1)
            continue;
        const double near = normal_near(&d->n, v->near);
        out->sign[i] = fmb_normal_sign(&d->n, near, d->error, v->whole);
        face |= (unsigned)(out->sign[i] == 0) << i;
        out->low += out->sign[i] < 0 ? near : 0;
        out->high += out->sign[i] > 0 ? near : 0;
    }
    return face;
}

/* The sign of n (corner i - corner j), as doubles both `near`. */
static int compare_corners(const decider *d, int k, unsigned face, const double *near, int i, int j)
{
    normal_vector between;
    if (i == j || (face >> i & face >> j & 1))
        return 0;
    return fmb_normal_sign(&d->n, near[i] - near[j], d->error,
                           fmb_whole_pair_edge(&d->pair, k, j, i, &between)->whole);
}

/* The extent of a simplex along n; returns all corners as far along n as those of the face. */
static unsigned span_simplex(const decider *d, int k, unsigned face, whole_span *out)
{
    const whole_body *b = &d->pair.body[k];
    const int first = face ? __builtin_ctz(face) : 0;
    double near[NORMAL_MOST_DIM + 1];
    unsigned flat = 0;
    out->lowest = out->highest = 0;
    for (int i = 0; i < b->n; i++)
        near[i] = normal_near(&d->n, b->edge[i].near);
    for (int i = 0; i < b->n; i++) {
        if (compare_corners(d, k, face, near, i, out->highest) > 0)
            out->highest = i;
        if (compare_corners(d, k, face, near, i, out->lowest) < 0)
            out->lowest = i;
        flat |= (unsigned)(compare_corners(d, k, face, near, i, first) == 0) << i;
    }
    out->low = near[out->lowest];
    out->high = near[out->highest];
    return flat;
}

/* The sign of the gap with A below B, or B below A. */
static int ask_side(const decider *d, const whole_span s[2], double shift, bool b_below)
{
    const double finer = (double)d->pair.finer;
    const double gap =
        b_below ? shift + finer * (s[1].high - s[0].low) : shift + finer * (s[1].low - s[0].high);
    normal_vector between;
    fmb_whole_pair_between(&d->pair, s, b_below, &between);
    const int sign = fmb_normal_sign(&d->n, gap, d->n.error, between.whole);
    return b_below ? -sign : sign;
}

/* The sign of the gap along n. */
static int ask_normal(decider *d, whole_faces faces)
{
    const double shift = normal_near(&d->n, d->pair.shift.near);
    whole_faces flat = {{0, 0}};
    whole_span s[2];
    for (int k = 0; k < 2; k++)
        flat.of[k] = d->pair.body[k].simplex ? span_simplex(d, k, faces.of[k], &s[k])
                                             : span_cuboid(d, &d->pair.body[k], faces.of[k], &s[k]);
    d->flat[d->flats++] = flat;
    const int sign = ask_side(d, s, shift, false), other = ask_side(d, s, shift, true);
    return sign > other ? sign : other;
}

/* ---- all of it ------------------------------------------------------------------------------- */

static fmb_verdict decide(decider *d, unsigned l)
{
    const fmb_open_rows *x = d->x;
    bool begun = false, fits = false;
    for (int i = 0; i < x->n; i++) {
        const fmb_open_row *row = &x->row[i];
        whole_faces faces = {{row->face[0], row->face[1]}};
        if (!(row->lanes >> l & 1) || fmb_whole_pair_trim(&d->pair, &faces) < d->pair.dim - 1 ||
            is_settled(d, faces))
            continue;
        if (x->closed && fmb_whole_point_meet(&d->pair, faces))
            return FMB_FEASIBLE;
        if (d->flats == MOST_SETTLED || d->nulls == MOST_SETTLED)
            return FMB_UNKNOWN;
        fits = begun ? fits : begin_normal(d);
        begun = true;
        if (!fits || !find_normal(d, faces, row->from_b))
            continue;
        const int gap = ask_normal(d, faces);
        if (gap > 0 || (gap == 0 && !x->closed))
            return FMB_INFEASIBLE;
    }
    return (fits || !begun) && x->all && !(x->full >> l & 1) ? FMB_FEASIBLE : FMB_UNKNOWN;
}

fmb_verdict fmb_open_rows_decide(const fmb_open_rows *x, unsigned l)
{
    decider d;
    fmb_whole_pair_read(&x->of, l, &d.pair);
    d.x = x;
    d.flats = d.nulls = 0;
    return decide(&d, l);
}
