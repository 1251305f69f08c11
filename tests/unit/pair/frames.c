/* frames.c: sets of frames: the same answers as for single frames: pairs by index, rows, all
 * against all, in every width and by any number of threads. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/frames.h>

#include "fault/hook.h"
#include "pair/kernels/pair_kernels.h"
#include "property/random/rows.h"
#include "study/draw/pairs.h"
#include "support/pair_counts.h"

/* ---- frames ---------------------------------------------------------------------------------- */

enum { MOST = 150, MOST_PAIRS = 3000 };

/* Frames of all kinds of a dimension, or of one kind. */
typedef struct many {
    study_pair pair[MOST];
    fmb_frame frame[MOST];
    fmb_frames *set;
} many;

/* kind < 0: shapes, axes and speeds in turn; else the shape of all. */
static void draw_many(int dim, int kind, bool moves, study_pair_family family, uint64_t seed,
                      many *out)
{
    const study_pair_plan plan = {.family = family,
                                  .dim = dim,
                                  .moves = true,
                                  .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
    for (int i = 0; i < MOST; i++) {
        study_pair_draw(&plan, seed, (uint64_t)(i / 2), &out->pair[i]);
        fmb_frame *f = &out->frame[i];
        *f = i % 2 ? out->pair[i].q : out->pair[i].p;
        if (kind >= 0)
            f->shape = (fmb_shape)kind;
        if (kind < 0 && i % 3 == 0)
            f->naxes = i / 3 % (dim + 1);
        if (kind < 0 ? i % 5 < 3 : !moves)
            f->speed = NULL;
        if (kind < 0 && i % 11 == 0)
            f->shape = f->shape == FMB_SIMPLEX ? FMB_SIMPLEX_BY_CORNERS : FMB_CUBOID_BY_CORNERS;
    }
    must(fmb_frames_new(dim, MOST, out->frame, NULL, &out->set));
}

static fmb_pair *opened(int dim, fmb_simd simd, size_t threads)
{
    fmb_pair *k = NULL;
    fmb_pair_options o = {.size = sizeof o};
    o.simd = simd;
    o.threads = threads;
    must(fmb_pair_new(dim, &o, NULL, &k));
    return k;
}

static fmb_frames_pair some_pair(size_t i)
{
    return (fmb_frames_pair){(uint32_t)(i * 7 % MOST), (uint32_t)(i * i % MOST)};
}

/* By fmb_pair_test. */
static void ask_one_by_one(fmb_pair *k, const many *a, const many *b, size_t n,
                           const fmb_frames_pair *pair, fmb_verdict *out)
{
    for (size_t i = 0; i < n; i++)
        must(fmb_pair_test(
            k, 1, &a->frame[pair[i].a], &b->frame[pair[i].b],
            &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &out[i]}));
}

/* ---- what is kept ---------------------------------------------------------------------------- */

static void expect_equal_frames(const fmb_frame *f, const fmb_frame *g)
{
    size_t dim = (size_t)f->dim, bytes = dim * sizeof(double);
    cr_expect(f->shape == g->shape && f->dim == g->dim && f->naxes == g->naxes);
    cr_expect_eq(!f->speed, !g->speed);
    cr_expect_eq(memcmp(f->origin, g->origin, bytes), 0);
    cr_expect_eq(memcmp(f->axes, g->axes, (size_t)f->naxes * bytes), 0);
    if (f->speed && g->speed)
        cr_expect_eq(memcmp(f->speed, g->speed, bytes), 0);
}

Test(frames, a_set_gives_back_what_it_got)
{
    static many m;
    for (int dim = 1; dim <= 4; dim++) {
        draw_many(dim, -1, false, STUDY_PAIR_ARTICLE, 1, &m);
        cr_expect_eq(fmb_frames_count(m.set), (size_t)MOST);
        cr_expect_null(fmb_frames_at(m.set, MOST).origin);
        cr_expect_null(fmb_frames_at(m.set, SIZE_MAX).origin);
        cr_expect_eq(fmb_frames_dim(m.set), dim);
        for (size_t i = 0; i < MOST; i++) {
            fmb_frame f = fmb_frames_at(m.set, i);
            expect_equal_frames(&m.frame[i], &f);
        }
        fmb_frames_free(m.set);
    }
    cr_expect_eq(fmb_frames_count(NULL), 0u);
    cr_expect_eq(fmb_frames_dim(NULL), 0);
    cr_expect_eq(fmb_frames_at(NULL, 0).dim, 0);
    fmb_frames_free(NULL);
}

