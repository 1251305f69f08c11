/* walk.c: the walk around a shadow against the projection by elimination, which is irredundant:
 * where the shadow has inner points both are the same rows up to their order. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "dense.h"
#include "lp/walk.h"

enum { MOST_SECONDS = 60 };

/* ---- an oracle and the same rows as a system ------------------------------------------------- */

typedef struct bench {
    dense d; /* integers */
    const char *name;
    uint64_t seed;
    fmb_system *s;
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_vec *vec;   /* [rows] */
    int64_t *words; /* [rows][dim + 1] */
    fmb_lp_row *row;
    fmb_lp lp;
} bench;

static void fill_row(bench *b, size_t i)
{
    size_t width = (size_t)b->d.dim + 1;
    mpz_t *z = malloc(width * sizeof *z);
    for (size_t j = 0; j < width; j++)
        mpz_init_set(z[j], mpq_numref(dense_row(&b->d, (int)i)[j]));
    b->vec[i] = (fmb_vec){.s = b->words + i * width};
    cr_assert_eq(fmb_vec_set_z(&b->vec[i], width, z, &b->mem), FMB_OK);
    b->row[i] = (fmb_lp_row){&b->vec[i], b->d.rel[i]};
    for (size_t j = 0; j < width; j++)
        mpz_clear(z[j]);
    free(z);
}

