/* factor.c: exact solutions, by minors and by lifting, against fraction-free elimination on the
 * dense matrix and its right side (Bareiss 1968). */
#include <criterion/criterion.h>

#include <stdlib.h>

#include "bareiss.h"
#include "counted_clock.h"
#include "lp/linalg/exact/factor.h"
#include "num/prime.h"
#include "support.h"

/* ---- a matrix and its factor ----------------------------------------------------------------- */

typedef struct bench {
    size_t n, m; /* the program has m rows */
    mpz_t *a;    /* [n][n] the basis, densely */
    size_t *basis;
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_program p;
    fmb_factor *f;
} bench;

static void open_bench(bench *b, size_t n)
{
    fmb_options o = {.size = sizeof o};
    *b = (bench){.n = n, .a = bareiss_numbers(n * n), .basis = malloc(n * sizeof *b->basis)};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    fmb_program_init(&b->p, &b->mem, (int)n);
}

/* The rows of a, in another order; some that are unit vectors are so by their number. */
static void build_program(bench *b, support_rng *g)
{
    mpz_t *row = bareiss_numbers(b->n + 1);
    for (size_t i = 0; i < b->n; i++)
        b->basis[i] = i;
    for (size_t i = b->n; i-- > 1;) {
        size_t j = (size_t)support_between(g, 0, (int)i), t = b->basis[i];
        b->basis[i] = b->basis[j];
        b->basis[j] = t;
    }
    for (size_t i = 0; i < b->n; i++) {
        size_t r = 0;
        while (b->basis[r] != i)
            r++;
        for (size_t j = 0; j < b->n; j++)
            mpz_set(row[j], b->a[r * b->n + j]);
        cr_assert_eq(fmb_program_add_integers(&b->p, row, FMB_LE), FMB_OK);
    }
    b->m = b->n;
    bareiss_free(row, b->n + 1);
    cr_assert_eq(fmb_factor_new(&b->run, &b->p, &b->f), FMB_OK);
}

static void make_unit_row(bench *b, size_t r, size_t j)
{
    for (size_t k = 0; k < b->n; k++)
        mpz_set_ui(b->a[r * b->n + k], k == j);
    b->basis[r] = b->m + j;
}

static void close_bench(bench *b)
{
    fmb_factor_free(b->f);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
    bareiss_free(b->a, b->n * b->n);
    free(b->basis);
}

/* Its solution, or across it that of its transpose, against the plain way where n is small, and by
 * multiplication in any case. */
static void check_solution_for(bench *b, bool across, mpz_t *right)
{
    size_t n = b->n;
    mpz_t *x = bareiss_numbers(n), *truth = bareiss_numbers(n), *a = bareiss_numbers(n * n), den, t;
    mpz_inits(den, t, NULL);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            mpz_set(a[across ? j * n + i : i * n + j], b->a[i * n + j]);
    fmb_status (*solve)(fmb_factor *, mpz_t *, mpz_t *, mpz_t) =
        across ? fmb_factor_solve_transposed : fmb_factor_solve;
    cr_assert_eq(solve(b->f, right, x, den), FMB_OK);
    cr_assert_gt(mpz_sgn(den), 0);
    for (size_t i = 0; i < n; i++) {
        mpz_mul(t, den, right[i]);
        for (size_t j = 0; j < n; j++)
            mpz_submul(t, a[i * n + j], x[j]);
        cr_assert_eq(mpz_sgn(t), 0, "row %zu of %zu", i, n);
    }
    if (n <= 24) {
        bareiss_solve(a, n, right, truth, t);
        cr_assert_eq(mpz_cmp(den, t), 0);
        for (size_t i = 0; i < n; i++)
            cr_assert_eq(mpz_cmp(x[i], truth[i]), 0);
    }
    for (size_t i = 0; i < n; i++) /* lowest terms */
        mpz_gcd(den, den, x[i]);
    cr_assert_eq(mpz_cmp_ui(den, 1), 0);
    mpz_clears(den, t, NULL);
    bareiss_free(x, n);
    bareiss_free(truth, n);
    bareiss_free(a, n * n);
}

/* For a random right side. */
static void check_solution(bench *b, support_rng *g, bool across, int bits, int percent)
{
    mpz_t *right = bareiss_numbers(b->n);
    for (size_t i = 0; i < b->n; i++)
        if (support_chance(g, percent))
            support_integer(g, bits, right[i]);
    check_solution_for(b, across, right);
    bareiss_free(right, b->n);
}

