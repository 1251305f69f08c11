/* ray_shooting.c: redundant rows by guesses that are proved, against one linear program for each
 * row; each proof is recomputed from the rows. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>

#include "claims.h"
#include "lp/redundancy/ray_shooting/ray_shooting.h"
#include "num/rationals.h"
#include "support/dense.h"
#include "support/must.h"

/* ---- both ways ------------------------------------------------------------------------------- */

typedef struct tally {
    size_t systems, inner, rows, unknown, redundant, kept;
} tally;

/* False: infeasible. */
static bool decide_by_programs(scene *c, fmb_fate *fate)
{
    bool feasible;
    for (size_t i = 0; i < c->m; i++)
        fate[i] = FMB_FATE_UNKNOWN;
    must(fmb_irredundant(&c->run, c->n, c->m, c->row, fate, NULL, &feasible));
    return feasible;
}

static void count_fates(const scene *c, const fmb_fate *fate, tally *t)
{
    t->rows += c->m;
    for (size_t i = 0; i < c->m; i++) {
        t->unknown += fate[i] == FMB_FATE_UNKNOWN;
        t->redundant += fate[i] == FMB_FATE_REDUNDANT;
        t->kept += fate[i] == FMB_FATE_KEPT;
    }
}

static void sort_and_compare(scene *c, const char *what, uint64_t seed, tally *t)
{
    fmb_fate *fate = calloc(c->m, sizeof *fate), *truth = calloc(c->m, sizeof *truth);
    bool *gone = calloc(c->m, sizeof *gone), inner = false;
    scene_listener l = {c, gone, 0};
    fmb_verdicts told = {scene_hear_redundant, NULL, scene_hear_irredundant, &l};
    fmb_ray_shooting s;
    t->systems++;
    must(fmb_ray_shooting_open(&s, &c->run, c->n, c->m, c->row, &inner));
    if (inner) {
        t->inner++;
        must(fmb_ray_shooting_sort(&s, fate, &told));
        count_fates(c, fate, t);
        cr_assert(decide_by_programs(c, truth), "%s, seed %llu", what, (unsigned long long)seed);
    }
    for (size_t i = 0; inner && i < c->m; i++) {
        l.claims -= fate[i] != FMB_FATE_UNKNOWN;
        cr_assert(fate[i] == FMB_FATE_UNKNOWN || fate[i] == truth[i], "%s, seed %llu, row %zu: %d",
                  what, (unsigned long long)seed, i, fate[i]);
    }
    cr_assert_eq(l.claims, 0);
    fmb_ray_shooting_close(&s);
    free(fate);
    free(truth);
    free(gone);
}

static void sort_system(const fmb_system *s, const char *what, uint64_t seed, tally *t)
{
    scene c;
    if (scene_open(&c, s))
        sort_and_compare(&c, what, seed, t);
    scene_close(&c);
}

/* ---- systems --------------------------------------------------------------------------------- */

Test(ray_shooting, small_systems_of_all_families)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 400; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case c = support_make(family, seed, NULL);
            sort_system(c.s, support_family_name(family), seed, &t);
            support_case_clear(&c);
        }
    cr_expect_gt(t.inner, 400);
    cr_expect_gt(t.redundant, 300);
    cr_expect_gt(t.kept, 1000);
    cr_expect_lt(25 * t.unknown, t.rows, "%zu of %zu rows", t.unknown, t.rows);
}

/* Without equalities, and with larger right sides: mostly with a point inside. */
static fmb_system *move_rows_out(const fmb_system *s, support_rng *g, int bits)
{
    dense d = dense_of(s);
    mpz_t z;
    mpz_init(z);
    for (int i = 0; i < d.rows; i++) {
        d.rel[i] = d.rel[i] == FMB_EQ ? FMB_LE : d.rel[i];
        mpz_set_ui(z, (unsigned long)support_between(g, 0, 9));
        mpz_mul_2exp(z, z, (mp_bitcnt_t)bits);
        mpz_addmul(mpq_numref(dense_rhs(&d, i)), z, mpq_denref(dense_rhs(&d, i)));
    }
    fmb_system *wider = dense_system(&d);
    dense_free(&d);
    mpz_clear(z);
    return wider;
}

Test(ray_shooting, larger_systems_of_all_families)
{
    static const int bits[] = {0, 0, 0, 31, 63, 200};
    tally t = {0};
    support_rng g = {7};
    for (uint64_t seed = 0; seed < 120; seed++) {
        support_shape shape = {support_between(&g, 2, 7), support_between(&g, 10, 40),
                               bits[support_between(&g, 0, 5)]};
        support_family family = (support_family)support_between(&g, 0, SUPPORT_FAMILIES - 1);
        support_case c = support_make(family, seed, &shape);
        fmb_system *wider = move_rows_out(c.s, &g, shape.bits);
        sort_system(c.s, support_family_name(family), seed, &t);
        sort_system(wider, support_family_name(family), seed, &t);
        fmb_system_free(wider);
        support_case_clear(&c);
    }
    cr_expect_gt(t.inner, 30);
    cr_expect_gt(t.redundant, 100);
    cr_expect_lt(10 * t.unknown, t.rows, "%zu of %zu rows", t.unknown, t.rows);
}

typedef enum shape { ROUND, DEEP, CORNER, SCALED, SHAPES } shape;

/* A row |a| <= 9: tangents of a ball; tangents and rows far off; many rows through one corner, some
 * of them strict; like the first, in columns and rows of very different scale. */
