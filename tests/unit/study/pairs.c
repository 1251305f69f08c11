/* pairs.c: random pairs of frames: each from its number alone, as hard as its family says. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/draw/draft.h"
#include "study/draw/pairs.h"
#include "support/must.h"

static study_pair_plan plan_of(study_pair_family family, int dim, bool moves)
{
    return (study_pair_plan){.family = family,
                             .dim = dim,
                             .moves = moves,
                             .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
}

/* ---- numbers --------------------------------------------------------------------------------- */

/* The first outputs of the authors' code (Vigna, splitmix64.c) from 1234567. */
Test(pairs, the_generator_is_splitmix64)
{
    static const uint64_t expected[] = {6457827717110365317u, 3203168211198807973u,
                                        9817491932198370423u};
    uint64_t state;
    study_splitmix.set(&state, 1234567);
    for (int i = 0; i < 3; i++)
        cr_expect_eq((uint64_t)study_splitmix.get(&state), expected[i]);
    for (int i = 0; i < 1000; i++) {
        double x = study_splitmix.get_double(&state);
        cr_assert(x >= 0 && x < 1);
    }
}

static void expect_equal(const fmb_frame *f, const fmb_frame *g)
{
    size_t dim = (size_t)f->dim, axes = dim * (size_t)f->naxes;
    cr_assert(f->shape == g->shape && f->dim == g->dim && f->naxes == g->naxes);
    cr_expect_arr_eq(f->origin, g->origin, dim * sizeof(double));
    cr_expect_arr_eq(f->axes, g->axes, axes * sizeof(double));
    cr_assert_eq(f->speed == NULL, g->speed == NULL);
    if (f->speed)
        cr_expect_arr_eq(f->speed, g->speed, dim * sizeof(double));
}

static bool differ(const study_pair *a, const study_pair *b)
{
    return memcmp(a->q.origin, b->q.origin, (size_t)a->q.dim * sizeof(double)) != 0;
}

Test(pairs, each_from_plan_seed_and_number)
{
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++) {
        study_pair_plan plan = plan_of((study_pair_family)f, 3, true);
        static study_pair one;
        study_pairs many;
        must(study_pairs_room(&plan, 5, &many));
        study_pairs_fill(&plan, 7, 100, 5, &many);
        for (uint64_t k = 0; k < 5; k++) {
            study_pair_draw(&plan, 7, 100 + k, &one);
            expect_equal(&one.p, &many.p[k]);
            expect_equal(&one.q, &many.q[k]);
        }
        study_pairs_free(&many);
    }
    study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, 3, false);
    study_pair_plan still = plan_of(STUDY_PAIR_SWEPT, 3, false);
    static study_pair a, b;
    study_pair_draw(&plan, 7, 1, &a);
    study_pair_draw(&plan, 8, 1, &b);
    cr_expect(differ(&a, &b), "another seed");
    study_pair_draw(&plan, 7, 2, &b);
    cr_expect(differ(&a, &b), "another number");
    study_pair_draw(&still, 7, 1, &b);
    cr_expect(differ(&a, &b), "another family");
}

/* ---- families -------------------------------------------------------------------------------- */

static bool is_finite(const double *x, int n)
{
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i]))
            return false;
    return true;
}

static void expect_good(const fmb_frame *f, const study_pair_plan *plan, int which)
{
    int naxes = plan->naxes[which] ? plan->naxes[which] : plan->dim;
    cr_assert(f->dim == plan->dim && f->naxes == naxes);
    cr_assert(is_finite(f->origin, f->dim) && is_finite(f->axes, f->naxes * f->dim));
    cr_assert(!f->speed || (plan->moves && is_finite(f->speed, f->dim)));
}

Test(pairs, words)
{
    study_pair_family back = STUDY_PAIR_ARTICLE;
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++) {
        const char *word = study_pair_family_text((study_pair_family)f);
        cr_expect(study_pair_family_parse(word, &back) && (int)back == f);
    }
    cr_expect_not(study_pair_family_parse("hard", &back));
}

