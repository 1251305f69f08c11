/* fmplex.c: FMplex against the ground truth; every point and every multiplier is checked here on
 * the rows of the user, in rationals, by independent code. */
#include <criterion/criterion.h>

#include "counted_clock.h"
#include "dense.h"
#include "fault/hook.h"
#include "regress/systems.h"
#include "study/fmplex/fmplex.h"
#include "study/textbook/exact.h"
#include "support/must.h"

/* A system as FMplex takes it, and what it answered. */
typedef struct bench {
    fmb_mem mem;
    fmb_arena arena;
    fmb_run run;
    atomic_int cancel;
    dense d;
    fmb_vec *row;
    bool feasible;
    mpq_t *x;
    fmb_weights w;
} bench;

/* Row i times the least number that makes it integer. */
static void load_row(bench *b, int i)
{
    size_t n = (size_t)b->d.dim + 1;
    mpz_t *z = calloc(n, sizeof *z), scale;
    mpz_init_set_ui(scale, 1);
    for (size_t j = 0; j < n; j++)
        mpz_lcm(scale, scale, mpq_denref(dense_row(&b->d, i)[j]));
    for (size_t j = 0; j < n; j++) {
        mpq_ptr from = dense_row(&b->d, i)[j];
        mpz_init(z[j]);
        mpz_divexact(z[j], scale, mpq_denref(from));
        mpz_mul(z[j], z[j], mpq_numref(from));
        mpq_set_z(from, z[j]);
    }
    b->row[i].s = calloc(n, sizeof *b->row[i].s);
    cr_assert_eq(fmb_vec_set_z(&b->row[i], n, z, &b->mem), FMB_OK);
    for (size_t j = 0; j < n; j++)
        mpz_clear(z[j]);
    mpz_clear(scale);
    free(z);
}

static void open_bench(bench *b, const fmb_system *s, const fmb_alloc *alloc)
{
    *b = (bench){.d = dense_of(s)};
    fmb_mem_init(&b->mem, alloc, 0);
    fmb_arena_init(&b->arena, &b->mem);
    b->row = calloc((size_t)b->d.rows + 1, sizeof *b->row);
    b->x = calloc((size_t)b->d.dim + 1, sizeof *b->x);
    for (int i = 0; i < b->d.rows; i++)
        load_row(b, i);
    for (int j = 0; j < b->d.dim; j++)
        mpq_init(b->x[j]);
}

static fmb_status ask(bench *b, const fmb_options *o)
{
    fmb_weights_clear(&b->w, &b->mem);
    fmb_run_begin(&b->run, &b->mem, o, &b->cancel, (fmb_sink){0}, "test");
    fmb_status st = study_fmplex_decide(&b->run, &b->arena, b->d.dim, (size_t)b->d.rows, b->row,
                                        b->d.rel, o, &b->feasible, b->x, &b->w);
    b->mem.limit = 0;
    fmb_arena_reset(&b->arena);
    return st;
}

static void close_bench(bench *b)
{
    fmb_weights_clear(&b->w, &b->mem);
    for (int i = 0; i < b->d.rows; i++) {
        fmb_vec_clear(&b->row[i], (size_t)b->d.dim + 1, &b->mem);
        free(b->row[i].s);
    }
    for (int j = 0; j < b->d.dim; j++)
        mpq_clear(b->x[j]);
    free(b->row);
    free(b->x);
    fmb_arena_clear(&b->arena);
    cr_assert_eq(b->mem.used, 0, "%zu bytes are left", b->mem.used);
    dense_free(&b->d);
}

/* Does x satisfy every row? */
static bool point_holds(bench *b)
{
    bool good = true;
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (int i = 0; good && i < b->d.rows; i++) {
        mpq_set_ui(sum, 0, 1);
        for (int j = 0; j < b->d.dim; j++) {
            mpq_mul(t, dense_row(&b->d, i)[j], b->x[j]);
            mpq_add(sum, sum, t);
        }
        int order = mpq_cmp(sum, dense_rhs(&b->d, i));
        good = b->d.rel[i] == FMB_EQ ? order == 0 : b->d.rel[i] == FMB_LT ? order < 0 : order <= 0;
    }
    mpq_clears(sum, t, NULL);
    return good;
}

