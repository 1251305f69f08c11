/* door.c: what the door hands out is a basis; what it says of it is proved in rationals here, which
 * must succeed nearly always; and it is the same from where it stood as from the beginning. */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "lp/float/side.h"
#include "solve/query/part.h"
#include "support/support.h"

/* A connected system as a program, and matrices to solve with. */
typedef struct bench {
    support_case c;
    fmb_mem mem;
    fmb_arena arena;
    fmb_run run;
    atomic_int cancel;
    fmb_parts parts;
    const fmb_part *part; /* the first, or NULL */
    fmb_program p;        /* its rows */
    size_t n, *basis;
    bool *off;
    mpq_t *matrix; /* [n][n + 1] */
    mpq_t *x, *y;  /* [n] */
    double *cost;  /* [n] */
} bench;

static mpq_t *new_numbers(size_t count)
{
    mpq_t *q = malloc((count + 1) * sizeof *q);
    for (size_t k = 0; k < count; k++)
        mpq_init(q[k]);
    return q;
}

static void free_numbers(mpq_t *q, size_t count)
{
    for (size_t k = 0; k < count; k++)
        mpq_clear(q[k]);
    free(q);
}

/* False: the system has no part, so there is nothing to ask. */
static bool open_bench(bench *b, support_family family, uint64_t seed, const support_shape *shape)
{
    fmb_options o = {.size = sizeof o};
    *b = (bench){.c = support_make(family, seed, shape)};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_arena_init(&b->arena, &b->mem);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    cr_assert_eq(fmb_parts_split(&b->parts, b->c.s, &b->run, &b->arena, true), FMB_OK);
    b->part = b->parts.count > 0 ? &b->parts.part[0] : NULL;
    if (b->part)
        cr_assert_eq(fmb_part_load(&b->parts.part[0], b->c.s, b->parts.place, &b->run, false),
                     FMB_OK);
    b->n = b->part ? (size_t)b->part->n : 0;
    fmb_program_init(&b->p, &b->mem, (int)b->n);
    b->basis = calloc(b->n + 1, sizeof *b->basis);
    b->cost = calloc(b->n + 1, sizeof *b->cost);
    b->off = calloc(b->part ? b->part->m : 1, sizeof *b->off);
    b->matrix = new_numbers(b->n * (b->n + 1));
    b->x = new_numbers(b->n);
    b->y = new_numbers(b->n);
    return b->part != NULL;
}

/* Append rows of the part until there are that many. */
static void append_rows(bench *b, size_t m)
{
    for (size_t i = b->p.m; i < m; i++)
        cr_assert_eq(fmb_program_add_dense(&b->p, &b->part->row[i], b->part->rel[i]), FMB_OK);
}

static void close_bench(bench *b)
{
    free(b->basis);
    free(b->cost);
    free(b->off);
    free_numbers(b->matrix, b->n * (b->n + 1));
    free_numbers(b->x, b->n);
    free_numbers(b->y, b->n);
    fmb_program_clear(&b->p);
    fmb_parts_clear(&b->parts, &b->mem);
    fmb_arena_clear(&b->arena);
    cr_assert_eq(b->mem.used, 0);
    support_case_clear(&b->c);
}

/* ---- exact arithmetic ------------------------------------------------------------------------ */

static void coefficient(const bench *b, size_t i, size_t k, mpq_t out)
{
    fmb_vec_get_q(b->p.row[i].value, k, out);
}

/* matrix row r = member i of a basis, its right side last. */
static void write_member(bench *b, size_t r, size_t i)
{
    mpq_t *row = &b->matrix[r * (b->n + 1)];
    for (size_t j = 0; j <= b->n; j++)
        mpq_set_ui(row[j], 0, 1);
    if (i >= b->p.m) {
        mpq_set_ui(row[i - b->p.m], 1, 1);
        return;
    }
    for (size_t k = 0; k < b->p.row[i].size; k++)
        coefficient(b, i, k, row[b->p.row[i].column[k]]);
    coefficient(b, i, b->p.row[i].size, row[b->n]);
}