Test(pairs, every_family_in_every_dimension_and_with_fewer_axes)
{
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++)
        for (int dim = 1; dim <= STUDY_PAIR_MOST_DIM; dim++)
            for (int moves = 0; moves < 2; moves++)
                for (int fewer = 0; fewer < 2 && fewer < dim; fewer++) {
                    study_pair_plan plan = plan_of((study_pair_family)f, dim, moves);
                    plan.naxes[0] = dim - fewer;
                    plan.naxes[1] = fewer ? 1 : 0;
                    static study_pair pair;
                    for (uint64_t k = 0; k < 20; k++) {
                        study_pair_draw(&plan, 3, k, &pair);
                        expect_good(&pair.p, &plan, 0);
                        expect_good(&pair.q, &plan, 1);
                    }
                }
}

static double determinant(const double *a)
{
    return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
           a[2] * (a[3] * a[7] - a[4] * a[6]);
}

/* The mean of a number within +-100 has a standard deviation of 0.6 over 10,000. */
Test(pairs, the_article_s)
{
    study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, 3, true);
    static study_pair pair;
    double sum[5] = {0};
    int cuboids = 0;
    for (uint64_t k = 0; k < 10000; k++) {
        study_pair_draw(&plan, 1, k, &pair);
        const double *some[5] = {pair.p.origin, pair.q.origin + 2, pair.p.axes + 4, pair.q.axes + 8,
                                 pair.q.speed + 1};
        for (int i = 0; i < 5; i++) {
            cr_assert(fabs(*some[i]) <= 100);
            sum[i] += *some[i];
        }
        cr_assert(fabs(determinant(pair.p.axes)) > 0.1 && fabs(determinant(pair.q.axes)) > 0.1);
        cuboids += pair.p.shape == FMB_CUBOID;
    }
    for (int i = 0; i < 5; i++)
        cr_expect(fabs(sum[i]) < 10000 * 3, "%d: %g", i, sum[i]);
    cr_expect(abs(cuboids - 5000) < 250);
}

/* How many of n pairs meet, exactly. */
static int meeting(const study_pair_plan *plan, fmb_contact contact, size_t n)
{
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    study_pairs pairs;
    fmb_verdict verdict[1000];
    int count = 0;
    o.method = FMB_PAIR_EXACT;
    o.contact = contact;
    must(fmb_pair_new(plan->dim, &o, NULL, &k));
    must(study_pairs_make(plan, 5, n, NULL, NULL, &pairs));
    must(fmb_pair_test(k, n, pairs.p, pairs.q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = verdict}));
    for (size_t i = 0; i < n; i++)
        count += verdict[i] == FMB_FEASIBLE;
    study_pairs_free(&pairs);
    fmb_pair_free(k);
    return count;
}

Test(pairs, touching_ones_touch)
{
    for (int dim = 1; dim <= 5; dim++)
        for (int moves = 0; moves < 2; moves++) {
            study_pair_plan plan = plan_of(STUDY_PAIR_TOUCHING, dim, moves);
            cr_expect_eq(meeting(&plan, FMB_CONTACT_CLOSED, 100), 100, "%d %d", dim, moves);
            cr_expect_eq(meeting(&plan, FMB_CONTACT_OPEN, 100), 0, "%d %d", dim, moves);
        }
}

/* No family is all one verdict, but for those that touch. */
Test(pairs, both_verdicts_are_common)
{
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++)
        for (int dim = 2; dim <= 3; dim++)
            for (int moves = 0; moves < 2 && f != STUDY_PAIR_TOUCHING; moves++) {
                study_pair_plan plan = plan_of((study_pair_family)f, dim, moves);
                int meet = meeting(&plan, FMB_CONTACT_CLOSED, 200);
                cr_expect(meet > 20 && meet < 180, "%s: %d of 200 meet",
                          study_pair_family_text((study_pair_family)f), meet);
            }
}

/* The power of 2 of the largest number of a frame; of its largest one in coordinate j. */
static int size_in(const fmb_frame *f, int j)
{
    double most = fabs(f->origin[j]);
    for (int i = 0; i < f->naxes; i++)
        most = fmax(most, fabs(f->axes[i * f->dim + j]));
    return most > 0 ? ilogb(most) : 0;
}

