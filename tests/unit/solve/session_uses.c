/* session_uses.c: applications of systems that change: cuts and dives; and their faults: arguments,
 * memory, limits. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/gmp.h>

#include "fault/hook.h"
#include "fresh.h"
#include "property/random/rows.h"
#include "support.h"

/* 0 <= x_j <= most */
static fmb_system *box_of(int n, int64_t most, const fmb_alloc *mem)
{
    fmb_system *s = NULL;
    must(fmb_system_new(n, mem, &s));
    for (int j = 0; j < n; j++) {
        int64_t a[16] = {0};
        a[j] = 1;
        must(fmb_system_add_int(s, a, FMB_LE, most));
        a[j] = -1;
        must(fmb_system_add_int(s, a, FMB_LE, 0));
    }
    return s;
}

static fmb_solver *load_box(int n, int64_t most)
{
    fmb_solver *v = open_solver(NULL);
    fmb_system *s = box_of(n, most, NULL);
    must(fmb_solver_load(v, s));
    fmb_system_free(s);
    return v;
}

/* ---- cuts ------------------------------------------------------------------------------------ */

/* x at the optimum of a.x; false: there is no solution. */
static bool find_optimum(fmb_solver *v, const double *a, mpq_t *x, int n)
{
    fmb_optimum *o = NULL;
    const fmb_system *s = fmb_solver_system(v);
    must(fmb_optimize(v, s, &(fmb_objective){.sense = FMB_SENSE_MAX, .coef = a}, &o, NULL));
    expect_proof(v, s);
    for (int j = 0; o && j < n; j++)
        fmb_optimum_coordinate_q(o, j, x[j]);
    fmb_optimum_free(o);
    return o != NULL;
}

/* a.x <= floor(a.x*) - 1 */
static void cut_off(fmb_solver *v, const double *a, mpq_t *x, int n)
{
    mpq_t sum, t;
    int64_t row[16];
    mpq_inits(sum, t, NULL);
    for (int j = 0; j < n; j++) {
        row[j] = (int64_t)a[j];
        mpq_set_d(t, a[j]);
        mpq_mul(t, t, x[j]);
        mpq_add(sum, sum, t);
    }
    double b = floor(mpq_get_d(sum)) - 1;
    must(fmb_solver_add_int(v, row, FMB_LE, (int64_t)b));
    mpq_clears(sum, t, NULL);
}

/* The optimum of a random form is cut off, 74 times one after another; then there is nothing left.
 */
Test(session, seventy_four_cuts)
{
    enum { N = 8 };
    fmb_solver *v = load_box(N, 1000);
    support_rng g = {74};
    double a[N];
    mpq_t x[N];
    for (int j = 0; j < N; j++)
        mpq_init(x[j]);
    for (int k = 0; k < 74; k++) {
        for (int j = 0; j < N; j++)
            a[j] = support_between(&g, 1, 20);
        cr_assert(find_optimum(v, a, x, N));
        cut_off(v, a, x, N);
        cr_assert_eq(expect_as_fresh(v, k % 10 == 0 ? ALL_QUESTIONS : VERDICT), FMB_FEASIBLE);
    }
    for (int j = 0; j < N; j++)
        a[j] = -1;
    for (int j = 0; j < N; j++)
        mpq_set_ui(x[j], 0, 1);
    cut_off(v, a, x, N);
    must(fmb_solver_set_right(v, 1, -1000));
    cr_assert_eq(expect_as_fresh(v, VERDICT), FMB_FEASIBLE);
    must(fmb_solver_add_int(v, (int64_t[N]){1}, FMB_LT, 1000));
    cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_INFEASIBLE);
    for (int j = 0; j < N; j++)
        mpq_clear(x[j]);
    fmb_solver_free(v);
}

/* ---- dives ----------------------------------------------------------------------------------- */

typedef struct dive {
    fmb_solver *v;
    int n, nodes;
    double best;
    double form[16];
} dive;