/* Takes over d. */
static void open_bench(bench *b, const char *name, uint64_t seed, dense d)
{
    fmb_options o = fmb_options_default();
    size_t m = (size_t)d.rows;
    o.max_seconds = MOST_SECONDS;
    *b = (bench){.d = d, .name = name, .seed = seed, .s = dense_system(&d)};
    b->vec = calloc(m + 1, sizeof *b->vec);
    b->words = calloc((m + 1) * ((size_t)d.dim + 1), sizeof *b->words);
    b->row = calloc(m + 1, sizeof *b->row);
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    for (size_t i = 0; i < m; i++)
        fill_row(b, i);
    cr_assert_eq(fmb_lp_init(&b->lp, &b->run, d.dim, m, b->row, seed % 4 == 0), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_lp_clear(&b->lp);
    for (size_t i = 0; i < (size_t)b->d.rows; i++)
        fmb_vec_clear(&b->vec[i], (size_t)b->d.dim + 1, &b->mem);
    cr_assert_eq(b->mem.used, 0);
    free(b->vec);
    free(b->words);
    free(b->row);
    fmb_system_free(b->s);
    dense_free(&b->d);
}

/* ---- the truth ------------------------------------------------------------------------------- */

/* a.x <= b in the plane. */
typedef struct half {
    mpq_t a[2], b;
    bool equality;
} half;

typedef struct image {
    half *row;
    size_t size;
    int rank;
    bool flat;
} image;

static void read_row(const fmb_system *p, size_t i, bool swap, half *out)
{
    mpq_inits(out->a[0], out->a[1], out->b, NULL);
    for (size_t k = 0; k < fmb_system_terms(p, i); k++) {
        mpq_t t;
        mpq_init(t);
        int var = fmb_system_term_q(p, i, k, t);
        mpq_set(out->a[swap ? 1 - var : var], t);
        mpq_clear(t);
    }
    fmb_system_rhs_q(p, i, out->b);
    out->equality = fmb_system_rel(p, i) == FMB_EQ;
}

static int cross(const half *a, const half *b)
{
    mpq_t p, q;
    mpq_inits(p, q, NULL);
    mpq_mul(p, a->a[0], b->a[1]);
    mpq_mul(q, a->a[1], b->a[0]);
    int sign = mpq_cmp(p, q);
    mpq_clears(p, q, NULL);
    return sign;
}

/* The projection on x_i and x_j by elimination; false if that takes too long. */
static bool eliminate(const fmb_system *s, int i, int j, image *out)
{
    int keep[2] = {i < j ? i : j, i < j ? j : i};
    fmb_options o = fmb_options_default();
    fmb_solver *v;
    fmb_result r;
    fmb_system *p = NULL;
    o.method = FMB_METHOD_FM;
    o.max_rows = 20000;
    o.max_seconds = 5;
    cr_assert_eq(fmb_solver_new(&o, NULL, &v), FMB_OK);
    cr_assert_eq(fmb_project(v, s, keep, 2, &p, &r), FMB_OK);
    *out = (image){0};
    if (p) {
        cr_assert_eq(r.verdict, FMB_FEASIBLE);
        out->size = fmb_system_rows(p);
        out->row = malloc((out->size + 1) * sizeof *out->row);
    }
    for (size_t k = 0; k < out->size; k++) {
        read_row(p, k, i > j, &out->row[k]);
        out->flat |= out->row[k].equality;
        out->rank = out->rank == 2 || cross(&out->row[0], &out->row[k]) != 0 ? 2 : 1;
    }
    fmb_system_free(p);
    fmb_solver_free(v);
    return out->row != NULL;
}

static void image_clear(image *t)
{
    for (size_t k = 0; k < t->size; k++)
        mpq_clears(t->row[k].a[0], t->row[k].a[1], t->row[k].b, NULL);
    free(t->row);
}

/* ---- checks ---------------------------------------------------------------------------------- */

/* The multipliers are >= 0 except on equalities, and give the edge. */
static void check_weights(const bench *b, const fmb_edge *e, int i, int j)
{
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (size_t k = 0; k < e->w.size; k++)
        cr_assert(mpq_sgn(e->w.value[k]) >= 0 || b->d.rel[e->w.index[k]] == FMB_EQ, "%s %lu",
                  b->name, (unsigned long)b->seed);
    for (int c = 0; c <= b->d.dim; c++) {
        mpq_set_ui(sum, 0, 1);
        for (size_t k = 0; k < e->w.size; k++) {
            mpq_mul(t, e->w.value[k], dense_row(&b->d, (int)e->w.index[k])[c]);
            mpq_add(sum, sum, t);
        }
        mpq_set_ui(t, 0, 1);
        if (c == i || c == j)
            mpq_set_z(t, e->normal[c == j]);
        cr_assert(mpq_equal(sum, c == b->d.dim ? e->bound : t), "%s %lu: column %d", b->name,
                  (unsigned long)b->seed, c);
    }
    mpq_clears(sum, t, NULL);
}

/* The edge as a row. */
static void edge_row(const fmb_edge *e, half *out)
{
    mpq_inits(out->a[0], out->a[1], out->b, NULL);
    mpq_set_z(out->a[0], e->normal[0]);
    mpq_set_z(out->a[1], e->normal[1]);
    mpq_set(out->b, e->bound);
    mpz_t g;
    mpz_init(g);
    mpz_gcd(g, e->normal[0], e->normal[1]);
    cr_assert(mpz_cmp_ui(g, 1) == 0, "the normal is not primitive");
    mpz_clear(g);
}

/* Is one a positive multiple of the other? */
static bool is_same(const half *x, const half *y)
{
    int k = mpq_sgn(x->a[0]) == 0;
    bool same = cross(x, y) == 0 && mpq_sgn(x->a[k]) == mpq_sgn(y->a[k]);
    mpq_t p, q;
    mpq_inits(p, q, NULL);
    mpq_mul(p, x->b, y->a[k]);
    mpq_mul(q, y->b, x->a[k]);
    same = same && mpq_equal(p, q);
    mpq_clears(p, q, NULL);
    return same;
}

static void check_edges(const bench *b, const fmb_edges *list, const image *t, int i, int j)
{
    bool *met = calloc(t->size + 1, sizeof *met);
    cr_assert_eq(list->size, t->size, "%s %lu: %zu edges, %zu rows", b->name,
                 (unsigned long)b->seed, list->size, t->size);
    for (size_t k = 0; k < list->size; k++) {
        half h;
        size_t at = 0;
        edge_row(&list->edge[k], &h);
        while (at < t->size && (met[at] || !is_same(&h, &t->row[at])))
            at++;
        cr_assert_lt(at, t->size, "%s %lu: edge %zu is no row", b->name, (unsigned long)b->seed, k);
        met[at] = true;
        check_weights(b, &list->edge[k], i, j);
        mpq_clears(h.a[0], h.a[1], h.b, NULL);
    }
    free(met);
}

/* How the walks of a test ended. */
typedef struct tally {
    int done, flat, no_vertex, unjudged;
} tally;

/* From the dictionary at hand. */
static void check_walk(bench *b, int i, int j, tally *sum)
{
    fmb_edges list = {0};
    image t;
    bool done;
    fmb_status st = fmb_lp_walk(&b->lp, i, j, &list, &done);
    cr_assert_eq(st, FMB_OK, "%s %lu: status %d", b->name, (unsigned long)b->seed, (int)st);
    if (eliminate(b->s, i, j, &t)) {
        cr_assert_eq(done, !t.flat && t.rank == 2, "%s %lu: done %d, flat %d, rank %d", b->name,
                     (unsigned long)b->seed, done, t.flat, t.rank);
        if (done)
            check_edges(b, &list, &t, i, j);
        sum->done += done;
        sum->flat += t.flat;
        sum->no_vertex += t.rank < 2;
    } else {
        sum->unjudged++;
    }
    image_clear(&t);
    fmb_edges_clear(&list, &b->mem);
}

/* ---- systems --------------------------------------------------------------------------------- */

static mpz_ptr cell(const dense *d, int i, int j)
{
    return mpq_numref(dense_row(d, i)[j]);
}

static int any_dim(support_rng *g)
{
    return support_between(g, 2, 6);
}

static void fill(const dense *d, int i, support_rng *g, int most, int density)
{
    for (int j = 0; j < d->dim; j++)
        mpz_set_si(cell(d, i, j), support_chance(g, density) ? support_between(g, -most, most) : 0);
}

/* b_i = a_i.point + slack. */
static void let_in(const dense *d, int i, const int *point, int slack)
{
    mpz_ptr b = cell(d, i, d->dim);
    mpz_set_si(b, slack);
    for (int j = 0; j < d->dim; j++)
        if (point[j] >= 0)
            mpz_addmul_ui(b, cell(d, i, j), (unsigned)point[j]);
        else
            mpz_submul_ui(b, cell(d, i, j), (unsigned)-point[j]);
}

/* Rows +-x_j <= most from row i on. */
static void fill_box(const dense *d, int i, int most)
{
    for (int k = 0; k < 2 * d->dim; k++) {
        mpz_set_si(cell(d, i + k, k / 2), k % 2 ? 1 : -1);
        mpz_set_si(cell(d, i + k, d->dim), most);
    }
}

static void negate(const dense *d, int to, int from)
{
    for (int j = 0; j <= d->dim; j++)
        mpz_neg(cell(d, to, j), cell(d, from, j));
}

static void any_point(support_rng *g, int *point)
{
    for (int j = 0; j < 6; j++)
        point[j] = support_between(g, -3, 3);
}

static dense dense_rows(support_rng *g)
{
    dense d = dense_new(any_dim(g), support_between(g, 2, 12));
    int density = support_between(g, 40, 100), most = support_chance(g, 30) ? 1 : 9;
    for (int i = 0; i < d.rows; i++) {
        fill(&d, i, g, most, density);
        mpz_set_si(cell(&d, i, d.dim), support_between(g, -2, 12));
    }
    return d;
}

static dense bounded(support_rng *g)
{
    int n = any_dim(g), more = support_between(g, 0, 20 - 2 * n);
    dense d = dense_new(n, 2 * n + more);
    fill_box(&d, more, support_between(g, 1, 9));
    for (int i = 0; i < more; i++) {
        fill(&d, i, g, 9, 80);
        mpz_set_si(cell(&d, i, n), support_between(g, 0, 20));
    }
    return d;
}

/* Many rows through one point; with all of them: a cone. */
static dense through_a_point(support_rng *g)
{
    int point[6], share = support_chance(g, 40) ? 100 : support_between(g, 30, 90);
    dense d = dense_new(any_dim(g), support_between(g, 2, 14));
    int most = support_chance(g, 50) ? 1 : 4;
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        fill(&d, i, g, most, 70);
        let_in(&d, i, point, support_chance(g, share) ? 0 : support_between(g, 1, 6));
    }
    return d;
}

