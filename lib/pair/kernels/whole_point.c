/* whole_point.c: a common point of two frames that touch; see whole_point.h.
 *
 * Let n, the normal of a row, be the direction in which A and B touch: then the face of A with its
 * highest corner a along n and the face of B with its lowest corner b, or with lowest and highest
 * exchanged, have a common point. With w = b - a, and vectors v_i that span the two faces,
 *
 *     w + sum s_i x_i v_i = 0,   s_i = 1 for vectors of B, -1 for those of A.
 *
 * Such x_i in 0 ... 1, for a simplex of sum at most 1, prove that A and B meet, for any n, a, b.
 * 1. Doubles find n, the corners, and x by a left inverse Y of the matrix V of the vectors. If n is
 *    perpendicular to more vectors, there are more x_i than equations: the others are set to 0 or
 *    1, and a vector whose x_i is not in 0 ... 1 is exchanged with one of them (the dual simplex
 *    method without costs).
 * 2. An x_i close to 0 or 1 is set to that: its vector is dropped, for 1 after it is added to w.
 *    The rows of Y of the other vectors are a left inverse of these.
 * 3. If all row sums of |E|, E = 1 - Y V, are at most 2^-20, V has full rank. If w is in the span
 *    of its columns, which holds iff all minors of V and w are 0 in integers, then exactly one x
 *    exists. With x'_i = -s_i (Y w)_i, s x = (1 - E)^-1 s x', so |x - x'| < 2^-19 if all x' are in
 *    0 ... 1.
 * 4. If the sums of absolute values in the products of Y with V and w are at most 2^20, rounding
 *    (one error an entry, D products and sums) adds less than 2^-20. So x is in 0 ... 1 if the
 *    computed x' is in 2^-10 ... 1 - 2^-10.
 */
#include "pair/kernels/whole_point.h"

#include <string.h>

enum { DIM = NORMAL_MOST_DIM, MOST_SHARES = 2 * (DIM + 1), MOST_STEPS = 32 };

static const double NEXT_TO = 0x1p-10, REGULAR = 0x1p-30, CLEAN = 0x1p-20, STEEPEST = 0x1p20;

/* The coefficient x_i of the vector of an edge. */
typedef struct share {
    int body, number;
    const normal_vector *v;
    normal_vector room;
    double x;
} share;

typedef struct touching {
    const whole_pair *p;
    int dim, n;  /* n vectors */
    int base[2]; /* corners of simplices at which the vectors start */
    int more;    /* other vectors that are perpendicular to n, after the first D - 1 */
    share share[MOST_SHARES];
    double y[DIM][DIM], normal[DIM];
    normal_vector w;
} touching;

static void add_share(touching *m, int at, int k, int number)
{
    share *s = &m->share[at];
    s->body = k;
    s->number = number;
    s->v = fmb_whole_pair_edge(m->p, k, m->base[k], number, &s->room);
}

static void list_shares(touching *m, whole_faces faces)
{
    m->n = m->more = 0;
    for (int k = 0; k < 2; k++) {
        const bool simplex = m->p->body[k].simplex;
        unsigned left = faces.of[k];
        m->base[k] = simplex && left ? __builtin_ctz(left) : 0;
        for (left = simplex ? left & (left - 1) : left; left; left &= left - 1)
            add_share(m, m->n++, k, __builtin_ctz(left));
    }
}

/* Gauss-Jordan elimination: the first rows of [V | 1] become [1 | Y], the last one [0 | n]. False:
 * V does not have full rank, or nearly not. */
static bool find_left_inverse(touching *m)
{
    const int dim = m->dim, width = dim - 1 + dim;
    double x[DIM][2 * DIM];
    for (int r = 0; r < dim; r++) {
        for (int c = 0; c < dim - 1; c++)
            x[r][c] = m->share[c].v->near[r];
        for (int c = dim - 1; c < width; c++)
            x[r][c] = c - (dim - 1) == r;
    }
    for (int c = 0; c < dim - 1; c++) {
        int best = c;
        double row[2 * DIM];
        for (int r = c + 1; r < dim; r++)
            best = fabs(x[r][c]) > fabs(x[best][c]) ? r : best;
        if (!(fabs(x[best][c]) > REGULAR * m->share[c].v->most))
            return false;
        memcpy(row, x[best], sizeof row);
        memcpy(x[best], x[c], sizeof row);
        const double by = 1 / row[c];
        for (int j = c; j < width; j++)
            x[c][j] = row[j] * by;
        for (int r = 0; r < dim; r++) {
            const double factor = x[r][c];
            for (int j = c; r != c && j < width; j++)
                x[r][j] -= factor * x[c][j];
        }
    }
    for (int r = 0; r < dim; r++)
        memcpy(r < dim - 1 ? m->y[r] : m->normal, &x[r][dim - 1], (size_t)dim * sizeof(double));
    return true;
}