static int size_of(const fmb_frame *f)
{
    int most = size_in(f, 0);
    for (int j = 1; j < f->dim; j++)
        most = size_in(f, j) > most ? size_in(f, j) : most;
    return most;
}

Test(pairs, scaled_ones_reach_both_ends_of_doubles)
{
    study_pair_plan plan = plan_of(STUDY_PAIR_SCALED, 2, true);
    int least = 0, most = 0, middle = 0;
    for (uint64_t k = 0; k < 1000; k++) {
        static study_pair pair;
        study_pair_draw(&plan, 3, k, &pair);
        int size = size_of(&pair.p);
        least += size < -1020;
        most += size > 950;
        middle += size > -900 && size < 900;
    }
    cr_expect(least > 200 && most > 200 && middle > 200, "%d, %d, %d", least, most, middle);
}

Test(pairs, spread_ones_differ_from_coordinate_to_coordinate)
{
    study_pair_plan plan = plan_of(STUDY_PAIR_SPREAD, 2, true);
    int much = 0, apart = 0;
    for (uint64_t k = 0; k < 1000; k++) {
        static study_pair pair;
        study_pair_draw(&plan, 3, k, &pair);
        int by[2] = {size_in(&pair.p, 0) - size_in(&pair.p, 1),
                     size_in(&pair.q, 0) - size_in(&pair.q, 1)};
        much += abs(by[0]) > 200;
        apart += abs(by[0] - by[1]) > 60;
    }
    cr_expect(much > 200 && apart < 100, "%d of 1000 spread, %d of them not both", much, apart);
}

/* Numbers of a frame that are not 0, but less than this part of its largest one. */
static int count_tiny(const fmb_frame *f, double part)
{
    double most = ldexp(1, size_of(f));
    int tiny = 0;
    for (int k = 0; k < f->naxes * f->dim; k++)
        tiny += f->axes[k] != 0 && fabs(f->axes[k]) < part * most;
    return tiny;
}

Test(pairs, ragged_ones_have_numbers_whose_products_vanish)
{
    study_pair_plan plan = plan_of(STUDY_PAIR_RAGGED, 3, true);
    int vanish = 0, large = 0;
    for (uint64_t k = 0; k < 1000; k++) {
        static study_pair pair;
        study_pair_draw(&plan, 3, k, &pair);
        vanish += count_tiny(&pair.p, 0x1p-540) > 1;
        large += abs(size_of(&pair.p)) < 30;
    }
    cr_expect(vanish > 100 && large > 900, "%d, %d", vanish, large);
}

/* The quotient of the longest axis and the shortest, as a power of 2. */
static int unevenness(const fmb_frame *f)
{
    int most = -2000, least = 2000;
    for (int i = 0; i < f->naxes; i++) {
        double size = 0;
        int power;
        for (int j = 0; j < f->dim; j++)
            size = fmax(size, fabs(f->axes[i * f->dim + j]));
        frexp(size, &power);
        most = power > most ? power : most;
        least = power < least ? power : least;
    }
    return most - least;
}

Test(pairs, uneven_ones_are_long_and_short)
{
    study_pair_plan plan = plan_of(STUDY_PAIR_UNEVEN, 4, false);
    int much = 0;
    for (uint64_t k = 0; k < 1000; k++) {
        static study_pair pair;
        study_pair_draw(&plan, 3, k, &pair);
        much += unevenness(&pair.p) > 10 || unevenness(&pair.q) > 10;
    }
    cr_expect(much > 400, "%d", much);
}

static bool meets_left(void *self, const fmb_frame *p, const fmb_frame *q)
{
    ++*(int *)self;
    return p->origin[0] < q->origin[0];
}

Test(pairs, those_that_are_wanted)
{
    study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, 2, false);
    study_pairs pairs;
    int asked = 0;
    must(study_pairs_make(&plan, 1, 100, meets_left, &asked, &pairs));
    cr_expect_eq(pairs.n, 100u);
    cr_expect(pairs.drawn == (uint64_t)asked && asked > 120);
    for (size_t i = 0; i < pairs.n; i++)
        cr_expect(pairs.p[i].origin[0] < pairs.q[i].origin[0]);
    study_pairs_free(&pairs);
}