/* Do the multipliers have the right signs, and combine the rows to 0 <= negative or 0 < 0? */
static bool multipliers_hold(bench *b)
{
    bool good = b->w.size > 0, strict = false;
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (size_t k = 0; good && k < b->w.size; k++) {
        fmb_rel rel = b->d.rel[b->w.index[k]];
        int sign = mpq_sgn(b->w.value[k]);
        good = (int)b->w.index[k] < b->d.rows && (rel == FMB_EQ || sign > 0);
        strict = strict || rel == FMB_LT;
        for (size_t l = 0; l < k; l++)
            good = good && b->w.index[l] != b->w.index[k];
    }
    for (int j = 0; good && j <= b->d.dim; j++) {
        mpq_set_ui(sum, 0, 1);
        for (size_t k = 0; k < b->w.size; k++) {
            mpq_mul(t, dense_row(&b->d, (int)b->w.index[k])[j], b->w.value[k]);
            mpq_add(sum, sum, t);
        }
        int sign = mpq_sgn(sum);
        good = j < b->d.dim ? sign == 0 : sign < 0 || (sign == 0 && strict);
    }
    mpq_clears(sum, t, NULL);
    return good;
}

static const fmb_order orders[] = {FMB_ORDER_GIVEN, FMB_ORDER_PAIRS};
static const fmb_arith ariths[] = {FMB_ARITH_INT, FMB_ARITH_GMP};

/* Every way to ask gives this verdict (UNKNOWN: any), with evidence that holds. */
static fmb_verdict expect(const fmb_system *s, fmb_verdict verdict, const char *name)
{
    bench b;
    open_bench(&b, s, NULL);
    for (int way = 0; way < 4; way++) {
        fmb_options o = {.size = sizeof o};
        o.order = orders[way % 2];
        o.arith = ariths[way / 2];
        cr_assert_eq(ask(&b, &o), FMB_OK);
        fmb_verdict found = b.feasible ? FMB_FEASIBLE : FMB_INFEASIBLE;
        verdict = verdict == FMB_UNKNOWN ? found : verdict;
        cr_assert_eq(found, verdict, "%s, way %d", name, way);
        if (b.feasible)
            cr_assert(point_holds(&b), "%s, way %d: the point", name, way);
        else
            cr_assert(multipliers_hold(&b), "%s, way %d: the multipliers", name, way);
    }
    close_bench(&b);
    return verdict;
}

static void expect_rows(int dim, int rows, const int64_t *row, const fmb_rel *rel,
                        fmb_verdict verdict, const char *name)
{
    fmb_system *s = NULL;
    must(fmb_system_new(dim, NULL, &s));
    for (int i = 0; i < rows; i++, row += dim + 1)
        must(fmb_system_add_int(s, row, rel ? rel[i] : FMB_LE, row[dim]));
    expect(s, verdict, name);
    fmb_system_free(s);
}

Test(fmplex, systems_that_broke_others)
{
    for (int k = 0; k < regress_count; k++) {
        const regress *g = &regress_systems[k];
        int64_t row[REGRESS_ROWS * (REGRESS_DIM + 1)];
        for (int i = 0; i < g->rows; i++)
            for (int j = 0; j <= g->dim; j++)
                row[i * (g->dim + 1) + j] = g->row[i][j];
        expect_rows(g->dim, g->rows, row, NULL, g->verdict, g->name);
    }
}

