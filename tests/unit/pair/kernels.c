/* kernels.c: verdicts by elimination, or by separating axes (BY_SAT): every kernel of every width
 * against exact answers: never wrong, rarely undecided. */
#include <criterion/criterion.h>
#include <float.h>
#include <math.h>

#include "pair/block.h"
#include "property/random/rows.h"
#include "study/draw/pairs.h"
#include "study/sat/sat.h"
#ifdef BY_SAT
#define KERNELS_TESTED study_sat_kernels
#endif
#include "widths.h"

enum { LANES = FMB_BLOCK_MOST_LANES };

/* ---- kernels --------------------------------------------------------------------------------- */

typedef struct kind {
    int dim;
    bool moves;
    int shape[2];
} kind;

enum { KINDS = 12 };

static kind kind_of(int i)
{
    return (kind){2 + i / 6, i / 3 % 2, {i % 3 == 2, i % 3 > 0}};
}

static study_pair_plan plan_of(study_pair_family family, kind k)
{
    return (study_pair_plan){
        .family = family, .dim = k.dim, .moves = k.moves, .shape = {k.shape[0], k.shape[1]}};
}

static fmb_verdict_kernel *kernel_of(const fmb_pair_kernels *w, const fmb_frame *p,
                                     const fmb_frame *q)
{
    return w->verdict[p->dim - 2][p->speed || q->speed][p->shape][q->shape];
}

/* The answers on LANES pairs, however many at a time. */
static fmb_pair_bits ask(const fmb_pair_kernels *w, kind k, const fmb_frame *p, const fmb_frame *q)
{
    fmb_pair_bits out = {0, 0};
    for (int i = 0; i < LANES; i += w->width) {
        fmb_block b = {.lanes = 0};
        for (int lane = 0; lane < w->width; lane++)
            fmb_block_put(&b, w->width, &p[i + lane], &q[i + lane], k.moves, false, 0);
        fmb_pair_bits some = kernel_of(w, p, q)(b.number);
        out.apart |= some.apart << i;
        out.meet |= some.meet << i;
    }
    return out;
}

/* ---- the truth ------------------------------------------------------------------------------- */

typedef struct truth {
    fmb_pair *closed, *open;
} truth;

static truth truth_new(int dim)
{
    truth t;
    fmb_pair_options o = {.size = sizeof o};
    o.method = FMB_PAIR_EXACT;
    must(fmb_pair_new(dim, &o, NULL, &t.closed));
    o.contact = FMB_CONTACT_OPEN;
    must(fmb_pair_new(dim, &o, NULL, &t.open));
    return t;
}

static void truth_free(truth *t)
{
    fmb_pair_free(t->closed);
    fmb_pair_free(t->open);
}

/* Which pairs are apart when closed, which meet when open. */
static fmb_pair_bits truth_of(const truth *t, const fmb_frame *p, const fmb_frame *q)
{
    fmb_verdict closed[LANES], open[LANES];
    fmb_pair_bits out = {0, 0};
    must(fmb_pair_test(t->closed, LANES, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = closed}));
    must(fmb_pair_test(t->open, LANES, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = open}));
    for (int i = 0; i < LANES; i++) {
        out.apart |= (unsigned)(closed[i] == FMB_INFEASIBLE) << i;
        out.meet |= (unsigned)(open[i] == FMB_FEASIBLE) << i;
    }
    return out;
}

/* Every width, in both orders; the lanes that all know. */
static unsigned check(const truth *t, kind k, const fmb_frame *p, const fmb_frame *q,
                      const char *what)
{
    const fmb_pair_kernels *w[WIDTHS];
    fmb_pair_bits is = truth_of(t, p, q);
    unsigned known = (1U << LANES) - 1;
    for (int i = 0, n = widths(w); i < n; i++)
        for (int swapped = 0; swapped < 2; swapped++) {
            fmb_pair_bits says = ask(w[i], k, swapped ? q : p, swapped ? p : q);
            cr_expect_eq(says.apart & ~is.apart, 0, "%s %dD %d %d%d: width %d, not apart", what,
                         k.dim, k.moves, k.shape[0], k.shape[1], w[i]->width);
            cr_expect_eq(says.meet & ~is.meet, 0, "%s %dD %d %d%d: width %d, not meeting", what,
                         k.dim, k.moves, k.shape[0], k.shape[1], w[i]->width);
            known &= says.apart | says.meet;
        }
    return known;
}

/* ---- random pairs ---------------------------------------------------------------------------- */

static void draw(const study_pair_plan *plan, uint64_t first, study_pair *pair, fmb_frame *p,
                 fmb_frame *q)
{
    for (int i = 0; i < LANES; i++) {
        study_pair_draw(plan, 4, first + (uint64_t)i, &pair[i]);
        p[i] = pair[i].p;
        q[i] = pair[i].q;
    }
}

