/* generate.c: random systems with planted answers; see support.h. */
#include "dense.h"

/* A coefficient or right side: often 0, sometimes a fraction. */
static void random_number(support_rng *g, int bits, mpq_ptr out)
{
    mpq_set_ui(out, 0, 1);
    if (support_chance(g, 30))
        return;
    support_integer(g, bits, mpq_numref(out));
    if (support_chance(g, 15))
        mpz_set_si(mpq_denref(out), support_between(g, 2, 7));
    mpq_canonicalize(out);
}

static fmb_rel random_rel(support_rng *g, int strict, int equal)
{
    return support_chance(g, equal) ? FMB_EQ : support_chance(g, strict) ? FMB_LT : FMB_LE;
}

static void random_left(support_rng *g, int bits, dense *d, int i)
{
    for (int j = 0; j < d->dim; j++)
        random_number(g, bits, dense_row(d, i)[j]);
}

/* out += factor * the left side of row i, column by column; with the right side if whole. */
static void add_row(mpq_t *out, mpq_srcptr factor, const dense *d, int i, bool whole)
{
    mpq_t product;
    mpq_init(product);
    for (int j = 0; j < d->dim + whole; j++) {
        mpq_mul(product, factor, dense_row(d, i)[j]);
        mpq_add(out[j], out[j], product);
    }
    mpq_clear(product);
}

/* ---- families -------------------------------------------------------------------------------- */

/* The point satisfies row i, in two of five cases with equality. */
static void around_point(support_rng *g, int bits, dense *d, int i, mpq_t *point)
{
    mpq_t slack;
    mpq_init(slack);
    random_left(g, bits, d, i);
    for (int j = 0; j < d->dim; j++) {
        mpq_mul(slack, dense_row(d, i)[j], point[j]);
        mpq_add(dense_rhs(d, i), dense_rhs(d, i), slack);
    }
    d->rel[i] = random_rel(g, 20, 10);
    bool touch = d->rel[i] == FMB_EQ || (d->rel[i] == FMB_LE && support_chance(g, 40));
    if (!touch) {
        random_number(g, bits, slack);
        mpq_abs(slack, slack);
        if (mpq_sgn(slack) == 0)
            mpq_set_si(slack, 1, 3);
        mpq_add(dense_rhs(d, i), dense_rhs(d, i), slack);
    }
    mpq_clear(slack);
}

static fmb_verdict planted_point(support_rng *g, int bits, dense *d)
{
    dense point = dense_new(d->dim, 1);
    for (int j = 0; j < d->dim; j++)
        random_number(g, bits, dense_row(&point, 0)[j]);
    for (int i = 0; i < d->rows; i++)
        around_point(g, bits, d, i, dense_row(&point, 0));
    dense_free(&point);
    return FMB_FEASIBLE;
}

/* The last of the rows 0..n is chosen so that all, with the multipliers, add up to 0 <= -gap. The
 * gap may be 0 if one of them is strict. Equalities get multipliers of any sign. */
static void close_conflict(support_rng *g, dense *d, int n)
{
    mpq_t factor;
    mpq_t *last = dense_row(d, n);
    bool strict = false;
    mpq_init(factor);
    for (int i = 0; i < n; i++) {
        int sign = d->rel[i] == FMB_EQ && support_chance(g, 50) ? -1 : 1;
        mpq_set_si(factor, -sign * support_between(g, 1, 6), (unsigned)support_between(g, 1, 3));
        mpq_canonicalize(factor);
        add_row(last, factor, d, i, true);
        strict = strict || d->rel[i] == FMB_LT;
    }
    if (strict && support_chance(g, 50))
        mpq_set_ui(factor, 0, 1);
    else
        mpq_set_si(factor, support_between(g, 1, 5), (unsigned)support_between(g, 1, 4));
    mpq_canonicalize(factor);
    mpq_sub(last[d->dim], last[d->dim], factor);
    mpq_clear(factor);
}

static fmb_verdict planted_farkas(support_rng *g, int bits, dense *d)
{
    int most = d->dim + 1 < d->rows ? d->dim + 1 : d->rows;
    int size = support_between(g, 1, most); /* of the conflict */
    for (int i = 0; i < d->rows; i++) {
        if (i == size - 1)
            continue;
        random_left(g, bits, d, i);
        random_number(g, bits, dense_rhs(d, i));
        d->rel[i] = random_rel(g, 25, 15);
    }
    close_conflict(g, d, size - 1);
    for (int i = d->rows - 1; i > 0; i--)
        dense_swap(d, i, support_between(g, 0, i));
    return FMB_INFEASIBLE;
}

