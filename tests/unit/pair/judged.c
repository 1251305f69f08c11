/* judged.c: contacts as fmb-validate --contact judges them: depths, distances, normals, nearest
 * points and separating rows, against exact ones. */
#include <criterion/criterion.h>
#include <math.h>

#include "property/random/rows.h"
#include "study/draw/pairs.h"
#include "study/reference/validate_contacts.h"
#include "support/support.h"

/* Distances, normals, nearest points and rows between, too. The share that doubles tell. */
static double judge_by_study(int dim, fmb_simd simd, size_t n, const fmb_frame *p,
                             const fmb_frame *q)
{
    study_contact_bench *b = NULL;
    study_tally tally = {0};
    size_t index[STUDY_VALIDATE_MOST];
    unsigned faults[STUDY_VALIDATE_MOST] = {0};
    for (size_t i = 0; i < n; i++)
        index[i] = i;
    cr_assert_eq(study_contact_bench_open(dim, simd, &b), FMB_OK);
    cr_assert_eq(study_contact_bench_run(b, n, p, q, index, faults, &tally), FMB_OK);
    study_contact_bench_close(b);
    for (size_t i = 0; i < n; i++)
        cr_assert_eq(faults[i], 0, "pair %zu of %zu in %d dimensions", i, n, dim);
    cr_assert_eq(tally.contacts, n);
    return 1 - (double)tally.contacts_open / (double)(2 * n);
}

Test(contact, apart)
{
    enum { N = 12 };
    study_pairs pairs;
    for (int i = 0; i < 4 * STUDY_PAIR_FAMILIES; i++) {
        study_pair_plan plan = {.family = (study_pair_family)(i / 4), .dim = 2 + i % 2};
        plan.moves = i % 4 > 1;
        plan.shape[0] = plan.shape[1] = STUDY_PAIR_ANY_SHAPE;
        if (i % 4 == 3)
            plan.naxes[i / 4 % 2] = 1 + i / 4 % plan.dim;
        cr_assert_eq(study_pairs_make(&plan, 8, N, NULL, NULL, &pairs), FMB_OK);
        double told = judge_by_study(plan.dim, i / 4 % 2 ? FMB_SIMD_PLAIN : FMB_SIMD_AUTO, N,
                                     pairs.p, pairs.q);
        cr_assert(plan.family != STUDY_PAIR_ARTICLE || told == 1);
        study_pairs_free(&pairs);
    }
}

/* Hulls of many corners: on spheres; of small integers, which touch and have corners within
 * faces; and either far up or down in the range of doubles. */
Test(contact, hulls)
{
    enum { N = 24, CORNERS = 12 };
    static double x[2 * N][CORNERS * 3];
    support_rng g = {11};
    for (int kind = 0; kind < 8; kind++) {
        int dim = 2 + kind % 2, power = kind > 3 ? (kind > 5 ? 1000 : -1000) : 0;
        bool whole = kind / 2 % 2;
        fmb_frame f[2 * N];
        for (int i = 0; i < 2 * N; i++) {
            int corners = support_between(&g, dim + 2, whole ? CORNERS - 2 : CORNERS),
                away = support_between(&g, -12, 12);
            for (int c = 0; c < corners * dim; c++) {
                double at = whole ? support_between(&g, -3, 3)
                                  : support_between(&g, -1000000, 1000000) * 3e-6;
                x[i][c] = ldexp(at + away / 5 * (c % dim == 0), power);
            }
            f[i] = (fmb_frame){FMB_SIMPLEX_BY_CORNERS, dim, corners - 1, x[i], x[i] + dim, NULL};
        }
        double told = judge_by_study(dim, kind < 4 ? FMB_SIMD_AUTO : FMB_SIMD_PLAIN, N, f, f + N);
        cr_assert(whole || told > 0.95, "%g of kind %d", told, kind);
    }
}

/* ---- hulls of whole numbers ------------------------------------------------------------------ */