static void bound_variable(fmb_solver *v, int j, int sign, int64_t b)
{
    int64_t a[16] = {0};
    a[j] = sign;
    must(fmb_solver_add_int(v, a, FMB_LE, sign * b));
}

/* The largest value of the form over integers. */
static void dive_for_integers(dive *d)
{
    fmb_optimum *o = NULL;
    const fmb_system *s = fmb_solver_system(d->v);
    d->nodes++;
    (void)expect_as_fresh(d->v, VERDICT);
    must(
        fmb_optimize(d->v, s, &(fmb_objective){.sense = FMB_SENSE_MAX, .coef = d->form}, &o, NULL));
    expect_proof(d->v, s);
    if (!o)
        return;
    int j = 0;
    double value = fmb_optimum_end(o).value, x = 0;
    for (; j < d->n; j++) {
        x = fmb_optimum_coordinate(o, j);
        if (fabs(x - round(x)) > 1e-9)
            break;
    }
    fmb_optimum_free(o);
    if (floor(value + 1e-9) <= d->best)
        return;
    if (j == d->n) {
        d->best = round(value);
        return;
    }
    for (int sign = 1; sign >= -1; sign -= 2) {
        must(fmb_solver_push(d->v));
        bound_variable(d->v, j, sign, (int64_t)(sign > 0 ? floor(x) : ceil(x)));
        dive_for_integers(d);
        must(fmb_solver_pop(d->v));
    }
}

/* max 5 x1 + 4 x2 + 3 x3 + 7 x4 over 0 <= x <= 3, by trying all. */
static double try_all(const double *form, int64_t (*row)[4], const int64_t *right, int rows)
{
    double best = -1;
    for (int code = 0; code < 256; code++) {
        int x[4] = {code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6};
        bool fits = true;
        double value = 0;
        for (int i = 0; i < rows; i++) {
            int64_t sum = 0;
            for (int j = 0; j < 4; j++)
                sum += row[i][j] * x[j];
            fits = fits && sum <= right[i];
        }
        for (int j = 0; j < 4; j++)
            value += form[j] * x[j];
        best = fits && value > best ? value : best;
    }
    return best;
}

Test(session, dives)
{
    int64_t row[3][4] = {{2, 3, 1, 5}, {4, 1, 2, 3}, {3, 4, 2, 7}}, right[3] = {11, 13, 16};
    dive d = {.v = load_box(4, 3), .n = 4, .best = -1, .form = {5, 4, 3, 7}};
    for (int i = 0; i < 3; i++)
        must(fmb_solver_add_int(d.v, row[i], FMB_LE, right[i]));
    dive_for_integers(&d);
    cr_assert_gt(d.nodes, 3);
    cr_assert_eq(d.best, try_all(d.form, row, right, 3));
    cr_assert_eq(fmb_solver_pop(d.v), FMB_ERR_STATE);
    fmb_solver_free(d.v);
}

/* Rows that come and go again: what they leave behind does not add up. */
Test(session, many_rows_come_and_go)
{
    fmb_solver *v = load_box(6, 10);
    support_rng g = {6};
    size_t most = 0;
    for (int k = 0; k < 600; k++) {
        int64_t a[6];
        fmb_result r = {.size = sizeof r};
        for (int j = 0; j < 6; j++)
            a[j] = support_between(&g, -9, 9);
        must(fmb_solver_push(v));
        must(fmb_solver_add_int(v, a, FMB_LE, -1));
        must(fmb_solve(v, fmb_solver_system(v), &r));
        expect_proof(v, fmb_solver_system(v));
        must(fmb_solver_pop(v));
        most = k == 100 ? r.stats.bytes_peak : most;
        cr_assert(k <= 100 || r.stats.bytes_peak < 3 * most);
    }
    fmb_solver_free(v);
}

/* ---- every verb ------------------------------------------------------------------------------ */

