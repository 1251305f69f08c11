/* glpk.c: GLPK behind the door; see side.h.
 *
 * Columns of the program are free structural variables of GLPK. A row of one term is a bound of its
 * column, the tightest one counts; every other row is a row of GLPK, whose auxiliary variable it
 * bounds. A basis then has exactly n nonbasic variables, and these are the n rows that the door
 * hands out.
 *
 * A search is the dual method with objective 0, for which every basis is dual feasible. GLPK may
 * abort (memory, failed assertions): that ends in a jump, and the door goes on without it. Its
 * environment is freed by the door that made it if nobody uses it by then.
 *
 * Source: Applegate, Cook, Dash, Espinoza 2007, Exact solutions to linear programming problems.
 */
#include "lp/float/side.h"

#ifdef FMB_HAVE_GLPK

#include <float.h>
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
    size_t m;           /* rows of the program taken in */
    int *row;           /* [m] the row of GLPK, 0: a bound */
    size_t *source;     /* [rows of GLPK + 1] the row of the program */
    size_t *next;       /* [m] the next row that bounds the same column */
    size_t *first;      /* [n] the first row that bounds this column */
    size_t *low, *high; /* [n] the tightest of them */
    int *index;         /* [n + rows + 1] scratch */
    double *value;      /* likewise */
    size_t row_room, source_room, next_room, index_room, value_room;
    /* What the jobs are about. */
    const double *cost;
    const size_t *basis;
    size_t which;
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

/* Do what asks GLPK; a jump out of it breaks this side of the door for good. */
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

/* Rows g->m, ... of the reals. */
static void load_new_rows(fmb_glpk *g)
{
    const fmb_reals *f = g->f;
    int before = glp_get_num_rows(g->lp), more = 0;
    for (size_t i = g->m; i < f->m; i++) {
        bool is_bound = f->p->row[i].size == 1;
        g->row[i] = is_bound ? 0 : before + ++more;
        if (is_bound) {
            size_t j = (size_t)fmb_reals_columns(f, i)[0];
            g->next[i] = g->first[j];
            g->first[j] = i;
        } else {
            g->source[g->row[i]] = i;
        }
    }
    if (more > 0)
        glp_add_rows(g->lp, more);
    for (size_t i = g->m; i < f->m; i++)
        if (g->row[i] > 0)
            load_terms_of_row(g, i);
        else
            load_bounds_of_column(g, (size_t)fmb_reals_columns(f, i)[0]);
    g->m = f->m;
    g->feasible = false;
}

static void load_program(fmb_glpk *g)
{
    g->lp = glp_create_prob();
    glp_set_obj_dir(g->lp, GLP_MAX);
    glp_add_cols(g->lp, (int)g->f->n);
    for (size_t j = 0; j < g->f->n; j++)
        load_bounds_of_column(g, j);
    load_new_rows(g);
    glp_std_basis(g->lp);
}

/* ---- life ------------------------------------------------------------------------------------ */

/* About what GLPK takes for a program: matrix by rows and columns, a copy of it, the factors. */
static fmb_status charge_for_glpk(fmb_glpk *g)
{
    size_t bytes = 160 * g->f->start[g->f->m] + 800 * (g->f->m + g->f->n);
    if (bytes > g->charged && !fmb_mem_charge(g->mem, bytes - g->charged))
        return fmb_mem_status(g->mem);
    g->charged = bytes > g->charged ? bytes : g->charged;
    return FMB_OK;
}

static fmb_status reserve_for_rows(fmb_glpk *g)
{
    size_t m = g->f->m, both = g->f->n + m + 2;
    fmb_status st = fmb_mem_reserve(g->mem, (void **)&g->row, &g->row_room, m, sizeof *g->row);
    if (st == FMB_OK)
        st =
            fmb_mem_reserve(g->mem, (void **)&g->source, &g->source_room, m + 1, sizeof *g->source);
    if (st == FMB_OK)
        st = fmb_mem_reserve(g->mem, (void **)&g->next, &g->next_room, m, sizeof *g->next);
    if (st == FMB_OK)
        st = fmb_mem_reserve(g->mem, (void **)&g->index, &g->index_room, both, sizeof *g->index);
    if (st == FMB_OK)
        st = fmb_mem_reserve(g->mem, (void **)&g->value, &g->value_room, both, sizeof *g->value);
    return st == FMB_OK ? charge_for_glpk(g) : st;
}

