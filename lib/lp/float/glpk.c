/* glpk.c: GLPK, asked once where our own simplex gives up; see side.h.
 *
 * Columns of the program are free structural variables of GLPK. A row of one term is a bound of its
 * column, the tightest one counts; every other row is a row of GLPK, whose auxiliary variable it
 * bounds. A basis then has exactly n nonbasic variables, and these are the n rows that the door
 * hands out.
 *
 * A search is the dual method with objective 0, for which every basis is dual feasible. GLPK may
 * abort (memory, failed assertions): that ends in a jump, and there is no hint. Its environment is
 * freed by who made it if nobody uses it by then.
 *
 * Source: Applegate, Cook, Dash, Espinoza 2007, Exact solutions to linear programming problems.
 */
#include "lp/float/side.h"

#ifdef FMB_HAVE_GLPK

#include <glpk.h>
#include <math.h>
#include <setjmp.h>
#include <string.h>

/* Numbers beyond are not for GLPK. */
#define TOO_LARGE 1e100
/* Bounds that are so close, relatively, are one to GLPK. */
#define NARROW 1e-14
/* Between two looks at the limits GLPK passes so many numbers of the program, and makes at least so
 * many iterations: its ways out of a stall begin after 200. */
#define NUMBERS_A_LOOK 2500000
#define LEAST_A_LOOK   500

typedef struct fmb_glpk {
    const fmb_reals *f;
    fmb_mem *mem;
    glp_prob *lp;
    bool broken, made_environment, feasible;
    size_t charged;     /* [bytes] for what GLPK allocates, roughly */
    int *row;           /* [m] the row of GLPK, 0: a bound */
    size_t *source;     /* [m + 1] by rows of GLPK: the row of the program */
    size_t *next;       /* [m] the next row that bounds the same column */
    size_t *first;      /* [n] the first row that bounds this column */
    size_t *low, *high; /* [n] the tightest of them */
    int *index;         /* [n + m + 1] scratch */
    double *value;      /* likewise */
    const double *cost; /* [n], or NULL: any point */
    fmb_hint *hint;
    fmb_status status;
} fmb_glpk;

/* ---- calls, guarded -------------------------------------------------------------------------- */

/* GLPK says why it aborts, even with its terminal output off. */
static int swallow_glpk_output(void *self, const char *text)
{
    (void)self, (void)text;
    return 1;
}

static void leave_glpk_by_jump(void *self)
{
    longjmp(*(jmp_buf *)self, 1);
}

/* Do what asks GLPK, unless a jump out of it has broken all before. */
static void call_glpk(fmb_glpk *g, void (*job)(fmb_glpk *))
{
    jmp_buf here;
    if (g->broken)
        return;
    int term = glp_term_out(GLP_OFF);
    glp_term_hook(swallow_glpk_output, NULL);
    glp_error_hook(leave_glpk_by_jump, &here);
    if (setjmp(here) == 0)
        job(g);
    else
        g->broken = true;
    glp_error_hook(NULL, NULL);
    glp_term_hook(NULL, NULL);
    glp_term_out(term);
}

/* ---- rows and bounds ------------------------------------------------------------------------- */

static double bound_of_column(const fmb_reals *f, size_t i)
{
    return f->right[i] / f->value[f->start[i]];
}

/* The tightest rows that bound column j from below and from above. */
static void find_tightest_bounds(fmb_glpk *g, size_t j)
{
    const fmb_reals *f = g->f;
    double low = -INFINITY, high = INFINITY;
    g->low[j] = g->high[j] = FMB_NOWHERE;
    for (size_t i = g->first[j]; i != FMB_NOWHERE; i = g->next[i]) {
        double bound = bound_of_column(f, i);
        bool is_equality = fmb_reals_is_equality(f, i), is_high = f->value[f->start[i]] > 0;
        if (f->off[i])
            continue;
        if ((is_equality || is_high) && bound < high) {
            high = bound;
            g->high[j] = i;
        }
        if ((is_equality || !is_high) && bound > low) {
            low = bound;
            g->low[j] = i;
        }
    }
}