/* Verbs that have no use for an oracle take it as they take any system. */
Test(session, other_verbs)
{
    fmb_solver *v = load_box(3, 5);
    fmb_system *shadow = NULL, *less = NULL;
    fmb_fate fate[7];
    must(fmb_solver_add(v, (double[]){0.5, 0.25, 1}, FMB_GE, 0.125));
    must(fmb_project(v, fmb_solver_system(v), (int[]){0, 1}, 2, &shadow, NULL));
    expect_proof(v, fmb_solver_system(v));
    must(fmb_reduce(v, fmb_solver_system(v), fate, &less, NULL));
    expect_proof(v, fmb_solver_system(v));
    cr_assert_eq(fmb_system_rows(shadow), 4);
    cr_assert_eq(fmb_system_rows(less), 7);
    (void)expect_as_fresh(v, ALL_QUESTIONS);
    fmb_system_free(shadow);
    fmb_system_free(less);
    fmb_solver_free(v);
}

/* A system of its own may be loaded again. */
Test(session, loaded_twice)
{
    fmb_solver *v = load_box(2, 5);
    must(fmb_solver_push(v));
    must(fmb_solver_load(v, fmb_solver_system(v)));
    cr_assert_eq(fmb_solver_pop(v), FMB_ERR_STATE);
    cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_FEASIBLE);
    fmb_solver_unload(v);
    cr_assert_null(fmb_solver_system(v));
    fmb_solver_unload(v);
    fmb_solver_free(v);
}

/* ---- arguments ------------------------------------------------------------------------------- */

Test(session, nothing_loaded)
{
    fmb_solver *v = open_solver(NULL);
    mpq_t one;
    mpq_init(one);
    for (int k = 0; k < 2; k++) {
        fmb_solver *w = k == 0 ? v : NULL;
        fmb_status expected = k == 0 ? FMB_ERR_STATE : FMB_ERR_ARG;
        cr_expect_null(fmb_solver_system(w));
        cr_expect_eq(fmb_solver_add(w, (double[]){1}, FMB_LE, 1), expected);
        cr_expect_eq(fmb_solver_add_int(w, (int64_t[]){1}, FMB_LE, 1), expected);
        cr_expect_eq(fmb_solver_add_q(w, 0, NULL, NULL, FMB_LE, one), expected);
        cr_expect_eq(fmb_solver_remove(w, 0), expected);
        cr_expect_eq(fmb_solver_set_right(w, 0, 1), expected);
        cr_expect_eq(fmb_solver_set_right_q(w, 0, one), expected);
        cr_expect_eq(fmb_solver_push(w), expected);
        cr_expect_eq(fmb_solver_pop(w), expected);
        fmb_solver_unload(w);
    }
    cr_expect_eq(fmb_solver_load(v, NULL), FMB_ERR_ARG);
    mpq_clear(one);
    fmb_solver_free(v);
}

