/* certify.c: whatever basis, corner, weight or sign is guessed, a successful proof is right:
 * touching frames are never proved apart, and a corner is proved extreme for a goal only if it is.
 * The truth is known by construction, and from all corners. */
#include <criterion/criterion.h>
#include <math.h>

#include "pair/exact_box/exact_box_value.h"
#include "pair/exact_box/exact_walk.h"

enum { DIM = FMB_EXACT_BOX_DIM };

/* Room for the integers of what is asked. */
static fmb_exact_box_whole whole;

/* ---- pairs at a distance --------------------------------------------------------------------- */

typedef struct certified_pair {
    fmb_frame p, q;
    double origin[DIM]; /* of q */
    fmb_exact_box_program program;
} certified_pair;

static const double ZERO[DIM], TWICE_PLANE[] = {2, 0, 0, 2},
                               TWICE_SPACE[] = {2, 0, 0, 0, 2, 0, 0, 0, 2};

/* On a line, end to end. */
static void place_segments(certified_pair *c, double gap)
{
    static const double edge[] = {2};
    c->origin[0] = 2 + gap;
    c->p = (fmb_frame){FMB_CUBOID, 1, 1, ZERO, edge, NULL};
    c->q = (fmb_frame){FMB_CUBOID, 1, 1, c->origin, edge, NULL};
}

/* On a line, one comes as near as that at the end of the time. */
static void place_moving_segment(certified_pair *c, double gap)
{
    static const double edge[] = {2}, speed[] = {-3};
    place_segments(c, gap + 3);
    c->q.axes = edge;
    c->q.speed = speed;
}

/* The corner of a square and the long edge of a triangle, on x + y = 4. */
static void place_triangle(certified_pair *c, double gap)
{
    static const double edges[] = {2, -2, 2, 0};
    c->origin[0] = 1 + gap;
    c->origin[1] = 3;
    c->p = (fmb_frame){FMB_CUBOID, 2, 2, ZERO, TWICE_PLANE, NULL};
    c->q = (fmb_frame){FMB_SIMPLEX, 2, 2, c->origin, edges, NULL};
}

/* An edge of a cube and one of a tetrahedron, which cross in y + z = 4. */
static void place_tetrahedron(certified_pair *c, double gap)
{
    static const double edges[] = {0, 2, -2, -1, 2, 0, 1, 2, 0};
    c->origin[0] = 1;
    c->origin[1] = 1 + gap;
    c->origin[2] = 3;
    c->p = (fmb_frame){FMB_CUBOID, 3, 3, ZERO, TWICE_SPACE, NULL};
    c->q = (fmb_frame){FMB_SIMPLEX, 3, 3, c->origin, edges, NULL};
}

typedef void place_pair(certified_pair *c, double gap);

static place_pair *const PLACES[] = {place_segments, place_moving_segment, place_triangle,
                                     place_tetrahedron};
enum { KINDS = sizeof PLACES / sizeof *PLACES };

static void load_pair(certified_pair *c, int kind, double gap)
{
    PLACES[kind](c, gap);
    cr_assert(fmb_exact_box_load(&c->program, &c->p, &c->q));
}

/* ---- all that may be guessed ----------------------------------------------------------------- */

/* The next of all ways to give each unknown a place; only units may be at their upper end. Those
 * with the wrong number of basic unknowns are among them. */
static bool turn_to_next_basis(const fmb_exact_box_program *s, fmb_exact_box_basis *basis,
                               bool high)
{
    for (int j = 0; j < s->unknowns; j++) {
        unsigned char *place = &basis->place[j];
        if (s->group[j] == FMB_EXACT_BOX_NONE)
            continue;
        if (*place == FMB_EXACT_BOX_LOW && high && s->group[j] == FMB_EXACT_BOX_UNIT) {
            *place = FMB_EXACT_BOX_HIGH;
            return true;
        }
        if (*place != FMB_EXACT_BOX_BASIC) {
            *place = FMB_EXACT_BOX_BASIC;
            return true;
        }
        *place = FMB_EXACT_BOX_LOW;
    }
    return false;
}