/* Numbers that a float holds. */
Test(frames, arrays_of_floats_and_of_doubles)
{
    enum { N = 5 };
    for (int shape = 0; shape < 4; shape++)
        for (int single = 0; single < 2; single++) {
            float number[N * 2 * 4];
            double same[N * 2 * 4];
            for (int i = 0; i < N * 2 * 4; i++) {
                number[i] = (float)(i * i % 17) - 5.5F;
                same[i] = number[i];
            }
            const fmb_frame_arrays a = {
                .size = sizeof a,
                .shape = (fmb_shape)shape,
                .naxes = 2,
                .single = single,
                .origin = single ? (void *)number : (void *)same,
                .axes = single ? (void *)(number + 2 * N) : (void *)(same + 2 * N),
                .speed = single ? (void *)(number + 6 * N) : (void *)(same + 6 * N)};
            fmb_frames *set = NULL;
            must(fmb_frames_from_arrays(2, N, &a, NULL, &set));
            for (int i = 0; i < N; i++) {
                const fmb_frame is = {(fmb_shape)shape,    2, 2, same + 2 * i, same + 2 * N + 4 * i,
                                      same + 6 * N + 2 * i};
                fmb_frame f = fmb_frames_at(set, (size_t)i);
                expect_equal_frames(&is, &f);
            }
            fmb_frames_free(set);
        }
}

/* ---- pairs by index -------------------------------------------------------------------------- */

static void check_pairs(const many *a, const many *b, fmb_simd simd, size_t n)
{
    static fmb_frames_pair pair[MOST_PAIRS];
    static fmb_verdict is[MOST_PAIRS], says[MOST_PAIRS];
    fmb_pair *k = NULL, *one = opened(fmb_frames_dim(a->set), FMB_SIMD_PLAIN, 1);
    fmb_pair_options o = {.size = sizeof o};
    o.simd = simd;
    if (fmb_pair_new(fmb_frames_dim(a->set), &o, NULL, &k) == FMB_OK) {
        for (size_t i = 0; i < n; i++)
            pair[i] = some_pair(i);
        ask_one_by_one(one, a, b, n, pair, is);
        must(fmb_frames_test(
            k, a->set, b->set, n, pair,
            &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = says}));
        for (size_t i = 0; i < n; i++)
            cr_expect_eq(says[i], is[i], "pair %zu: %d, not %d", i, says[i], is[i]);
        cr_expect_eq(counts_of_pairs(k).pairs, n);
    }
    fmb_pair_free(k);
    fmb_pair_free(one);
}

static const fmb_simd LEVEL[3] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};

Test(frames, pairs_of_one_kind)
{
    static many a, b;
    for (int i = 0; i < 2 * 2 * 2 * 2; i++) {
        int dim = 2 + i % 2;
        draw_many(dim, i / 2 % 2, i / 8, STUDY_PAIR_ARTICLE, 2, &a);
        draw_many(dim, i / 4 % 2, i / 8, STUDY_PAIR_ARTICLE, 3, &b);
        for (int l = 0; l < 3; l++)
            check_pairs(&a, &b, LEVEL[l], 200 + (size_t)i);
        fmb_frames_free(a.set);
        fmb_frames_free(b.set);
    }
}

Test(frames, pairs_of_all_kinds)
{
    static many a, b;
    for (int dim = 1; dim <= 4; dim++)
        for (int family = 0; family < 2; family++) {
            draw_many(dim, -1, false, (study_pair_family)family, 4, &a);
            draw_many(dim, -1, false, (study_pair_family)family, 4, &b);
            for (int l = 0; l < 3; l++)
                check_pairs(&a, &b, LEVEL[l], 1100);
            fmb_frames_free(a.set);
            fmb_frames_free(b.set);
        }
}

