/* walk.c: the walk around a shadow against the projection by elimination, which is irredundant:
 * where the shadow has inner points both are the same rows up to their order. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "hull/shadow/shadow.h"
#include "lp/dictionary/exact_simplex.h"
#include "shadows.h"

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
    fmb_options o = {.size = sizeof o};
    size_t m = (size_t)d.rows;
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
    fmb_options o = {.size = sizeof o};
    fmb_solver *v;
    fmb_result r = {.size = sizeof r};
    fmb_system *p = NULL;
    o.method = FMB_METHOD_FM;
    o.max_rows = 20000;
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
    fmb_status st = fmb_shadow_polygon(&b->lp, i, j, &list, &done);
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

/* ---- families -------------------------------------------------------------------------------- */

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
    tally t = walk_family((family){"dense rows", shadow_dense_rows, 400});
    cr_expect(t.done > 100 && t.no_vertex > 20, "%d %d", t.done, t.no_vertex);
}

Test(walk, bounded)
{
    tally t = walk_family((family){"bounded", shadow_bounded, 150});
    cr_expect_eq(t.done + t.unjudged, 300);
}

Test(walk, through_a_point)
{
    tally t = walk_family((family){"through a point", shadow_through_a_point, 400});
    cr_expect(t.done > 100 && t.flat > 0 && t.no_vertex > 20, "%d %d %d", t.done, t.flat,
              t.no_vertex);
}

Test(walk, cones)
{
    tally t = walk_family((family){"cone", shadow_cone, 300});
    cr_expect(t.done > 20 && t.flat > 0 && t.no_vertex > 20, "%d %d %d", t.done, t.flat,
              t.no_vertex);
}

Test(walk, equalities)
{
    tally t = walk_family((family){"with equalities", shadow_with_equalities, 300});
    cr_expect(t.done > 100 && t.flat > 0, "%d %d", t.done, t.flat);
}

Test(walk, flat)
{
    tally t = walk_family((family){"flat", shadow_flat, 300});
    cr_expect(t.done > 20 && t.flat > 100, "%d %d", t.done, t.flat);
}

Test(walk, single_points)
{
    tally t = walk_family((family){"single point", shadow_single_point, 200});
    cr_expect_eq(t.flat + t.unjudged, 400);
}

Test(walk, cubes_and_the_like)
{
    tally t = walk_family((family){"cross-polytope", shadow_cross_polytope, 20});
    cr_expect_eq(t.done, 40);
    t = walk_family((family){"pyramid", shadow_pyramid, 60});
    cr_expect_eq(t.done, 120);
}

Test(walk, narrow)
{
    tally t = walk_family((family){"narrow", shadow_narrow, 600});
    cr_expect(t.done > 100, "%d", t.done);
}

Test(walk, unnamed_variables)
{
    tally t = walk_family((family){"unnamed", shadow_unnamed, 150});
    cr_expect(t.done > 50 && t.no_vertex > 20, "%d %d", t.done, t.no_vertex);
}

Test(walk, wide_numbers)
{
    tally t = walk_family((family){"wide", shadow_wide, 200});
    cr_expect(t.done > 50, "%d", t.done);
}

/* A strict row anywhere: the walk declines. */
Test(walk, strict)
{
    for (uint64_t seed = 0; seed < 20; seed++) {
        support_rng g = {seed};
        dense d = shadow_bounded(&g);
        fmb_edges list = {0};
        bool feasible, done;
        bench b;
        d.rel[d.rows - 1] = FMB_LT;
        open_bench(&b, "strict", seed, d);
        cr_assert_eq(fmb_lp_feasible(&b.lp, &feasible), FMB_OK);
        if (feasible) {
            cr_assert_eq(fmb_shadow_polygon(&b.lp, 0, 1, &list, &done), FMB_OK);
            cr_assert(!done && list.size == 0);
        }
        close_bench(&b);
    }
}
