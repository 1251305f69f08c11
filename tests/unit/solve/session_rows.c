/* session_rows.c: handles and labels of rows, and variables, of systems that change, against a list
 * that undergoes the same changes, and against fresh solvers. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/gmp.h>

#include "fault/hook.h"
#include "fresh.h"
#include "property/random/rows.h"
#include "support.h"

enum { MOST_ROWS = 24, MOST_VARIABLES = 9, DEEPEST = 6, LABEL = 16 };

typedef struct model_row {
    fmb_row handle;
    char label[LABEL]; /* "": none */
} model_row;

typedef struct model {
    model_row row[MOST_ROWS];
    size_t rows;
    int variables;
} model;

typedef struct game {
    fmb_solver *v;
    support_rng g;
    model now, before[DEEPEST];
    int depth;
    fmb_row last; /* handle that was given */
} game;

/* ---- what must hold -------------------------------------------------------------------------- */

static size_t find_in_model(const model *m, fmb_row handle)
{
    for (size_t i = 0; i < m->rows; i++)
        if (m->row[i].handle == handle)
            return i;
    return SIZE_MAX;
}

static void expect_model(const game *p)
{
    const fmb_system *s = fmb_solver_system(p->v);
    cr_assert_eq(fmb_system_rows(s), p->now.rows);
    cr_assert_eq(fmb_system_dim(s), p->now.variables);
    for (size_t i = 0; i < p->now.rows; i++) {
        const char *label = fmb_system_label(s, i);
        cr_assert_eq(fmb_solver_row(p->v, i), p->now.row[i].handle);
        cr_assert_str_eq(label ? label : "", p->now.row[i].label);
    }
    for (fmb_row handle = 0; handle <= p->last + 1; handle++)
        cr_assert_eq(fmb_solver_row_number(p->v, handle), find_in_model(&p->now, handle));
    cr_assert_eq(fmb_solver_row(p->v, p->now.rows), 0u);
    cr_assert_eq(fmb_solver_last_row(p->v), p->now.rows ? p->now.row[p->now.rows - 1].handle : 0u);
}

/* The rows of a conflict, kept as handles: after rows before them have gone they still are in
 * conflict. */
static void expect_conflict_by_handles(game *p)
{
    fmb_row guilty[MOST_ROWS];
    size_t n = 0;
    fmb_result r = {.size = sizeof r};
    must(fmb_solve(p->v, fmb_solver_system(p->v), &r));
    if (r.verdict != FMB_INFEASIBLE)
        return;
    must(fmb_solver_conflict(p->v, &n));
    for (size_t k = 0; k < n; k++)
        guilty[k] = fmb_solver_row(p->v, fmb_solver_conflict_row(p->v, k));
    must(fmb_solver_push(p->v));
    for (size_t i = p->now.rows; i-- > 0;) {
        bool kept = false;
        for (size_t k = 0; k < n; k++)
            kept |= guilty[k] == fmb_solver_row(p->v, i);
        if (!kept)
            must(fmb_solver_remove(p->v, i));
    }
    cr_assert_eq(fmb_system_rows(fmb_solver_system(p->v)), n);
    cr_assert_eq(expect_as_fresh(p->v, VERDICT), FMB_INFEASIBLE);
    must(fmb_solver_remove(p->v, fmb_solver_row_number(p->v, guilty[n / 2])));
    cr_assert_eq(expect_as_fresh(p->v, VERDICT), FMB_FEASIBLE);
    must(fmb_solver_pop(p->v));
}

/* ---- changes --------------------------------------------------------------------------------- */

static void add_row(game *p)
{
    int64_t a[MOST_VARIABLES];
    if (p->now.rows == MOST_ROWS)
        return;
    for (int j = 0; j < p->now.variables; j++)
        a[j] = support_chance(&p->g, 50) ? support_between(&p->g, -3, 3) : 0;
    must(fmb_solver_add_int(p->v, a, support_chance(&p->g, 80) ? FMB_LE : FMB_GE,
                            support_between(&p->g, -2, 9)));
    fmb_row handle = fmb_solver_last_row(p->v);
    cr_assert_gt(handle, p->last, "no handle comes twice");
    p->last = handle;
    p->now.row[p->now.rows++] = (model_row){.handle = handle};
}