static double multiply(int dim, const double *a, const double *b)
{
    double sum = 0;
    for (int r = 0; r < dim; r++)
        sum += a[r] * b[r];
    return sum;
}

/* The extent of a cuboid along n. Edges outside the face but perpendicular to n are listed, too.
 */
static void find_span_of_cuboid(touching *m, int k, unsigned face, double size, whole_span *out)
{
    const whole_body *b = &m->p->body[k];
    out->low = out->high = 0;
    for (int i = 0; i < b->n; i++) {
        const double along = multiply(m->dim, m->normal, b->edge[i].near);
        out->sign[i] = 0;
        if (face >> i & 1)
            continue;
        if (fabs(along) <= REGULAR * size * b->edge[i].most) {
            add_share(m, m->n + m->more++, k, i);
            continue;
        }
        out->sign[i] = along > 0 ? 1 : -1;
        *(along > 0 ? &out->high : &out->low) += along;
    }
}

/* The extent of a simplex along n. */
static void find_span_of_simplex(const touching *m, int k, double *at, whole_span *out)
{
    const whole_body *b = &m->p->body[k];
    out->lowest = out->highest = 0;
    for (int i = 0; i < b->n; i++) {
        at[i] = multiply(m->dim, m->normal, b->edge[i].near);
        out->lowest = at[i] < at[out->lowest] ? i : out->lowest;
        out->highest = at[i] > at[out->highest] ? i : out->highest;
    }
    out->low = at[out->lowest];
    out->high = at[out->highest];
}

/* The corner where a simplex's vectors start. Corners outside the face but as far along n are
 * listed, too. False: the face is not at that end. */
static bool find_base(touching *m, int k, unsigned face, double size, const double *at, int *corner)
{
    const whole_body *b = &m->p->body[k];
    double most = 0;
    for (int i = 0; i < b->n; i++)
        most = fmax(most, b->edge[i].most);
    if (!face)
        m->base[k] = *corner;
    if (fabs(at[*corner] - at[m->base[k]]) > REGULAR * size * most)
        return false;
    *corner = m->base[k];
    for (int i = 0; i < b->n; i++)
        if (i != *corner && !(face >> i & 1) && fabs(at[*corner] - at[i]) <= REGULAR * size * most)
            add_share(m, m->n + m->more++, k, i);
    return true;
}

/* The corners a and b at the ends along n, and w = b - a. */
static bool find_corners(touching *m, whole_faces faces)
{
    whole_span s[2];
    double at[2][DIM + 1], size = 0;
    const double finer = (double)m->p->finer, shift = multiply(m->dim, m->normal, m->p->shift.near);
    for (int r = 0; r < m->dim; r++)
        size += fabs(m->normal[r]);
    for (int k = 0; k < 2; k++)
        if (m->p->body[k].simplex)
            find_span_of_simplex(m, k, at[k], &s[k]);
        else
            find_span_of_cuboid(m, k, faces.of[k], size, &s[k]);
    const bool b_below =
        finer * (s[0].low - s[1].high) - shift > finer * (s[1].low - s[0].high) + shift;
    for (int k = 0; k < 2; k++)
        if (m->p->body[k].simplex && !find_base(m, k, faces.of[k], size, at[k],
                                                (k == 0) != b_below ? &s[k].highest : &s[k].lowest))
            return false;
    fmb_whole_pair_between(m->p, s, b_below, &m->w);
    return true;
}

