/* nearest.c: the point of a polytope nearest to 0, by P. Wolfe's algorithm, exactly.
 *
 * A corral is a set of affinely independent vertices whose affine hull has its point x nearest to 0
 * inside their convex hull. If no vertex v of M has v.x < x.x, all of M lies beyond the plane
 * through x at right angles to it, and x is the answer. Otherwise such a v joins the corral. The
 * point y nearest to 0 of the new affine hull is nearer than x. If y is outside the convex hull, x
 * moves towards y as far as the hull reaches, and the vertices whose weights are 0 there are
 * dropped, until y is inside. x always comes nearer to 0, so no corral is repeated, and there are
 * finitely many. All signs are exact.
 *
 * First y is computed in doubles, as long as x comes nearer. The last corral is a guess: the exact
 * walk begins with it, at the mean of its vertices, and mostly ends there; if its vertices are
 * dependent, it begins at one of them.
 *
 * Source: P. Wolfe, Finding the nearest point in a polytope, Mathematical Programming 11 (1976).
 */
#include <float.h>
#include <math.h>

#include "num/rationals.h"
#include "num/vec.h"
#include "proximity/proximity_private.h"

typedef struct wolfe {
    fmb_minkowski *m;
    fmb_run *run;
    size_t most;     /* vertices in a corral, dim + 1, and one more */
    size_t n;        /* those in it */
    mpz_t **vertex;  /* [most] (minkowski.h) */
    mpz_t *vertices; /* their numbers */
    mpz_t *table;    /* [most][most] */
    mpz_t *edge; /* [most][dim] from the first vertex to the others, without the powers of 2 they
                    share ... */
    mp_bitcnt_t *power; /* [most] ... which these are */
    mpz_t *share;       /* [most] of the vertices in x, times the determinant */
    mpz_t *direction;   /* [dim] x times the determinant */
    mpq_t *weight;      /* [most] of the vertices in x */
    mpq_t *wish;        /* [most] in y */
    double *near;  /* [most][dim] in doubles: vertices, scaled so that no number exceeds 1 ... */
    double *gram;  /* ... [most][most + 1] their products, and 1 */
    double *rough; /* [dim] x */
    double length; /* |x|^2 */
    long bits;     /* a bound on those of a vertex's numbers */
    bool roughly;  /* y is found in doubles */
    mpz_t det, a, b;
    mpq_t step, t;
} wolfe;

static size_t vertex_size(const wolfe *w)
{
    return FMB_VERTEX_ROWS * (size_t)w->m->dim;
}

static size_t table_size(const wolfe *w)
{
    return w->most * (w->most + (size_t)w->m->dim + 1); /* with edges and shares */
}

static size_t rough_size(const wolfe *w)
{
    size_t dim = (size_t)w->m->dim;
    return w->most * dim + w->most * (w->most + 1) + dim;
}

/* ---- life ------------------------------------------------------------------------------------ */

/* A number of a vertex is a sum of numbers of all rows. */
static long bits_of_rows(const fmb_minkowski *m)
{
    size_t bits = 0;
    for (size_t i = 0; i < m->cells; i++)
        bits = mpz_sizeinbase(m->cell[i], 2) > bits ? mpz_sizeinbase(m->cell[i], 2) : bits;
    return (long)bits;
}

static fmb_status open_wolfe(wolfe *w, fmb_minkowski *m, fmb_run *run)
{
    size_t dim = (size_t)m->dim;
    fmb_mem *mem = m->mem;
    *w = (wolfe){.m = m, .run = run, .most = dim + 2, .length = INFINITY};
    w->bits = bits_of_rows(m);
    mpz_inits(w->det, w->a, w->b, NULL);
    mpq_inits(w->step, w->t, NULL);
    w->vertex = fmb_mem_get(mem, w->most, sizeof(mpz_t *));
    w->vertices = fmb_vec_block(w->most * vertex_size(w), mem);
    w->table = fmb_vec_block(table_size(w), mem);
    w->direction = fmb_vec_block(dim, mem);
    w->near = fmb_mem_get(mem, rough_size(w), sizeof *w->near);
    w->power = fmb_mem_get(mem, w->most, sizeof *w->power);
    if (!w->power || !w->vertex || !w->vertices || !w->table || !w->direction || !w->near)
        return fmb_mem_status(mem);
    w->edge = w->table + w->most * w->most;
    w->share = w->edge + w->most * dim;
    for (size_t i = 0; i < w->most; i++)
        w->vertex[i] = w->vertices + i * vertex_size(w);
    w->gram = w->near + w->most * dim;
    w->rough = w->gram + w->most * (w->most + 1);
    FMB_TRY(fmb_rationals_new(&w->weight, w->most, mem));
    return fmb_rationals_new(&w->wish, w->most, mem);
}