static void check_all_solutions(bench *b, support_rng *g)
{
    static const int bits[] = {0, 0, 30, 61, 62, 63, 64, 130, 700};
    for (size_t k = 0; k < sizeof bits / sizeof *bits; k++)
        check_solution(b, g, k % 2 != 0, bits[k], k % 3 == 0 ? 10 : 100);
    check_solution(b, g, true, 0, 0);
    check_solution(b, g, false, 0, 100);
}

/* ---- matrices -------------------------------------------------------------------------------- */

/* percent of the entries are not 0. */
static void fill(bench *b, support_rng *g, int percent, int bits)
{
    for (size_t t = 0; t < b->n * b->n; t++)
        if (support_chance(g, percent))
            support_integer(g, bits, b->a[t]);
}

static void make_triangular(bench *b, support_rng *g)
{
    for (size_t i = 0; i < b->n; i++) {
        for (size_t j = i + 1; j < b->n; j++)
            mpz_set_ui(b->a[i * b->n + j], 0);
        while (mpz_sgn(b->a[i * b->n + i]) == 0)
            support_integer(g, 0, b->a[i * b->n + i]);
    }
}

static void shuffle_columns(bench *b, support_rng *g)
{
    for (size_t j = b->n; j-- > 1;) {
        size_t k = (size_t)support_between(g, 0, (int)j);
        for (size_t i = 0; i < b->n; i++)
            mpz_swap(b->a[i * b->n + j], b->a[i * b->n + k]);
    }
}

/* Row r becomes a combination of two others. */
static void make_row_dependent(bench *b, support_rng *g, size_t r)
{
    size_t i = (size_t)support_between(g, 0, (int)b->n - 1);
    size_t k = (size_t)support_between(g, 0, (int)b->n - 1);
    mpz_t f, h;
    mpz_inits(f, h, NULL);
    mpz_set_si(f, i == r ? 0 : support_between(g, -3, 3));
    mpz_set_si(h, k == r ? 0 : support_between(g, -3, 3));
    for (size_t j = 0; j < b->n; j++) {
        mpz_set_ui(b->a[r * b->n + j], 0);
        if (mpz_sgn(f) != 0)
            mpz_addmul(b->a[r * b->n + j], f, b->a[i * b->n + j]);
        if (mpz_sgn(h) != 0)
            mpz_addmul(b->a[r * b->n + j], h, b->a[k * b->n + j]);
    }
    mpz_clears(f, h, NULL);
}

/* Factor; take over what was exchanged, and check that it had to be and helps. */
static void factor_and_check_rank(bench *b)
{
    size_t n = b->n, rank = bareiss_rank(b->a, n), exchanged = 0;
    size_t *before = malloc(n * sizeof *before);
    bool changed;
    for (size_t r = 0; r < n; r++)
        before[r] = b->basis[r];
    cr_assert_eq(fmb_factor_set(b->f, b->basis, &changed), FMB_OK);
    cr_assert_eq(changed, rank < n, "n %zu rank %zu", n, rank);
    for (size_t r = 0; r < n; r++) {
        if (b->basis[r] == before[r])
            continue;
        exchanged++;
        cr_assert(b->basis[r] >= b->m && b->basis[r] < b->m + n);
        make_unit_row(b, r, b->basis[r] - b->m);
    }
    cr_assert_eq(exchanged, n - rank);
    cr_assert_eq(bareiss_rank(b->a, n), n);
    free(before);
}

static void check_random_matrix(uint64_t seed)
{
    static const int bits[] = {0, 0, 0, 30, 33, 61, 62, 64, 200};
    support_rng g = {seed};
    bench b;
    open_bench(&b, (size_t)support_between(&g, 1, seed % 10 == 0 ? 60 : seed % 10 == 5 ? 28 : 14));
    int percent = seed % 3 == 0 ? 100 : support_between(&g, 5, 60);
    fill(&b, &g, percent, bits[seed % 9]);
    if (seed % 4 == 1)
        make_triangular(&b, &g);
    shuffle_columns(&b, &g);
    if (seed % 5 == 2)
        make_row_dependent(&b, &g, 0);
    if (seed % 5 >= 1 && b.n > 4)
        make_row_dependent(&b, &g, 2);
    build_program(&b, &g);
    for (size_t r = 0; r < b.n; r++)
        if (support_chance(&g, (int)(seed % 7) * 10))
            make_unit_row(&b, r, (size_t)support_between(&g, 0, (int)b.n - 1));
    factor_and_check_rank(&b);
    check_all_solutions(&b, &g);
    close_bench(&b);
}

Test(factor, random_matrices)
{
    for (uint64_t seed = 1; seed <= 600 / WATCHED; seed++)
        check_random_matrix(seed);
}

