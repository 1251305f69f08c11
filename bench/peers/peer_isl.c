/* peer_isl.c: isl on rational basic sets.
 *
 * isl's sets are integer by nature; "{ rat: [...] : ... }" makes one that is rational, on which
 * isl_basic_set_eliminate is exact over the reals: Fourier-Motzkin with redundant rows removed
 * after each variable. Outside the clock: the basic set, read from text (the public way to the
 * flag). Inside: eliminate, project out, remove redundancies. Decide: isl_basic_set_is_empty. Sets
 * are closed: no strict rows.
 */
#include <isl/constraint.h>
#include <isl/ctx.h>
#include <isl/options.h>
#include <isl/set.h>
#include <isl/val.h>
#include <isl/val_gmp.h>
#include <stdio.h>
#include <stdlib.h>

#include "peers.h"

typedef struct state {
    isl_ctx *ctx;
    char *text;
    isl_basic_set *work, *result;
    int n, keep;
} state;

static char *text_of(const problem *p)
{
    char *text = NULL;
    size_t size;
    FILE *out = need(open_memstream(&text, &size));
    fputs("{ rat: [", out);
    for (int j = 0; j < p->n; j++)
        fprintf(out, "%sx%d", j ? ", " : "", j);
    fputs("] : 0 = 0", out);
    for (size_t i = 0; i < p->m; i++) {
        const problem_row *r = &p->rows[i];
        fputs(" and 0", out);
        for (int j = 0; j < p->n; j++) {
            if (mpz_sgn(r->a[j]) != 0)
                gmp_fprintf(out, " %+Zd*x%d", r->a[j], j);
        }
        gmp_fprintf(out, r->rel == FMB_EQ ? " = %Zd" : " <= %Zd", r->a[p->n]);
    }
    fputs(" }", out);
    fclose(out);
    return text;
}

static void *open_isl(const problem *p, const peer_setup *setup)
{
    (void)setup;
    if (p->strict)
        return NULL;
    state *s = need(calloc(1, sizeof *s));
    *s = (state){need(isl_ctx_alloc()), text_of(p), NULL, NULL, p->n, p->keep};
    isl_options_set_on_error(s->ctx, ISL_ON_ERROR_CONTINUE);
    return s;
}

static void forget(state *s)
{
    isl_basic_set_free(s->work);
    isl_basic_set_free(s->result);
    s->work = s->result = NULL;
}

/* Read the set anew: isl_basic_set_copy only counts references, and a copy would cache answers. */
static void ready_isl(void *self)
{
    state *s = self;
    forget(s);
    s->work = need(isl_basic_set_read_from_str(s->ctx, s->text));
}

static bool project_isl(void *self)
{
    state *s = self;
    unsigned first = (unsigned)s->keep, count = (unsigned)(s->n - s->keep);
    isl_basic_set *b = isl_basic_set_eliminate(s->work, isl_dim_set, first, count);
    s->work = NULL;
    b = isl_basic_set_project_out(b, isl_dim_set, first, count);
    s->result = isl_basic_set_remove_redundancies(b);
    return s->result != NULL;
}

typedef struct rows {
    fmb_system *out;
    mpz_t *a;
} rows;

/* c.x + b >= 0 or = 0 */
static isl_stat add_constraint(isl_constraint *c, void *user)
{
    rows *r = user;
    int n = fmb_system_dim(r->out);
    for (int j = 0; j <= n; j++) {
        isl_val *v = j < n ? isl_constraint_get_coefficient_val(c, isl_dim_set, j)
                           : isl_constraint_get_constant_val(c);
        isl_val_get_num_gmp(v, r->a[j]);
        isl_val_free(v);
        if (j < n)
            mpz_neg(r->a[j], r->a[j]);
    }
    system_add_row(r->out, r->a, isl_constraint_is_equality(c) ? FMB_EQ : FMB_LE);
    isl_constraint_free(c);
    return isl_stat_ok;
}

static fmb_system *fetch_isl(void *self)
{
    state *s = self;
    rows r = {system_of_dim(s->keep), integers_new((size_t)s->keep + 1)};
    if (isl_basic_set_plain_is_empty(s->result)) {
        mpz_set_si(r.a[s->keep], -1);
        system_add_row(r.out, r.a, FMB_LE);
    } else if (isl_basic_set_foreach_constraint(s->result, add_constraint, &r) < 0) {
        need(NULL);
    }
    integers_free(r.a, (size_t)s->keep + 1);
    return r.out;
}

static fmb_verdict decide_isl(void *self)
{
    state *s = self;
    isl_bool empty = isl_basic_set_is_empty(s->work);
    return empty < 0 ? FMB_UNKNOWN : empty ? FMB_INFEASIBLE : FMB_FEASIBLE;
}

static void close_isl(void *self)
{
    state *s = self;
    forget(s);
    free(s->text);
    isl_ctx_free(s->ctx);
    free(s);
}

const peer peer_isl = {
    .name = "isl",
    .library = "isl",
    .open = open_isl,
    .ready = ready_isl,
    .project = project_isl,
    .fetch = fetch_isl,
    .decide = decide_isl,
    .close = close_isl,
};
