/* building.c: the k-th allocation fails while a system is built, changed and copied. */
#include <criterion/criterion.h>

#include "hook.h"
#include "property/random/rows.h"
#include "samples.h"

/* One step of building; step s of STEPS. */
static fmb_status step(fmb_system *s, int number)
{
    static const double real[] = {0.5, -0.25, 3};
    static const int64_t whole[] = {1, 0, INT64_MAX};
    int var[] = {2, 0, 2};
    mpq_t coef[3], b;
    fmb_status st = FMB_ERR_ARG;
    switch (number) {
    case 0:
        return fmb_system_add(s, real, FMB_LE, 0.1);
    case 1:
        return fmb_system_add_int(s, whole, FMB_EQ, INT64_MIN);
    case 2:
        return fmb_system_set_name(s, 1, "height");
    case 3:
        return fmb_system_set_label(s, 0, "cap");
    case 4:
        mpq_inits(coef[0], coef[1], coef[2], b, NULL);
        mpq_set_str(coef[0], "123456789012345678901234567890/7", 10);
        mpq_set_str(coef[1], "-1/3", 10);
        mpq_set_ui(coef[2], 5, 1);
        st = fmb_system_add_q(s, 3, var, coef, FMB_LT, b);
        mpq_clears(coef[0], coef[1], coef[2], b, NULL);
        return st;
    case 5:
        return fmb_system_set_label(s, 0, "a longer label than before");
    case 6:
        return fmb_system_set_objective(s, &(fmb_objective){FMB_SENSE_MAX, real, 0.1});
    case 7:
        return fmb_system_parse_objective(s, FMB_SENSE_MIN, "2 x3 + height/3 - 1e30", 22, NULL);
    case 8:
        return fmb_system_add_rows(s, 2, (size_t[]){0, 2, 4}, (int[]){0, 2, 2, 2},
                                   (double[]){1, 2, 0.1, 1e300}, NULL, (double[]){3, 4});
    case 9:
        return fmb_system_add_rows_int(s, 2, NULL, NULL, (int64_t[]){1, 2, 3, INT64_MIN, 5, 6},
                                       NULL, (int64_t[]){3, INT64_MAX});
    case 10:
        return fmb_system_add_terms(s, 1, var, real, FMB_GE, 1);
    case 11:
        return fmb_system_add_terms_int(s, 1, var, whole, FMB_EQ, 1);
    case 12:
        return fmb_system_set_objective_terms(s, FMB_SENSE_MIN, 3, var, real, 0.1);
    case 13:
        return fmb_system_add_terms_text(s, 2, var, (const char *const[]){"1e-30", "2/7"}, FMB_LE,
                                         "123456789012345678901234567890");
    default:
        return fmb_system_add_variable(s, "w", NULL);
    }
}

enum { STEPS = 15 };

static char *print(const fmb_system *s)
{
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    rows_print(s, f);
    must(fmb_system_write(s, FMB_FORMAT_TEXT, f)); /* the objective too */
    fprintf(f, "%s", fmb_system_rows(s) && fmb_system_label(s, 0) ? fmb_system_label(s, 0) : "");
    fclose(f);
    return text;
}

/* A step that fails leaves the system as it was; the next try succeeds. */
static void build(hook *h, size_t fail_at, size_t *calls)
{
    fmb_alloc mem = hook_alloc(h);
    fmb_system *s = NULL;
    must(fmb_system_new(3, &mem, &s));
    *calls = 0;
    for (int i = 0; i < STEPS; i++) {
        char *before = print(s);
        hook_arm(h, fail_at > *calls ? fail_at - *calls : 0, false);
        fmb_status st = step(s, i);
        *calls += h->calls;
        hook_calm(h);
        if (st != FMB_OK) {
            char *after = print(s);
            cr_assert_eq(st, FMB_ERR_MEMORY, "step %d: %s", i, fmb_status_text(st));
            cr_assert_str_eq(before, after, "step %d left its mark", i);
            must(step(s, i));
            free(after);
        }
        free(before);
    }
    cr_assert_eq(fmb_system_rows(s), 10);
    cr_assert_eq(fmb_system_sense(s), FMB_SENSE_MIN);
    cr_assert_eq(fmb_system_find(s, "height"), 1);
    cr_assert_eq(fmb_system_find(s, "w"), 3);
    cr_assert_str_eq(fmb_system_label(s, 0), "a longer label than before");
    fmb_system_free(s);
    cr_assert_eq(h->live, 0);
}