static dense cone(support_rng *g)
{
    dense d = dense_new(any_dim(g), support_between(g, 2, 12));
    for (int i = 0; i < d.rows; i++)
        fill(&d, i, g, support_chance(g, 50) ? 1 : 9, 90);
    return d;
}

static dense with_equalities(support_rng *g)
{
    int point[6];
    dense d = dense_new(any_dim(g), support_between(g, 4, 14));
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        fill(&d, i, g, 5, 80);
        bool equality = i < d.dim - 1 && support_chance(g, 40);
        d.rel[i] = equality ? FMB_EQ : FMB_LE;
        let_in(&d, i, point, equality ? 0 : support_between(g, 0, 9));
    }
    return d;
}

/* Pairs of opposite rows: equalities in disguise, of few variables each. */
static dense flat(support_rng *g)
{
    int point[6], pairs = support_between(g, 1, 3), more = support_between(g, 0, 10);
    dense d = dense_new(any_dim(g), 2 * pairs + more);
    any_point(g, point);
    for (int i = 0; i < 2 * pairs; i += 2) {
        int a = support_between(g, 0, d.dim - 1), b = support_between(g, 0, d.dim - 1);
        mpz_set_si(cell(&d, i, a), support_between(g, 1, 5));
        mpz_set_si(cell(&d, i, b), support_between(g, -5, 5));
        let_in(&d, i, point, 0);
        negate(&d, i + 1, i);
    }
    for (int i = 2 * pairs; i < d.rows; i++) {
        fill(&d, i, g, 5, 70);
        let_in(&d, i, point, support_between(g, 0, 5));
    }
    return d;
}