static void check_family(study_pair_family family, int pairs, bool all_known)
{
    static study_pair pair[LANES];
    for (int i = 0; i < KINDS; i++) {
        kind k = kind_of(i);
        study_pair_plan plan = plan_of(family, k);
        truth t = truth_new(k.dim);
        int known = 0;
        for (int first = 0; first < pairs; first += LANES) {
            fmb_frame p[LANES], q[LANES];
            draw(&plan, (uint64_t)first, pair, p, q);
            unsigned bits = check(&t, k, p, q, study_pair_family_text(family));
            known += __builtin_popcount(bits);
        }
        if (all_known)
            cr_expect_eq(known, pairs, "%dD %d %d%d: %d of %d", k.dim, k.moves, k.shape[0],
                         k.shape[1], known, pairs);
        truth_free(&t);
    }
}

Test(pair_kernels, pairs_of_the_article_are_known_and_right)
{
    check_family(STUDY_PAIR_ARTICLE, 512, true);
}

Test(pair_kernels, never_wrong_on_hard_families)
{
    for (int family = STUDY_PAIR_LATTICE; family < STUDY_PAIR_FAMILIES; family++)
        check_family((study_pair_family)family, 96 / WATCHED, false);
}

Test(pair_kernels, fewer_than_one_pair_of_the_article_in_10000_is_unknown)
{
    static study_pair pair[LANES];
    const fmb_pair_kernels *w[WIDTHS];
    const int pairs = 1 << 14;
    int unknown = 0, last = widths(w) - 1;
    for (int i = 0; i < KINDS; i++) {
        study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, kind_of(i));
        for (int first = 0; first < pairs; first += LANES) {
            fmb_frame p[LANES], q[LANES];
            draw(&plan, (uint64_t)first, pair, p, q);
            fmb_pair_bits says = ask(w[last], kind_of(i), p, q);
            unknown += LANES - __builtin_popcount(says.apart | says.meet);
        }
    }
    cr_expect_lt(unknown, KINDS * pairs / 10000, "%d", unknown);
}

static void scale(double *x, int n, double by)
{
    for (int i = 0; i < n; i++)
        x[i] *= by;
}

/* Speeds of a few times the least double, so that products with them underflow. */
Test(pair_kernels, never_wrong_on_slow_pairs)
{
    static study_pair pair[LANES];
    for (int i = 0; i < KINDS; i++) {
        kind k = kind_of(i);
        study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, k);
        truth t = truth_new(k.dim);
        for (int first = 0; k.moves && first < 128; first += LANES) {
            fmb_frame p[LANES], q[LANES];
            draw(&plan, (uint64_t)first, pair, p, q);
            for (int j = 0; j < 2 * LANES; j++) {
                double *x = pair[j / 2].number[j % 2], *speed = x + k.dim * (k.dim + 1);
                scale(x, k.dim * (k.dim + 1), 0x1p-7);
                scale(speed, k.dim, 0x1p-1000);
                scale(speed, k.dim, 0x1p-80);
            }
            check(&t, k, p, q, "slow");
        }
        truth_free(&t);
    }
}

/* ---- all small pairs of the plane ------------------------------------------------------------ */

/* A is the unit square or triangle, B any with axes of -1 ... 1 and origin -2 ... 2; moving ones by
 * one of nine speeds in turn. */
Test(pair_kernels, all_small_pairs_of_the_plane)
{
    static const double unit[4] = {1, 0, 0, 1}, zero[2] = {0, 0};
    double origin[LANES][2], axes[LANES][4], speed[LANES][2];
    fmb_frame p[LANES], q[LANES];
    truth t = truth_new(2);
    for (int i = 0; i < KINDS / 2; i++) {
        kind k = kind_of(i);
        study_pair_plan plan = plan_of(STUDY_PAIR_LATTICE, k);
        for (int n = 0, lane = 0; n < 25 * 81; n++) {
            for (int j = 0, rest = n / 25; j < 4; j++, rest /= 3)
                axes[lane][j] = rest % 3 - 1;
            origin[lane][0] = n % 5 - 2;
            origin[lane][1] = n / 5 % 5 - 2;
            speed[lane][0] = n % 3 - 1;
            speed[lane][1] = n / 3 % 3 - 1;
            p[lane] = (fmb_frame){(fmb_shape)plan.shape[0], 2, 2, zero, unit, NULL};
            q[lane] = (fmb_frame){(fmb_shape)plan.shape[1],    2, 2, origin[lane], axes[lane],
                                  k.moves ? speed[lane] : NULL};
            if (++lane == LANES) {
                check(&t, k, p, q, "small");
                lane = 0;
            }
        }
    }
    truth_free(&t);
}

