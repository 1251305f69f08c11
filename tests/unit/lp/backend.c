/* backend.c: the backend returns a basis; its claim about it is proved in rationals here, which
 * must succeed nearly always; and a warm start gives the same answer as a cold one. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "backend_bench.h"

/* ---- what a hint says ------------------------------------------------------------------------ */

/* n distinct members that are independent. */
static void check_basis(backend_bench *b)
{
    for (size_t r = 0; r < b->n; r++) {
        cr_assert_lt(b->basis[r], b->p.m + b->n);
        for (size_t s = 0; s < r; s++)
            cr_assert_neq(b->basis[r], b->basis[s], "seed %lu", (unsigned long)b->c.seed);
    }
    cr_assert(backend_bench_meet(b), "singular, seed %lu", (unsigned long)b->c.seed);
}

typedef struct tally {
    int asked, proved, none;
} tally;

/* Is what it says true, and proved by the basis? */
static void count_hint(backend_bench *b, const fmb_hint *h, bool of_search, tally *t)
{
    check_basis(b);
    bool proved = false;
    if (h->kind == FMB_HINT_OPTIMUM)
        proved = of_search ? backend_bench_meet(b) && backend_bench_holds(b, b->x, false)
                           : backend_bench_proves_optimum(b);
    else if (h->kind == FMB_HINT_INFEASIBLE)
        proved = h->odd < b->p.m && backend_bench_proves_conflict(b, h->odd);
    else if (h->kind == FMB_HINT_UNBOUNDED)
        proved = !of_search && h->odd < b->n && backend_bench_proves_ray(b, h->odd);
    t->asked++;
    t->proved += proved;
    t->none += h->kind == FMB_HINT_NONE;
}

static void draw_cost(backend_bench *b, support_rng *g)
{
    for (size_t j = 0; j < b->n; j++)
        b->cost[j] = support_between(g, -3, 3);
}

static fmb_hint ask(backend_bench *b, fmb_backend *d, bool search, tally *t)
{
    fmb_hint h = {.basis = b->basis};
    cr_assert_eq(search ? fmb_backend_search(d, NULL, &h) : fmb_backend_maximize(d, b->cost, &h),
                 FMB_OK);
    count_hint(b, &h, search, t);
    return h;
}

static fmb_backend *open_side(backend_bench *b, bool factors)
{
    fmb_backend *d;
    cr_assert_eq(fmb_backend_open_with(&b->run, &b->p, factors, &d), FMB_OK);
    cr_assert(d);
    return d;
}

/* A search, then costs one after another. Numbers that doubles cannot tell apart may get answers
 * that contradict each other. */
static void ask_all(backend_bench *b, bool factors, int costs, tally *t)
{
    support_rng g = {b->c.seed};
    backend_bench_append(b, b->part->m);
    fmb_backend *d = open_side(b, factors);
    fmb_hint_kind first = ask(b, d, true, t).kind;
    for (int k = 0; k < costs; k++) {
        draw_cost(b, &g);
        fmb_hint h = ask(b, d, false, t);
        if (b->c.shape.bits == 0)
            cr_assert_eq(h.kind == FMB_HINT_INFEASIBLE, first == FMB_HINT_INFEASIBLE, "seed %lu",
                         (unsigned long)b->c.seed);
    }
    fmb_backend_close(d);
}

static void expect_share(const char *what, const tally *t, double share)
{
    cr_log_info("%s: %d of %d proved, %d given up", what, t->proved, t->asked, t->none);
    cr_expect_geq(t->proved, share * t->asked, "%s: only %d of %d proved", what, t->proved,
                  t->asked);
}

static void ask_small_systems(bool factors)
{
    tally narrow = {0}, wide = {0};
    for (uint64_t seed = 0; seed < 1000 / WATCHED; seed++) {
        support_shape shape = {.dim = 1 + (int)(seed % 6), .rows = 1 + (int)(seed % 13)};
        support_family family = (support_family)(seed % SUPPORT_FAMILIES);
        bool is_narrow = seed % 3 > 0;
        backend_bench b;
        if (backend_bench_open(&b, family, seed, is_narrow ? &shape : NULL))
            ask_all(&b, factors, 4, is_narrow ? &narrow : &wide);
        backend_bench_close(&b);
    }
    expect_share("small", &narrow, 0.999);
    expect_share("wide", &wide, 0.7);
}

