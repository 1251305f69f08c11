/* arguments.c: wrong arguments of the queries, and missing evidence. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/fmb.h>

#include "property/random/rows.h"

static fmb_solver *solver(bool evidence)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.evidence = evidence ? FMB_EVIDENCE_ALL : FMB_EVIDENCE_NONE;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

/* x1 + x2 + x3 <= 3 */
static fmb_system *triple(void)
{
    static const int64_t one[] = {1, 1, 1};
    fmb_system *s = rows_none(3);
    must(fmb_system_add_int(s, one, FMB_LE, 3));
    return s;
}

static const struct {
    int n, list[4];
} BAD[] = {{-1, {0}},      {1, {3}},          {1, {-1}},       {2, {1, 0}},      {2, {1, 1}},
           {3, {0, 2, 1}}, {4, {0, 1, 2, 3}}, {3, {-1, 0, 1}}, {2, {0, 1 << 30}}};

Test(arguments, project)
{
    fmb_solver *v = solver(true);
    fmb_system *s = triple(), *out = s;
    fmb_result r = {.size = sizeof r}, fresh = {.size = sizeof fresh};
    memset(&r, 0x5a, sizeof r);
    r.size = sizeof r;
    fresh = r;
    for (size_t i = 0; i < sizeof BAD / sizeof *BAD; i++) {
        cr_expect_eq(fmb_project(v, s, BAD[i].list, BAD[i].n, &out, &r), FMB_ERR_ARG, "%zu", i);
        cr_expect(out == s && memcmp(&r, &fresh, sizeof r) == 0);
    }
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* Onto nothing: a system of dimension 0 that says whether s is feasible. */
Test(arguments, project_on_nothing)
{
    fmb_solver *v = solver(true);
    fmb_system *s = triple(), *out = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_project(v, s, NULL, 0, &out, &r));
    cr_expect(fmb_system_dim(out) == 0 && fmb_system_rows(out) == 0);
    fmb_system_free(out);
    int64_t zero[3] = {0};
    must(fmb_system_add_int(s, zero, FMB_LT, 0));
    must(fmb_project(v, s, NULL, 0, &out, &r));
    cr_expect(fmb_system_dim(out) == 0 && fmb_system_rows(out) == 1);
    fmb_system_free(out);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* Names go along, and onto everything is reduction. */
Test(arguments, project_names)
{
    static const int keep[] = {0, 2};
    fmb_solver *v = solver(true);
    fmb_system *s = triple(), *out = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_system_set_name(s, 2, "height"));
    must(fmb_project(v, s, keep, 2, &out, &r));
    cr_expect_str_eq(fmb_system_name(out, 0), "x1");
    cr_expect_str_eq(fmb_system_name(out, 1), "height");
    fmb_system_free(out);
    fmb_system_free(s);
    fmb_solver_free(v);
}

Test(arguments, bound)
{
    fmb_solver *v = solver(true);
    fmb_system *s = triple();
    fmb_box *const mark = (fmb_box *)s, *box = mark;
    fmb_result r = {.size = sizeof r}, fresh = {.size = sizeof fresh};
    memset(&r, 0x5a, sizeof r);
    r.size = sizeof r;
    fresh = r;
    static const int bad[][2] = {{3, 0}, {-1, 0}, {0, 1 << 30}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        cr_expect_eq(fmb_bound(v, s, bad[i], 2, &box, &r), FMB_ERR_ARG, "%zu", i);
        cr_expect(box == mark && memcmp(&r, &fresh, sizeof r) == 0);
    }
    cr_expect_eq(fmb_bound(v, s, bad[0], -1, &box, &r), FMB_ERR_ARG);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* Only the variables asked for, in the order asked. */
Test(arguments, bound_some)
{
    static const int vars[] = {2, 0};
    static const int64_t low[] = {-1, 0, 0}, high[] = {0, 0, 2};
    fmb_solver *v = solver(true);
    fmb_system *s = triple();
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_system_add_int(s, low, FMB_LT, 1));
    must(fmb_system_add_int(s, high, FMB_LE, 5));
    must(fmb_bound(v, s, vars, 2, &box, &r));
    cr_assert_eq(fmb_box_size(box), 2);
    cr_expect(fmb_box_var(box, 0) == 2 && fmb_box_var(box, 1) == 0);
    fmb_end e = fmb_box_end(box, 0, FMB_UPPER);
    cr_expect(e.kind == FMB_END_FINITE && e.attained);
    cr_expect_float_eq(e.value, 2.5, 0);
    e = fmb_box_end(box, 1, FMB_LOWER);
    cr_expect(e.kind == FMB_END_FINITE && !e.attained);
    cr_expect_float_eq(e.value, -1, 0);
    cr_expect_eq(fmb_box_end(box, 0, FMB_LOWER).kind, FMB_END_INFINITE);
    cr_expect_eq(fmb_box_end(box, 1, FMB_UPPER).kind, FMB_END_INFINITE);
    fmb_box_free(box);
    fmb_system_free(s);
    fmb_solver_free(v);
}