static void subtract_row(mpq_t *from, mpq_t *row, size_t column, size_t n)
{
    mpq_t factor, t;
    if (mpq_sgn(from[column]) == 0)
        return;
    mpq_inits(factor, t, NULL);
    mpq_div(factor, from[column], row[column]);
    for (size_t j = 0; j <= n; j++) {
        mpq_mul(t, factor, row[j]);
        mpq_sub(from[j], from[j], t);
    }
    mpq_clears(factor, t, NULL);
}

/* Solve matrix x = last column, by Gauss and Jordan. False: singular. */
static bool solve(bench *b, mpq_t *x)
{
    size_t n = b->n, w = n + 1;
    for (size_t j = 0; j < n; j++) {
        size_t r = j;
        while (r < n && mpq_sgn(b->matrix[r * w + j]) == 0)
            r++;
        if (r == n)
            return false;
        for (size_t k = 0; r != j && k <= n; k++)
            mpq_swap(b->matrix[r * w + k], b->matrix[j * w + k]);
        for (size_t s = 0; s < n; s++)
            if (s != j)
                subtract_row(&b->matrix[s * w], &b->matrix[j * w], j, n);
    }
    for (size_t j = 0; j < n; j++)
        mpq_div(x[j], b->matrix[j * w + n], b->matrix[j * w + j]);
    return true;
}

/* x = where the members of the basis meet. */
static bool meet(bench *b)
{
    for (size_t r = 0; r < b->n; r++)
        write_member(b, r, b->basis[r]);
    return solve(b, b->x);
}

/* y times the basis = these numbers, target[n]. */
static bool combine(bench *b, mpq_t *target)
{
    size_t n = b->n, w = n + 1;
    mpq_t *rows = new_numbers(n * w);
    for (size_t r = 0; r < n; r++)
        write_member(b, r, b->basis[r]);
    for (size_t k = 0; k < n * w; k++)
        mpq_swap(rows[k], b->matrix[k]);
    for (size_t r = 0; r < n; r++)
        for (size_t j = 0; j < n; j++)
            mpq_set(b->matrix[j * w + r], rows[r * w + j]);
    for (size_t j = 0; j < n; j++)
        mpq_set(b->matrix[j * w + n], target[j]);
    free_numbers(rows, n * w);
    return solve(b, b->y);
}

/* out = row i times x. */
static void times(const bench *b, size_t i, mpq_t *x, mpq_t out)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(out, 0, 1);
    for (size_t k = 0; k < b->p.row[i].size; k++) {
        coefficient(b, i, k, t);
        mpq_mul(t, t, x[b->p.row[i].column[k]]);
        mpq_add(out, out, t);
    }
    mpq_clear(t);
}

/* Do all rows that are on hold at x, strict ones as if they were not? With `flat`, along x. */
static bool holds(const bench *b, mpq_t *x, bool flat)
{
    mpq_t sum, right;
    bool all = true;
    mpq_inits(sum, right, NULL);
    for (size_t i = 0; all && i < b->p.m; i++) {
        times(b, i, x, sum);
        if (!flat)
            coefficient(b, i, b->p.row[i].size, right);
        int side = mpq_cmp(sum, right);
        all = b->off[i] || side == 0 || (side < 0 && b->p.row[i].rel != FMB_EQ);
    }
    mpq_clears(sum, right, NULL);
    return all;
}

/* Are the multipliers y those of an optimum (sign 1), or of a conflict with one row more (-1)? */
static bool is_signed(const bench *b, int sign)
{
    for (size_t r = 0; r < b->n; r++) {
        size_t i = b->basis[r];
        int s = sign * mpq_sgn(b->y[r]);
        bool off = i >= b->p.m || b->off[i];
        if (s != 0 && (off || (s < 0 && b->p.row[i].rel != FMB_EQ)))
            return false;
    }
    return true;
}