static void free_block(wolfe *w, mpz_t *block, size_t n)
{
    fmb_vec_block_free(block, n, w->m->mem);
}

static void close_wolfe(wolfe *w)
{
    size_t dim = (size_t)w->m->dim;
    fmb_mem *mem = w->m->mem;
    free_block(w, w->vertices, w->most * vertex_size(w));
    free_block(w, w->table, table_size(w));
    free_block(w, w->direction, dim);
    fmb_mem_put(mem, w->near, rough_size(w), sizeof *w->near);
    fmb_mem_put(mem, w->vertex, w->most, sizeof *w->vertex);
    fmb_mem_put(mem, w->power, w->most, sizeof *w->power);
    fmb_rationals_free(w->weight, w->most, mem);
    fmb_rationals_free(w->wish, w->most, mem);
    mpz_clears(w->det, w->a, w->b, NULL);
    mpq_clears(w->step, w->t, NULL);
}

/* ---- the nearest point of an affine hull ----------------------------------------------------- */

/* Vertex i in doubles. */
static void read_vertex(wolfe *w, size_t i)
{
    for (int j = 0; j < w->m->dim; j++) {
        long exponent;
        double x = mpz_get_d_2exp(&exponent, w->vertex[i][j]);
        long power = exponent - w->bits;
        w->near[i * (size_t)w->m->dim + (size_t)j] = power < -1000 ? 0 : ldexp(x, (int)power);
    }
}

static double rough_dot(const wolfe *w, const double *a, const double *b)
{
    double sum = 0;
    for (int j = 0; j < w->m->dim; j++)
        sum += a[j] * b[j];
    return sum;
}

/* With 1 added to all products the matrix is regular even if 0 is in the hull, and its solution is
 * a multiple of the weights. A weight that is a NaN is set to 0. */
static void find_rough_wish(wolfe *w)
{
    size_t n = w->n, dim = (size_t)w->m->dim;
    double *a = w->gram, sum = 0;
    for (size_t i = 0; i < n; i++)
        read_vertex(w, i);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k <= n; k++)
            a[i * (n + 1) + k] = k < n ? 1 + rough_dot(w, w->near + i * dim, w->near + k * dim) : 1;
    for (size_t p = 0; p < n; p++)
        for (size_t i = 0; i < n; i++) {
            double by = i == p ? 0 : a[i * (n + 1) + p] / a[p * (n + 1) + p];
            for (size_t k = p; k <= n; k++)
                a[i * (n + 1) + k] -= by * a[p * (n + 1) + k];
        }
    for (size_t i = 0; i < n; i++)
        sum += a[i * (n + 1) + n] /= a[i * (n + 1) + i];
    for (size_t i = 0; i < n; i++) {
        double weight = a[i * (n + 1) + n] / sum;
        mpq_set_d(w->wish[i], isfinite(weight) ? weight : 0);
    }
}

/* Edge i, from the first vertex to vertex i + 1, without the power of 2 that its numbers share. */
static mp_bitcnt_t find_edge(wolfe *w, size_t i)
{
    mpz_t *e = w->edge + i * (size_t)w->m->dim;
    mpz_set_ui(w->a, 0);
    for (int j = 0; j < w->m->dim; j++) {
        mpz_sub(e[j], w->vertex[i + 1][j], w->vertex[0][j]);
        mpz_ior(w->a, w->a, e[j]);
    }
    mp_bitcnt_t power = mpz_sgn(w->a) == 0 ? 0 : mpz_scan1(w->a, 0);
    for (int j = 0; j < w->m->dim; j++)
        mpz_tdiv_q_2exp(e[j], e[j], power);
    return power;
}

