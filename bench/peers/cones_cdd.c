/* cones_cdd.c: cddlib's double description with GMP rationals, from rows to generators and back, in
 * its usual order of rows (lexicographic). Outside the clock: the matrix. */
#include <cddlib/setoper.h>

#include <cddlib/cdd.h>
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    dd_MatrixPtr rows, result;
    int n;
    bool hull, homogeneous; /* all right sides are 0 */
} state;

/* Row i of M: (b, -a), or the generator (1, x / t), (0, x). */
static void set_row(dd_MatrixPtr M, size_t i, const problem_row *r, const state *s)
{
    bool vertex = s->hull && mpz_sgn(r->a[s->n]) > 0;
    for (int j = 0; j <= s->n; j++) {
        mpq_ptr to = M->matrix[i][j < s->n ? j + 1 : 0];
        mpq_set_z(to, r->a[j]);
        if (vertex) {
            mpz_set(mpq_denref(to), r->a[s->n]);
            mpq_canonicalize(to);
        } else if (!s->hull && j < s->n) {
            mpq_neg(to, to);
        }
    }
}

static void *open_cdd(const problem *p, const peer_setup *setup)
{
    if (p->strict)
        return NULL;
    dd_set_global_constants();
    state *s = need(calloc(1, sizeof *s));
    *s = (state){.n = p->n, .hull = setup->question == PEER_HULL, .homogeneous = true};
    s->rows = dd_CreateMatrix((dd_rowrange)p->m, (dd_colrange)p->n + 1);
    s->rows->representation = s->hull ? dd_Generator : dd_Inequality;
    s->rows->numbtype = dd_Rational;
    for (size_t i = 0; i < p->m; i++) {
        set_row(s->rows, i, &p->rows[i], s);
        s->homogeneous &= mpz_sgn(p->rows[i].a[p->n]) == 0;
        if (p->rows[i].rel == FMB_EQ)
            set_addelem(s->rows->linset, (long)i + 1);
    }
    return s;
}

static void ready_cdd(void *self)
{
    state *s = self;
    if (s->result)
        dd_FreeMatrix(s->result);
    s->result = NULL;
}

static bool convert_cdd(void *self)
{
    state *s = self;
    dd_ErrorType error = dd_NoError;
    dd_PolyhedraPtr body = dd_DDMatrix2Poly(s->rows, &error);
    if (error != dd_NoError)
        return false;
    s->result = s->hull ? dd_CopyInequalities(body) : dd_CopyGenerators(body);
    dd_FreePolyhedra(body);
    return true;
}

/* b + c.x >= 0 as -c.x <= b; a generator (t, x) as x <= t. */
static void integer_row(const state *s, mpq_t *row, mpz_t *a)
{
    mpz_t common;
    mpz_init_set_ui(common, 1);
    for (int j = 0; j <= s->n; j++)
        mpz_lcm(common, common, mpq_denref(row[j]));
    for (int j = 0; j <= s->n; j++) {
        mpz_ptr to = a[j ? j - 1 : s->n];
        mpz_divexact(to, common, mpq_denref(row[j]));
        mpz_mul(to, to, mpq_numref(row[j]));
        if (j && s->hull)
            mpz_neg(to, to);
    }
    mpz_clear(common);
}

/* The vertex of a cone, the origin, is left out. */
static fmb_system *fetch_cdd(void *self)
{
    state *s = self;
    fmb_system *out = system_of_dim(s->n);
    mpz_t *a = integers_new((size_t)s->n + 1);
    for (dd_rowrange i = 0; i < s->result->rowsize; i++) {
        integer_row(s, s->result->matrix[i], a);
        system_add_row(out, a, set_member(i + 1, s->result->linset) ? FMB_EQ : FMB_LE);
    }
    for (int j = 0; j <= s->n; j++)
        mpz_set_ui(a[j], j == s->n);
    if (s->homogeneous && !s->hull)
        system_add_row(out, a, FMB_LE);
    integers_free(a, (size_t)s->n + 1);
    return out;
}

static void close_cdd(void *self)
{
    state *s = self;
    ready_cdd(s);
    dd_FreeMatrix(s->rows);
    free(s);
}

const peer peer_cdd_cones = {
    .name = "cddlib",
    .library = "cddlib",
    .open = open_cdd,
    .ready = ready_cdd,
    .vertices = convert_cdd,
    .hull = convert_cdd,
    .fetch = fetch_cdd,
    .close = close_cdd,
};