static void load_bounds_of_column(fmb_glpk *g, size_t j)
{
    find_tightest_bounds(g, j);
    bool has_low = g->low[j] != FMB_NOWHERE, has_high = g->high[j] != FMB_NOWHERE;
    double low = has_low ? bound_of_column(g->f, g->low[j]) : 0;
    double high = has_high ? bound_of_column(g->f, g->high[j]) : 0;
    bool is_narrow = high - low <= NARROW * (fabs(low) + fabs(high));
    int type = has_low && has_high ? (is_narrow ? GLP_FX : GLP_DB)
               : has_low           ? GLP_LO
               : has_high          ? GLP_UP
                                   : GLP_FR;
    glp_set_col_bnds(g->lp, (int)j + 1, type, low, high);
}

static void load_bound_of_row(fmb_glpk *g, size_t i)
{
    double b = g->f->right[i];
    int type = g->f->off[i] || !(b < TOO_LARGE) ? GLP_FR
               : fmb_reals_is_equality(g->f, i) ? GLP_FX
                                                : GLP_UP;
    glp_set_row_bnds(g->lp, g->row[i], type, b, b);
}

static void load_terms_of_row(fmb_glpk *g, size_t i)
{
    const fmb_program_row *row = &g->f->p->row[i];
    for (size_t k = 0; k < row->size; k++) {
        g->index[k + 1] = row->column[k] + 1;
        g->value[k + 1] = g->f->value[g->f->start[i] + k];
    }
    glp_set_mat_row(g->lp, g->row[i], (int)row->size, g->index, g->value);
    load_bound_of_row(g, i);
}

/* A row of the program is a bound of a column or a row of GLPK. */
static void sort_rows_of_program(fmb_glpk *g)
{
    const fmb_reals *f = g->f;
    int rows = 0;
    for (size_t i = 0; i < f->m; i++) {
        bool is_bound = f->p->row[i].size == 1;
        g->row[i] = is_bound ? 0 : ++rows;
        if (is_bound) {
            size_t j = (size_t)fmb_reals_columns(f, i)[0];
            g->next[i] = g->first[j];
            g->first[j] = i;
        } else {
            g->source[g->row[i]] = i;
        }
    }
    if (rows > 0)
        glp_add_rows(g->lp, rows);
}

static void load_program(fmb_glpk *g)
{
    g->lp = glp_create_prob();
    glp_set_obj_dir(g->lp, GLP_MAX);
    glp_add_cols(g->lp, (int)g->f->n);
    sort_rows_of_program(g);
    for (size_t j = 0; j < g->f->n; j++)
        load_bounds_of_column(g, j);
    for (size_t i = 0; i < g->f->m; i++)
        if (g->row[i] > 0)
            load_terms_of_row(g, i);
}

/* Make row i of the program, or a unit vector, nonbasic. */
static void set_nonbasic(fmb_glpk *g, size_t i)
{
    size_t m = g->f->m;
    if (i >= m) {
        glp_set_col_stat(g->lp, (int)(i - m) + 1, GLP_NF);
    } else if (g->row[i] > 0) {
        glp_set_row_stat(g->lp, g->row[i], GLP_NU);
    } else {
        bool up = g->f->value[g->f->start[i]] > 0;
        glp_set_col_stat(g->lp, fmb_reals_columns(g->f, i)[0] + 1, up ? GLP_NU : GLP_NL);
    }
}

static void place_basis_in_glpk(fmb_glpk *g)
{
    int rows = glp_get_num_rows(g->lp), n = (int)g->f->n;
    for (int i = 1; i <= rows; i++)
        glp_set_row_stat(g->lp, i, GLP_BS);
    for (int j = 1; j <= n; j++)
        glp_set_col_stat(g->lp, j, GLP_BS);
    for (int r = 0; r < n; r++)
        set_nonbasic(g, g->hint->basis[r]);
}