Test(building, steps)
{
    hook h = {0};
    size_t calls = 1;
    for (size_t k = 1; k <= calls; k++)
        build(&h, k, &calls);
}

Test(building, new_and_copy)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_system *const mark = (fmb_system *)&h, *s = mark, *t = mark;
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        hook_arm(&h, k, false);
        st = fmb_system_new(3, &mem, &s);
        cr_assert(st == FMB_OK || (st == FMB_ERR_MEMORY && s == mark && h.live == 0));
    }
    hook_calm(&h);
    for (int i = 0; i < STEPS; i++)
        must(step(s, i));
    fmb_system_set_kept(s, 1, true);
    size_t before = h.live;
    st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        hook_arm(&h, k, false);
        st = fmb_system_copy(s, &t);
        cr_assert(st == FMB_OK || (st == FMB_ERR_MEMORY && t == mark && h.live == before));
    }
    char *a = print(s), *b = print(t);
    cr_assert_str_eq(a, b);
    cr_assert(fmb_system_asks_projection(t) && fmb_system_is_kept(t, 1) &&
              !fmb_system_is_kept(t, 0));
    free(a);
    free(b);
    fmb_system_free(s);
    fmb_system_free(t);
    cr_assert_eq(h.live, 0);
}

/* A matrix of the rows: a failure leaves nothing behind. */
Test(building, matrix)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_matrix *const mark = (fmb_matrix *)&h, *m = mark;
    fmb_status st = FMB_ERR_MEMORY;
    fmb_system *s = sample(0, &mem);
    size_t before = h.live, tries = 0;
    for (; st != FMB_OK; tries++) {
        hook_arm(&h, tries + 1, false);
        st = fmb_system_matrix(s, &m);
        cr_assert(st == FMB_OK || (st == FMB_ERR_MEMORY && m == mark && h.live == before));
    }
    hook_calm(&h);
    cr_expect_gt(tries, 5);
    cr_expect_eq(m->rows, fmb_system_rows(s));
    fmb_system_free(s);
    fmb_matrix_free(m);
    cr_assert_eq(h.live, 0);
}

/* Evidence read from text: a failure leaves nothing behind. */
Test(building, evidence)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_evidence *const mark = (fmb_evidence *)&h, *e = NULL, *f = mark;
    char *text = NULL;
    size_t size = 0;
    fmb_system *s = sample(0, &mem);
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    must(fmb_solver_evidence(v, &e));
    FILE *out = open_memstream(&text, &size);
    must(fmb_evidence_write(e, s, out));
    fclose(out);
    size_t before = h.live;
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st != FMB_OK; k++) {
        FILE *in = fmemopen(text, size, "r");
        hook_arm(&h, k, false);
        st = fmb_evidence_read(in, s, &f, NULL);
        fclose(in);
        cr_assert(st == FMB_OK || (st == FMB_ERR_MEMORY && f == mark && h.live == before));
    }
    hook_calm(&h);
    fmb_judgement j = {.size = sizeof j};
    must(fmb_check(s, f, &j));
    cr_assert(j.accepted && j.verdict == FMB_FEASIBLE);
    fmb_evidence_free(e);
    fmb_evidence_free(f);
    fmb_solver_free(v);
    fmb_system_free(s);
    free(text);
    cr_assert_eq(h.live, 0);
}