/* Sparse ones whose rest is dense, and a dense one: checked by multiplication. */
Test(factor, larger_matrices)
{
    for (uint64_t seed = 1; seed <= 8; seed++) {
        support_rng g = {seed};
        bench b;
        bool changed;
        open_bench(&b, 120);
        fill(&b, &g, seed == 1 ? 100 : 3, seed == 2 ? 40 : 0);
        for (size_t i = 0; i < b.n; i++)
            if (support_chance(&g, 70))
                mpz_set_si(b.a[i * b.n + i], support_between(&g, 1, 9));
        shuffle_columns(&b, &g);
        build_program(&b, &g);
        cr_assert_eq(fmb_factor_set(b.f, b.basis, &changed), FMB_OK);
        for (size_t r = 0; r < b.n; r++)
            if (b.basis[r] >= b.m)
                make_unit_row(&b, r, b.basis[r] - b.m);
        check_all_solutions(&b, &g);
        close_bench(&b);
    }
}

/* Solved by substitution, or lifted where the product of the diagonal is long. */
Test(factor, triangular_matrices)
{
    for (uint64_t seed = 1; seed <= 12; seed++) {
        support_rng g = {seed};
        bench b;
        bool changed;
        open_bench(&b, seed % 3 == 0 ? 80 : 20);
        fill(&b, &g, 15, 0);
        for (size_t i = 0; i < b.n; i++)
            support_integer(&g, seed % 2 ? 0 : 60, b.a[i * b.n + i]);
        make_triangular(&b, &g);
        shuffle_columns(&b, &g);
        build_program(&b, &g);
        cr_assert_eq(fmb_factor_set(b.f, b.basis, &changed), FMB_OK);
        cr_assert(!changed);
        check_all_solutions(&b, &g);
        close_bench(&b);
    }
}

/* The primes stand in the matrix, and in the determinant only. */
Test(factor, determinants_divisible_by_the_prime)
{
    for (int both = 0; both < 2; both++)
        for (size_t n = 1; n <= 12; n++) {
            support_rng g = {n};
            bench b;
            bool changed;
            open_bench(&b, n);
            fill(&b, &g, 100, 0);
            make_triangular(&b, &g);
            mpz_set_ui(b.a[(n - 1) * n + n - 1], fmb_prime_number(0).p);
            if (both)
                mpz_set_ui(b.a[0], fmb_prime_number(1).p);
            for (size_t j = 1; j < n; j++) { /* column j plus column j - 1 */
                for (size_t i = 0; i < n; i++)
                    mpz_add(b.a[i * n + j], b.a[i * n + j], b.a[i * n + j - 1]);
            }
            shuffle_columns(&b, &g);
            build_program(&b, &g);
            cr_assert_eq(fmb_factor_set(b.f, b.basis, &changed), FMB_OK);
            cr_assert(both || !changed);
            for (size_t r = 0; r < n; r++)
                if (b.basis[r] >= b.m)
                    make_unit_row(&b, r, b.basis[r] - b.m);
            check_all_solutions(&b, &g);
            close_bench(&b);
        }
}

/* The prime is 2^61 - 1, so 2^k 2^(61 - k) is 1 modulo it: numbers that are short solve this modulo
 * the prime, and are not the solution. */
static void check_short_residues(size_t n, int k, bool across)
{
    support_rng g = {(uint64_t)k};
    bench b;
    bool changed;
    mpz_t *right = bareiss_numbers(n);
    open_bench(&b, n);
    fill(&b, &g, 100, 0);
    mpz_set_ui(b.a[0], 1ul << k);
    build_program(&b, &g);
    cr_assert_eq(fmb_factor_set(b.f, b.basis, &changed), FMB_OK);
    cr_assert(!changed);
    for (size_t j = 0; j < n; j++) {
        int y = support_between(&g, -9, 9);
        for (size_t i = 0; i < n; i++) {
            size_t at = across ? j * n + i : i * n + j;
            if (j > 0)
                (y < 0 ? mpz_submul_ui : mpz_addmul_ui)(right[i], b.a[at], (unsigned long)abs(y));
            else if (i > 0)
                mpz_addmul_ui(right[i], b.a[at], 1ul << (61 - k));
            else
                mpz_add_ui(right[i], right[i], 1);
        }
    }
    check_solution_for(&b, across, right);
    bareiss_free(right, n);
    close_bench(&b);
}

Test(factor, solutions_that_are_short_modulo_the_prime_only)
{
    for (int k = 1; k <= 60; k++) {
        check_short_residues(28, k, false);
        check_short_residues(28, k, true);
    }
}