Test(session, wrong_arguments)
{
    fmb_solver *v = load_box(2, 5);
    mpq_t broken;
    mpq_init(broken);
    mpz_set_ui(mpq_denref(broken), 0);
    cr_expect_eq(fmb_solver_load(v, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_load(NULL, fmb_solver_system(v)), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_add(v, NULL, FMB_LE, 1), FMB_ERR_ARG);
    cr_expect(strstr(fmb_solver_trouble(v), "NULL"));
    cr_expect_eq(fmb_solver_add(v, (double[]){1, NAN}, FMB_LE, 1), FMB_ERR_ARG);
    cr_expect(strstr(fmb_solver_trouble(v), "x2"));
    cr_expect_eq(fmb_solver_add_int(v, (int64_t[]){1, 1}, (fmb_rel)9, 1), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_add_q(v, 1, (int[]){2}, &broken, FMB_LE, broken), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_remove(v, 4), FMB_ERR_ARG);
    cr_expect(strstr(fmb_solver_trouble(v), "row is 4, but there are 4"));
    cr_expect_eq(fmb_solver_set_right(v, 4, 1), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_set_right(v, 0, INFINITY), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_set_right_q(v, 0, broken), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_set_right_q(v, 0, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_rows(fmb_solver_system(v)), 4);
    must(fmb_solver_remove(v, 3));
    cr_expect_str_eq(fmb_solver_trouble(v), "");
    mpz_set_ui(mpq_denref(broken), 1);
    mpq_clear(broken);
    fmb_solver_free(v);
}

/* ---- right sides ----------------------------------------------------------------------------- */

/* Right side b is given to row i: the row is kept with sign * b. */
static void expect_kept_right_side(fmb_solver *v, size_t i, double b, double sign)
{
    mpq_t q;
    mpq_init(q);
    must(fmb_solver_set_right(v, i, b));
    fmb_system_rhs_q(fmb_solver_system(v), i, q);
    cr_expect_eq(mpq_get_d(q), sign * b, "row %zu: %g", i, mpq_get_d(q));
    mpq_clear(q);
}

/* Rows of each relation, from a text, from another system and added, have their right sides set
 * twice and after a pop, in the direction in which they were given. */
Test(session, right_sides_keep_their_direction)
{
    static const char text[] = "x >= 1\nx > 1/3\nx <= 90\nx < 91\n2x + y >= 3 - y\n";
    static const double sign[] = {-1, -1, 1, 1, -1, -1, -1, 1};
    fmb_options o = {.size = sizeof o};
    fmb_system *read = NULL, *s = NULL;
    fmb_solver *v = NULL;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_system_parse(text, sizeof text - 1, NULL, &read, NULL));
    must(fmb_system_new(2, NULL, &s));
    must(fmb_system_join(s, read, NULL));
    must(fmb_solver_load(v, s));
    must(fmb_solver_add(v, (double[]){1, 0.5}, FMB_GE, 2));
    must(fmb_solver_add_int(v, (int64_t[]){1, 1}, FMB_GT, 2));
    must(fmb_solver_add_int(v, (int64_t[]){1, 1}, FMB_EQ, 40));
    for (size_t i = 0; i < sizeof sign / sizeof *sign; i++) {
        expect_kept_right_side(v, i, 6, sign[i]);
        must(fmb_solver_push(v));
        expect_kept_right_side(v, i, 7, sign[i]);
        expect_kept_right_side(v, i, -8.5, sign[i]);
        must(fmb_solver_pop(v));
        expect_kept_right_side(v, i, 5, sign[i]);
    }
    fmb_solver_free(v);
    fmb_system_free(read);
    fmb_system_free(s);
}

/* ---- memory ---------------------------------------------------------------------------------- */

typedef fmb_status step(fmb_solver *v);

static const int64_t CUT[] = {-3, 1, -2, 5, -4};

static fmb_status do_load(fmb_solver *v)
{
    fmb_system *s = box_of(5, 7, NULL);
    fmb_status st = fmb_solver_load(v, s);
    fmb_system_free(s);
    return st;
}
static fmb_status do_solve(fmb_solver *v)
{
    return fmb_solve(v, fmb_solver_system(v), NULL);
}
static fmb_status do_bound(fmb_solver *v)
{
    fmb_box *box = NULL;
    fmb_status st = fmb_bound(v, fmb_solver_system(v), NULL, 0, &box, NULL);
    fmb_box_free(box);
    return st;
}
static fmb_status do_cut(fmb_solver *v)
{
    return fmb_solver_add_int(v, CUT, FMB_LT, -9);
}
static fmb_status do_remove(fmb_solver *v)
{
    return fmb_solver_remove(v, 2);
}
static fmb_status do_shift(fmb_solver *v)
{
    return fmb_solver_set_right(v, 4, 6.5);
}
static fmb_status do_push(fmb_solver *v)
{
    return fmb_solver_push(v);
}
static fmb_status do_pop(fmb_solver *v)
{
    return fmb_solver_pop(v);
}

static step *const SCRIPT[] = {do_load,  do_cut, do_solve, do_push,  do_remove, do_shift,
                               do_solve, do_cut, do_bound, do_push,  do_shift,  do_cut,
                               do_bound, do_pop, do_solve, do_shift, do_pop,    do_bound};

/* The k-th request fails, in whichever step that is; the step is taken again. False: there are
 * fewer. */
static bool survives_request(size_t k)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_solver *v = open_solver(&mem);
    bool failed = false;
    hook_arm(&h, k, false);
    for (size_t i = 0; i < sizeof SCRIPT / sizeof *SCRIPT; i++) {
        size_t rows = fmb_system_rows(fmb_solver_system(v));
        fmb_status st = SCRIPT[i](v);
        if (st == FMB_OK)
            continue;
        cr_assert(st == FMB_ERR_MEMORY && !failed, "step %zu, request %zu", i, k);
        cr_assert_eq(fmb_system_rows(fmb_solver_system(v)), rows);
        failed = true;
        must(SCRIPT[i](v));
    }
    hook_calm(&h);
    cr_assert_eq(fmb_system_rows(fmb_solver_system(v)), 11);
    if (k / WATCHED % 8 == 0)
        cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_FEASIBLE);
    fmb_solver_free(v);
    cr_assert_eq(h.live, 0, "request %zu", k);
    return failed;
}