/* Boxes, times and witnesses are those of fmb_pair_test, bit by bit, as the same kernels find them.
 */
Test(frames, boxes)
{
    enum { N = 100 };
    static many a;
    static fmb_frame p[N], q[N];
    fmb_frames_pair pair[N];
    fmb_verdict verdict[2][N];
    static double world[2][N][3][2], inside[2][N][3][2], time[2][N][2], witness[2][N][3];
    memset(world, 0, sizeof world);
    memset(inside, 0, sizeof inside);
    memset(time, 0, sizeof time);
    memset(witness, 0, sizeof witness);
    draw_many(3, -1, false, STUDY_PAIR_ARTICLE, 5, &a);
    fmb_pair *k = opened(3, FMB_SIMD_PLAIN, 1);
    for (size_t i = 0; i < N; i++) {
        pair[i] = some_pair(i);
        p[i] = a.frame[pair[i].a];
        q[i] = a.frame[pair[i].b];
    }
    fmb_pair_answers out[2];
    for (int w = 0; w < 2; w++)
        out[w] = (fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                    .verdict = verdict[w],
                                    .world = world[w][0][0],
                                    .inside = inside[w][0][0],
                                    .time = time[w][0],
                                    .witness = witness[w][0]};
    must(fmb_pair_test(k, N, p, q, &out[0]));
    must(fmb_frames_test(k, a.set, a.set, N, pair, &out[1]));
    cr_expect_eq(memcmp(verdict[0], verdict[1], sizeof verdict[0]), 0);
    cr_expect_eq(memcmp(world[0], world[1], sizeof world[0]), 0);
    cr_expect_eq(memcmp(inside[0], inside[1], sizeof inside[0]), 0);
    cr_expect_eq(memcmp(time[0], time[1], sizeof time[0]), 0);
    cr_expect_eq(memcmp(witness[0], witness[1], sizeof witness[0]), 0);
    fmb_pair_free(k);
    fmb_frames_free(a.set);
}

/* ---- rows and all against all ---------------------------------------------------------------- */

/* What told heard. */
typedef struct heard {
    size_t n, calls, most_calls;
    fmb_frames_pair pair[MOST * MOST];
} heard;

static bool hear(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair)
{
    heard *h = self;
    cr_assert_eq(verdict, FMB_FEASIBLE);
    cr_assert_gt(n, 0u);
    memcpy(h->pair + h->n, pair, n * sizeof *pair);
    h->n += n;
    return ++h->calls < h->most_calls;
}

static void check_rows(fmb_pair *k, const many *a, const many *b, fmb_verdict (*is)[MOST])
{
    for (uint32_t i = 0; i < MOST; i++) {
        fmb_frames_pair pair[MOST];
        for (uint32_t j = 0; j < MOST; j++)
            pair[j] = (fmb_frames_pair){i, j};
        must(fmb_frames_test(
            k, a->set, b->set, MOST, pair,
            &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = is[i]}));
        if (i % 8 == 0) {
            fmb_verdict says[MOST];
            must(fmb_frames_test_row(k, a->set, i, b->set, says));
            cr_expect_eq(memcmp(says, is[i], sizeof says), 0, "row %u", i);
        }
    }
}

static void check_meeting(fmb_pair *k, const many *a, const many *b, fmb_verdict (*is)[MOST])
{
    static heard h;
    h = (heard){.most_calls = SIZE_MAX};
    must(fmb_frames_meet(k, a->set, a == b ? NULL : b->set, hear, &h));
    size_t n = 0;
    for (uint32_t i = 0; i < MOST; i++)
        for (uint32_t j = a == b ? i + 1 : 0; j < MOST; j++)
            if (is[i][j] == FMB_FEASIBLE) {
                cr_assert(n < h.n && h.pair[n].a == i && h.pair[n].b == j, "%u %u", i, j);
                n++;
            }
    cr_expect_eq(n, h.n);
}