/* ---- reading a basis ------------------------------------------------------------------------- */

/* The row that stands for column j where it is fixed: `up` where the upper end does. */
static size_t bounding_row(const fmb_glpk *g, size_t j, bool up)
{
    return up ? g->high[j] : g->low[j];
}

/* The row for nonbasic column j. An objective that grows with it presses against its upper end. */
static size_t row_of_column(const fmb_glpk *g, size_t j)
{
    switch (glp_get_col_stat(g->lp, (int)j + 1)) {
    case GLP_NL:
        return bounding_row(g, j, false);
    case GLP_NU:
        return bounding_row(g, j, true);
    case GLP_NS:
        return bounding_row(g, j, glp_get_col_dual(g->lp, (int)j + 1) > 0);
    default:
        return g->f->m + j;
    }
}

/* The place in the basis of variable k of GLPK; its number of entries, if k is 0. */
static size_t write_basis(const fmb_glpk *g, size_t *basis, int k)
{
    int rows = glp_get_num_rows(g->lp);
    size_t size = 0, place = FMB_NOWHERE;
    for (int i = 1; i <= rows; i++) {
        if (glp_get_row_stat(g->lp, i) == GLP_BS || size == g->f->n)
            continue;
        place = i == k ? size : place;
        basis[size++] = g->source[i];
    }
    for (int j = 1; j <= (int)g->f->n; j++) {
        if (glp_get_col_stat(g->lp, j) == GLP_BS || size == g->f->n)
            continue;
        place = j + rows == k ? size : place;
        basis[size++] = row_of_column(g, (size_t)j - 1);
    }
    return k == 0 ? size : place;
}

/* Which of two rows stands for a column that is fixed matters in a conflict: variable k, basic, is
 * past its end, and no nonbasic one may help by moving away from the end at which it is. */
static void choose_conflicting_ends(fmb_glpk *g, size_t *basis, int k, bool above)
{
    int rows = glp_get_num_rows(g->lp), size = glp_eval_tab_row(g->lp, k, g->index, g->value);
    for (int t = 1; t <= size; t++) {
        int j = g->index[t] - rows - 1;
        if (j < 0 || glp_get_col_stat(g->lp, j + 1) != GLP_NS)
            continue;
        size_t old = row_of_column(g, (size_t)j);
        for (size_t r = 0; r < g->f->n; r++)
            if (basis[r] == old)
                basis[r] = bounding_row(g, (size_t)j, (g->value[t] > 0) != above);
    }
}

/* Variable k cannot come to where it should: the row that says where. */
static size_t find_odd_row(fmb_glpk *g, size_t *basis, int k)
{
    int rows = glp_get_num_rows(g->lp);
    if (k <= rows) {
        bool above = glp_get_row_prim(g->lp, k) > g->f->right[g->source[k]];
        choose_conflicting_ends(g, basis, k, above);
        return g->source[k];
    }
    size_t j = (size_t)(k - rows) - 1;
    bool above = g->high[j] != FMB_NOWHERE &&
                 (g->low[j] == FMB_NOWHERE ||
                  glp_get_col_prim(g->lp, k - rows) > glp_get_col_ub(g->lp, k - rows));
    choose_conflicting_ends(g, basis, k, above);
    return bounding_row(g, j, above);
}

/* ---- the simplex ----------------------------------------------------------------------------- */

/* Run one method, looking at the limits now and then; GLPK's answer. In doubles it may go round in
 * circles: any basis will do, so there is an end. */
