/* batches.c: pairs in four to eight dimensions, many at once: the same answers as one by one, of
 * any mixture of shapes, speeds and families, in every width; a bad frame is named. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/pair.h>

#include "study/draw/pairs.h"
#include "support/must.h"

enum { PAIRS = 120, MOST_DIM = 8 };

/* Pairs of all families, shapes and speeds in turns; some with an axis less. */
static void draw_mixture(int dim, study_pair *pair, fmb_frame *p, fmb_frame *q)
{
    for (int i = 0; i < PAIRS; i++) {
        const study_pair_plan plan = {.family = (study_pair_family)(i % STUDY_PAIR_FAMILIES),
                                      .dim = dim,
                                      .moves = i / 2 % 3 == 0,
                                      .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE},
                                      .naxes = {i % 23 == 22 ? dim - 1 : 0}};
        study_pair_draw(&plan, 31, (uint64_t)i, &pair[i]);
        p[i] = pair[i].p;
        q[i] = pair[i].q;
    }
}

static fmb_pair *new_pair(int dim, fmb_pair_options o)
{
    fmb_pair *k = NULL;
    o.size = sizeof o;
    must(fmb_pair_new(dim, &o, NULL, &k));
    return k;
}

typedef struct answers {
    fmb_verdict verdict[PAIRS];
    double world[PAIRS * MOST_DIM * 2], time[PAIRS * 2];
} answers;

/* The answers, in calls of `each` pairs. */
static void ask(fmb_pair *k, int dim, size_t each, const fmb_frame *p, const fmb_frame *q,
                answers *out)
{
    memset(out, 0, sizeof *out);
    for (size_t i = 0; i < PAIRS; i += each) {
        const fmb_pair_answers some = {.size = sizeof some,
                                       .verdict = out->verdict + i,
                                       .world = out->world + 2 * (size_t)dim * i,
                                       .time = out->time + 2 * i};
        must(fmb_pair_test(k, PAIRS - i < each ? PAIRS - i : each, p + i, q + i, &some));
    }
}

static void expect_same_answers(int dim, fmb_pair_options o)
{
    static study_pair pair[PAIRS];
    static fmb_frame p[PAIRS], q[PAIRS];
    static answers alone, some;
    const size_t each[] = {2, 3, 7, PAIRS};
    draw_mixture(dim, pair, p, q);
    fmb_pair *k = new_pair(dim, o);
    ask(k, dim, 1, p, q, &alone);
    for (size_t e = 0; e < sizeof each / sizeof *each; e++) {
        ask(k, dim, each[e], p, q, &some);
        cr_expect_arr_eq(some.verdict, alone.verdict, sizeof alone.verdict);
        cr_expect_arr_eq(some.world, alone.world, sizeof alone.world);
        cr_expect_arr_eq(some.time, alone.time, sizeof alone.time);
    }
    fmb_pair_free(k);
}

Test(batches, same_as_one_by_one)
{
    for (int dim = 4; dim <= MOST_DIM; dim++)
        for (int contact = 0; contact < 2; contact++)
            for (int simd = 0; simd <= (int)FMB_SIMD_AVX512; simd++) {
                const fmb_pair_options o = {.size = sizeof o,
                                            .contact = (fmb_contact)contact,
                                            .tightest = true,
                                            .simd = (fmb_simd)simd};
                if (fmb_pair_options_trouble(&o, NULL, 0) == 0 && (dim < 7 || simd == 0))
                    expect_same_answers(dim, o);
            }
}

/* Verdicts in doubles alone may be UNKNOWN, but are never others. */
Test(batches, doubles_only)
{
    static study_pair pair[PAIRS];
    static fmb_frame p[PAIRS], q[PAIRS];
    static answers alone, some;
    for (int dim = 4; dim <= MOST_DIM; dim++) {
        size_t known = 0;
        draw_mixture(dim, pair, p, q);
        fmb_pair *exact = new_pair(dim, (fmb_pair_options){.tightest = true});
        fmb_pair *doubles = new_pair(dim, (fmb_pair_options){.doubles_only = true});
        ask(exact, dim, 1, p, q, &alone);
        must(fmb_pair_test(
            doubles, PAIRS, p, q,
            &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = some.verdict}));
        for (int i = 0; i < PAIRS; i++) {
            known += some.verdict[i] != FMB_UNKNOWN;
            cr_expect(some.verdict[i] == FMB_UNKNOWN || some.verdict[i] == alone.verdict[i]);
        }
        cr_expect_gt(known, PAIRS / 2u);
        fmb_pair_free(exact);
        fmb_pair_free(doubles);
    }
}

Test(batches, bad_frames)
{
    static study_pair pair[PAIRS];
    static fmb_frame p[PAIRS], q[PAIRS];
    fmb_verdict verdict[PAIRS];
    const fmb_pair_answers out = {.size = sizeof out, .verdict = verdict};
    for (int dim = 4; dim <= MOST_DIM; dim++) {
        draw_mixture(dim, pair, p, q);
        fmb_pair *k = new_pair(dim, (fmb_pair_options){0});
        double *number = pair[57].number[1] + (q[57].axes - pair[57].number[1]) + dim + 2;
        const double kept = *number;
        *number = NAN;
        cr_expect_eq(fmb_pair_test(k, PAIRS, p, q, &out), FMB_ERR_ARG);
        cr_expect(strstr(fmb_pair_trouble(k), "q[57]: axes[1][2]"), "%s", fmb_pair_trouble(k));
        *number = kept;
        must(fmb_pair_test(k, PAIRS, p, q, &out));
        p[99].axes = NULL;
        cr_expect_eq(fmb_pair_test(k, PAIRS, p, q, &out), FMB_ERR_ARG);
        cr_expect(strstr(fmb_pair_trouble(k), "p[99]"), "%s", fmb_pair_trouble(k));
        fmb_pair_free(k);
    }
}