static void add_drawn_row(fmb_system *s, support_rng *g, shape kind, const int64_t *scale)
{
    int n = fmb_system_dim(s);
    int64_t a[8] = {0}, right = 0;
    fmb_rel rel = kind == CORNER && support_chance(g, 30) ? FMB_LT : FMB_LE;
    int64_t row = kind == SCALED && support_chance(g, 50) ? 1000000007 : 1;
    for (int j = 0; j < n; j++) {
        a[j] = support_between(g, -9, 9);
        right += kind == CORNER ? a[j] * (j + 1) : a[j] * a[j];
    }
    if (kind == DEEP)
        right += support_chance(g, 70) ? support_between(g, 0, 400) : 0;
    bool turned = kind == CORNER && right < 0; /* 0 lies inside */
    if (kind == CORNER)
        right = support_chance(g, 40) ? llabs(right) : llabs(right) + support_between(g, 1, 30);
    for (int j = 0; j < n; j++)
        a[j] *= (turned ? -row : row) * (kind == SCALED ? scale[j] : 1);
    must(fmb_system_add_int(s, a, rel, (kind == ROUND ? 3 : 1) * row * right));
}

Test(ray_shooting, balls_corners_and_scales)
{
    static const int64_t scale[8] = {1, 1000000, 1, 1000, 3, 1, 100000000, 1};
    tally t[SHAPES] = {0};
    support_rng g = {11};
    for (uint64_t seed = 0; seed < 100; seed++) {
        shape kind = (shape)(seed % SHAPES);
        fmb_system *s = NULL;
        must(fmb_system_new(support_between(&g, 2, 6), NULL, &s));
        int rows = support_between(&g, 20, 120);
        for (int i = 0; i < rows; i++)
            add_drawn_row(s, &g, kind, scale);
        sort_system(s, "drawn", seed, &t[kind]);
        fmb_system_free(s);
    }
    for (int kind = 0; kind < SHAPES; kind++) {
        cr_expect_gt(t[kind].inner, 15, "%d: %zu", kind, t[kind].inner);
        cr_expect_lt(20 * t[kind].unknown, (kind == CORNER ? 10 : 1) * t[kind].rows,
                     "%d: %zu of %zu rows", kind, t[kind].unknown, t[kind].rows);
    }
}

/* More rows than are awake at once, and more than a block. */
Test(ray_shooting, many_rows)
{
    tally t = {0};
    support_rng g = {5};
    for (int n = 2; n <= 3; n++) {
        fmb_system *s = NULL;
        must(fmb_system_new(n, NULL, &s));
        for (int i = 0; i < 250; i++) {
            int64_t a[3];
            double square = 0;
            for (int j = 0; j < n; j++) {
                a[j] = support_between(&g, -999, 999);
                square += (double)(a[j] * a[j]);
            }
            must(fmb_system_add_int(s, a, FMB_LE, (int64_t)ceil(1e6 * sqrt(square))));
        }
        sort_system(s, "sphere", (uint64_t)n, &t);
        fmb_system_free(s);
    }
    cr_expect_eq(t.inner, 2);
    cr_expect_eq(t.unknown, 0);
    cr_expect_gt(t.kept, 250);
}

/* Two strict rows that touch the same corner: one of them may go, but neither is seen from inside.
 * Found out by programs, so ray shooting leaves them alone. */
Test(ray_shooting, leaves_what_only_touches)
{
    fmb_system *s = NULL;
    tally t = {0};
    must(fmb_system_new(2, NULL, &s));
    must(fmb_system_add_int(s, (int64_t[]){1, 0}, FMB_LE, 1));
    must(fmb_system_add_int(s, (int64_t[]){0, 1}, FMB_LE, 1));
    must(fmb_system_add_int(s, (int64_t[]){-1, -1}, FMB_LE, 0));
    must(fmb_system_add_int(s, (int64_t[]){1, 1}, FMB_LT, 2));
    must(fmb_system_add_int(s, (int64_t[]){2, 1}, FMB_LT, 3));
    sort_system(s, "corner", 0, &t);
    cr_expect_eq(t.kept, 3);
    cr_expect_eq(t.unknown, 2);
    fmb_system_free(s);
}

/* Of two rows that differ in their 30,000th bit alone, a ray meets one first by as little, and the
 * point behind it alone has as many bits. */
Test(sieve, rows_nearly_met_at_once)
{
    enum { BITS = 30000 };
    static const int8_t cell[5][3] = {{1, 1, 1}, {1, 1, 1}, {-1, 0, 1}, {0, -1, 1}, {0, 1, 1}};
    tally t = {0};
    dense d = dense_new(2, 5);
    for (int i = 0; i < d.rows; i++)
        for (int j = 0; j < 3; j++)
            mpq_set_si(dense_row(&d, i)[j], cell[i][j], 1);
    for (int j = 0; j < 3; j++)
        mpq_mul_2exp(dense_row(&d, 1)[j], dense_row(&d, 1)[j], BITS);
    mpz_sub_ui(mpq_numref(dense_row(&d, 1)[1]), mpq_numref(dense_row(&d, 1)[1]), 1);
    fmb_system *s = dense_system(&d);
    sort_system(s, "nearly parallel", 0, &t);
    cr_expect_eq(t.inner, 1);
    cr_expect_leq(t.unknown, 1);
    fmb_system_free(s);
    dense_free(&d);
}