static void expect_no_evidence(fmb_solver *v)
{
    fmb_evidence *const mark = (fmb_evidence *)&v, *e = mark;
    cr_expect_eq(fmb_solver_evidence(v, &e), FMB_ERR_STATE);
    cr_expect_eq(e, mark);
}

Test(arguments, evidence_state)
{
    fmb_system *s = triple();
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = solver(true);
    expect_no_evidence(v);
    must(fmb_solve(v, s, &r));
    fmb_evidence *e = NULL;
    cr_expect_eq(fmb_solver_evidence(v, &e), FMB_OK);
    cr_expect_eq(fmb_evidence_claims(e), 1);
    cr_expect_eq(fmb_evidence_kind(e, 0), FMB_CLAIM_FEASIBLE);
    cr_expect_eq(fmb_evidence_row(e, 0), SIZE_MAX);
    cr_expect_eq(fmb_evidence_var(e, 0), -1);
    fmb_evidence_free(e);
    fmb_solver_free(v);
    v = solver(false);
    must(fmb_solve(v, s, &r));
    cr_expect_eq(r.verdict, FMB_FEASIBLE);
    expect_no_evidence(v);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* Evidence is the caller's: it outlives the solver and later queries. */
Test(arguments, evidence_is_owned)
{
    static const int64_t zero[3] = {0};
    fmb_system *s = triple(), *bad = triple();
    fmb_evidence *e = NULL, *f = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = solver(true);
    must(fmb_system_add_int(bad, zero, FMB_LE, -1));
    must(fmb_solve(v, s, &r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_solve(v, bad, &r));
    must(fmb_solver_evidence(v, &f));
    fmb_solver_free(v);
    must(fmb_check(s, e, &j));
    cr_expect(j.accepted && j.verdict == FMB_FEASIBLE);
    must(fmb_check(bad, f, &j));
    cr_expect(j.accepted && j.verdict == FMB_INFEASIBLE);
    cr_expect_eq(fmb_check(s, f, &j), FMB_ERR_ARG);
    fmb_evidence_free(e);
    fmb_evidence_free(f);
    fmb_system_free(s);
    fmb_system_free(bad);
}

/* The system may be freed before its evidence and results are read. */
Test(arguments, results_are_owned)
{
    fmb_solver *v = solver(true);
    fmb_system *s = triple(), *out = NULL;
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_bound(v, s, NULL, 0, &box, &r));
    must(fmb_reduce(v, s, NULL, &out, &r));
    fmb_system_free(s);
    fmb_solver_free(v);
    cr_expect_eq(fmb_box_size(box), 3);
    cr_expect_eq(fmb_system_rows(out), 1);
    fmb_box_free(box);
    fmb_system_free(out);
}

/* ---- what is wrong --------------------------------------------------------------------------- */

static void expect_said(fmb_solver *v, fmb_status st, const char *why)
{
    cr_expect_eq(st, FMB_ERR_ARG, "%s", why);
    cr_expect_str_eq(fmb_solver_trouble(v), why);
}

/* No argument crashes, the message says which one is wrong, and the last answer is still there. */
Test(arguments, missing)
{
    fmb_solver *v = solver(true);
    fmb_system *s = triple(), *out = NULL;
    fmb_box *box = NULL;
    fmb_evidence *e = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_solve(v, s, NULL));
    cr_expect_str_empty(fmb_solver_trouble(v));
    expect_said(v, fmb_solve(v, NULL, &r), "s is NULL");
    expect_said(v, fmb_project(v, NULL, NULL, 0, &out, &r), "s is NULL");
    expect_said(v, fmb_project(v, s, NULL, 0, NULL, &r), "out is NULL");
    expect_said(v, fmb_project(v, s, NULL, 2, &out, &r), "keep is NULL, but n is 2");
    expect_said(v, fmb_bound(v, NULL, NULL, 0, &box, &r), "s is NULL");
    expect_said(v, fmb_bound(v, s, NULL, 0, NULL, &r), "out is NULL");
    expect_said(v, fmb_reduce(v, NULL, NULL, &out, &r), "s is NULL");
    expect_said(v, fmb_reduce(v, s, NULL, NULL, &r), "out is NULL");
    expect_said(v, fmb_solver_add_rule(v, NULL), "rule is NULL");
    expect_said(v, fmb_solver_add_rule(v, &(fmb_rule){.name = ""}), "the rule has no name");
    cr_expect_eq(fmb_solver_evidence(v, NULL), FMB_ERR_ARG);
    must(fmb_solver_evidence(v, &e));
    must(fmb_solve(v, s, &r));
    cr_expect_str_empty(fmb_solver_trouble(v));
    fmb_evidence_free(e);
    fmb_system_free(s);
    fmb_solver_free(v);
}

