/* peer_cdd.c: cddlib with GMP rationals, in three ways; the best of them counts.
 *
 * block:   dd_BlockElimination of all variables that go, then redundancy removal
 *          (dd_MatrixCanonicalize).
 * fourier: dd_FourierElimination of one variable after the other, redundant rows removed
 *          (dd_MatrixRedundancyRemove) after each. It refuses equalities: they come as two rows;
 *          and of rows without a solution the removal may leave some that have one, so that the
 *          feasibility program is solved first.
 * gens:    double description to generators, drop their coordinates, double description back.
 *
 * Outside the clock: the matrix. Decide: dd_Matrix2Feasibility and dd_LPSolve (dual simplex).
 * cddlib has no strict rows in matrices.
 */
#include <cddlib/setoper.h>

#include <cddlib/cdd.h>
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    dd_MatrixPtr rows, work, result;
    int n, keep;
} state;

/* Row i of M: b - sign a.x */
static void set_row(dd_MatrixPtr M, size_t i, const problem_row *r, int n, bool negate)
{
    mpz_t z;
    mpz_init(z);
    for (int j = 0; j <= n; j++) {
        mpz_set(z, r->a[j]);
        if ((j < n) != negate)
            mpz_neg(z, z);
        mpq_set_z(M->matrix[i][j < n ? j + 1 : 0], z);
    }
    mpz_clear(z);
}

static void *open_matrix(const problem *p, bool split)
{
    if (p->strict)
        return NULL;
    dd_set_global_constants();
    state *s = need(calloc(1, sizeof *s));
    size_t m = p->m + (split ? p->equalities : 0), next = 0;
    s->n = p->n;
    s->keep = p->keep;
    s->rows = dd_CreateMatrix((dd_rowrange)m, (dd_colrange)p->n + 1);
    s->rows->representation = dd_Inequality;
    s->rows->numbtype = dd_Rational;
    for (size_t i = 0; i < p->m; i++) {
        bool equal = p->rows[i].rel == FMB_EQ;
        set_row(s->rows, next++, &p->rows[i], p->n, false);
        if (equal && split)
            set_row(s->rows, next++, &p->rows[i], p->n, true);
        else if (equal)
            set_addelem(s->rows->linset, (long)next);
    }
    return s;
}

static void *open_cdd(const problem *p, const peer_setup *setup)
{
    (void)setup;
    return open_matrix(p, false);
}

static void *open_split(const problem *p, const peer_setup *setup)
{
    (void)setup;
    return open_matrix(p, true);
}

static void forget(dd_MatrixPtr *m)
{
    if (*m)
        dd_FreeMatrix(*m);
    *m = NULL;
}

static void ready_cdd(void *self)
{
    state *s = self;
    forget(&s->work);
    forget(&s->result);
    s->work = dd_CopyMatrix(s->rows);
}

static fmb_verdict decide_cdd(void *self)
{
    state *s = self;
    dd_ErrorType error = dd_NoError;
    dd_LPPtr lp = dd_Matrix2Feasibility(s->work, &error);
    if (error != dd_NoError)
        return FMB_UNKNOWN;
    dd_LPSolve(lp, dd_DualSimplex, &error);
    bool positive = lp->LPS == dd_Optimal && dd_Positive(lp->optvalue);
    bool zero = lp->LPS == dd_Optimal && dd_EqualToZero(lp->optvalue);
    dd_FreeLPData(lp);
    return error != dd_NoError ? FMB_UNKNOWN : positive || zero ? FMB_FEASIBLE : FMB_INFEASIBLE;
}

/* The result 0 >= 1. */
static dd_MatrixPtr nothing(int keep)
{
    dd_MatrixPtr m = dd_CreateMatrix(1, (dd_colrange)keep + 1);
    mpq_set_si(m->matrix[0][0], -1, 1);
    return m;
}

/* ---- three ways ------------------------------------------------------------------------------ */

static bool project_block(void *self)
{
    state *s = self;
    dd_colset gone;
    dd_ErrorType error = dd_NoError;
    dd_rowset implicit = NULL, redundant = NULL;
    dd_rowindex place = NULL;
    set_initialize(&gone, s->n + 1);
    for (int j = s->keep; j < s->n; j++)
        set_addelem(gone, j + 2);
    s->result = dd_BlockElimination(s->work, gone, &error);
    set_free(gone);
    if (error != dd_NoError || !s->result)
        return false;
    if (s->result->rowsize > 0)
        dd_MatrixCanonicalize(&s->result, &implicit, &redundant, &place, &error);
    set_free(implicit);
    set_free(redundant);
    free(place);
    return error == dd_NoError;
}