static fmb_status reserve_for_columns(fmb_glpk *g)
{
    size_t n = g->f->n;
    g->first = fmb_mem_get(g->mem, n, sizeof *g->first);
    g->low = fmb_mem_get(g->mem, n, sizeof *g->low);
    g->high = fmb_mem_get(g->mem, n, sizeof *g->high);
    if (!g->first || !g->low || !g->high)
        return fmb_mem_status(g->mem);
    for (size_t j = 0; j < n; j++)
        g->first[j] = FMB_NOWHERE;
    return reserve_for_rows(g);
}

/* Would GLPK take this program? */
static bool is_for_glpk(const fmb_reals *f)
{
    size_t most = INT32_MAX / 8;
    return f->n > 0 && f->n < most && f->m < most && f->start[f->m] < most;
}

static void close_glpk(void *self);

static fmb_status open_glpk(const fmb_reals *f, void **out)
{
    int made = is_for_glpk(f) ? glp_init_env() : 2;
    if (made > 1) {
        *out = NULL;
        return FMB_OK;
    }
    fmb_glpk *g = fmb_mem_zero(f->run->mem, 1, sizeof *g);
    if (!g)
        return fmb_mem_status(f->run->mem);
    g->f = f;
    g->mem = f->run->mem;
    g->made_environment = made == 0;
    fmb_status st = reserve_for_columns(g);
    if (st == FMB_OK)
        call_glpk(g, load_program);
    if (st == FMB_OK)
        *out = g;
    else
        close_glpk(g);
    return st;
}

static void delete_glpk_program(fmb_glpk *g)
{
    if (g->lp)
        glp_delete_prob(g->lp);
}

/* The environment goes with the last program that is in it, if a door made it. */
static void leave_environment(fmb_glpk *g)
{
    int blocks = 0;
    glp_mem_usage(&blocks, NULL, NULL, NULL);
    if (g->made_environment && blocks == 0)
        glp_free_env();
}