static void check_rows_and_meeting(int dim, fmb_simd simd, const many *a, const many *b)
{
    static fmb_verdict is[MOST][MOST];
    fmb_pair_options o = {.size = sizeof o};
    fmb_pair *k = NULL;
    o.simd = simd;
    if (fmb_pair_new(dim, &o, NULL, &k) != FMB_OK)
        return; /* not on this processor */
    check_rows(k, a, b, is);
    check_meeting(k, a, b, is);
    check_rows(k, a, a, is);
    check_meeting(k, a, a, is);
    fmb_pair_free(k);
}

/* Each width; two kinds beside all kinds. */
Test(frames, rows_and_all_against_all)
{
    static many a, b;
    for (int i = 0; i < 6; i++) {
        int dim = 2 + i / 3;
        draw_many(dim, i % 3 - 1, false, STUDY_PAIR_ARTICLE, 6, &a);
        draw_many(dim, i % 3 == 1, false, STUDY_PAIR_ARTICLE, 7, &b);
        check_rows_and_meeting(dim, LEVEL[i % 3], &a, &b);
        fmb_frames_free(a.set);
        fmb_frames_free(b.set);
    }
}

/* All around the same corner, so that no face tells many of them apart. */
static void gather(int dim, many *m)
{
    fmb_frames_free(m->set);
    for (int i = 1; i < MOST; i++)
        m->frame[i].origin = m->frame[0].origin;
    must(fmb_frames_new(dim, MOST, m->frame, NULL, &m->set));
}

/* In four and more dimensions, each width: cuboids that have records, still and moving, beside all
 * kinds; frames around one corner, where most meet. */
Test(frames, sets_in_more_dimensions)
{
    static many a, b;
    for (int i = 0; i < 12; i++) {
        int dim = 4 + i % 3;
        draw_many(dim, i % 4 == 3 ? -1 : 0, i / 4 % 2, STUDY_PAIR_ARTICLE, 13, &a);
        draw_many(dim, 0, i / 3 % 2, STUDY_PAIR_ARTICLE, 14, &b);
        if (i >= 6)
            gather(dim, &b);
        check_pairs(&a, &b, LEVEL[i % 3], 300);
        if (dim == 4)
            check_rows_and_meeting(dim, LEVEL[i / 3 % 3], &a, &b);
        fmb_frames_free(a.set);
        fmb_frames_free(b.set);
    }
}

/* Each width, few of them apart by faces and many, still and moving. */
Test(frames, rows_of_simplices_in_space)
{
    static many a, b;
    for (int i = 0; i < 12; i++) {
        draw_many(3, FMB_SIMPLEX, i / 3 % 2, STUDY_PAIR_ARTICLE, 8, &a);
        draw_many(3, FMB_SIMPLEX, i / 3 % 2, STUDY_PAIR_ARTICLE, 9, &b);
        if (i >= 6)
            gather(3, &b);
        check_rows_and_meeting(3, LEVEL[i % 3], &a, &b);
        fmb_frames_free(a.set);
        fmb_frames_free(b.set);
    }
}

/* Frames of about unit size, spread so that few boxes meet: `far` from the origin, where sums round
 * to the spacing of doubles, or on a lattice, where many touch. */
static void spread_many(int dim, int kind, double far, many *m)
{
    draw_many(dim, kind, true, STUDY_PAIR_LATTICE, 12, m);
    fmb_frames_free(m->set);
    for (int i = 0; i < MOST; i++) {
        double *number = m->pair[i / 2].number[i % 2];
        double *origin = number + (m->frame[i].origin - number);
        for (int j = 0; j < dim; j++)
            origin[j] += far + (i * (7 + 4 * j) % 37) / 2;
    }
    must(fmb_frames_new(dim, MOST, m->frame, NULL, &m->set));
}

Test(frames, rows_of_frames_far_from_one_another)
{
    static many m;
    static fmb_verdict is[MOST][MOST];
    for (int i = 0; i < 30; i++) {
        int dim = 2 + i / 6;
        spread_many(dim, i % 3 - 1, i / 3 % 2 ? 0x1p52 : 0, &m);
        fmb_pair *k = opened(dim, FMB_SIMD_PLAIN, 1);
        check_rows(k, &m, &m, is);
        check_meeting(k, &m, &m, is);
        fmb_pair_free(k);
        fmb_frames_free(m.set);
    }
}