/* x >= p, sum x <= sum p, and rows through p. */
static dense single_point(support_rng *g)
{
    int point[6], n = any_dim(g);
    dense d = dense_new(n, n + 1 + support_between(g, 0, 8));
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        if (i < n)
            mpz_set_si(cell(&d, i, i), -1);
        else if (i > n)
            fill(&d, i, g, 3, 80);
        for (int j = 0; i == n && j < n; j++)
            mpz_set_si(cell(&d, i, j), support_between(g, 1, 4));
        let_in(&d, i, point, 0);
    }
    return d;
}

/* Cross-polytopes: many rows through every vertex. */
static dense cross_polytope(support_rng *g)
{
    int n = support_between(g, 2, 4);
    dense d = dense_new(n, 1 << n);
    for (int i = 0; i < d.rows; i++)
        for (int j = 0; j <= n; j++)
            mpz_set_si(cell(&d, i, j), j == n || (i >> j) % 2 ? 1 : -1);
    return d;
}

/* Over a cube: a pyramid, whose top is in 2 (n - 1) rows. */
static dense pyramid(support_rng *g)
{
    int n = any_dim(g);
    dense d = dense_new(n, 2 * n - 1);
    for (int i = 0; i < d.rows - 1; i++) {
        mpz_set_si(cell(&d, i, i / 2), i % 2 ? 1 : -1);
        mpz_set_si(cell(&d, i, n - 1), 1);
        mpz_set_si(cell(&d, i, n), support_between(g, 1, 2));
    }
    mpz_set_si(cell(&d, d.rows - 1, n - 1), -1);
    return d;
}

/* Few directions lead to no end in the shadow, if any: it has a corner of almost half a turn. Or it
 * is a long needle. The other variables are mixed in. */
static dense narrow(support_rng *g)
{
    int n = any_dim(g), point[6];
    dense d = dense_new(n, 2 + support_between(g, 0, 4));
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        mpz_set_si(cell(&d, i, 1), i < 2 ? -1 : support_between(g, -1, 1));
        mpz_set_si(cell(&d, i, 0), i == 0 ? 1 : i == 1 ? -1 : support_between(g, -1, 1));
        int bits = support_between(g, 0, 70);
        mpz_mul_2exp(cell(&d, i, i % 2), cell(&d, i, i % 2), (mp_bitcnt_t)bits);
        if (i < 2 && support_chance(g, 50))
            mpz_swap(cell(&d, i, 0), cell(&d, i, 1));
        for (int j = 2; j < n; j++)
            mpz_set_si(cell(&d, i, j), i < 2 ? 0 : support_between(g, -1, 1));
        let_in(&d, i, point, support_between(g, 0, 2));
    }
    return d;
}

/* Some column is empty. */
static dense unnamed(support_rng *g)
{
    dense d = support_chance(g, 50) ? bounded(g) : dense_rows(g);
    int j = support_between(g, 0, d.dim - 1);
    for (int i = 0; i < d.rows; i++)
        mpz_set_si(cell(&d, i, j), 0);
    return d;
}

static dense wide(support_rng *g)
{
    static const int BITS[] = {31, 53, 61, 62, 63, 64, 200};
    int n = support_between(g, 2, 4), bits = BITS[support_between(g, 0, 6)];
    dense d = dense_new(n, support_between(g, 2, 10));
    int point[6];
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        for (int j = 0; j < n; j++)
            support_integer(g, bits, cell(&d, i, j));
        let_in(&d, i, point, support_between(g, 0, 9));
    }
    return d;
}

