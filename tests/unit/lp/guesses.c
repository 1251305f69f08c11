/* guesses.c: the simplex method in doubles: its claims are recomputed from the columns alone. */
#include <criterion/criterion.h>
#include <math.h>

#include "lp/simplex/bounded/bounded_simplex.h"
#include "support/support.h"

enum { MOST_D = 5, MOST_COLUMNS = 12 };

typedef struct problem {
    size_t d, n;
    double column[MOST_COLUMNS][MOST_D], target[MOST_D], cost[MOST_COLUMNS];
    fmb_range range[MOST_COLUMNS];
} problem;

static void draw(support_rng *g, problem *p)
{
    p->d = (size_t)support_between(g, 1, MOST_D);
    p->n = (size_t)support_between(g, 1, MOST_COLUMNS);
    for (size_t j = 0; j < p->n; j++) {
        p->range[j] = (fmb_range)support_between(g, FMB_RANGE_UP, FMB_RANGE_ZERO);
        p->cost[j] = support_between(g, -4, 4) / 4.0;
        for (size_t k = 0; k < p->d; k++)
            p->column[j][k] = support_between(g, -3, 3) / 3.0;
    }
    for (size_t k = 0; k < p->d; k++)
        p->target[k] = support_between(g, -3, 3) / 3.0;
}

static void load(fmb_basis *b, const problem *p)
{
    fmb_basis_restart(b, p->d);
    for (size_t j = 0; j < p->n; j++)
        cr_assert_eq(fmb_basis_add(b, p->column[j], p->range[j]), FMB_OK);
    for (size_t j = 0; j < p->n; j++)
        if (p->range[j] != FMB_RANGE_ZERO)
            (void)fmb_basis_span(b, j, b->entry_zero);
}

static double upper_end(fmb_range range)
{
    return range == FMB_RANGE_ZERO ? 0 : range == FMB_RANGE_UNIT ? 1 : INFINITY;
}

/* z where the basis stands: all in their ranges, and they make up the target. False: a unit vector
 * is still needed for it. */
static bool check_point(const fmb_basis *b, const problem *p, double *z)
{
    for (size_t j = 0; j < p->n; j++)
        z[j] = b->is_high[j];
    for (size_t r = 0; r < p->d; r++) {
        if (b->basic[r] != SIZE_MAX)
            z[b->basic[r]] = b->value[r];
        else if (fabs(b->value[r]) > 1e-9)
            return false;
    }
    for (size_t j = 0; j < p->n; j++) {
        cr_assert(p->range[j] == FMB_RANGE_FREE || z[j] >= -1e-9);
        cr_assert(z[j] <= upper_end(p->range[j]) + 1e-9);
    }
    for (size_t k = 0; k < p->d; k++) {
        double sum = -p->target[k];
        for (size_t j = 0; j < p->n; j++)
            sum += z[j] * p->column[j][k];
        cr_assert_float_eq(sum, 0, 1e-7);
    }
    return true;
}

static double dot(const double *a, const double *b, size_t d)
{
    double sum = 0;
    for (size_t k = 0; k < d; k++)
        sum += a[k] * b[k];
    return sum;
}

/* The least of normal.(sum z a) is above normal.target. */
static void check_normal(const fmb_basis *b, const problem *p)
{
    double least = 0;
    for (size_t j = 0; j < p->n; j++) {
        double a = dot(b->normal, p->column[j], p->d);
        if (p->range[j] == FMB_RANGE_UNIT)
            least += fmin(a, 0);
        else if (p->range[j] != FMB_RANGE_ZERO)
            cr_assert(a > -1e-6 && (p->range[j] == FMB_RANGE_UP || a < 1e-6));
    }
    cr_assert_gt(least, dot(b->normal, p->target, p->d) + 1e-10);
}

/* By weak duality no z has more than y.target and what columns bring beyond their prices. */
static bool check_optimum(const fmb_basis *b, const problem *p, const double *y)
{
    double z[MOST_COLUMNS], bound = dot(y, p->target, p->d), value = 0;
    if (!check_point(b, p, z))
        return false;
    for (size_t j = 0; j < p->n; j++) {
        double gain = p->cost[j] - dot(y, p->column[j], p->d);
        value += p->cost[j] * z[j];
        if (p->range[j] == FMB_RANGE_UNIT)
            bound += fmax(gain, 0);
        else if (p->range[j] == FMB_RANGE_UP)
            cr_assert_lt(gain, 1e-7);
    }
    cr_assert_float_eq(value, bound, 1e-6);
    return true;
}

Test(guesses, are_what_they_claim)
{
    fmb_mem mem;
    fmb_basis b;
    support_rng g = {5};
    int inside = 0, outside = 0, optima = 0;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_basis_init(&b, &mem, fmb_kernels_choose(FMB_SIMD_AUTO), MOST_D), FMB_OK);
    b.value_zero = 1e-9;
    b.entry_zero = 1e-7;
    for (int i = 0; i < 20000; i++) {
        problem p;
        double z[MOST_COLUMNS], y[MOST_D];
        fmb_guess guess;
        draw(&g, &p);
        load(&b, &p);
        cr_assert_eq(fmb_simplex_search(&b, p.target, SIZE_MAX, NULL, &guess), FMB_OK);
        outside += guess == FMB_GUESS_OUTSIDE;
        if (guess == FMB_GUESS_OUTSIDE)
            check_normal(&b, &p);
        if (guess != FMB_GUESS_INSIDE || !check_point(&b, &p, z))
            continue;
        inside++;
        bool is_bounded = true;
        for (size_t j = 0; j < p.n; j++)
            is_bounded &= p.range[j] == FMB_RANGE_UNIT;
        if (is_bounded && fmb_simplex_maximize(&b, p.target, p.cost, y))
            optima += check_optimum(&b, &p, y);
    }
    cr_expect(inside > 2000 && outside > 2000 && optima > 50, "%d %d %d", inside, outside, optima);
    fmb_basis_clear(&b);
    cr_expect_eq(mem.used, 0u);
}