Test(fmplex, strict_rows)
{
    static const struct {
        const char *name;
        int dim, rows;
        int64_t row[20];
        fmb_rel rel[5];
        fmb_verdict verdict;
    } cases[] = {
        {"x < 0, x >= 0", 1, 2, {1, 0, -1, 0}, {FMB_LT, FMB_LE}, FMB_INFEASIBLE},
        {"x <= 0, x >= 0", 1, 2, {1, 0, -1, 0}, {FMB_LE, FMB_LE}, FMB_FEASIBLE},
        {"0 < x < 1", 1, 2, {-1, 0, 1, 1}, {FMB_LT, FMB_LT}, FMB_FEASIBLE},
        {"equal bounds, one strict",
         1,
         3,
         {-1, -2, -1, -2, 1, 2},
         {FMB_LE, FMB_LT, FMB_LE},
         FMB_INFEASIBLE},
        {"y/2 <= x <= y, x > 0: a bound that only its own strictness refutes",
         2,
         3,
         {1, -1, 0, -2, 1, 0, -1, 0, 0},
         {FMB_LE, FMB_LE, FMB_LT},
         FMB_FEASIBLE},
        {"the same, closed by y <= 0",
         2,
         4,
         {1, -1, 0, -2, 1, 0, -1, 0, 0, 0, 1, 0},
         {FMB_LE, FMB_LE, FMB_LT, FMB_LE},
         FMB_INFEASIBLE},
        {"a thin wedge",
         2,
         3,
         {1, -1, 0, -1, 0, 0, 1000000, 1000000, 1},
         {FMB_LT, FMB_LT, FMB_LT},
         FMB_FEASIBLE},
        {"x = y, x < y", 2, 2, {1, -1, 0, 1, -1, 0}, {FMB_EQ, FMB_LT}, FMB_INFEASIBLE},
        {"0 < 0", 1, 1, {0, 0}, {FMB_LT}, FMB_INFEASIBLE},
        {"0 <= 0", 1, 1, {0, 0}, {FMB_LE}, FMB_FEASIBLE},
        {"0 = 1", 1, 1, {0, 1}, {FMB_EQ}, FMB_INFEASIBLE},
        {"0 = -1", 1, 1, {0, -1}, {FMB_EQ}, FMB_INFEASIBLE},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        expect_rows(cases[k].dim, cases[k].rows, cases[k].row, cases[k].rel, cases[k].verdict,
                    cases[k].name);
}

Test(fmplex, equalities)
{
    static const fmb_rel eq3[] = {FMB_EQ, FMB_EQ, FMB_EQ}, one[] = {FMB_EQ, FMB_LE, FMB_LE};
    static const int64_t square[] = {1, 1, 3, 1, -1, 1, 2, 0, 4},
                         off[] = {1, 1, 3, 1, -1, 1, 2, 0, 5},
                         above[] = {1, 1, 3, 1, -1, 1, 2, 0, 3},
                         slope[] = {2, -3, 1, -1, 0, -2, 0, 1, 1};
    expect_rows(2, 3, square, eq3, FMB_FEASIBLE, "three lines through a point");
    expect_rows(2, 3, off, eq3, FMB_INFEASIBLE, "a line too low");
    expect_rows(2, 3, above, eq3, FMB_INFEASIBLE, "a line too high");
    expect_rows(2, 3, slope, one, FMB_FEASIBLE, "a line and a quarter plane");
}

Test(fmplex, no_rows_no_variables)
{
    fmb_system *s = NULL;
    must(fmb_system_new(0, NULL, &s));
    expect(s, FMB_FEASIBLE, "nothing");
    must(fmb_system_add_int(s, NULL, FMB_LE, -1));
    expect(s, FMB_INFEASIBLE, "0 <= -1");
    fmb_system_free(s);
    must(fmb_system_new(3, NULL, &s));
    expect(s, FMB_FEASIBLE, "no rows");
    fmb_system_free(s);
}

Test(fmplex, random_systems)
{
    int verdicts[3] = {0};
    for (uint64_t seed = 1; seed <= 4000 / WATCHED; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case c = support_make(family, seed, NULL);
            fmb_verdict truth = FMB_UNKNOWN;
            char name[80];
            snprintf(name, sizeof name, "%s %lu", support_family_name(family), (unsigned long)seed);
            cr_assert_eq(study_textbook_solve(c.s, 5000, &truth), FMB_OK);
            verdicts[truth]++;
            expect(c.s, truth, name);
            support_case_clear(&c);
        }
    cr_assert(verdicts[FMB_FEASIBLE] > 1000 / WATCHED && verdicts[FMB_INFEASIBLE] > 1000 / WATCHED);
}

Test(fmplex, all_tiny_systems)
{
    support_tiny at = {0};
    fmb_system *s;
    for (int i = 0; (s = support_tiny_next(&at)); i++) {
        fmb_verdict truth = FMB_UNKNOWN;
        char name[20];
        snprintf(name, sizeof name, "%d", i);
        if (i % WATCHED == 0) {
            cr_assert_eq(study_textbook_solve(s, 5000, &truth), FMB_OK);
            expect(s, truth, name);
        }
        fmb_system_free(s);
    }
}

/* Where plain elimination would drown. */
Test(fmplex, deep_branching)
{
    for (uint64_t seed = 1; seed <= 60; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_shape shape = {.dim = 6 + (int)(seed % 5), .rows = 20 + (int)(seed % 11)};
            support_case c = support_make(family, seed, &shape);
            expect(c.s, support_proved_verdict(c.s), support_family_name(family));
            support_case_clear(&c);
        }
}

/* A system for which many nodes are tried. */
static support_case hard(void)
{
    support_shape shape = {.dim = 10, .rows = 30};
    return support_make(SUPPORT_PLANTED_POINT, 23, &shape);
}

Test(fmplex, memory_follows_the_depth)
{
    support_case c = hard();
    bench b;
    fmb_options o = {.size = sizeof o};
    open_bench(&b, c.s, NULL);
    cr_assert_eq(ask(&b, &o), FMB_OK);
    size_t levels = (size_t)b.d.dim + 1, most = levels * (size_t)b.d.rows;
    cr_assert_gt(b.run.stats.rounds, 2 * levels, "more nodes than a path has");
    cr_assert_leq(b.run.stats.rows_peak, most);
    cr_assert_gt(b.run.stats.rows_made, b.run.stats.rows_peak);
    close_bench(&b);
    support_case_clear(&c);
}

/* With a limit the answer is right, or a limit; with none of it afterwards, right. */
static fmb_stop limited(bench *b, const fmb_options *o)
{
    fmb_status st = ask(b, o);
    if (st == FMB_LIMIT)
        return b->mem.over && b->run.stop == FMB_STOP_DONE ? FMB_STOP_BYTES : b->run.stop;
    cr_assert_eq(st, FMB_OK);
    cr_assert(b->feasible ? point_holds(b) : multipliers_hold(b));
    return FMB_STOP_DONE;
}

Test(fmplex, limits)
{
    support_case c = hard();
    bench b;
    open_bench(&b, c.s, NULL);
    for (int way = 0; way < 2; way++) {
        fmb_options o = {.size = sizeof o};
        o.arith = ariths[way];
        o.max_rows = 40;
        cr_assert_eq(limited(&b, &o), FMB_STOP_ROWS);
        o.max_rows = 0;
        o.max_seconds = 1;
        counted_clock_start(0, NULL, NULL);
        fmb_stop late = limited(&b, &o);
        counted_clock_stop();
        cr_assert_eq(late, FMB_STOP_TIME);
        o.max_seconds = 0;
        atomic_store(&b.cancel, 1);
        cr_assert_eq(limited(&b, &o), FMB_STOP_CANCELLED);
        atomic_store(&b.cancel, 0);
        fmb_arena_clear(&b.arena);
        size_t least = b.mem.used;
        for (size_t more = 0;; more += 1024) {
            fmb_arena_clear(&b.arena);
            o.max_bytes = least + more;
            fmb_stop stop = limited(&b, &o);
            if (stop == FMB_STOP_DONE)
                break;
            cr_assert_eq(stop, FMB_STOP_BYTES);
            cr_assert_lt(more, (size_t)1 << 22);
        }
        o.max_bytes = 0;
        cr_assert_eq(limited(&b, &o), FMB_STOP_DONE);
    }
    close_bench(&b);
    support_case_clear(&c);
}

Test(fmplex, every_allocation_fails_once)
{
    support_shape shape = {.dim = 5, .rows = 12, .bits = 200};
    for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
        support_case c = support_make(family, 3, &shape);
        hook h = {0};
        fmb_alloc alloc = hook_alloc(&h);
        fmb_options o = {.size = sizeof o};
        fmb_status st = FMB_ERR_MEMORY;
        for (size_t at = 1; st != FMB_OK; at++) {
            bench b;
            open_bench(&b, c.s, &alloc);
            hook_arm(&h, at, false);
            st = ask(&b, &o);
            cr_assert(st == FMB_OK || (st == FMB_ERR_MEMORY && h.calls >= at));
            hook_calm(&h);
            close_bench(&b);
        }
        support_case_clear(&c);
    }
}