/* y . right sides of the basis, compared with the right side of row i. */
static int compare_sides(const bench *b, size_t i)
{
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (size_t r = 0; r < b->n; r++) {
        if (b->basis[r] >= b->p.m)
            continue;
        coefficient(b, b->basis[r], b->p.row[b->basis[r]].size, t);
        mpq_mul(t, t, b->y[r]);
        mpq_add(sum, sum, t);
    }
    coefficient(b, i, b->p.row[i].size, t);
    int order = mpq_cmp(sum, t);
    mpq_clears(sum, t, NULL);
    return order;
}

/* Row `odd` is a combination of the basis that says the contrary. */
static bool proves_conflict(bench *b, size_t odd)
{
    mpq_t *target = new_numbers(b->n);
    for (size_t k = 0; k < b->p.row[odd].size; k++)
        coefficient(b, odd, k, target[b->p.row[odd].column[k]]);
    bool proved = !b->off[odd] && combine(b, target);
    int order = proved ? compare_sides(b, odd) : 0;
    proved = proved && ((order > 0 && is_signed(b, -1)) ||
                        (order < 0 && b->p.row[odd].rel == FMB_EQ && is_signed(b, 1)));
    free_numbers(target, b->n);
    return proved;
}

static void exact_cost(const bench *b, mpq_t *target)
{
    for (size_t j = 0; j < b->n; j++)
        mpq_set_d(target[j], b->cost[j]);
}

static bool proves_optimum(bench *b)
{
    mpq_t *target = new_numbers(b->n);
    exact_cost(b, target);
    bool proved = meet(b) && holds(b, b->x, false) && combine(b, target) && is_signed(b, 1);
    free_numbers(target, b->n);
    return proved;
}

/* x is a solution, and along the edge that leaves the row at that place the cost grows for ever. */
static bool proves_ray(bench *b, size_t place)
{
    size_t w = b->n + 1;
    mpq_t *target = new_numbers(b->n), gain, t;
    mpq_inits(gain, t, NULL);
    exact_cost(b, target);
    bool proved = meet(b) && holds(b, b->x, false);
    for (size_t r = 0; r < b->n; r++) {
        write_member(b, r, b->basis[r]);
        mpq_set_si(b->matrix[r * w + b->n], r == place, 1);
    }
    proved = proved && solve(b, b->x);
    for (size_t j = 0; j < b->n; j++) {
        mpq_mul(t, target[j], b->x[j]);
        mpq_add(gain, gain, t);
    }
    for (size_t j = 0; mpq_sgn(gain) < 0 && j < b->n; j++)
        mpq_neg(b->x[j], b->x[j]);
    proved = proved && mpq_sgn(gain) != 0 && holds(b, b->x, true);
    mpq_clears(gain, t, NULL);
    free_numbers(target, b->n);
    return proved;
}

/* ---- what a hint says ------------------------------------------------------------------------ */

/* n distinct members that are independent. */
static void check_basis(bench *b)
{
    for (size_t r = 0; r < b->n; r++) {
        cr_assert_lt(b->basis[r], b->p.m + b->n);
        for (size_t s = 0; s < r; s++)
            cr_assert_neq(b->basis[r], b->basis[s], "seed %lu", (unsigned long)b->c.seed);
    }
    cr_assert(meet(b), "singular, seed %lu", (unsigned long)b->c.seed);
}

typedef struct tally {
    int asked, proved, none;
} tally;

/* Is what it says true, and proved by the basis? */
static void count_hint(bench *b, const fmb_hint *h, bool of_search, tally *t)
{
    check_basis(b);
    bool proved = false;
    if (h->kind == FMB_HINT_OPTIMUM)
        proved = of_search ? meet(b) && holds(b, b->x, false) : proves_optimum(b);
    else if (h->kind == FMB_HINT_INFEASIBLE)
        proved = h->odd < b->p.m && proves_conflict(b, h->odd);
    else if (h->kind == FMB_HINT_UNBOUNDED)
        proved = !of_search && h->odd < b->n && proves_ray(b, h->odd);
    t->asked++;
    t->proved += proved;
    t->none += h->kind == FMB_HINT_NONE;
}