Test(factor, no_columns_at_all)
{
    bench b;
    bool changed = true;
    mpz_t den, none[1];
    mpz_inits(den, none[0], NULL);
    open_bench(&b, 0);
    cr_assert_eq(fmb_factor_new(&b.run, &b.p, &b.f), FMB_OK);
    cr_assert_eq(fmb_factor_set(b.f, b.basis, &changed), FMB_OK);
    cr_assert(!changed);
    cr_assert_eq(fmb_factor_solve(b.f, (mpz_t *)none, none, den), FMB_OK);
    cr_assert_eq(mpz_cmp_ui(den, 1), 0);
    mpz_clears(den, none[0], NULL);
    close_bench(&b);
}

/* ---- limits ---------------------------------------------------------------------------------- */

static fmb_status solve_once(bench *b, mpz_t *right, mpz_t *x, mpz_t den)
{
    bool changed;
    fmb_factor *f;
    fmb_status st = fmb_factor_new(&b->run, &b->p, &f);
    if (st != FMB_OK)
        return st;
    st = fmb_factor_set(f, b->basis, &changed);
    if (st == FMB_OK)
        st = fmb_factor_solve(f, (mpz_t *)right, x, den);
    if (st == FMB_OK)
        st = fmb_factor_solve_transposed(f, (mpz_t *)right, x, den);
    fmb_factor_free(f);
    return st;
}

/* Less and less memory, down to none: a limit each time, and nothing is left behind. */
Test(factor, limits_on_memory_leave_nothing_behind)
{
    for (int kind = 0; kind < 4; kind++) {
        bool wide = kind % 2, small = kind / 2;
        support_rng g = {3};
        bench b;
        open_bench(&b, small ? 10 : 60);
        fill(&b, &g, small ? 60 : 8, wide ? 200 : 0);
        for (size_t i = 0; i < b.n; i++)
            mpz_set_ui(b.a[i * b.n + i], 1);
        build_program(&b, &g);
        mpz_t *right = bareiss_numbers(b.n), *x = bareiss_numbers(b.n), den;
        mpz_init(den);
        for (size_t i = 0; i < b.n; i++)
            support_integer(&g, 70, right[i]);
        cr_assert_eq(solve_once(&b, right, x, den), FMB_OK);
        size_t used = b.mem.used, peak = b.mem.peak;
        for (size_t part = 1; part < 60; part += WATCHED) {
            b.mem.limit = used + (peak - used) * part / 60;
            cr_assert_eq(solve_once(&b, right, x, den), FMB_LIMIT);
            cr_assert_eq(b.mem.used, used);
        }
        b.mem.limit = 0;
        atomic_store(&b.cancel, 1);
        cr_assert_eq(solve_once(&b, right, x, den), FMB_LIMIT);
        cr_assert_eq(b.mem.used, used);
        mpz_clear(den);
        bareiss_free(right, b.n);
        bareiss_free(x, b.n);
        close_bench(&b);
    }
}

/* A small matrix of long numbers: whether to go on is asked at each row, so a limit of any number
 * of readings stops it there; behind a limit the same is solved. */
Test(factor, stops_between_rows)
{
    support_rng g = {11};
    bench b;
    mpz_t x[8], right[8], den;
    size_t limit = 0;
    fmb_status st;
    open_bench(&b, 8);
    fill(&b, &g, 100, 200);
    build_program(&b, &g);
    mpz_init(den);
    for (size_t i = 0; i < b.n; i++) {
        mpz_init(x[i]);
        mpz_init_set_ui(right[i], i + 1);
    }
    factor_and_check_rank(&b);
    do {
        counted_clock_start(0, NULL, NULL);
        b.run.stop = FMB_STOP_DONE;
        b.run.deadline = (double)++limit;
        st = fmb_factor_solve(b.f, right, x, den);
        counted_clock_stop();
        cr_assert(st == FMB_OK || (st == FMB_LIMIT && b.run.stop == FMB_STOP_TIME));
        cr_assert_leq(counted_clock_readings(), limit);
    } while (st != FMB_OK);
    cr_assert_geq(limit, (b.n - 1) * (b.n - 2) / 2, "%zu readings", limit); /* behind step 0 */
    b.run.deadline = 0;
    check_solution(&b, &g, false, 200, 100);
    check_solution(&b, &g, true, 200, 100);
    for (size_t i = 0; i < b.n; i++)
        mpz_clears(x[i], right[i], NULL);
    mpz_clear(den);
    close_bench(&b);
}