typedef struct family {
    const char *name;
    dense (*make)(support_rng *g);
    int count;
} family;

static tally walk_family(family f)
{
    tally sum = {0};
    for (int k = 0; k < f.count; k++) {
        support_rng g = {(uint64_t)k * 1000003 + 17};
        bench b;
        bool feasible;
        open_bench(&b, f.name, (uint64_t)k, f.make(&g));
        cr_assert_eq(fmb_lp_feasible(&b.lp, &feasible), FMB_OK);
        for (int again = 0; feasible && again < 2; again++) {
            int i = support_between(&g, 0, b.d.dim - 1), j = support_between(&g, 0, b.d.dim - 2);
            check_walk(&b, i, j + (j >= i), &sum);
        }
        close_bench(&b);
    }
    cr_log_info("%s: %d done, %d flat, %d without vertex, %d unjudged\n", f.name, sum.done,
                sum.flat, sum.no_vertex, sum.unjudged);
    cr_expect_leq(sum.unjudged, f.count / 20, "%s: %d unjudged", f.name, sum.unjudged);
    return sum;
}

Test(walk, dense_rows)
{
    tally t = walk_family((family){"dense rows", dense_rows, 400});
    cr_expect(t.done > 100 && t.no_vertex > 20, "%d %d", t.done, t.no_vertex);
}

Test(walk, bounded)
{
    tally t = walk_family((family){"bounded", bounded, 150});
    cr_expect_eq(t.done + t.unjudged, 300);
}

Test(walk, through_a_point)
{
    tally t = walk_family((family){"through a point", through_a_point, 400});
    cr_expect(t.done > 100 && t.flat > 0 && t.no_vertex > 20, "%d %d %d", t.done, t.flat,
              t.no_vertex);
}

Test(walk, cones)
{
    tally t = walk_family((family){"cone", cone, 300});
    cr_expect(t.done > 20 && t.flat > 0 && t.no_vertex > 20, "%d %d %d", t.done, t.flat,
              t.no_vertex);
}

Test(walk, equalities)
{
    tally t = walk_family((family){"with equalities", with_equalities, 300});
    cr_expect(t.done > 100 && t.flat > 0, "%d %d", t.done, t.flat);
}

Test(walk, flat)
{
    tally t = walk_family((family){"flat", flat, 300});
    cr_expect(t.done > 20 && t.flat > 100, "%d %d", t.done, t.flat);
}

Test(walk, single_points)
{
    tally t = walk_family((family){"single point", single_point, 200});
    cr_expect_eq(t.flat + t.unjudged, 400);
}

Test(walk, cubes_and_the_like)
{
    tally t = walk_family((family){"cross-polytope", cross_polytope, 20});
    cr_expect_eq(t.done, 40);
    t = walk_family((family){"pyramid", pyramid, 60});
    cr_expect_eq(t.done, 120);
}

Test(walk, narrow)
{
    tally t = walk_family((family){"narrow", narrow, 600});
    cr_expect(t.done > 100, "%d", t.done);
}

Test(walk, unnamed_variables)
{
    tally t = walk_family((family){"unnamed", unnamed, 150});
    cr_expect(t.done > 50 && t.no_vertex > 20, "%d %d", t.done, t.no_vertex);
}

Test(walk, wide_numbers)
{
    tally t = walk_family((family){"wide", wide, 200});
    cr_expect(t.done > 50, "%d", t.done);
}

/* A strict row anywhere: the walk declines. */
Test(walk, strict)
{
    for (uint64_t seed = 0; seed < 20; seed++) {
        support_rng g = {seed};
        dense d = bounded(&g);
        fmb_edges list = {0};
        bool feasible, done;
        bench b;
        d.rel[d.rows - 1] = FMB_LT;
        open_bench(&b, "strict", seed, d);
        cr_assert_eq(fmb_lp_feasible(&b.lp, &feasible), FMB_OK);
        if (feasible) {
            cr_assert_eq(fmb_lp_walk(&b.lp, 0, 1, &list, &done), FMB_OK);
            cr_assert(!done && list.size == 0);
        }
        close_bench(&b);
    }
}