static void draw_cost(bench *b, support_rng *g)
{
    for (size_t j = 0; j < b->n; j++)
        b->cost[j] = support_between(g, -3, 3);
}

static fmb_hint ask(bench *b, fmb_door *d, bool search, tally *t)
{
    fmb_hint h = {.basis = b->basis};
    cr_assert_eq(search ? fmb_door_search(d, &h) : fmb_door_maximize(d, b->cost, &h), FMB_OK);
    count_hint(b, &h, search, t);
    return h;
}

static fmb_door *open_side(bench *b, const fmb_door_side *side)
{
    fmb_door *d;
    cr_assert_eq(fmb_door_open_side(&b->run, &b->p, side, &d), FMB_OK);
    cr_assert(d);
    return d;
}

/* A search, then costs one after another. Numbers that doubles cannot tell apart may get answers
 * that contradict each other. */
static void ask_all(bench *b, const fmb_door_side *side, int costs, tally *t)
{
    support_rng g = {b->c.seed};
    append_rows(b, b->part->m);
    fmb_door *d = open_side(b, side);
    fmb_hint_kind first = ask(b, d, true, t).kind;
    for (int k = 0; k < costs; k++) {
        draw_cost(b, &g);
        fmb_hint h = ask(b, d, false, t);
        if (b->c.shape.bits == 0)
            cr_assert_eq(h.kind == FMB_HINT_INFEASIBLE, first == FMB_HINT_INFEASIBLE, "seed %lu",
                         (unsigned long)b->c.seed);
    }
    fmb_door_close(d);
}

static void expect_share(const char *what, const tally *t, double share)
{
    cr_log_info("%s: %d of %d proved, %d given up", what, t->proved, t->asked, t->none);
    cr_expect_geq(t->proved, share * t->asked, "%s: only %d of %d proved", what, t->proved,
                  t->asked);
}

static void ask_small_systems(const fmb_door_side *side)
{
    tally narrow = {0}, wide = {0};
    for (uint64_t seed = 0; seed < 1000; seed++) {
        support_shape shape = {.dim = 1 + (int)(seed % 6), .rows = 1 + (int)(seed % 13)};
        support_family family = (support_family)(seed % SUPPORT_FAMILIES);
        bool is_narrow = seed % 3 > 0;
        bench b;
        if (open_bench(&b, family, seed, is_narrow ? &shape : NULL))
            ask_all(&b, side, 4, is_narrow ? &narrow : &wide);
        close_bench(&b);
    }
    expect_share("small", &narrow, 0.999);
    expect_share("wide", &wide, 0.7);
}

static void ask_larger_systems(const fmb_door_side *side)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 60; seed++) {
        bench b;
        support_shape shape = {.dim = 4 + (int)(seed % 4) * 6, .rows = 10 + (int)(seed % 7) * 10};
        if (open_bench(&b, (support_family)(seed % SUPPORT_FAMILIES), seed, &shape))
            ask_all(&b, side, 3, &t);
        close_bench(&b);
    }
    expect_share("larger", &t, 0.999);
}

Test(door, hints_of_our_own_are_proved)
{
    ask_small_systems(&fmb_door_side_own);
    ask_larger_systems(&fmb_door_side_own);
}

Test(door, hints_of_factors_are_proved)
{
    ask_small_systems(&fmb_door_side_factors);
    ask_larger_systems(&fmb_door_side_factors);
}

/* ---- changes --------------------------------------------------------------------------------- */

typedef void change(bench *b, fmb_door *d, support_rng *g, tally *t);