static void remove_row(game *p, size_t i)
{
    must(fmb_solver_remove(p->v, fmb_solver_row_number(p->v, p->now.row[i].handle)));
    p->now.rows--;
    memmove(&p->now.row[i], &p->now.row[i + 1], (p->now.rows - i) * sizeof *p->now.row);
}

static void label_row(game *p, size_t i)
{
    char label[LABEL] = "";
    if (support_chance(&p->g, 70))
        snprintf(label, sizeof label, "row%d", support_between(&p->g, 0, 99));
    must(fmb_solver_set_label(p->v, i, *label ? label : NULL));
    memcpy(p->now.row[i].label, label, sizeof label);
}

static void add_variable(game *p)
{
    int index = -1;
    char name[LABEL];
    if (p->now.variables == MOST_VARIABLES)
        return;
    snprintf(name, sizeof name, "new%d", p->now.variables);
    must(fmb_solver_add_variable(p->v, support_chance(&p->g, 50) ? name : NULL, &index));
    cr_assert_eq(index, p->now.variables++);
}

static void push_or_pop(game *p, bool push)
{
    if (push && p->depth < DEEPEST) {
        p->before[p->depth++] = p->now;
        must(fmb_solver_push(p->v));
    } else if (!push && p->depth > 0) {
        p->now = p->before[--p->depth];
        must(fmb_solver_pop(p->v));
    }
}

static void change_something(game *p)
{
    int what = support_between(&p->g, 0, 99);
    size_t i = p->now.rows ? (size_t)support_between(&p->g, 0, (int)p->now.rows - 1) : 0;
    if (what < 30)
        push_or_pop(p, what < 15);
    else if (what < 38)
        add_variable(p);
    else if (what < 65 || p->now.rows == 0)
        add_row(p);
    else if (what < 80)
        label_row(p, i);
    else if (what < 92)
        remove_row(p, i);
    else
        must(fmb_solver_set_right(p->v, i, support_between(&p->g, -9, 9)));
}

static void load_some(game *p)
{
    fmb_system *s = NULL;
    must(fmb_system_new(2, NULL, &s));
    must(fmb_system_add_int(s, (int64_t[]){1, 1}, FMB_LE, 4));
    must(fmb_system_set_label(s, 0, "cap"));
    must(fmb_solver_load(p->v, s));
    fmb_system_free(s);
    p->now = (model){.row = {{fmb_solver_row(p->v, 0), "cap"}}, .rows = 1, .variables = 2};
    cr_assert_gt(p->now.row[0].handle, p->last, "also of another system");
    p->last = p->now.row[0].handle;
    p->depth = 0;
}

Test(session_rows, against_a_list)
{
    int conflicts = 0, asked = 0;
    for (uint64_t seed = 0; seed < 12; seed++) {
        game p = {.v = open_solver(NULL), .g = {seed}};
        load_some(&p);
        for (int k = 0; k < 120; k++) {
            change_something(&p);
            expect_model(&p);
            if (!support_chance(&p.g, 25))
                continue;
            fmb_verdict verdict =
                expect_as_fresh(p.v, support_chance(&p.g, 30) ? ALL_QUESTIONS : VERDICT);
            asked++;
            conflicts += verdict == FMB_INFEASIBLE;
            if (verdict == FMB_INFEASIBLE)
                expect_conflict_by_handles(&p);
            expect_model(&p);
        }
        load_some(&p);
        expect_model(&p);
        fmb_solver_free(p.v);
    }
    cr_assert(conflicts > 20 && asked - conflicts > 20, "%d of %d", conflicts, asked);
}

/* ---- variables ------------------------------------------------------------------------------- */