/* ---- the door: parts, claims, limits ----------------------------------------------------------
 */

/* The verdict on s; what it claims is checked. UNKNOWN: a limit was reached. */
static fmb_status solve(const fmb_system *s, const fmb_options *o, const fmb_alloc *alloc,
                        fmb_result *r)
{
    fmb_solver *v = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement found = {.size = sizeof found};
    fmb_status st = fmb_solver_new(o, alloc, &v);
    if (st == FMB_OK)
        st = study_fmplex_solve(v, s, r);
    if (st == FMB_OK)
        st = fmb_solver_evidence(v, &e);
    if (st == FMB_OK && r->verdict != FMB_UNKNOWN) {
        st = fmb_check(s, e, &found);
        cr_assert(st != FMB_OK || (found.accepted && found.verdict == r->verdict),
                  "the evidence is rejected");
    }
    fmb_evidence_free(e);
    fmb_solver_free(v);
    return st;
}

/* Two systems side by side: no row names variables of both. */
static fmb_system *beside(const fmb_system *a, const fmb_system *b)
{
    dense from[2] = {dense_of(a), dense_of(b)};
    dense to = dense_new(from[0].dim + from[1].dim, from[0].rows + from[1].rows);
    for (int k = 0, row = 0; k < 2; k++)
        for (int i = 0; i < from[k].rows; i++, row++) {
            for (int j = 0; j < from[k].dim; j++)
                mpq_set(dense_row(&to, row)[k * from[0].dim + j], dense_row(&from[k], i)[j]);
            mpq_set(dense_rhs(&to, row), dense_rhs(&from[k], i));
            to.rel[row] = from[k].rel[i];
        }
    fmb_system *s = dense_system(&to);
    dense_free(&to);
    dense_free(&from[0]);
    dense_free(&from[1]);
    return s;
}