static int run_glpk_simplex(fmb_glpk *g, int method)
{
    glp_smcp how;
    int why, rows = glp_get_num_rows(g->lp);
    double numbers = (double)g->f->start[g->f->m] + rows + 1;
    double left = 2000 + 40.0 * (rows + (double)g->f->n);
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.meth = method;
    how.it_lim = (int)fmax(LEAST_A_LOOK, NUMBERS_A_LOOK / numbers);
    if (g->f->sharp)
        how.tol_bnd = how.tol_dj = 1e-9;
    do {
        g->status = fmb_run_poll_now(g->f->run);
        why = g->status == FMB_OK ? glp_simplex(g->lp, &how) : GLP_EFAIL;
        if (why == GLP_ESING || why == GLP_EBADB || why == GLP_ECOND) {
            glp_std_basis(g->lp);
            why = GLP_EITLIM;
        }
        left -= how.it_lim;
    } while (why == GLP_EITLIM && left > 0 && g->status == FMB_OK);
    return why;
}

static void clear_glpk_costs(fmb_glpk *g)
{
    for (int j = 1; j <= (int)g->f->n; j++)
        glp_set_obj_coef(g->lp, j, 0);
}

/* Two bounds of one column that contradict each other; the lower one, or FMB_NOWHERE. The basis is
 * one of unit vectors with the other of them. */
static bool find_empty_column(fmb_glpk *g, fmb_hint *h)
{
    for (size_t j = 0; j < g->f->n; j++) {
        size_t low = g->low[j], high = g->high[j];
        if (low == FMB_NOWHERE || high == FMB_NOWHERE ||
            bound_of_column(g->f, low) <= bound_of_column(g->f, high))
            continue;
        for (size_t k = 0; k < g->f->n; k++)
            h->basis[k] = g->f->m + k;
        h->basis[j] = low;
        h->odd = high;
        h->kind = FMB_HINT_INFEASIBLE;
        return true;
    }
    return false;
}

static void search_by_glpk(fmb_glpk *g)
{
    fmb_hint *h = g->hint;
    if (find_empty_column(g, h))
        return;
    clear_glpk_costs(g);
    int why = run_glpk_simplex(g, GLP_DUAL);
    if (why != 0 && g->status == FMB_OK)
        why = run_glpk_simplex(g, GLP_PRIMAL);
    if (write_basis(g, h->basis, 0) != g->f->n || why != 0)
        return;
    g->feasible = glp_get_prim_stat(g->lp) == GLP_FEAS;
    int k = glp_get_unbnd_ray(g->lp);
    if (g->feasible) {
        h->kind = FMB_HINT_OPTIMUM;
    } else if (glp_get_prim_stat(g->lp) == GLP_NOFEAS && k > 0) {
        h->kind = FMB_HINT_INFEASIBLE;
        h->odd = find_odd_row(g, h->basis, k);
    }
}

static void maximize_by_glpk(fmb_glpk *g)
{
    fmb_hint *h = g->hint;
    h->kind = FMB_HINT_NONE;
    for (size_t j = 0; j < g->f->n; j++)
        glp_set_obj_coef(g->lp, (int)j + 1, g->cost[j]);
    int why = run_glpk_simplex(g, GLP_PRIMAL), k = glp_get_unbnd_ray(g->lp);
    size_t place = write_basis(g, h->basis, k);
    g->feasible = why == 0 && glp_get_prim_stat(g->lp) == GLP_FEAS;
    if (!g->feasible)
        return;
    if (glp_get_dual_stat(g->lp) == GLP_FEAS) {
        h->kind = FMB_HINT_OPTIMUM;
    } else if (k > 0 && place != FMB_NOWHERE) {
        h->kind = FMB_HINT_UNBOUNDED;
        h->odd = place;
    }
}

static void ask_glpk_program(fmb_glpk *g)
{
    load_program(g);
    place_basis_in_glpk(g);
    search_by_glpk(g);
    if (g->cost && g->feasible)
        maximize_by_glpk(g);
}

/* ---- life ------------------------------------------------------------------------------------ */