/* Of all weights of artificial unknowns that are these, how many prove that basis apart? */
static int count_proofs(fmb_exact_box *v, const fmb_exact_box_program *s,
                        const fmb_exact_box_basis *basis)
{
    static const double weights[] = {0, 1, -1, 4};
    int proofs = 0;
    for (int code = 0; code < 64; code++) {
        const double weight[DIM] = {weights[code % 4], weights[code / 4 % 4], weights[code / 16]};
        proofs += fmb_exact_box_take_basis(v, s, basis) && fmb_exact_box_are_apart(v, weight);
    }
    return proofs;
}

Test(certify, only_frames_that_are_apart_are_proved_apart)
{
    static const double gaps[] = {-1, -0x1p-40, 0, 0x1p-40, 0.5};
    for (int kind = 0; kind < KINDS; kind++)
        for (size_t i = 0; i < sizeof gaps / sizeof *gaps; i++) {
            certified_pair c;
            fmb_exact_box v = {.whole = &whole};
            fmb_exact_box_basis basis = {{0}};
            int proofs = 0;
            load_pair(&c, kind, gaps[i]);
            do
                proofs += count_proofs(&v, &c.program, &basis);
            while (turn_to_next_basis(&c.program, &basis, false));
            cr_expect((proofs > 0) == (gaps[i] > 0), "pair %d, gap %g: %d", kind, gaps[i], proofs);
        }
}

/* From whatever basis. */
Test(certify, integers_tell_frames_that_are_apart_from_those_that_touch)
{
    static const double gaps[] = {-1, -0x1p-40, 0, 0x1p-40, 0.5};
    for (int kind = 0; kind < KINDS; kind++)
        for (size_t i = 0; i < sizeof gaps / sizeof *gaps; i++) {
            certified_pair c;
            fmb_exact_box v = {.whole = &whole};
            fmb_exact_box_basis basis = {{0}};
            int asked = 0;
            load_pair(&c, kind, gaps[i]);
            do
                if (fmb_exact_box_take_basis(&v, &c.program, &basis)) {
                    fmb_verdict said = fmb_exact_box_walk_exactly(&v, NULL);
                    cr_assert_eq(said, gaps[i] > 0 ? FMB_INFEASIBLE : FMB_FEASIBLE,
                                 "pair %d, gap %g: %d", kind, gaps[i], (int)said);
                    asked++;
                }
            while (turn_to_next_basis(&c.program, &basis, true));
            cr_expect_gt(asked, 0);
        }
}

/* ---- ends ------------------------------------------------------------------------------------ */

static double value_here(fmb_exact_box *v, const fmb_exact_box_goal *goal)
{
    fmb_wide numerator, denominator;
    fmb_exact_box_value(v, goal, &numerator, &denominator);
    cr_assert(numerator.n <= 1 && denominator.n == 1);
    double size = numerator.n == 0 ? 0 : (double)numerator.word[0] / (double)denominator.word[0];
    return numerator.minus ? -size : size;
}

/* The greatest value, or the least, of the goal at all corners. */
static double find_end(fmb_exact_box *v, const fmb_exact_box_program *s,
                       const fmb_exact_box_goal *goal)
{
    fmb_exact_box_basis basis = {{0}};
    double end = goal->greatest ? -INFINITY : INFINITY;
    do
        if (fmb_exact_box_state(v, s, &basis)) {
            double value = value_here(v, goal);
            end = goal->greatest ? fmax(end, value) : fmin(end, value);
        }
    while (turn_to_next_basis(s, &basis, true));
    return end;
}