Test(fmplex, parts_and_claims)
{
    fmb_options o = {.size = sizeof o};
    int verdicts[3] = {0};
    o.evidence = FMB_EVIDENCE_ALL;
    for (uint64_t seed = 1; seed <= 200; seed++)
        for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
            support_case a = support_make(family, seed, NULL);
            support_case b = support_make((family + seed) % SUPPORT_FAMILIES, seed + 1, NULL);
            fmb_system *s = beside(a.s, b.s);
            fmb_result r = {.size = sizeof r};
            must(solve(s, &o, NULL, &r));
            cr_assert_eq(r.verdict, support_proved_verdict(s), "seed %lu", (unsigned long)seed);
            verdicts[r.verdict]++;
            fmb_system_free(s);
            support_case_clear(&a);
            support_case_clear(&b);
        }
    cr_assert(verdicts[FMB_FEASIBLE] > 100 && verdicts[FMB_INFEASIBLE] > 100);
}

Test(fmplex, a_limit_is_a_result)
{
    support_case c = hard();
    fmb_options o = {.size = sizeof o};
    fmb_result r = {.size = sizeof r};
    o.evidence = FMB_EVIDENCE_ALL;
    o.max_rows = 40;
    must(solve(c.s, &o, NULL, &r));
    cr_assert(r.verdict == FMB_UNKNOWN && r.stop == FMB_STOP_ROWS);
    o.max_rows = 0;
    o.max_bytes = 1;
    must(solve(c.s, &o, NULL, &r));
    cr_assert(r.verdict == FMB_UNKNOWN && r.stop == FMB_STOP_BYTES);
    support_case_clear(&c);
}

Test(fmplex, every_allocation_of_a_query_fails_once)
{
    for (support_family family = 0; family < SUPPORT_FAMILIES; family++) {
        support_case c = support_make(family, 5, NULL);
        hook h = {0};
        fmb_alloc alloc = hook_alloc(&h);
        fmb_options o = {.size = sizeof o};
        fmb_status st = FMB_ERR_MEMORY;
        fmb_result r = {.size = sizeof r};
        o.evidence = FMB_EVIDENCE_ALL;
        for (size_t at = 1; st != FMB_OK; at++) {
            hook_arm(&h, at, false);
            st = solve(c.s, &o, &alloc, &r);
            cr_assert(h.live == 0 && (st == FMB_OK || (st == FMB_ERR_MEMORY && h.calls >= at)));
        }
        support_case_clear(&c);
    }
}
