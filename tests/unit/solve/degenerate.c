/* degenerate.c: systems without rows or variables, of constant rows, of equalities only. */
#include <criterion/criterion.h>
#include <math.h>

#include "property/random/agree.h"
#include "property/random/options.h"

/* Everything about one system, under every option. */
static void expect_truth(const fmb_system *s, fmb_verdict verdict)
{
    truth t;
    agree g = {.max_rows = 1000};
    truth_init(&t, s, g.max_rows);
    cr_assert_eq(t.verdict, verdict);
    for (int i = 0; i < options_count(); i += WATCHED) {
        fmb_options o = options_at(i);
        fmb_solver *v = NULL;
        must(fmb_solver_new(&o, NULL, &v));
        bool good = agree_solve(&g, v, &t) && agree_bound(&g, v, &t) &&
                    agree_reduce(&g, v, &t, NULL) && agree_project(&g, v, &t, NULL, 0, NULL);
        cr_assert(good, "%s", g.why);
        fmb_solver_free(v);
    }
    truth_clear(&t);
}

static fmb_system *constants(int dim, fmb_rel rel, int64_t b)
{
    static const int64_t zero[8] = {0};
    fmb_system *s = rows_none(dim);
    must(fmb_system_add_int(s, zero, rel, b));
    return s;
}

Test(degenerate, no_variables_no_rows)
{
    fmb_system *s = rows_none(0);
    expect_truth(s, FMB_FEASIBLE);
    fmb_system_free(s);
}

Test(degenerate, no_rows)
{
    fmb_system *s = rows_none(3);
    expect_truth(s, FMB_FEASIBLE);
    fmb_system_free(s);
}

Test(degenerate, constant_rows)
{
    static const struct {
        fmb_rel rel;
        int64_t b;
        fmb_verdict verdict;
    } table[] = {{FMB_LE, 0, FMB_FEASIBLE},    {FMB_LE, 1, FMB_FEASIBLE},
                 {FMB_LE, -1, FMB_INFEASIBLE}, {FMB_LT, 0, FMB_INFEASIBLE},
                 {FMB_LT, 1, FMB_FEASIBLE},    {FMB_LT, -1, FMB_INFEASIBLE},
                 {FMB_EQ, 0, FMB_FEASIBLE},    {FMB_EQ, 1, FMB_INFEASIBLE}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        for (int dim = 0; dim < 3; dim++) {
            fmb_system *s = constants(dim, table[i].rel, table[i].b);
            expect_truth(s, table[i].verdict);
            fmb_system_free(s);
        }
}

/* A constant row beside rows that say something. */
Test(degenerate, mixed)
{
    static const int64_t a[] = {1, -2}, b[] = {-1, 0};
    for (int bad = 0; bad < 2; bad++) {
        fmb_system *s = constants(2, FMB_LE, bad ? -1 : 1);
        must(fmb_system_add_int(s, a, FMB_EQ, 7));
        must(fmb_system_add_int(s, b, FMB_LT, 0));
        must(fmb_system_add_int(s, b, FMB_LT, 0));
        expect_truth(s, bad ? FMB_INFEASIBLE : FMB_FEASIBLE);
        fmb_system_free(s);
    }
}

/* Equalities only: a point, a line, a contradiction, one said twice. */
Test(degenerate, equalities)
{
    static const int64_t row[][4] = {
        {1, 1, 1, 6}, {1, -1, 0, 0}, {2, 0, 1, 6}, {0, 0, 1, 2}, {0, 0, 2, 5}};
    fmb_system *s = rows_none(3);
    for (int i = 0; i < 5; i++) {
        must(fmb_system_add_int(s, row[i], FMB_EQ, row[i][3]));
        expect_truth(s, i < 4 ? FMB_FEASIBLE : FMB_INFEASIBLE);
    }
    fmb_system_free(s);
}