static void close_glpk(void *self)
{
    fmb_glpk *g = self;
    call_glpk(g, delete_glpk_program);
    if (!g->broken)
        leave_environment(g);
    fmb_mem_put(g->mem, g->row, g->row_room, sizeof *g->row);
    fmb_mem_put(g->mem, g->source, g->source_room, sizeof *g->source);
    fmb_mem_put(g->mem, g->next, g->next_room, sizeof *g->next);
    fmb_mem_put(g->mem, g->index, g->index_room, sizeof *g->index);
    fmb_mem_put(g->mem, g->value, g->value_room, sizeof *g->value);
    fmb_mem_put(g->mem, g->first, g->f->n, sizeof *g->first);
    fmb_mem_put(g->mem, g->low, g->f->n, sizeof *g->low);
    fmb_mem_put(g->mem, g->high, g->f->n, sizeof *g->high);
    fmb_mem_refund(g->mem, g->charged);
    fmb_mem_put(g->mem, g, 1, sizeof *g);
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
    if (!g->feasible)
        search_by_glpk(g);
    if (!g->feasible)
        return;
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

static fmb_status do_job_of_glpk(fmb_glpk *g, void (*job)(fmb_glpk *), const double *cost,
                                 fmb_hint *h)
{
    g->hint = h;
    g->cost = cost;
    g->status = FMB_OK;
    h->kind = FMB_HINT_NONE;
    for (size_t j = 0; j < g->f->n; j++)
        h->basis[j] = g->f->m + j;
    call_glpk(g, job);
    h->kind = g->broken ? FMB_HINT_NONE : h->kind;
    return g->status;
}

static fmb_status search_glpk(void *self, fmb_hint *h)
{
    return do_job_of_glpk(self, search_by_glpk, NULL, h);
}

static fmb_status maximize_glpk(void *self, const double *cost, fmb_hint *h)
{
    return do_job_of_glpk(self, maximize_by_glpk, cost, h);
}

/* ---- changes --------------------------------------------------------------------------------- */

static fmb_status grow_glpk(void *self)
{
    fmb_glpk *g = self;
    if (!is_for_glpk(g->f))
        g->broken = true;
    fmb_status st = reserve_for_rows(g);
    if (st == FMB_OK)
        call_glpk(g, load_new_rows);
    return st;
}

/* The end of basic variable k that stops it when it changes at this rate, and how far that is. */
static double find_room_of_variable(const fmb_glpk *g, int k, double rate)
{
    int rows = glp_get_num_rows(g->lp);
    bool is_row = k <= rows;
    double at = is_row ? glp_get_row_prim(g->lp, k) : glp_get_col_prim(g->lp, k - rows);
    double low = is_row ? glp_get_row_lb(g->lp, k) : glp_get_col_lb(g->lp, k - rows);
    double high = is_row ? glp_get_row_ub(g->lp, k) : glp_get_col_ub(g->lp, k - rows);
    if (rate > 0)
        return high < DBL_MAX ? fmax(0, high - at) / rate : INFINITY;
    return low > -DBL_MAX ? fmax(0, at - low) / -rate : INFINITY;
}

static void set_status_of_variable(fmb_glpk *g, int k, int status)
{
    int rows = glp_get_num_rows(g->lp);
    if (k <= rows)
        glp_set_row_stat(g->lp, k, status);
    else
        glp_set_col_stat(g->lp, k - rows, status);
}

/* Nonbasic variable k becomes basic: it moves, either way, until another one comes to an end; or a
 * free one takes its place. */
static void expel_variable(fmb_glpk *g, int k)
{
    if (glp_warm_up(g->lp) != 0)
        return;
    int size = glp_eval_tab_col(g->lp, k, g->index, g->value), leaving = 0, status = GLP_NF;
    double least = INFINITY, most = 0;
    for (int t = 1; t <= size; t++) {
        double weight = fabs(g->value[t]);
        if (weight < 1e-9)
            continue;
        for (int way = -1; way <= 1; way += 2) {
            double rate = way * g->value[t], room = find_room_of_variable(g, g->index[t], rate);
            bool is_free_column = room == INFINITY && g->index[t] > glp_get_num_rows(g->lp);
            if ((room == INFINITY && !is_free_column) || room > least ||
                (room == least && weight <= most))
                continue;
            leaving = g->index[t];
            least = room;
            most = weight;
            status = room == INFINITY ? GLP_NF : rate > 0 ? GLP_NU : GLP_NL;
        }
    }
    if (leaving == 0)
        return;
    set_status_of_variable(g, leaving, status);
    set_status_of_variable(g, k, GLP_BS);
}

/* The variable of GLPK that row i of the program bounds. */
static int variable_of_row(const fmb_glpk *g, size_t i)
{
    return g->row[i] > 0 ? g->row[i] : glp_get_num_rows(g->lp) + 1 + fmb_reals_columns(g->f, i)[0];
}

/* Does the basis hold row i? */
static bool is_tight_in_glpk(const fmb_glpk *g, size_t i)
{
    if (g->row[i] > 0)
        return glp_get_row_stat(g->lp, g->row[i]) != GLP_BS;
    size_t j = (size_t)fmb_reals_columns(g->f, i)[0];
    int status = glp_get_col_stat(g->lp, (int)j + 1);
    return status != GLP_BS && status != GLP_NF && (g->low[j] == i || g->high[j] == i);
}

/* A row that is left out leaves the basis before. */
static void switch_row_of_glpk(fmb_glpk *g)
{
    size_t i = g->which;
    bool off = g->f->off[i];
    if (off && is_tight_in_glpk(g, i))
        expel_variable(g, variable_of_row(g, i));
    g->feasible = g->feasible && off;
    if (g->row[i] > 0)
        load_bound_of_row(g, i);
    else
        load_bounds_of_column(g, (size_t)fmb_reals_columns(g->f, i)[0]);
}

static fmb_status switch_glpk(void *self, size_t i)
{
    fmb_glpk *g = self;
    g->which = i;
    call_glpk(g, switch_row_of_glpk);
    return FMB_OK;
}

static void load_all_bounds_again(fmb_glpk *g)
{
    g->feasible = false;
    for (size_t i = 0; i < g->m; i++)
        if (g->row[i] > 0)
            load_bound_of_row(g, i);
    for (size_t j = 0; j < g->f->n; j++)
        load_bounds_of_column(g, j);
}

static void shift_glpk(void *self)
{
    call_glpk(self, load_all_bounds_again);
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
    g->feasible = false;
    for (int i = 1; i <= rows; i++)
        glp_set_row_stat(g->lp, i, GLP_BS);
    for (int j = 1; j <= n; j++)
        glp_set_col_stat(g->lp, j, GLP_BS);
    for (int r = 0; r < n; r++)
        set_nonbasic(g, g->basis[r]);
}

static fmb_status place_glpk(void *self, const size_t *basis)
{
    fmb_glpk *g = self;
    g->basis = basis;
    call_glpk(g, place_basis_in_glpk);
    return FMB_OK;
}

const fmb_door_side fmb_door_side_glpk = {open_glpk, close_glpk,  search_glpk, maximize_glpk,
                                          grow_glpk, switch_glpk, place_glpk,  shift_glpk};

#else

static fmb_status open_no_glpk(const fmb_reals *f, void **out)
{
    (void)f;
    *out = NULL;
    return FMB_OK;
}

const fmb_door_side fmb_door_side_glpk = {.open = open_no_glpk};

#endif
