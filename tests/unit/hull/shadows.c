/* shadows.c: systems for walks; see shadows.h. */
#include "shadows.h"

static mpz_ptr cell(const dense *d, int i, int j)
{
    return mpq_numref(dense_row(d, i)[j]);
}

static int any_dim(support_rng *g)
{
    return support_between(g, 2, 6);
}

static void fill(const dense *d, int i, support_rng *g, int most, int density)
{
    for (int j = 0; j < d->dim; j++)
        mpz_set_si(cell(d, i, j), support_chance(g, density) ? support_between(g, -most, most) : 0);
}

/* b_i = a_i.point + slack. */
static void let_in(const dense *d, int i, const int *point, int slack)
{
    mpz_ptr b = cell(d, i, d->dim);
    mpz_set_si(b, slack);
    for (int j = 0; j < d->dim; j++)
        if (point[j] >= 0)
            mpz_addmul_ui(b, cell(d, i, j), (unsigned)point[j]);
        else
            mpz_submul_ui(b, cell(d, i, j), (unsigned)-point[j]);
}

/* Rows +-x_j <= most from row i on. */
static void fill_box(const dense *d, int i, int most)
{
    for (int k = 0; k < 2 * d->dim; k++) {
        mpz_set_si(cell(d, i + k, k / 2), k % 2 ? 1 : -1);
        mpz_set_si(cell(d, i + k, d->dim), most);
    }
}

static void negate(const dense *d, int to, int from)
{
    for (int j = 0; j <= d->dim; j++)
        mpz_neg(cell(d, to, j), cell(d, from, j));
}

static void any_point(support_rng *g, int *point)
{
    for (int j = 0; j < 6; j++)
        point[j] = support_between(g, -3, 3);
}

dense shadow_dense_rows(support_rng *g)
{
    dense d = dense_new(any_dim(g), support_between(g, 2, 12));
    int density = support_between(g, 40, 100), most = support_chance(g, 30) ? 1 : 9;
    for (int i = 0; i < d.rows; i++) {
        fill(&d, i, g, most, density);
        mpz_set_si(cell(&d, i, d.dim), support_between(g, -2, 12));
    }
    return d;
}

dense shadow_bounded(support_rng *g)
{
    int n = any_dim(g), more = support_between(g, 0, 20 - 2 * n);
    dense d = dense_new(n, 2 * n + more);
    fill_box(&d, more, support_between(g, 1, 9));
    for (int i = 0; i < more; i++) {
        fill(&d, i, g, 9, 80);
        mpz_set_si(cell(&d, i, n), support_between(g, 0, 20));
    }
    return d;
}

/* Many rows through one point; with all of them: a cone. */
dense shadow_through_a_point(support_rng *g)
{
    int point[6], share = support_chance(g, 40) ? 100 : support_between(g, 30, 90);
    dense d = dense_new(any_dim(g), support_between(g, 2, 14));
    int most = support_chance(g, 50) ? 1 : 4;
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        fill(&d, i, g, most, 70);
        let_in(&d, i, point, support_chance(g, share) ? 0 : support_between(g, 1, 6));
    }
    return d;
}

dense shadow_cone(support_rng *g)
{
    dense d = dense_new(any_dim(g), support_between(g, 2, 12));
    for (int i = 0; i < d.rows; i++)
        fill(&d, i, g, support_chance(g, 50) ? 1 : 9, 90);
    return d;
}

dense shadow_with_equalities(support_rng *g)
{
    int point[6];
    dense d = dense_new(any_dim(g), support_between(g, 4, 14));
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        fill(&d, i, g, 5, 80);
        bool equality = i < d.dim - 1 && support_chance(g, 40);
        d.rel[i] = equality ? FMB_EQ : FMB_LE;
        let_in(&d, i, point, equality ? 0 : support_between(g, 0, 9));
    }
    return d;
}

