/* fresh.c: see fresh.h. */
#include "fresh.h"

#include <criterion/criterion.h>

#include "property/random/rows.h"

fmb_solver *open_solver(const fmb_alloc *mem)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, mem, &v));
    return v;
}

void expect_proof(fmb_solver *v, const fmb_system *s)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_assert(j.accepted, "%s", j.reason);
    fmb_evidence_free(e);
}

static fmb_verdict ask_verdict(fmb_solver *v, const fmb_system *s)
{
    fmb_result r = {.size = sizeof r};
    must(fmb_solve(v, s, &r));
    expect_proof(v, s);
    return r.verdict;
}

static fmb_box *ask_box(fmb_solver *v, const fmb_system *s)
{
    fmb_box *box = NULL;
    must(fmb_bound(v, s, NULL, 0, &box, NULL));
    expect_proof(v, s);
    return box;
}

static void expect_same_boxes(const fmb_box *a, const fmb_box *b)
{
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    cr_assert_eq(a == NULL, b == NULL);
    for (int i = 0; i < fmb_box_size(a); i++)
        for (int side = 0; side < 2; side++) {
            fmb_end p = fmb_box_end(a, i, (fmb_side)side), q = fmb_box_end(b, i, (fmb_side)side);
            cr_assert_eq(p.kind, q.kind);
            cr_assert_eq(p.attained, q.attained);
            if (fmb_box_end_q(a, i, (fmb_side)side, x)) {
                cr_assert(fmb_box_end_q(b, i, (fmb_side)side, y));
                cr_assert(mpq_equal(x, y));
            }
        }
    mpq_clears(x, y, NULL);
}

static fmb_optimum *ask_optimum(fmb_solver *v, const fmb_system *s)
{
    double coef[64] = {0};
    fmb_optimum *o = NULL;
    for (int j = 0; j < fmb_system_dim(s) && j < 64; j++)
        coef[j] = (j + 1) * (j % 3 == 2 ? -1 : 1);
    must(fmb_optimize(v, s, &(fmb_objective){.sense = FMB_SENSE_MAX, .coef = coef}, &o, NULL));
    expect_proof(v, s);
    return o;
}

static void expect_same_optima(const fmb_optimum *a, const fmb_optimum *b)
{
    mpq_t x, y;
    cr_assert_eq(a == NULL, b == NULL);
    if (!a)
        return;
    mpq_inits(x, y, NULL);
    cr_assert_eq(fmb_optimum_end(a).kind, fmb_optimum_end(b).kind);
    cr_assert_eq(fmb_optimum_end(a).attained, fmb_optimum_end(b).attained);
    cr_assert_eq(fmb_optimum_value_q(a, x), fmb_optimum_value_q(b, y));
    cr_assert(mpq_equal(x, y));
    mpq_clears(x, y, NULL);
}

/* A fresh solver, asked about a copy, says the same. */
fmb_verdict expect_as_fresh(fmb_solver *v, questions ask)
{
    const fmb_system *s = fmb_solver_system(v);
    fmb_system *copy = NULL;
    fmb_solver *fresh = open_solver(NULL);
    must(fmb_system_copy(s, &copy));
    fmb_verdict verdict = ask_verdict(v, s);
    cr_assert_eq(verdict, ask_verdict(fresh, copy));
    if (ask == ALL_QUESTIONS) {
        fmb_box *a = ask_box(v, s), *b = ask_box(fresh, copy);
        expect_same_boxes(a, b);
        fmb_box_free(a);
        fmb_box_free(b);
        fmb_optimum *p = ask_optimum(v, s), *q = ask_optimum(fresh, copy);
        expect_same_optima(p, q);
        fmb_optimum_free(p);
        fmb_optimum_free(q);
    }
    fmb_solver_free(fresh);
    fmb_system_free(copy);
    return verdict;
}