/* About what GLPK takes for a program: matrix by rows and columns, a copy of it, the factors. */
static fmb_status charge_for_glpk(fmb_glpk *g)
{
    size_t bytes = 160 * g->f->start[g->f->m] + 800 * (g->f->m + g->f->n);
    if (!fmb_mem_charge(g->mem, bytes))
        return fmb_mem_status(g->mem);
    g->charged = bytes;
    return FMB_OK;
}

static fmb_status reserve_for_glpk(fmb_glpk *g)
{
    size_t n = g->f->n, m = g->f->m;
    g->row = fmb_mem_get(g->mem, m, sizeof *g->row);
    g->source = fmb_mem_get(g->mem, m + 1, sizeof *g->source);
    g->next = fmb_mem_get(g->mem, m, sizeof *g->next);
    g->first = fmb_mem_get(g->mem, n, sizeof *g->first);
    g->low = fmb_mem_get(g->mem, n, sizeof *g->low);
    g->high = fmb_mem_get(g->mem, n, sizeof *g->high);
    g->index = fmb_mem_get(g->mem, n + m + 1, sizeof *g->index);
    g->value = fmb_mem_get(g->mem, n + m + 1, sizeof *g->value);
    if (!g->row || !g->source || !g->next || !g->first || !g->low || !g->high || !g->index ||
        !g->value)
        return fmb_mem_status(g->mem);
    for (size_t j = 0; j < n; j++)
        g->first[j] = FMB_NOWHERE;
    return charge_for_glpk(g);
}

static void free_glpk_scratch(fmb_glpk *g)
{
    size_t n = g->f->n, m = g->f->m;
    fmb_mem_put(g->mem, g->row, m, sizeof *g->row);
    fmb_mem_put(g->mem, g->source, m + 1, sizeof *g->source);
    fmb_mem_put(g->mem, g->next, m, sizeof *g->next);
    fmb_mem_put(g->mem, g->first, n, sizeof *g->first);
    fmb_mem_put(g->mem, g->low, n, sizeof *g->low);
    fmb_mem_put(g->mem, g->high, n, sizeof *g->high);
    fmb_mem_put(g->mem, g->index, n + m + 1, sizeof *g->index);
    fmb_mem_put(g->mem, g->value, n + m + 1, sizeof *g->value);
    fmb_mem_refund(g->mem, g->charged);
}

static void delete_glpk_program(fmb_glpk *g)
{
    if (g->lp)
        glp_delete_prob(g->lp);
}

/* The environment goes with the last program that is in it, if we made it. */
static void leave_environment(fmb_glpk *g)
{
    int blocks = 0;
    glp_mem_usage(&blocks, NULL, NULL, NULL);
    if (g->made_environment && blocks == 0)
        glp_free_env();
}

/* Would GLPK take this program? */
static bool is_for_glpk(const fmb_reals *f)
{
    size_t most = INT32_MAX / 8;
    return f->n > 0 && f->n < most && f->m < most && f->start[f->m] < most;
}

fmb_status fmb_glpk_ask(const fmb_reals *f, const double *cost, fmb_hint *h)
{
    fmb_glpk g = {.f = f, .mem = f->run->mem, .cost = cost, .hint = h};
    int made = is_for_glpk(f) ? glp_init_env() : 2;
    h->kind = FMB_HINT_NONE;
    if (made > 1)
        return FMB_OK;
    g.made_environment = made == 0;
    fmb_status st = reserve_for_glpk(&g);
    if (st == FMB_OK) {
        call_glpk(&g, ask_glpk_program);
        st = g.status;
    }
    call_glpk(&g, delete_glpk_program);
    h->kind = g.broken ? FMB_HINT_NONE : h->kind;
    if (!g.broken)
        leave_environment(&g);
    free_glpk_scratch(&g);
    return st;
}

#else

fmb_status fmb_glpk_ask(const fmb_reals *f, const double *cost, fmb_hint *h)
{
    (void)f, (void)cost;
    h->kind = FMB_HINT_NONE;
    return FMB_OK;
}

#endif