static void expect_ends_only(fmb_exact_box *v, const fmb_exact_box_program *s,
                             const fmb_exact_box_goal *goal)
{
    fmb_exact_box_basis basis = {{0}};
    double end = find_end(v, s, goal);
    int right = 0;
    do
        if (fmb_exact_box_state(v, s, &basis) && fmb_exact_box_is_farthest(v, goal)) {
            cr_assert_eq(value_here(v, goal), end, "%d %d: %g is not %g", goal->is_world,
                         goal->number, value_here(v, goal), end);
            right++;
        } else if (fmb_exact_box_take_basis(v, s, &basis)) { /* any basis, vertex or not */
            cr_assert_eq(fmb_exact_box_walk_exactly(v, goal), FMB_FEASIBLE);
            cr_assert(value_here(v, goal) == end && fmb_exact_box_is_farthest(v, goal));
        }
    while (turn_to_next_basis(s, &basis, true));
    cr_expect_gt(right, 0);
}

Test(certify, only_corners_at_the_end_are_farthest)
{
    for (int kind = 0; kind < KINDS; kind++)
        for (int gap = -1; gap <= 0; gap++) {
            certified_pair c;
            fmb_exact_box v = {.whole = &whole};
            load_pair(&c, kind, gap);
            for (int greatest = 0; greatest < 2; greatest++) {
                for (int i = 0; i < c.program.dim; i++)
                    expect_ends_only(&v, &c.program, &(fmb_exact_box_goal){true, i, greatest});
                for (int j = 0; j < c.program.columns; j++)
                    expect_ends_only(&v, &c.program, &(fmb_exact_box_goal){false, j, greatest});
            }
        }
}

/* ---- the lowest words ------------------------------------------------------------------------ */

static uint64_t next_random(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    return *state ^= *state << 17;
}

/* Whole numbers of so many bits, every fourth of them 0. */
static void draw_frame(uint64_t *state, int dim, int bits, double *number, fmb_frame *out)
{
    for (int i = 0; i < dim * (dim + 1); i++) {
        uint64_t x = next_random(state);
        number[i] = x % 4 == 0 ? 0 : (double)(int64_t)(x >> (64 - bits)) - ldexp(0.5, bits);
    }
    const fmb_shape shape = next_random(state) % 2 ? FMB_SIMPLEX : FMB_CUBOID;
    *out = (fmb_frame){shape, dim, dim, number, number + dim, NULL};
}

/* As many basic unknowns as there may be, any ones, and some at their upper ends. */
static void draw_basis(uint64_t *state, const fmb_exact_box_program *s, fmb_exact_box_basis *out)
{
    int left = s->dim + s->is_simplex[0] + s->is_simplex[1];
    *out = (fmb_exact_box_basis){{0}};
    for (int j = 0; j < s->unknowns; j++)
        if (s->group[j] == FMB_EXACT_BOX_UNIT && next_random(state) % 3 == 0)
            out->place[j] = FMB_EXACT_BOX_HIGH;
    while (left > 0) {
        int j = (int)(next_random(state) % (uint64_t)s->unknowns);
        if (s->group[j] != FMB_EXACT_BOX_NONE && out->place[j] != FMB_EXACT_BOX_BASIC) {
            out->place[j] = FMB_EXACT_BOX_BASIC;
            left--;
        }
    }
}

/* Is a, or - a, that modulo 2^128? */
static bool is_low_of(const fmb_wide *a, bool negative, fmb_u128 low)
{
    fmb_u128 size = fmb_u128_join(a->n > 1 ? a->word[1] : 0, a->n > 0 ? a->word[0] : 0);
    fmb_u128 is = a->minus != negative ? fmb_u128_minus(fmb_u128_of(0), size) : size;
    return fmb_u128_low(is) == fmb_u128_low(low) && fmb_u128_high(is) == fmb_u128_high(low);
}

/* They are those of the integers, det is not larger than its bound, and no number is said to be 0
 * that is none, whatever doubles know of it. How many are 0, and said to be. */