static bool project_fourier(void *self)
{
    state *s = self;
    dd_ErrorType error = dd_NoError;
    if (decide_cdd(s) == FMB_INFEASIBLE) {
        s->result = nothing(s->keep);
        return true;
    }
    s->result = dd_CopyMatrix(s->work);
    for (int j = s->n; j > s->keep && error == dd_NoError; j--) {
        dd_rowset redundant = NULL;
        dd_rowindex place = NULL;
        dd_MatrixPtr next = dd_FourierElimination(s->result, &error);
        if (error != dd_NoError)
            return false;
        dd_FreeMatrix(s->result);
        s->result = next;
        if (next->rowsize == 0)
            continue;
        dd_MatrixRedundancyRemove(&s->result, &redundant, &place, &error);
        set_free(redundant);
        free(place);
    }
    return error == dd_NoError;
}

/* The generators without the eliminated coordinates. */
static dd_MatrixPtr shortened(dd_MatrixPtr g, int keep)
{
    dd_MatrixPtr out = dd_CreateMatrix(g->rowsize, (dd_colrange)keep + 1);
    out->representation = dd_Generator;
    out->numbtype = dd_Rational;
    for (dd_rowrange i = 0; i < g->rowsize; i++) {
        for (int j = 0; j <= keep; j++)
            mpq_set(out->matrix[i][j], g->matrix[i][j]);
        if (set_member(i + 1, g->linset))
            set_addelem(out->linset, i + 1);
    }
    return out;
}

static bool project_gens(void *self)
{
    state *s = self;
    dd_ErrorType error = dd_NoError;
    dd_PolyhedraPtr body = dd_DDMatrix2Poly(s->work, &error);
    if (error != dd_NoError)
        return false;
    dd_MatrixPtr all = dd_CopyGenerators(body), some = shortened(all, s->keep);
    dd_FreePolyhedra(body);
    dd_FreeMatrix(all);
    if (some->rowsize == 0) { /* no generator: empty */
        s->result = nothing(s->keep);
        dd_FreeMatrix(some);
        return true;
    }
    dd_PolyhedraPtr shadow = dd_DDMatrix2Poly(some, &error);
    if (error == dd_NoError) {
        s->result = dd_CopyInequalities(shadow);
        dd_FreePolyhedra(shadow);
    }
    dd_FreeMatrix(some);
    return error == dd_NoError;
}

/* ---- results --------------------------------------------------------------------------------- */

/* b + c.x >= 0 with rational b, c as an integer row -c.x <= b */
static void integer_row(mpq_t *row, int n, mpz_t *a)
{
    mpz_t common;
    mpz_init_set_ui(common, 1);
    for (int j = 0; j <= n; j++)
        mpz_lcm(common, common, mpq_denref(row[j]));
    for (int j = 0; j <= n; j++) {
        mpz_ptr to = a[j ? j - 1 : n];
        mpz_divexact(to, common, mpq_denref(row[j]));
        mpz_mul(to, to, mpq_numref(row[j]));
        if (j)
            mpz_neg(to, to);
    }
    mpz_clear(common);
}

static fmb_system *fetch_cdd(void *self)
{
    state *s = self;
    fmb_system *out = system_of_dim(s->keep);
    mpz_t *a = integers_new((size_t)s->keep + 1);
    for (dd_rowrange i = 0; i < s->result->rowsize; i++) {
        integer_row(s->result->matrix[i], s->keep, a);
        system_add_row(out, a, set_member(i + 1, s->result->linset) ? FMB_EQ : FMB_LE);
    }
    integers_free(a, (size_t)s->keep + 1);
    return out;
}

static void close_cdd(void *self)
{
    state *s = self;
    forget(&s->work);
    forget(&s->result);
    forget(&s->rows);
    free(s);
}

const peer peer_cdd_block = {
    .name = "cdd-block",
    .library = "cddlib",
    .open = open_cdd,
    .ready = ready_cdd,
    .project = project_block,
    .fetch = fetch_cdd,
    .decide = decide_cdd,
    .close = close_cdd,
};

const peer peer_cdd_fourier = {
    .name = "cdd-fourier",
    .library = "cddlib",
    .open = open_split,
    .ready = ready_cdd,
    .project = project_fourier,
    .fetch = fetch_cdd,
    .close = close_cdd,
};

const peer peer_cdd_gens = {
    .name = "cdd-gens",
    .library = "cddlib",
    .open = open_cdd,
    .ready = ready_cdd,
    .project = project_gens,
    .fetch = fetch_cdd,
    .close = close_cdd,
};