/* w += by v. */
static void add_to_way(touching *m, int64_t by, const normal_vector *v)
{
    m->w.most = 0;
    for (int r = 0; r < m->dim; r++) {
        m->w.whole[r] += by * v->whole[r];
        m->w.near[r] = (double)m->w.whole[r];
        m->w.most = fmax(m->w.most, fabs(m->w.near[r]));
    }
}

static int64_t factor_of(const touching *m, const share *s)
{
    return s->body == 1 ? m->p->finer : -m->p->finer;
}

static void drop_share(touching *m, int i)
{
    m->n--;
    for (int j = i; j < m->n; j++) {
        const bool own = m->share[j + 1].v == &m->share[j + 1].room;
        m->share[j] = m->share[j + 1];
        if (own)
            m->share[j].v = &m->share[j].room;
        memcpy(m->y[j], m->y[j + 1], sizeof m->y[j]);
    }
}

static void find_x(touching *m)
{
    for (int i = 0; i < m->n; i++)
        m->share[i].x = -multiply(m->dim, m->y[i], m->w.near) / (double)factor_of(m, &m->share[i]);
}

/* ---- steps ----------------------------------------------------------------------------------- */

/* The vector of body k with the largest share, or -1. */
static int find_of_body(const touching *m, int k)
{
    int best = -1;
    for (int i = 0; i < m->n; i++)
        if (m->share[i].body == k)
            best = best < 0 || m->share[i].x > m->share[best].x ? i : best;
    return best;
}

/* The vectors of simplex k start at the end of vector i instead, and vector i leads to the old
 * start. Its row of Y, perpendicular to the other vectors, is minus the sum of all rows of the
 * simplex. */
static void change_base(touching *m, int k, int i)
{
    const int old = m->base[k];
    add_to_way(m, factor_of(m, &m->share[i]), m->share[i].v);
    m->base[k] = m->share[i].number;
    m->share[i].number = old;
    for (int r = 0; r < m->dim; r++) {
        double sum = 0;
        for (int j = 0; j < m->n; j++)
            sum += m->share[j].body == k ? m->y[j][r] : 0;
        m->y[i][r] = -sum;
    }
    for (int j = 0; j < m->n + m->more; j++)
        if (m->share[j].body == k)
            add_share(m, j, k, m->share[j].number);
}

/* The sum of the shares of simplex k among the first n. */
static double sum_shares(const touching *m, int k)
{
    double sum = 0;
    for (int i = 0; i < m->n; i++)
        sum += m->share[i].body == k ? m->share[i].x : 0;
    return sum;
}

/* The first share that is not in 0 ... 1, or -1. */
static int find_outside(touching *m)
{
    find_x(m);
    for (int k = 0; k < 2; k++)
        if (m->p->body[k].simplex && sum_shares(m, k) > 1 + REGULAR) {
            change_base(m, k, find_of_body(m, k));
            find_x(m);
        }
    for (int i = 0; i < m->n; i++)
        if (!(m->share[i].x >= -REGULAR &&
              (m->p->body[m->share[i].body].simplex || m->share[i].x <= 1 + REGULAR)))
            return i;
    return -1;
}

/* The other vector, of those behind the first n, that moves share i back most, or -1. */
static int find_help(const touching *m, int i)
{
    const share *s = &m->share[i];
    int best = -1;
    double most = REGULAR;
    for (int u = m->n; u < m->n + m->more; u++) {
        const share *other = &m->share[u];
        double by = multiply(m->dim, m->y[i], other->v->near);
        by = (s->body == other->body) == (other->x > 0.5) ? by : -by;
        by = s->x < 0 ? by : -by;
        if (by > most) {
            most = by;
            best = u;
        }
    }
    return best;
}

/* Share i is set to its nearer end, and the other vector u takes its place. */
static void exchange(touching *m, int i, int u)
{
    share *s = &m->share[i], *other = &m->share[u];
    const double by = 1 / multiply(m->dim, m->y[i], other->v->near);
    const int left = s->number, body = s->body;
    s->x = s->x > 0.5;
    if (s->x > 0)
        add_to_way(m, factor_of(m, s), s->v);
    if (other->x > 0)
        add_to_way(m, -factor_of(m, other), other->v);
    for (int r = 0; r < m->dim; r++)
        m->y[i][r] *= by;
    for (int j = 0; j < m->n; j++) {
        const double factor = multiply(m->dim, m->y[j], other->v->near);
        for (int r = 0; j != i && r < m->dim; r++)
            m->y[j][r] -= factor * m->y[i][r];
    }
    const double x = s->x;
    add_share(m, i, other->body, other->number);
    add_share(m, u, body, left);
    m->share[u].x = x;
}

