/* peer_z3.c: z3's solver for linear real arithmetic (QF_LRA), for verdicts.
 *
 * Outside the clock: the terms, and for each run a new solver that has them asserted. Inside:
 * Z3_solver_check.
 */
#include <stdlib.h>
#include <z3.h>

#include "peers.h"

typedef struct state {
    Z3_context ctx;
    Z3_solver solver;
    Z3_ast *rows;
    size_t m;
} state;

static Z3_ast number(Z3_context c, const mpz_t z)
{
    char *digits = need(mpz_get_str(NULL, 10, z));
    Z3_ast a = Z3_mk_numeral(c, digits, Z3_mk_real_sort(c));
    free(digits);
    return a;
}

static Z3_ast term(Z3_context c, const problem_row *r, int n)
{
    Z3_ast *part = need(calloc((size_t)n + 1, sizeof(Z3_ast)));
    unsigned parts = 0;
    for (int j = 0; j < n; j++) {
        if (mpz_sgn(r->a[j]) == 0)
            continue;
        Z3_ast x = Z3_mk_const(c, Z3_mk_int_symbol(c, j), Z3_mk_real_sort(c));
        Z3_ast product[] = {number(c, r->a[j]), x};
        part[parts++] = Z3_mk_mul(c, 2, product);
    }
    if (parts == 0)
        part[parts++] = Z3_mk_real(c, 0, 1);
    Z3_ast sum = Z3_mk_add(c, parts, part), b = number(c, r->a[n]);
    free(part);
    return r->rel == FMB_EQ   ? Z3_mk_eq(c, sum, b)
           : r->rel == FMB_LT ? Z3_mk_lt(c, sum, b)
                              : Z3_mk_le(c, sum, b);
}

static void *open_z3(const problem *p, const peer_setup *setup)
{
    (void)setup;
    state *s = need(calloc(1, sizeof *s));
    Z3_config how = Z3_mk_config();
    s->ctx = Z3_mk_context(how);
    Z3_del_config(how);
    s->m = p->m;
    s->rows = need(calloc(p->m + 1, sizeof(Z3_ast)));
    for (size_t i = 0; i < p->m; i++)
        s->rows[i] = term(s->ctx, &p->rows[i], p->n);
    return s;
}

static void forget(state *s)
{
    if (s->solver)
        Z3_solver_dec_ref(s->ctx, s->solver);
    s->solver = NULL;
}

static void ready_z3(void *self)
{
    state *s = self;
    forget(s);
    s->solver = Z3_mk_solver_for_logic(s->ctx, Z3_mk_string_symbol(s->ctx, "QF_LRA"));
    Z3_solver_inc_ref(s->ctx, s->solver);
    for (size_t i = 0; i < s->m; i++)
        Z3_solver_assert(s->ctx, s->solver, s->rows[i]);
}

static fmb_verdict decide_z3(void *self)
{
    state *s = self;
    Z3_lbool answer = Z3_solver_check(s->ctx, s->solver);
    return answer == Z3_L_TRUE ? FMB_FEASIBLE : answer == Z3_L_FALSE ? FMB_INFEASIBLE : FMB_UNKNOWN;
}

static void close_z3(void *self)
{
    state *s = self;
    forget(s);
    Z3_del_context(s->ctx);
    free(s->rows);
    free(s);
}

const peer peer_z3 = {
    .name = "z3",
    .library = "z3",
    .open = open_z3,
    .ready = ready_z3,
    .decide = decide_z3,
    .close = close_z3,
};