static fmb_verdict degenerate(support_rng *g, int bits, dense *d)
{
    (void)bits;
    for (int i = 0; i < d->rows; i++) {
        for (int j = 0; j < d->dim; j++)
            mpq_set_si(dense_row(d, i)[j], support_between(g, -1, 1), 1);
        if (support_chance(g, 40))
            mpq_set_si(dense_rhs(d, i), support_between(g, -1, 1), 1);
        d->rel[i] = random_rel(g, 25, 10);
    }
    return FMB_UNKNOWN;
}

/* Row i is a positive multiple of row k, perhaps moved by a little or with another relation. */
static void multiple(support_rng *g, dense *d, int i, int k)
{
    mpq_t factor;
    mpq_init(factor);
    mpq_set_si(factor, support_between(g, 1, 4), (unsigned)support_between(g, 1, 3));
    if (support_chance(g, 40))
        mpq_set_ui(factor, 1, 1);
    mpq_canonicalize(factor);
    d->rel[i] = d->rel[k] != FMB_EQ && support_chance(g, 20) ? random_rel(g, 50, 0) : d->rel[k];
    if (d->rel[i] != FMB_EQ && support_chance(g, 10))
        mpq_neg(factor, factor);
    add_row(dense_row(d, i), factor, d, k, true);
    if (support_chance(g, 30)) {
        mpq_set_si(factor, support_between(g, -1, 3), 5);
        mpq_canonicalize(factor);
        mpq_add(dense_rhs(d, i), dense_rhs(d, i), factor);
    }
    mpq_clear(factor);
}

static fmb_verdict parallel(support_rng *g, int bits, dense *d)
{
    int base = (d->rows + 1) / 2, dim = d->dim;
    dense point = dense_new(dim, 1);
    for (int j = 0; j < dim; j++)
        random_number(g, 0, dense_row(&point, 0)[j]);
    for (int i = 0; i < base; i++)
        around_point(g, bits, d, i, dense_row(&point, 0));
    for (int i = base; i < d->rows; i++)
        multiple(g, d, i, support_between(g, 0, i - 1));
    dense_free(&point);
    return FMB_UNKNOWN;
}

static fmb_verdict mixed(support_rng *g, int bits, dense *d)
{
    for (int i = 0; i < d->rows; i++) {
        random_left(g, bits, d, i);
        random_number(g, bits, dense_rhs(d, i));
        d->rel[i] = random_rel(g, 40, 25);
    }
    return FMB_UNKNOWN;
}

/* ---- cases ----------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    fmb_verdict (*fill)(support_rng *g, int bits, dense *d);
} FAMILY[SUPPORT_FAMILIES] = {
    [SUPPORT_PLANTED_POINT] = {"planted-point", planted_point},
    [SUPPORT_PLANTED_FARKAS] = {"planted-farkas", planted_farkas},
    [SUPPORT_DEGENERATE] = {"degenerate", degenerate},
    [SUPPORT_PARALLEL] = {"parallel", parallel},
    [SUPPORT_MIXED] = {"mixed", mixed},
};

const char *support_family_name(support_family family)
{
    return FAMILY[family].name;
}

static support_shape random_shape(support_rng *g)
{
    static const int bits[] = {0, 0, 0, 31, 53, 63, 200};
    support_shape shape = {.dim = support_between(g, 1, 5)};
    shape.rows = support_between(g, 1, shape.dim < 4 ? 10 : 8);
    shape.bits = bits[support_between(g, 0, (int)(sizeof bits / sizeof *bits) - 1)];
    return shape;
}

support_case support_make(support_family family, uint64_t seed, const support_shape *shape)
{
    support_rng g = {seed * SUPPORT_FAMILIES + family};
    support_case c = {.family = family, .seed = seed};
    c.shape = shape ? *shape : random_shape(&g);
    dense d = dense_new(c.shape.dim, c.shape.rows);
    c.verdict = FAMILY[family].fill(&g, c.shape.bits, &d);
    c.s = dense_system(&d);
    dense_free(&d);
    return c;
}

void support_case_clear(support_case *c)
{
    fmb_system_free(c->s);
    c->s = NULL;
}