/* The products of edge i with the later edges; in the last place, with the negated first vertex. */
static void find_products(wolfe *w, size_t i)
{
    size_t n = w->n, dim = (size_t)w->m->dim;
    mpz_t *row = w->table + i * n, *e = w->edge + i * dim;
    for (size_t k = i; k < n - 1; k++)
        fmb_minkowski_dot(w->m, e, w->edge + k * dim, row[k]);
    fmb_minkowski_dot(w->m, e, w->vertex[0], row[n - 1]);
    mpz_neg(row[n - 1], row[n - 1]);
}

/* Fraction-free elimination, as in frame/jordan.c, of the upper half of a symmetric matrix; det is
 * the last pivot. Pivots are squares of volumes: one is 0 only if edges are dependent. */
static fmb_status eliminate(wolfe *w)
{
    size_t n = w->n;
    mpz_set_ui(w->det, 1);
    for (size_t c = 0; c + 1 < n; c++) {
        mpz_t *p = w->table + c * n;
        if (mpz_sgn(p[c]) == 0)
            return FMB_ERR_ARG;
        for (size_t i = c + 1; i + 1 < n; i++) {
            mpz_t *row = w->table + i * n;
            for (size_t j = i; j < n; j++) {
                mpz_mul(row[j], row[j], p[c]);
                mpz_submul(row[j], p[i], p[j]);
                mpz_divexact(row[j], row[j], w->det);
            }
            FMB_TRY(fmb_poll_if_limited(w->run));
        }
        mpz_set(w->det, p[c]);
    }
    return FMB_OK;
}

/* y is the first vertex plus multiples of edges, and perpendicular to all edges. By Cramer's rule
 * each multiple times det is an integer. An edge was divided by 2^power: so its multiple has to be,
 * too; instead det, and all other multiples, are multiplied by 2^(most - power). */
static fmb_status find_exact_wish(wolfe *w)
{
    size_t n = w->n;
    mp_bitcnt_t *power = w->power, most = 0;
    if (n == 0) /* doubles dropped all vertices */
        return FMB_ERR_ARG;
    for (size_t i = 0; i + 1 < n; i++) {
        power[i] = find_edge(w, i);
        most = power[i] > most ? power[i] : most;
    }
    for (size_t i = 0; i + 1 < n; i++)
        find_products(w, i);
    FMB_TRY(eliminate(w));
    for (size_t i = n - 1; i-- > 0;) {
        mpz_t *row = w->table + i * n;
        mpz_ptr x = w->share[i + 1];
        mpz_mul(x, row[n - 1], w->det);
        for (size_t k = i + 1; k < n - 1; k++)
            mpz_submul(x, row[k], w->share[k + 1]);
        mpz_divexact(x, x, row[i]);
    }
    mpz_mul_2exp(w->det, w->det, most);
    mpz_set(w->share[0], w->det);
    for (size_t i = 1; i < n; i++) {
        mpz_mul_2exp(w->share[i], w->share[i], most - power[i - 1]);
        mpz_sub(w->share[0], w->share[0], w->share[i]);
    }
    for (size_t i = 0; i < n; i++) {
        mpz_set(mpq_numref(w->wish[i]), w->share[i]);
        mpz_set(mpq_denref(w->wish[i]), w->det);
    }
    return FMB_OK;
}

static fmb_status find_wish(wolfe *w)
{
    if (!w->roughly)
        return find_exact_wish(w);
    find_rough_wish(w);
    return FMB_OK;
}

static bool is_wish_inside(const wolfe *w)
{
    size_t i = 0;
    while (i < w->n && mpq_sgn(w->wish[i]) > 0)
        i++;
    return i == w->n;
}