/* ---- flat simplices -------------------------------------------------------------------------- */

/* B is flat and goes through A. All its rows pass A by far on one side, so that only the sign of
 * det B, which is not certain, keeps them from meeting in interiors. */
Test(pair_kernels, a_flat_simplex_meets_in_no_interior)
{
    static const double unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, zero[3] = {0};
    static const double flat[9] = {1, 0.31, 0, 0.47, 1.13, 0, 0.21, 0.77, 0};
    double origin[LANES][3], axes[LANES][9];
    fmb_frame p[LANES], q[LANES];
    truth t = truth_new(3);
    for (int i = 0; i < LANES; i++) {
        for (int j = 0; j < 9; j++) /* every other one is not quite flat */
            axes[i][j] = flat[j] + (i % 2 ? 0x1p-58 * (j % 3 == 2) * (j + i) : 0);
        origin[i][0] = -0.2;
        origin[i][1] = -0.3;
        origin[i][2] = 0.25 + 0x1p-5 * i;
        p[i] = (fmb_frame){FMB_SIMPLEX, 3, 3, zero, unit, NULL};
        q[i] = (fmb_frame){FMB_SIMPLEX, 3, 3, origin[i], axes[i], NULL};
    }
    const kind k = {3, false, {FMB_SIMPLEX, FMB_SIMPLEX}};
    check(&t, k, p, q, "flat");
    truth_free(&t);
#ifndef BY_SAT /* separating axes see no more than that they overlap */
    /* The truth is asked in coordinates of B, where B is never flat. */
    const fmb_pair_kernels *w[WIDTHS];
    for (int i = 0, n = widths(w); i < n; i++)
        cr_expect_eq(ask(w[i], k, p, q).meet & 0x55, 0, "width %d", w[i]->width);
#endif
}

/* ---- numbers out of range -------------------------------------------------------------------- */

/* A lane with a number that is none, or out of range, has no bit; the other lanes do not mind. */
Test(pair_kernels, numbers_out_of_range_make_their_lane_unknown)
{
    static study_pair pair[LANES];
    static const double strange[] = {NAN, -NAN, INFINITY, -INFINITY, 1e300, -DBL_MAX};
    const fmb_pair_kernels *w[WIDTHS];
    for (int i = 0, n = widths(w); i < n * KINDS; i++) {
        const fmb_pair_kernels *with = w[i / KINDS];
        kind k = kind_of(i % KINDS);
        study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, k);
        int width = with->width, rows = k.dim * (2 * k.dim + 1 + k.moves);
        fmb_frame p[LANES], q[LANES];
        fmb_block b = {.lanes = 0};
        draw(&plan, 0, pair, p, q);
        for (int lane = 0; lane < width; lane++)
            fmb_block_put(&b, width, &p[lane], &q[lane], k.moves, false, 0);
        fmb_verdict_kernel *kernel = kernel_of(with, p, q);
        fmb_pair_bits before = kernel(b.number);
        cr_assert_eq(before.apart | before.meet, (1U << width) - 1);
        for (int r = 0; r < rows * (int)(sizeof strange / sizeof *strange); r++) {
            int lane = r % width;
            double *at = &b.number[r % rows * width + lane], kept = *at;
            *at = strange[r / rows];
            fmb_pair_bits now = kernel(b.number);
            *at = kept;
            cr_expect_eq(now.apart, before.apart & ~(1U << lane), "%d: %d", width, r);
            cr_expect_eq(now.meet, before.meet & ~(1U << lane), "%d: %d", width, r);
        }
    }
}

/* Both NaN and infinity, in any two rows. */
Test(pair_kernels, a_nan_does_not_hide_an_infinity)
{
    static study_pair pair;
    for (int i = 0; i < KINDS; i++) {
        kind k = kind_of(i);
        study_pair_plan plan = plan_of(STUDY_PAIR_ARTICLE, k);
        int rows = k.dim * (2 * k.dim + 1 + k.moves);
        study_pair_draw(&plan, 4, 0, &pair);
        const fmb_pair_kernels *w[WIDTHS];
        for (int j = 0, n = widths(w); j < n; j++)
            for (int r = 0; r < rows * rows; r++) {
                fmb_block b = {.lanes = 0};
                for (int lane = 0; lane < w[j]->width; lane++)
                    fmb_block_put(&b, w[j]->width, &pair.p, &pair.q, k.moves, false, 0);
                b.number[r / rows * w[j]->width] = INFINITY;
                b.number[r % rows * w[j]->width] = NAN;
                fmb_pair_bits says = kernel_of(w[j], &pair.p, &pair.q)(b.number);
                cr_expect_eq((says.apart | says.meet) & 1U, 0, "%d: %d", w[j]->width, r);
            }
    }
}