/* x <= 4; then y, and x + y >= 9 and y <= 1; then neither; then another y. */
Test(session_rows, variables_come_and_go)
{
    fmb_solver *v = open_solver(NULL);
    fmb_system *s = NULL;
    int y = 0;
    must(fmb_system_new(1, NULL, &s));
    must(fmb_system_add_int(s, (int64_t[]){1}, FMB_LE, 4));
    must(fmb_solver_load(v, s));
    fmb_system_free(s);
    const fmb_system *now = fmb_solver_system(v);
    cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_FEASIBLE);
    for (int again = 0; again < 3; again++) {
        must(fmb_solver_push(v));
        must(fmb_solver_add_variable(v, "y", &y));
        cr_assert_eq(y, 1);
        cr_assert_eq(fmb_solver_add_variable(v, "y", NULL), FMB_ERR_ARG);
        cr_assert_not_null(strstr(fmb_solver_trouble(v), "\"y\" is taken"));
        cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_FEASIBLE);
        must(fmb_solver_add_int(v, (int64_t[]){1, 1}, FMB_GE, 9));
        cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_FEASIBLE);
        must(fmb_solver_add_int(v, (int64_t[]){0, 1}, FMB_LE, again));
        cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_INFEASIBLE);
        must(fmb_solver_pop(v));
        cr_assert_eq(fmb_system_dim(now), 1);
        cr_assert_eq(fmb_system_find(now, "y"), -1);
        cr_assert_eq(expect_as_fresh(v, ALL_QUESTIONS), FMB_FEASIBLE);
    }
    must(fmb_solver_add_variable(v, NULL, NULL));
    cr_assert_str_eq(fmb_system_name(now, 1), "x2");
    cr_assert_eq(fmb_solver_pop(v), FMB_ERR_STATE);
    fmb_solver_free(v);
}

/* ---- messages, arguments, memory ------------------------------------------------------------- */

Test(session_rows, messages_name_rows)
{
    game p = {.v = open_solver(NULL)};
    cr_expect_eq(fmb_solver_row(p.v, 0), 0u);
    cr_expect_eq(fmb_solver_last_row(p.v), 0u);
    cr_expect_eq(fmb_solver_row_number(p.v, 1), SIZE_MAX);
    cr_expect_eq(fmb_solver_set_label(p.v, 0, "a"), FMB_ERR_STATE);
    cr_expect_eq(fmb_solver_add_variable(p.v, NULL, NULL), FMB_ERR_STATE);
    load_some(&p);
    cr_expect_eq(fmb_solver_set_right(p.v, 0, NAN), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(p.v), "right side of row 0 (cap) is nan");
    must(fmb_solver_set_label(p.v, 0, NULL));
    cr_expect_eq(fmb_solver_set_right(p.v, 0, INFINITY), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(p.v), "right side of row 0 is infinite");
    cr_expect_eq(fmb_solver_set_label(p.v, 1, "a"), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_solver_trouble(p.v), "row is 1, but there are 1");
    fmb_solver_free(p.v);
}

/* Wherever memory ends, a change that fails changes nothing, and nothing leaks. */
Test(session_rows, memory_runs_out)
{
    for (size_t k = 1, failed = 1; failed; k++) {
        hook h = {0};
        fmb_alloc mem = hook_alloc(&h);
        game p = {.v = open_solver(&mem)};
        load_some(&p);
        must(fmb_solver_push(p.v));
        hook_arm(&h, k, false);
        fmb_status label = fmb_solver_set_label(p.v, 0, "another name");
        fmb_status variable = fmb_solver_add_variable(p.v, "z", NULL);
        hook_calm(&h);
        failed = label != FMB_OK || variable != FMB_OK;
        cr_assert(label == FMB_OK || label == FMB_ERR_MEMORY);
        cr_assert(variable == FMB_OK || variable == FMB_ERR_MEMORY);
        cr_assert_str_eq(fmb_system_label(fmb_solver_system(p.v), 0),
                         label == FMB_OK ? "another name" : "cap");
        cr_assert_eq(fmb_system_dim(fmb_solver_system(p.v)), variable == FMB_OK ? 3 : 2);
        must(fmb_solver_pop(p.v));
        expect_model(&p);
        fmb_solver_free(p.v);
        cr_assert_eq(h.live, 0u);
    }
}