/* Choose 0 or 1 for the shares behind the first n such that the first n shares are in 0 ... 1. */
static bool share_among_others(touching *m)
{
    for (int u = m->n; u < m->n + m->more; u++)
        m->share[u].x = 0;
    for (int steps = 0; steps < MOST_STEPS; steps++) {
        const int i = find_outside(m), u = i < 0 ? -1 : find_help(m, i);
        if (i < 0)
            return true;
        if (u < 0)
            return false;
        exchange(m, i, u);
    }
    return false;
}

/* ---- proofs ---------------------------------------------------------------------------------- */

/* Set shares close to 0 or 1 to that, and drop their vectors. False: a share is outside 0 ... 1. */
static bool drop_ends(touching *m)
{
    if (m->more > 0 && !share_among_others(m))
        return false;
    find_x(m);
    for (int i = m->n - 1; i >= 0; i--) {
        const share *s = &m->share[i];
        if (!(s->x > -NEXT_TO && s->x < 1 + NEXT_TO))
            return false;
        if (s->x > NEXT_TO && (m->p->body[s->body].simplex || s->x < 1 - NEXT_TO))
            continue;
        if (s->x > 0.5)
            add_to_way(m, factor_of(m, s), s->v);
        drop_share(m, i);
    }
    return true;
}

/* If the corner at which the vectors of simplex k start has no share, they start at another one.
 * False: the shares sum to more than 1. */
static bool choose_base(touching *m, int k)
{
    const double sum = sum_shares(m, k);
    const int best = find_of_body(m, k);
    if (!(sum < 1 + NEXT_TO))
        return false;
    if (best < 0 || sum < 1 - NEXT_TO)
        return true;
    m->more = 0;
    change_base(m, k, best);
    drop_share(m, best);
    return true;
}

/* Are all shares certainly inside, if there are any? */
static bool are_inside(touching *m)
{
    double sum[2] = {0, 0};
    find_x(m);
    for (int i = 0; i < m->n; i++) {
        double error = 0, size = 0;
        for (int j = 0; j < m->n; j++) {
            error += fabs((i == j) - multiply(m->dim, m->y[i], m->share[j].v->near));
            for (int r = 0; r < m->dim; r++)
                size += fabs(m->y[i][r]) * m->share[j].v->most;
        }
        for (int r = 0; r < m->dim; r++)
            size += fabs(m->y[i][r]) * m->w.most / (double)m->p->finer;
        if (!(error <= CLEAN && size <= STEEPEST && m->share[i].x > NEXT_TO &&
              m->share[i].x < 1 - NEXT_TO))
            return false;
        sum[m->share[i].body] += m->share[i].x;
    }
    for (int k = 0; k < 2; k++)
        if (m->p->body[k].simplex && !(sum[k] < 1 - NEXT_TO))
            return false;
    return true;
}

/* Is w in the span of the vectors, which are independent? */
static bool is_dependent(const touching *m)
{
    normal n;
    double error = 0x1p-53 * normal_error(m->n + 1) * m->w.most;
    for (int i = 0; i < m->n; i++)
        error *= m->share[i].v->most;
    const int words = normal_words(error);
    if (words == 0)
        return false;
    fmb_normal_begin(words, m->dim, error, &n);
    for (int i = 0; i < m->n; i++)
        (void)fmb_normal_put(i, i, m->share[i].v, &n);
    return fmb_normal_put(m->n, m->n, &m->w, &n);
}

bool fmb_whole_point_meet(const whole_pair *p, whole_faces faces)
{
    touching m;
    m.p = p;
    m.dim = p->dim;
    list_shares(&m, faces);
    if (!find_left_inverse(&m) || !find_corners(&m, faces) || !drop_ends(&m))
        return false;
    for (int k = 0; k < 2; k++)
        if (p->body[k].simplex && !choose_base(&m, k))
            return false;
    return are_inside(&m) && is_dependent(&m);
}