static void ask_larger_systems(bool factors)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 60 / WATCHED; seed++) {
        backend_bench b;
        support_shape shape = {.dim = 4 + (int)(seed % 4) * 6, .rows = 10 + (int)(seed % 7) * 10};
        if (backend_bench_open(&b, (support_family)(seed % SUPPORT_FAMILIES), seed, &shape))
            ask_all(&b, factors, 3, &t);
        backend_bench_close(&b);
    }
    expect_share("larger", &t, 0.999);
}

Test(backend, hints_of_our_own_are_proved)
{
    ask_small_systems(false);
    ask_larger_systems(false);
}

Test(backend, hints_of_factors_are_proved)
{
    ask_small_systems(true);
    ask_larger_systems(true);
}

/* ---- changes --------------------------------------------------------------------------------- */

typedef void change(backend_bench *b, fmb_backend *d, support_rng *g, tally *t);

/* What changes, on many systems and every side of the backend; it opens with so many of 100 rows.
 */
static void ask_while(const char *what, change *changes, int share)
{
    static const support_shape shape = {.dim = 6, .rows = 24};
    for (int side = 0; side < 2; side++) {
        tally t = {0};
        for (uint64_t seed = 0; seed < 120 / WATCHED; seed++) {
            support_rng g = {seed};
            backend_bench b;
            if (backend_bench_open(&b, (support_family)(seed % SUPPORT_FAMILIES), seed, &shape)) {
                backend_bench_append(&b, b.part->m * (size_t)share / 100);
                fmb_backend *d = open_side(&b, side == 1);
                changes(&b, d, &g, &t);
                fmb_backend_close(d);
            }
            backend_bench_close(&b);
        }
        expect_share(what, &t, 0.999);
    }
}

/* Rows come a few at a time. */
static void append_and_ask(backend_bench *b, fmb_backend *d, support_rng *g, tally *t)
{
    for (size_t m = 0; m <= b->part->m; m += (size_t)support_between(g, 1, 5)) {
        backend_bench_append(b, m);
        cr_assert_eq(fmb_backend_grow(d), FMB_OK);
        draw_cost(b, g);
        ask(b, d, support_chance(g, 50), t);
    }
}

Test(backend, follows_rows_that_come)
{
    ask_while("growing", append_and_ask, 0);
}

/* Rows go and come; no basis may hold one that is off. */
static void switch_and_ask(backend_bench *b, fmb_backend *d, support_rng *g, tally *t)
{
    for (int k = 0; k < 20; k++) {
        size_t i = (size_t)support_between(g, 0, (int)b->p.m - 1);
        b->off[i] = !b->off[i];
        fmb_backend_switch(d, i, !b->off[i]);
        draw_cost(b, g);
        ask(b, d, support_chance(g, 50), t);
        for (size_t r = 0; r < b->n; r++)
            cr_assert(b->basis[r] >= b->p.m || !b->off[b->basis[r]], "row %zu, seed %lu",
                      b->basis[r], (unsigned long)b->c.seed);
    }
}

Test(backend, follows_rows_that_are_switched)
{
    ask_while("switching", switch_and_ask, 100);
}

/* Other right sides, another basis, and back. */
static void move_and_ask(backend_bench *b, fmb_backend *d, support_rng *g, tally *t)
{
    double *right = calloc(b->p.m + 1, sizeof *right);
    fmb_hint h = {.basis = b->basis};
    for (size_t i = 0; i < b->p.m; i++)
        right[i] = support_between(g, -4, 4);
    draw_cost(b, g);
    ask(b, d, false, t);
    fmb_backend_shift(d, right);
    cr_assert_eq(fmb_backend_search(d, NULL, &h), FMB_OK);
    check_basis(b);
    fmb_backend_shift(d, NULL);
    fmb_backend_sharpen(d);
    ask(b, d, support_chance(g, 50), t);
    for (size_t r = 0; r < b->n; r++)
        b->basis[r] = b->p.m + r;
    fmb_backend_place(d, b->basis);
    ask(b, d, support_chance(g, 50), t);
    free(right);
}

Test(backend, starts_from_other_bases_and_right_sides)
{
    ask_while("moved", move_and_ask, 100);
}

/* As the library opens it. */
Test(backend, opens_on_our_own_side)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 20; seed++) {
        static const support_shape shape = {.dim = 104, .rows = 16};
        backend_bench b;
        fmb_backend *d;
        if (backend_bench_open(&b, SUPPORT_PLANTED_POINT, seed, seed ? NULL : &shape)) {
            backend_bench_append(&b, b.part->m);
            cr_assert_eq(fmb_backend_open(&b.run, &b.p, &d), FMB_OK);
            ask(&b, d, true, &t);
            fmb_backend_close(d);
        }
        backend_bench_close(&b);
    }
    expect_share("its own", &t, 0.7);
}