/* The largest step from x towards y that keeps all weights at least 0. */
static void find_step(wolfe *w)
{
    mpq_set_ui(w->step, 1, 1);
    for (size_t i = 0; i < w->n; i++) {
        if (mpq_sgn(w->wish[i]) > 0)
            continue;
        mpq_sub(w->t, w->weight[i], w->wish[i]);
        if (mpq_sgn(w->t) == 0)
            mpq_set_ui(w->t, 0, 1); /* both are 0: no step */
        else
            mpq_div(w->t, w->weight[i], w->t);
        if (mpq_cmp(w->t, w->step) < 0)
            mpq_set(w->step, w->t);
    }
}

static void drop_vertex(wolfe *w, size_t i)
{
    size_t last = --w->n;
    mpz_t *vertex = w->vertex[i];
    w->vertex[i] = w->vertex[last];
    w->vertex[last] = vertex;
    mpq_set(w->weight[i], w->weight[last]);
    mpq_set(w->wish[i], w->wish[last]);
}

/* At least one vertex is dropped: the one that limited the step. Only now are common divisors
 * removed.
 */
static void step_towards_wish(wolfe *w)
{
    for (size_t i = 0; i < w->n; i++) {
        mpq_canonicalize(w->wish[i]);
        mpq_canonicalize(w->weight[i]);
    }
    find_step(w);
    for (size_t i = w->n; i-- > 0;) {
        mpq_sub(w->t, w->wish[i], w->weight[i]);
        mpq_mul(w->t, w->t, w->step);
        mpq_add(w->weight[i], w->weight[i], w->t);
        if (mpq_sgn(w->weight[i]) == 0 && mpq_sgn(w->wish[i]) <= 0)
            drop_vertex(w, i);
    }
}

/* ---- corrals --------------------------------------------------------------------------------- */

static fmb_status make_corral(wolfe *w)
{
    FMB_TRY(find_wish(w));
    while (!is_wish_inside(w)) {
        step_towards_wish(w);
        FMB_TRY(find_wish(w));
    }
    for (size_t i = 0; i < w->n; i++)
        mpq_set(w->weight[i], w->wish[i]);
    return FMB_OK;
}

/* direction = det x, a whole vector. */
static void find_exact_direction(wolfe *w)
{
    for (int j = 0; j < w->m->dim; j++)
        mpz_set_ui(w->direction[j], 0);
    for (size_t i = 0; i < w->n; i++)
        for (int j = 0; j < w->m->dim; j++)
            mpz_addmul(w->direction[j], w->share[i], w->vertex[i][j]);
}

/* x in doubles, and as a direction of short whole numbers. */
static void find_rough_direction(wolfe *w)
{
    double most = 0;
    int exponent;
    for (int j = 0; j < w->m->dim; j++) {
        w->rough[j] = 0;
        for (size_t i = 0; i < w->n; i++)
            w->rough[j] += mpq_get_d(w->weight[i]) * w->near[i * (size_t)w->m->dim + (size_t)j];
        most = fmax(most, fabs(w->rough[j]));
    }
    (void)frexp(most, &exponent);
    for (int j = 0; j < w->m->dim; j++)
        mpz_set_d(w->direction[j], ldexp(w->rough[j], DBL_MANT_DIG - exponent));
}

/* Does the vertex after the corral's, the candidate, have v.x < x.x? */
static bool is_nearer(wolfe *w)
{
    fmb_minkowski_dot(w->m, w->direction, w->vertex[w->n], w->a);
    mpz_mul(w->a, w->a, w->det);
    fmb_minkowski_dot(w->m, w->direction, w->direction, w->b);
    return mpz_cmp(w->a, w->b) < 0;
}

/* Likewise in doubles, where x must also be nearer than at the last call, and the corral must have
 * room for a vertex. */
static bool is_roughly_nearer(wolfe *w)
{
    double length = rough_dot(w, w->rough, w->rough), *v = w->near + w->n * (size_t)w->m->dim;
    bool falls = length < w->length;
    read_vertex(w, w->n);
    w->length = length;
    return falls && w->n <= (size_t)w->m->dim && rough_dot(w, w->rough, v) < length;
}