Test(arguments, no_solver)
{
    fmb_system *s = triple(), *out = NULL;
    fmb_box *box = NULL;
    fmb_evidence *e = NULL;
    fmb_result r = {.size = sizeof r};
    cr_expect_eq(fmb_solve(NULL, s, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_project(NULL, s, NULL, 0, &out, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_project(NULL, s, NULL, -1, &out, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_bound(NULL, s, NULL, 0, &box, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_reduce(NULL, s, NULL, &out, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_evidence(NULL, &e), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_add_rule(NULL, fmb_rule_at(0)), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_new(NULL, NULL, NULL), FMB_ERR_ARG);
    cr_expect_str_empty(fmb_solver_trouble(NULL));
    fmb_solver_cancel(NULL);
    fmb_solver_set_sink(NULL, (fmb_sink){0});
    fmb_solver_set_chooser(NULL, (fmb_chooser){0});
    cr_expect(!out && !box && !e);
    fmb_system_free(s);
}

Test(arguments, values)
{
    static const int far[] = {0, 7}, low[] = {-3}, back[] = {2, 0};
    fmb_solver *v = solver(true);
    fmb_system *s = triple(), *out = NULL;
    fmb_box *box = NULL;
    expect_said(v, fmb_project(v, s, far, 2, &out, NULL),
                "keep[1] is 7, but there are 3 variables");
    expect_said(v, fmb_project(v, s, back, 2, &out, NULL),
                "keep[1] is 0, after 2: they must increase");
    expect_said(v, fmb_project(v, s, far, -4, &out, NULL), "n is -4");
    expect_said(v, fmb_bound(v, s, far, 2, &box, NULL), "vars[1] is 7, but there are 3 variables");
    expect_said(v, fmb_bound(v, s, low, 1, &box, NULL), "vars[0] is -3, but there are 3 variables");
    expect_said(v, fmb_bound(v, s, NULL, -1, &box, NULL), "n is -1");
    fmb_system_free(s);
    fmb_solver_free(v);
}

enum { MOST_RULES = 100 }; /* more than a solver takes */

/* A rule that is in use, and one too many. */
Test(arguments, rules)
{
    fmb_rule extra[MOST_RULES];
    char name[MOST_RULES][16];
    fmb_solver *v = solver(true);
    cr_expect_eq(fmb_solver_add_rule(v, fmb_rule_find("kohler")), FMB_ERR_RULE);
    cr_expect_str_eq(fmb_solver_trouble(v), "rule \"kohler\" is in use");
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < MOST_RULES; i++) {
        snprintf(name[i], sizeof name[i], "r%d", i);
        extra[i] = (fmb_rule){.name = name[i]};
        st = fmb_solver_add_rule(v, &extra[i]);
        cr_expect(st != FMB_OK || fmb_solver_trouble(v)[0] == '\0');
    }
    cr_expect_eq(st, FMB_ERR_RULE);
    cr_expect(strncmp(fmb_solver_trouble(v), "more than ", 10) == 0);
    fmb_solver_free(v);
}

static int choose_nothing(void *self, const fmb_view *w, const int *col, size_t n)
{
    (void)self, (void)w, (void)col, (void)n;
    return -1;
}

Test(arguments, chooser)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_system *s = triple();
    o.method = FMB_METHOD_FM;
    must(fmb_solver_new(&o, NULL, &v));
    fmb_solver_set_chooser(v, (fmb_chooser){.choose = choose_nothing});
    cr_expect_eq(fmb_solve(v, s, NULL), FMB_ERR_ARG);
    cr_expect(strstr(fmb_solver_trouble(v), "chooser") != NULL);
    fmb_system_free(s);
    fmb_solver_free(v);
}

Test(arguments, null_frees)
{
    fmb_solver_free(NULL);
    fmb_box_free(NULL);
    fmb_evidence_free(NULL);
    fmb_system_free(NULL);
}