/* Pairs of opposite rows: equalities in disguise, of few variables each. */
dense shadow_flat(support_rng *g)
{
    int point[6], pairs = support_between(g, 1, 3), more = support_between(g, 0, 10);
    dense d = dense_new(any_dim(g), 2 * pairs + more);
    any_point(g, point);
    for (int i = 0; i < 2 * pairs; i += 2) {
        int a = support_between(g, 0, d.dim - 1), b = support_between(g, 0, d.dim - 1);
        mpz_set_si(cell(&d, i, a), support_between(g, 1, 5));
        mpz_set_si(cell(&d, i, b), support_between(g, -5, 5));
        let_in(&d, i, point, 0);
        negate(&d, i + 1, i);
    }
    for (int i = 2 * pairs; i < d.rows; i++) {
        fill(&d, i, g, 5, 70);
        let_in(&d, i, point, support_between(g, 0, 5));
    }
    return d;
}

/* x >= p, sum x <= sum p, and rows through p. */
dense shadow_single_point(support_rng *g)
{
    int point[6], n = any_dim(g);
    dense d = dense_new(n, n + 1 + support_between(g, 0, 8));
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        if (i < n)
            mpz_set_si(cell(&d, i, i), -1);
        else if (i > n)
            fill(&d, i, g, 3, 80);
        for (int j = 0; i == n && j < n; j++)
            mpz_set_si(cell(&d, i, j), support_between(g, 1, 4));
        let_in(&d, i, point, 0);
    }
    return d;
}

/* Cross-polytopes: many rows through every vertex. */
dense shadow_cross_polytope(support_rng *g)
{
    int n = support_between(g, 2, 4);
    dense d = dense_new(n, 1 << n);
    for (int i = 0; i < d.rows; i++)
        for (int j = 0; j <= n; j++)
            mpz_set_si(cell(&d, i, j), j == n || (i >> j) % 2 ? 1 : -1);
    return d;
}

/* Over a cube: a pyramid, whose top is in 2 (n - 1) rows. */
dense shadow_pyramid(support_rng *g)
{
    int n = any_dim(g);
    dense d = dense_new(n, 2 * n - 1);
    for (int i = 0; i < d.rows - 1; i++) {
        mpz_set_si(cell(&d, i, i / 2), i % 2 ? 1 : -1);
        mpz_set_si(cell(&d, i, n - 1), 1);
        mpz_set_si(cell(&d, i, n), support_between(g, 1, 2));
    }
    mpz_set_si(cell(&d, d.rows - 1, n - 1), -1);
    return d;
}

/* Few directions lead to no end in the shadow, if any: it has a corner of almost half a turn. Or it
 * is a long needle. The other variables are mixed in. */
dense shadow_narrow(support_rng *g)
{
    int n = any_dim(g), point[6];
    dense d = dense_new(n, 2 + support_between(g, 0, 4));
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        mpz_set_si(cell(&d, i, 1), i < 2 ? -1 : support_between(g, -1, 1));
        mpz_set_si(cell(&d, i, 0), i == 0 ? 1 : i == 1 ? -1 : support_between(g, -1, 1));
        int bits = support_between(g, 0, 70);
        mpz_mul_2exp(cell(&d, i, i % 2), cell(&d, i, i % 2), (mp_bitcnt_t)bits);
        if (i < 2 && support_chance(g, 50))
            mpz_swap(cell(&d, i, 0), cell(&d, i, 1));
        for (int j = 2; j < n; j++)
            mpz_set_si(cell(&d, i, j), i < 2 ? 0 : support_between(g, -1, 1));
        let_in(&d, i, point, support_between(g, 0, 2));
    }
    return d;
}

/* Some column is empty. */
dense shadow_unnamed(support_rng *g)
{
    dense d = support_chance(g, 50) ? shadow_bounded(g) : shadow_dense_rows(g);
    int j = support_between(g, 0, d.dim - 1);
    for (int i = 0; i < d.rows; i++)
        mpz_set_si(cell(&d, i, j), 0);
    return d;
}

dense shadow_wide(support_rng *g)
{
    static const int BITS[] = {31, 53, 61, 62, 63, 64, 200};
    int n = support_between(g, 2, 4), bits = BITS[support_between(g, 0, 6)];
    dense d = dense_new(n, support_between(g, 2, 10));
    int point[6];
    any_point(g, point);
    for (int i = 0; i < d.rows; i++) {
        for (int j = 0; j < n; j++)
            support_integer(g, bits, cell(&d, i, j));
        let_in(&d, i, point, support_between(g, 0, 9));
    }
    return d;
}
