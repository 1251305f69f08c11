/* guess.c: a basis from GLPK's floating-point simplex; see guess.h.
 *
 * A good guess saves the exact simplex nearly all its pivots, a bad one only costs it some. GLPK
 * may abort (memory, failed assertions): that ends in a jump, and no guess; its environment is then
 * freed, unless the caller's thread had one. Source: Applegate, Cook, Dash, Espinoza 2007, Exact
 * solutions to linear programming problems.
 */
#include "lp/float/guess.h"

#ifndef FMB_HAVE_GLPK

fmb_status fmb_lp_guess(fmb_run *run, int n, size_t m, const fmb_lp_row *rows, bool *tight)
{
    (void)run, (void)n, (void)m, (void)rows, (void)tight;
    return FMB_OK;
}

#else

#include <glpk.h>
#include <math.h>
#include <setjmp.h>
#include <stdlib.h>

/* Below this many variables the exact simplex alone is faster. */
#define FEW_VARIABLES 16
/* GLPK iterations between two looks at the limits. */
#define ITERATIONS    200

static double entry_as_double(const fmb_vec *v, size_t j)
{
    return v->z ? mpz_get_d(v->z[j]) : (double)v->s[j];
}

/* Row i of the problem: its terms in index[1..], value[1..]; their number, or -1 if a number is too
 * large. */
static int terms_of(const fmb_vec *v, int n, int *index, double *value)
{
    int terms = 0;
    for (int j = 0; j <= n; j++) {
        double a = entry_as_double(v, (size_t)j);
        if (!(fabs(a) < 1e100))
            return -1;
        if (j == n || a == 0)
            continue;
        index[++terms] = j + 1;
        value[terms] = a;
    }
    return terms;
}

/* Let the inequality give way: its terms get -size t, size the largest of their coefficients. */
static int relax_inequality(int n, int terms, int *index, double *value)
{
    double size = 0;
    for (int k = 1; k <= terms; k++)
        size = fmax(size, fabs(value[k]));
    index[terms + 1] = n + 1;
    value[terms + 1] = -size;
    return terms + 1;
}

/* Minimise t >= 0 such that every inequality holds when relaxed by t. At the optimum the tight rows
 * are those of a feasible vertex if t = 0, and those of a conflict if t > 0: either way the basis
 * that is wanted. */
static bool load_relaxed_rows(glp_prob *p, int n, size_t m, const fmb_lp_row *rows, int *index,
                              double *value)
{
    glp_add_cols(p, n + 1);
    glp_add_rows(p, (int)m);
    for (int j = 1; j <= n; j++)
        glp_set_col_bnds(p, j, GLP_FR, 0, 0);
    glp_set_col_bnds(p, n + 1, GLP_LO, 0, 0);
    glp_set_obj_coef(p, n + 1, 1);
    for (size_t i = 0; i < m; i++) {
        int terms = terms_of(rows[i].v, n, index, value);
        if (terms < 0)
            return false;
        bool equality = rows[i].rel == FMB_EQ;
        double b = entry_as_double(rows[i].v, (size_t)n);
        if (!equality)
            terms = relax_inequality(n, terms, index, value);
        glp_set_mat_row(p, (int)i + 1, terms, index, value);
        glp_set_row_bnds(p, (int)i + 1, equality ? GLP_FX : GLP_UP, b, b);
    }
    return true;
}

static fmb_status run_simplex(fmb_run *run, glp_prob *p)
{
    glp_smcp smcp;
    fmb_status st;
    int why;
    glp_init_smcp(&smcp);
    smcp.msg_lev = GLP_MSG_OFF;
    smcp.it_lim = ITERATIONS;
    glp_scale_prob(p, GLP_SF_AUTO);
    glp_adv_basis(p, 0);
    /* In doubles it may go round in circles. Any basis will do to start from, so there is an end.
     */
    int left = 1000 + 100 * (glp_get_num_rows(p) + glp_get_num_cols(p));
    do {
        st = fmb_run_poll_now(run);
        why = st == FMB_OK ? glp_simplex(p, &smcp) : 0;
        left -= ITERATIONS;
    } while (why == GLP_EITLIM && left > 0);
    return st;
}

/* GLPK says why it aborts, even with its terminal output off. */
static int swallow_output(void *self, const char *text)
{
    (void)self, (void)text;
    return 1;
}

static void jump_out_of_glpk(void *self)
{
    longjmp(*(jmp_buf *)self, 1);
}

/* Nonbasic rows are tight. */
static fmb_status ask_glpk(fmb_run *run, int n, size_t m, const fmb_lp_row *rows, bool *tight)
{
    jmp_buf here;
    int *volatile index = malloc(((size_t)n + 2) * sizeof *index);
    double *volatile value = malloc(((size_t)n + 2) * sizeof *value);
    volatile fmb_status st = FMB_OK;
    if (index && value && setjmp(here) == 0) {
        glp_error_hook(jump_out_of_glpk, &here);
        glp_prob *p = glp_create_prob();
        if (load_relaxed_rows(p, n, m, rows, index, value))
            st = run_simplex(run, p);
        for (size_t i = 0; st == FMB_OK && i < m; i++)
            tight[i] = glp_get_row_stat(p, (int)i + 1) != GLP_BS;
        glp_delete_prob(p);
    }
    glp_error_hook(NULL, NULL);
    free(index);
    free(value);
    return st;
}

fmb_status fmb_lp_guess(fmb_run *run, int n, size_t m, const fmb_lp_row *rows, bool *tight)
{
    if (n < FEW_VARIABLES || m == 0 || m > INT32_MAX / 4)
        return FMB_OK;
    int made = glp_init_env();
    if (made > 1)
        return FMB_OK;
    int term = glp_term_out(GLP_OFF);
    glp_term_hook(swallow_output, NULL);
    fmb_status st = ask_glpk(run, n, m, rows, tight);
    glp_term_hook(NULL, NULL);
    if (made == 0)
        glp_free_env();
    else
        glp_term_out(term);
    return st;
}

#endif