static int check_low_words(fmb_exact_box *v, int *zeros)
{
    const fmb_exact_box_whole *w = fmb_exact_box_need_whole(v);
    const fmb_exact_box_low *low = fmb_exact_box_need_low(v);
    const bool negative = !is_low_of(&w->det, false, low->det);
    int told = 0;
    cr_assert_gt(w->det.n, 0);
    cr_expect(is_low_of(&w->det, negative, low->det));
    cr_expect_geq(low->most * (1 + 0x1p-50), fmb_wide_to_double(&w->det));
    for (int k = 0; k < v->program->dim; k++) {
        bool is = fmb_exact_box_is_low_zero(low, low->x[k], fabs(v->x[k].x) + v->x[k].error);
        cr_expect(!is || w->x[k].n == 0);
        cr_expect(is_low_of(&w->x[k], negative, low->x[k]));
        *zeros += w->x[k].n == 0;
        told += is;
    }
    return told;
}

Test(certify, lowest_words_are_those_of_the_integers)
{
    uint64_t state = 20261126;
    int zeros = 0, told = 0, checked = 0;
    for (int i = 0; i < 4000; i++) {
        static const int BITS[] = {3, 13, 26, 50};
        const int dim = 2 + i % (DIM - 1), bits = BITS[i / 8 % 4];
        double number[2][DIM * (DIM + 1)];
        fmb_frame p, q;
        fmb_exact_box_program s;
        fmb_exact_box v = {.whole = &whole};
        fmb_exact_box_basis basis;
        draw_frame(&state, dim, bits, number[0], &p);
        draw_frame(&state, dim, bits, number[1], &q);
        cr_assert(fmb_exact_box_load(&s, &p, &q));
        draw_basis(&state, &s, &basis);
        if (fmb_exact_box_take_basis(&v, &s, &basis) && v.is_near) {
            checked++;
            told += check_low_words(&v, &zeros);
        }
    }
    cr_expect_gt(checked, 500);
    cr_expect_gt(zeros, 100);
    cr_expect_gt(10 * told, 9 * zeros, "%d of %d", told, zeros);
}

/* ---- numbers of several bases in one room ---------------------------------------------------- */

/* det, and a value or a number of the adjugate. */
static void ask_basis(fmb_exact_box *v, bool adjugate, fmb_wide *out)
{
    const fmb_exact_box_whole *w =
        adjugate ? fmb_exact_box_need_adjugate(v) : fmb_exact_box_need_whole(v);
    fmb_wide_copy(&out[0], &w->det);
    fmb_wide_copy(&out[1], adjugate ? &w->adjugate[0][0] : &w->x[0]);
}

/* Of two bases. */
static void ask_in_turns(fmb_exact_box *v, uint64_t *state)
{
    fmb_wide first[4][2], again[2];
    for (int turn = 0; turn < 40; turn++) {
        const int question = turn < 4 ? turn : (int)(next_random(state) % 4);
        ask_basis(&v[question / 2], question % 2, turn < 4 ? first[question] : again);
        for (int i = 0; turn >= 4 && i < 2; i++)
            cr_assert_eq(fmb_wide_compare(&first[question][i], &again[i]), 0);
    }
}

Test(certify, bases_that_are_asked_in_turns_keep_their_numbers)
{
    uint64_t state = 20261127;
    int checked = 0;
    for (int i = 0; i < 400; i++) {
        const int dim = 2 + i % (DIM - 1);
        double number[2][DIM * (DIM + 1)];
        fmb_frame frame[2];
        fmb_exact_box_program s;
        fmb_exact_box v[2] = {{.whole = &whole}, {.whole = &whole}};
        bool good = true;
        for (int k = 0; k < 2; k++)
            draw_frame(&state, dim, 13, number[k], &frame[k]);
        cr_assert(fmb_exact_box_load(&s, &frame[0], &frame[1]));
        for (int k = 0; k < 2; k++) {
            fmb_exact_box_basis basis;
            draw_basis(&state, &s, &basis);
            good = fmb_exact_box_take_basis(&v[k], &s, &basis) && v[k].is_near && good;
        }
        if (good)
            ask_in_turns(v, &state);
        checked += good;
    }
    cr_expect_gt(checked, 50);
}