/* What changes, on many systems and every side of the door; it opens with so many of 100 rows. */
static void ask_while(const char *what, change *changes, int share)
{
    static const fmb_door_side *const sides[] = {&fmb_door_side_own, &fmb_door_side_factors};
    static const support_shape shape = {.dim = 6, .rows = 24};
    for (int side = 0; side < 2; side++) {
        tally t = {0};
        for (uint64_t seed = 0; seed < 120; seed++) {
            support_rng g = {seed};
            bench b;
            if (open_bench(&b, (support_family)(seed % SUPPORT_FAMILIES), seed, &shape)) {
                append_rows(&b, b.part->m * (size_t)share / 100);
                fmb_door *d = open_side(&b, sides[side]);
                changes(&b, d, &g, &t);
                fmb_door_close(d);
            }
            close_bench(&b);
        }
        expect_share(what, &t, 0.999);
    }
}

/* Rows come a few at a time. */
static void append_and_ask(bench *b, fmb_door *d, support_rng *g, tally *t)
{
    for (size_t m = 0; m <= b->part->m; m += (size_t)support_between(g, 1, 5)) {
        append_rows(b, m);
        cr_assert_eq(fmb_door_grow(d), FMB_OK);
        draw_cost(b, g);
        ask(b, d, support_chance(g, 50), t);
    }
}

Test(door, follows_rows_that_come)
{
    ask_while("growing", append_and_ask, 0);
}

/* Rows go and come; no basis may hold one that is off. */
static void switch_and_ask(bench *b, fmb_door *d, support_rng *g, tally *t)
{
    for (int k = 0; k < 20; k++) {
        size_t i = (size_t)support_between(g, 0, (int)b->p.m - 1);
        b->off[i] = !b->off[i];
        fmb_door_switch(d, i, !b->off[i]);
        draw_cost(b, g);
        ask(b, d, support_chance(g, 50), t);
        for (size_t r = 0; r < b->n; r++)
            cr_assert(b->basis[r] >= b->p.m || !b->off[b->basis[r]], "row %zu, seed %lu",
                      b->basis[r], (unsigned long)b->c.seed);
    }
}

Test(door, follows_rows_that_are_switched)
{
    ask_while("switching", switch_and_ask, 100);
}

/* Other right sides, another basis, and back. */
static void move_and_ask(bench *b, fmb_door *d, support_rng *g, tally *t)
{
    double *right = calloc(b->p.m + 1, sizeof *right);
    fmb_hint h = {.basis = b->basis};
    for (size_t i = 0; i < b->p.m; i++)
        right[i] = support_between(g, -4, 4);
    draw_cost(b, g);
    ask(b, d, false, t);
    fmb_door_shift(d, right);
    cr_assert_eq(fmb_door_search(d, &h), FMB_OK);
    check_basis(b);
    fmb_door_shift(d, NULL);
    fmb_door_sharpen(d);
    ask(b, d, support_chance(g, 50), t);
    for (size_t r = 0; r < b->n; r++)
        b->basis[r] = b->p.m + r;
    fmb_door_place(d, b->basis);
    ask(b, d, support_chance(g, 50), t);
    free(right);
}

Test(door, starts_from_other_bases_and_right_sides)
{
    ask_while("moved", move_and_ask, 100);
}

/* As the library opens it. */
Test(door, opens_on_our_own_side)
{
    tally t = {0};
    for (uint64_t seed = 0; seed < 20; seed++) {
        static const support_shape shape = {.dim = 104, .rows = 16};
        bench b;
        fmb_door *d;
        if (open_bench(&b, SUPPORT_PLANTED_POINT, seed, seed ? NULL : &shape)) {
            append_rows(&b, b.part->m);
            cr_assert_eq(fmb_door_open(&b.run, &b.p, &d), FMB_OK);
            ask(&b, d, true, &t);
            fmb_door_close(d);
        }
        close_bench(&b);
    }
    expect_share("its own", &t, 0.7);
}