/* Frames of corners that are small whole numbers times a power of two, perhaps all in one plane or
 * far away: hulls, and other frames beside them. */
typedef struct whole_frames {
    enum { WHOLE_PAIRS = 40, WHOLE_CORNERS = 14 } pairs;
    double x[2 * WHOLE_PAIRS][(WHOLE_CORNERS + 1) * 3];
    fmb_frame f[2 * WHOLE_PAIRS];
} whole_frames;

static void draw_whole_frame(support_rng *g, int dim, int power, double far, bool hull, double *x,
                             fmb_frame *out)
{
    static const fmb_shape SHAPE[] = {FMB_CUBOID, FMB_SIMPLEX, FMB_CUBOID_BY_CORNERS,
                                      FMB_SIMPLEX_BY_CORNERS};
    int size = support_chance(g, 70) ? 3 : 40, flat = support_chance(g, 10) ? 0 : dim;
    int naxes = hull ? support_between(g, dim + 1, WHOLE_CORNERS - 1) : support_between(g, 0, dim);
    fmb_shape shape = hull ? FMB_SIMPLEX_BY_CORNERS : SHAPE[support_between(g, 0, 3)];
    bool edges = shape == FMB_CUBOID || shape == FMB_SIMPLEX;
    int centre = support_between(g, -size, size);
    for (int c = 0; c < (naxes + 2) * dim; c++) {
        bool origin = c < dim, speed = c >= (naxes + 1) * dim;
        double at = c % dim == flat ? 1 : support_between(g, -size, size);
        if (c % dim == 0 && !speed && (origin || !edges))
            at += centre;
        x[c] = ldexp(at + (!speed && (origin || !edges) ? far : 0), power);
    }
    bool moves = support_chance(g, 20);
    *out = (fmb_frame){shape, dim, naxes, x, x + dim, moves ? x + (naxes + 1) * dim : NULL};
}

/* Verdicts of interiors, too. */
static void expect_open_verdicts(int dim, size_t n, const fmb_frame *p, const fmb_frame *q)
{
    fmb_verdict said[2][WHOLE_PAIRS];
    for (int exact = 0; exact < 2; exact++) {
        fmb_pair *k = NULL;
        fmb_pair_options o = {.size = sizeof o, .contact = FMB_CONTACT_OPEN};
        o.method = exact ? FMB_PAIR_EXACT : FMB_PAIR_FMB;
        fmb_pair_answers out = {.size = sizeof out, .verdict = said[exact]};
        cr_assert_eq(fmb_pair_new(dim, &o, NULL, &k), FMB_OK);
        cr_assert_eq(fmb_pair_test(k, n, p, q, &out), FMB_OK);
        fmb_pair_free(k);
    }
    for (size_t i = 0; i < n; i++)
        cr_expect_eq(said[0][i], said[1][i], "pair %zu in %d dimensions", i, dim);
}

/* None is left to the exact way, unless one plane holds both. */
Test(contact, hulls_of_whole_numbers)
{
    static whole_frames w;
    static const int POWER[] = {0, 0, 60, -60};
    support_rng g = {29};
    double told = 0;
    for (int round = 0; round < 16; round++) {
        int dim = 2 + round % 2;
        double far = round % 3 == 2 ? 0x1p40 : 0;
        for (int i = 0; i < 2 * WHOLE_PAIRS; i++)
            draw_whole_frame(&g, dim, POWER[round / 4], far, i < WHOLE_PAIRS || i % 3 > 0, w.x[i],
                             &w.f[i]);
        told += judge_by_study(dim, round % 2 ? FMB_SIMD_AUTO : FMB_SIMD_PLAIN, WHOLE_PAIRS, w.f,
                               w.f + WHOLE_PAIRS) /
                16;
        expect_open_verdicts(dim, WHOLE_PAIRS, w.f, w.f + WHOLE_PAIRS);
    }
    cr_expect_gt(told, 0.98, "%g", told);
}