/* Wolfe's algorithm from the present corral and weights. */
static fmb_status walk(wolfe *w, bool roughly)
{
    bool goes_on = true;
    for (w->roughly = roughly; goes_on; w->n += goes_on) {
        FMB_TRY(make_corral(w));
        (roughly ? find_rough_direction : find_exact_direction)(w);
        fmb_minkowski_lowest(w->m, w->direction, w->vertex[w->n]);
        goes_on = (roughly ? is_roughly_nearer : is_nearer)(w);
        if (goes_on)
            mpq_set_ui(w->weight[w->n], 0, 1);
        FMB_TRY(fmb_run_poll(w->run));
    }
    return FMB_OK;
}

/* Begin with the first n vertices, at their mean. */
static void begin(wolfe *w, size_t n)
{
    w->n = n;
    for (size_t i = 0; i < n; i++)
        mpq_set_ui(w->weight[i], 1, n);
}

static fmb_status find_nearest_corral(wolfe *w)
{
    fmb_minkowski_lowest(w->m, w->direction, w->vertex[0]); /* any vertex: the direction is 0 */
    begin(w, 1);
    FMB_TRY(walk(w, true));
    begin(w, w->n);
    fmb_status st = walk(w, false);
    if (st == FMB_ERR_ARG) {
        begin(w, 1);
        st = walk(w, false);
    }
    return st;
}

/* ---- the answer ------------------------------------------------------------------------------ */

/* out = sum of weight_i number_i, a number of each vertex, over unit. */
static void weigh_number(wolfe *w, size_t place, const mpz_t unit, mpq_t out)
{
    mpz_set_ui(mpq_numref(out), 0);
    for (size_t i = 0; i < w->n; i++)
        mpz_addmul(mpq_numref(out), w->share[i], w->vertex[i][place]);
    mpz_mul(mpq_denref(out), w->det, unit);
    mpq_canonicalize(out);
}

static void add_travel(wolfe *w, int k, int j, fmb_proximity *out)
{
    const fmb_minkowski_frame *f = &w->m->frame[k];
    mpq_set_z(w->t, f->row[(size_t)(f->naxes + 1) * (size_t)w->m->dim + (size_t)j]);
    mpz_set(mpq_denref(w->step), w->m->unit);
    mpz_set_ui(mpq_numref(w->step), 1);
    mpq_mul(w->t, w->t, w->step);
    mpq_mul(w->t, w->t, out->time);
    mpq_add(out->point[k][j], out->point[k][j], w->t);
}

static void write_nearest(wolfe *w, fmb_proximity *out)
{
    size_t dim = (size_t)w->m->dim;
    mpz_set_ui(w->a, 1);
    if (dim > 0)
        weigh_number(w, 3 * dim, w->a, out->time);
    mpq_set_ui(out->measure, 0, 1);
    for (size_t j = 0; j < dim; j++) {
        for (size_t k = 0; k < 2; k++) {
            weigh_number(w, (k + 1) * dim + j, w->m->unit, out->point[k][j]);
            add_travel(w, (int)k, (int)j, out);
        }
        mpq_sub(out->shift[j], out->point[0][j], out->point[1][j]);
        mpq_neg(out->normal[j], out->shift[j]);
        mpq_mul(w->t, out->shift[j], out->shift[j]);
        mpq_add(out->measure, out->measure, w->t);
    }
}

fmb_status fmb_find_nearest(fmb_minkowski *m, fmb_run *run, fmb_proximity *out,
                            fmb_verdict *verdict)
{
    wolfe w;
    fmb_status st = open_wolfe(&w, m, run);
    FMB_THEN(st, find_nearest_corral(&w));
    if (st == FMB_OK && out)
        write_nearest(&w, out);
    if (st == FMB_OK) {
        fmb_minkowski_dot(m, w.direction, w.direction, w.a);
        *verdict = mpz_sgn(w.a) == 0 ? FMB_FEASIBLE : FMB_INFEASIBLE;
    }
    close_wolfe(&w);
    return st;
}