/* ---- threads --------------------------------------------------------------------------------- */

Test(frames, answers_are_the_same_by_any_number_of_threads)
{
    static many a;
    static heard first, now;
    static fmb_frames_pair pair[MOST_PAIRS];
    static fmb_verdict verdict[2][MOST_PAIRS];
    draw_many(3, -1, false, STUDY_PAIR_ARTICLE, 8, &a);
    for (size_t i = 0; i < MOST_PAIRS; i++)
        pair[i] = some_pair(i);
    for (size_t threads = 1; threads < 5; threads++) {
        fmb_pair *k = opened(3, FMB_SIMD_AUTO, threads);
        now = (heard){.most_calls = SIZE_MAX};
        must(fmb_frames_meet(k, a.set, NULL, hear, &now));
        must(fmb_frames_test(k, a.set, a.set, MOST_PAIRS, pair,
                             &(fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                                 .verdict = verdict[threads > 1]}));
        if (threads == 1)
            first = now;
        cr_expect_eq(first.n, now.n);
        cr_expect_eq(memcmp(first.pair, now.pair, now.n * sizeof *now.pair), 0);
        cr_expect(threads == 1 || memcmp(verdict[0], verdict[1], sizeof verdict[0]) == 0);
        cr_expect_eq(counts_of_pairs(k).pairs, (size_t)MOST * (MOST - 1) / 2 + MOST_PAIRS);
        fmb_pair_free(k);
    }
    fmb_frames_free(a.set);
}

/* ---- limits, memory -------------------------------------------------------------------------- */

/* told may stop it all. */
Test(frames, told_says_when_it_is_enough)
{
    static many a;
    static heard h;
    draw_many(2, 0, false, STUDY_PAIR_ARTICLE, 8, &a);
    for (size_t threads = 1; threads < 3; threads++) {
        fmb_pair *k = opened(2, FMB_SIMD_AUTO, threads);
        h = (heard){.most_calls = 1};
        must(fmb_frames_meet(k, a.set, NULL, hear, &h));
        cr_expect_eq(h.calls, 1u);
        fmb_pair_free(k);
    }
    fmb_frames_free(a.set);
}

/* So few frames that one thread does all: the allocator counts for one only. */
static fmb_status use_sets(const many *m, const fmb_alloc *mem, heard *h)
{
    enum { FEW = 60 };
    fmb_frames *set = NULL;
    fmb_pair *k = NULL;
    fmb_pair_options o = {.size = sizeof o};
    fmb_verdict verdict[MOST];
    o.threads = 2;
    fmb_status st = fmb_frames_new(2, FEW, m->frame, mem, &set);
    if (st == FMB_OK)
        st = fmb_pair_new(2, &o, mem, &k);
    if (st == FMB_OK)
        st = fmb_frames_meet(k, set, NULL, hear, h);
    if (st == FMB_OK)
        st = fmb_frames_test_row(k, set, 3, set, verdict);
    fmb_pair_free(k);
    fmb_frames_free(set);
    return st;
}

Test(frames, memory_that_runs_out_is_an_error_and_nothing_leaks)
{
    static many a;
    static heard h;
    hook mem = {0};
    fmb_alloc alloc = hook_alloc(&mem);
    fmb_status st = FMB_ERR_MEMORY;
    draw_many(2, -1, false, STUDY_PAIR_ARTICLE, 8, &a);
    for (size_t fail = 1; st != FMB_OK && fail < 60; fail++) {
        h = (heard){.most_calls = SIZE_MAX};
        hook_arm(&mem, fail, false);
        st = use_sets(&a, &alloc, &h);
        hook_calm(&mem);
        cr_assert(st == FMB_OK || st == FMB_ERR_MEMORY);
        cr_assert_eq(mem.live, 0u, "%zu", fail);
    }
    h = (heard){.most_calls = SIZE_MAX};
    must(use_sets(&a, &alloc, &h));
    cr_expect_eq(mem.live, 0u);
    fmb_frames_free(a.set);
}