Test(session, memory)
{
    size_t k = 1;
    while (survives_request(k))
        k += WATCHED;
    cr_assert_gt(k, 100);
}

/* ---- limits ---------------------------------------------------------------------------------- */

static void cancel_at_program(void *self, const fmb_event *e)
{
    if (e->kind == FMB_EVENT_LP)
        fmb_solver_cancel(self);
}

/* A query that is cut short leaves a solver that answers the next one. */
Test(session, cancelled)
{
    fmb_solver *v = load_box(5, 7);
    fmb_result r = {.size = sizeof r};
    fmb_box *box = NULL;
    must(fmb_solver_add_int(v, CUT, FMB_LT, -9));
    for (int warm = 0; warm < 2; warm++) {
        fmb_solver_set_sink(v, (fmb_sink){cancel_at_program, v});
        must(fmb_bound(v, fmb_solver_system(v), NULL, 0, &box, &r));
        fmb_box_free(box);
        box = NULL;
        cr_assert_eq(r.stop, FMB_STOP_CANCELLED);
        expect_proof(v, fmb_solver_system(v));
        fmb_solver_set_sink(v, (fmb_sink){0});
        cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_FEASIBLE);
        must(fmb_solver_add_int(v, CUT, FMB_LT, -10));
    }
    fmb_solver_free(v);
}

/* Limits on bytes: too few for an oracle, and then a plain answer of others is still right. */
Test(session, bytes)
{
    for (size_t most = 1 << 10; most < 1 << 20; most *= 2) {
        fmb_options o = {.size = sizeof o};
        fmb_solver *v = NULL;
        fmb_system *s = box_of(5, 7, NULL);
        fmb_result r = {.size = sizeof r};
        o.evidence = FMB_EVIDENCE_ALL;
        o.max_bytes = most;
        must(fmb_solver_new(&o, NULL, &v));
        must(fmb_solver_load(v, s));
        must(fmb_solver_add_int(v, CUT, FMB_LT, -9));
        for (int k = 0; k < 2; k++) {
            must(fmb_solve(v, fmb_solver_system(v), &r));
            cr_assert(r.stop == FMB_STOP_BYTES ? r.verdict == FMB_UNKNOWN
                                               : r.verdict == FMB_FEASIBLE);
        }
        cr_assert(most < 1 << 18 || r.verdict == FMB_FEASIBLE);
        fmb_system_free(s);
        fmb_solver_free(v);
    }
}
