/* solver.c: rules and choosers of the user in a solver: refused ones and their error texts; limits
 * and failures inside a callback. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/gmp.h>

#include "counted_clock.h"
#include "fault/hook.h"
#include "property/random/rows.h"

static fmb_solver *open_solver(const char *rules, fmb_rebase rebase)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.method = FMB_METHOD_FM;
    o.rules = rules;
    o.rebase = rebase;
    must(fmb_solver_new(&o, NULL, &v));
    cr_assert_str_empty(fmb_solver_trouble(v));
    return v;
}

/* x + y + z <= 6, x - y <= 1, ... : a few rows that every query has to eliminate. */
static fmb_system *some(void)
{
    static const int64_t row[][4] = {{1, 1, 1, 6},   {1, -1, 0, 1},  {-1, 0, 1, 1}, {0, 1, -1, 1},
                                     {-1, -1, 0, 3}, {0, -1, -1, 3}, {1, 0, 1, 4},  {-1, 1, -1, 2}};
    fmb_system *s = rows_none(3);
    for (int i = 0; i < 8; i++)
        must(fmb_system_add_int(s, row[i], FMB_LE, row[i][3]));
    return s;
}

/* The four queries. On failure what they would give stays NULL. */
enum { SOLVE, PROJECT, BOUND, REDUCE, QUERIES };

static fmb_status ask(fmb_solver *v, const fmb_system *s, int query, fmb_result *r)
{
    static const int keep[] = {2};
    fmb_system *out = NULL;
    fmb_box *box = NULL;
    fmb_status st = FMB_OK;
    if (query == SOLVE)
        st = fmb_solve(v, s, r);
    if (query == PROJECT)
        st = fmb_project(v, s, keep, 1, &out, r);
    if (query == BOUND)
        st = fmb_bound(v, s, NULL, 0, &box, r);
    if (query == REDUCE)
        st = fmb_reduce(v, s, NULL, &out, r);
    cr_expect(st == FMB_OK || (!out && !box));
    fmb_system_free(out);
    fmb_box_free(box);
    return st;
}

/* Is every query, or every one but solve, refused with these two words in the reason, and the
 * solver good again for the one that is not? */
static void expect_trouble(fmb_solver *v, bool solve_too, const char *word, const char *other)
{
    fmb_system *s = some();
    fmb_result r = {.size = sizeof r};
    for (int query = SOLVE; query < QUERIES; query++) {
        bool refused = query != SOLVE || solve_too;
        cr_expect_eq(ask(v, s, query, &r), refused ? FMB_ERR_RULE : FMB_OK, "query %d", query);
        const char *why = fmb_solver_trouble(v);
        if (refused)
            cr_expect(strstr(why, word) && strstr(why, other), "query %d: '%s'", query, why);
        else
            cr_expect_str_empty(why);
    }
    cr_expect_eq(ask(v, s, SOLVE, &r), solve_too ? FMB_ERR_RULE : FMB_OK);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* ---- which rules go together ----------------------------------------------------------------- */

Test(rules, are_found_by_name)
{
    cr_assert_str_eq(fmb_rule_find("kohler")->name, "kohler");
    cr_assert_null(fmb_rule_find("kohle"));
    cr_assert_null(fmb_rule_find("kohler,"));
    cr_assert_null(fmb_rule_find(NULL));
    for (size_t i = 0; fmb_rule_at(i); i++)
        cr_assert_eq(fmb_rule_find(fmb_rule_at(i)->name), fmb_rule_at(i));
    cr_assert_null(fmb_rule_at(SIZE_MAX));
}

/* The source of each built-in rule is a key of the bibliography. */
Test(rules, sources_are_known)
{
    FILE *f = fopen(REFERENCES, "r");
    cr_assert_not_null(f);
    char text[1 << 16];
    size_t size = fread(text, 1, sizeof text - 1, f);
    fclose(f);
    text[size] = '\0';
    for (size_t i = 0; fmb_rule_at(i); i++) {
        char key[64];
        snprintf(key, sizeof key, "{%s,\n", fmb_rule_at(i)->source);
        cr_expect_not_null(strstr(text, key), "%s", key);
    }
}

Test(rules, never_rebase)
{
    expect_trouble(open_solver(NULL, FMB_REBASE_NEVER), true, "\"kohler\"", "\"duplicate\"");
    expect_trouble(open_solver("dominated,imbert", FMB_REBASE_NEVER), true, "\"imbert\"",
                   "\"dominated\"");
    static const char *const good[] = {"none", "kohler,chernikov,imbert,box", "duplicate,dominated",
                                       "box,duplicate,lp"};
    fmb_system *s = some();
    for (int i = 0; i < 4; i++) {
        fmb_solver *v = open_solver(good[i], FMB_REBASE_NEVER);
        for (int query = SOLVE; query < QUERIES; query++) {
            fmb_result r = {.size = sizeof r};
            cr_expect_eq(ask(v, s, query, &r), FMB_OK, "%s", good[i]);
        }
        fmb_solver_free(v);
    }
    fmb_system_free(s);
}

static const fmb_rule verdict_only = {.name = "verdict", .flags = FMB_RULE_VERDICT_ONLY};
static const fmb_rule one_base = {.name = "lonely",
                                  .flags = FMB_RULE_NEEDS_HISTORY | FMB_RULE_ONE_BASE};

Test(rules, verdict_only)
{
    fmb_solver *v = open_solver("kohler", FMB_REBASE_AUTO);
    must(fmb_solver_add_rule(v, &verdict_only));
    expect_trouble(v, false, "\"verdict\"", "verdict only");
}

Test(rules, one_base)
{
    fmb_solver *v = open_solver("duplicate", FMB_REBASE_AUTO);
    must(fmb_solver_add_rule(v, &one_base));
    expect_trouble(v, true, "\"lonely\"", "\"duplicate\"");
    fmb_system *s = some();
    fmb_result r = {.size = sizeof r};
    v = open_solver("kohler,box", FMB_REBASE_AUTO);
    must(fmb_solver_add_rule(v, &one_base));
    for (int query = SOLVE; query < QUERIES; query++)
        cr_expect_eq(ask(v, s, query, &r), FMB_OK);
    fmb_solver_free(v);
    fmb_system_free(s);
}

Test(rules, add_rule)
{
    static const fmb_rule nameless = {.name = NULL}, empty = {.name = ""};
    static fmb_rule many[20];
    static char name[20][16];
    fmb_solver *v = open_solver("kohler", FMB_REBASE_AUTO);
    cr_expect_eq(fmb_solver_add_rule(v, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_add_rule(v, &nameless), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_add_rule(v, &empty), FMB_ERR_ARG);
    cr_expect_eq(fmb_solver_add_rule(v, fmb_rule_find("kohler")), FMB_ERR_RULE);
    int added = 0;
    for (int i = 0; i < 20; i++) {
        snprintf(name[i], sizeof name[i], "r%d", i);
        many[i] = (fmb_rule){.name = name[i]};
        added += fmb_solver_add_rule(v, &many[i]) == FMB_OK;
    }
    cr_expect_eq(added, 15, "sixteen rules in all");
    fmb_system *s = some();
    fmb_result r = {.size = sizeof r};
    cr_expect_eq(ask(v, s, SOLVE, &r), FMB_OK, "rules without callbacks do nothing");
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* ---- choosers -------------------------------------------------------------------------------- */

typedef struct whim {
    int answer; /* to give, or -2: the last candidate */
    int calls;
} whim;

static int choose(void *self, const fmb_view *w, const int *col, size_t n)
{
    whim *h = self;
    cr_expect_eq(fmb_view_column(w), -1);
    cr_expect_gt(n, 0);
    for (size_t i = 0; i < n; i++)
        cr_expect(col[i] >= 0 && col[i] < fmb_view_dim(w));
    h->calls++;
    return h->answer == -2 ? col[n - 1] : h->answer;
}

Test(chooser, bad_answers)
{
    static const int bad[] = {-1, 3, 1 << 30, -100};
    fmb_system *s = some();
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = open_solver(NULL, FMB_REBASE_AUTO);
    for (int i = 0; i < 4; i++) {
        whim h = {.answer = bad[i]};
        fmb_solver_set_chooser(v, (fmb_chooser){choose, &h});
        cr_expect_eq(ask(v, s, SOLVE, &r), FMB_ERR_ARG, "%d", bad[i]);
        cr_expect_eq(ask(v, s, PROJECT, &r), FMB_ERR_ARG, "%d", bad[i]);
        cr_expect_eq(h.calls, 2);
    }
    whim kept = {.answer = 2};
    fmb_solver_set_chooser(v, (fmb_chooser){choose, &kept});
    cr_expect_eq(ask(v, s, PROJECT, &r), FMB_ERR_ARG, "x3 is to be kept");
    fmb_solver_set_chooser(v, (fmb_chooser){NULL, NULL});
    cr_expect_eq(ask(v, s, SOLVE, &r), FMB_OK);
    cr_expect_eq(r.verdict, FMB_FEASIBLE);
    fmb_solver_free(v);
    fmb_system_free(s);
}

static void note_round(void *self, const fmb_event *e)
{
    int *last = self;
    if (e->kind == FMB_EVENT_ROUND)
        cr_expect_eq(e->var, *last ? --*last : 0, "from the last variable on");
}

Test(chooser, is_obeyed)
{
    fmb_system *s = some();
    fmb_result r = {.size = sizeof r};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    o.method = FMB_METHOD_FM;
    o.presolve = "none";
    must(fmb_solver_new(&o, NULL, &v));
    whim h = {.answer = -2};
    int last = 3;
    fmb_solver_set_chooser(v, (fmb_chooser){choose, &h});
    fmb_solver_set_sink(v, (fmb_sink){note_round, &last});
    cr_expect_eq(ask(v, s, SOLVE, &r), FMB_OK);
    cr_expect_eq(h.calls, 2, "there is no choice of one");
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* The variable of the highest number: a pairing, where the equality of the test has none of it. */
static int choose_last(void *self, const fmb_view *w, const int *col, size_t n)
{
    int *offered = self, best = 0;
    for (size_t i = 1; i < n; i++)
        if (fmb_view_variable(w, col[i]) > fmb_view_variable(w, col[best]))
            best = (int)i;
    *offered = *offered == 0 ? (int)n : *offered;
    return col[best];
}

typedef struct bases {
    bool paired;
    int anew; /* histories started again after pairs */
} bases;

static void count_bases(void *self, const fmb_event *e)
{
    bases *b = self;
    b->paired |= e->kind == FMB_EVENT_ROUND && e->pairs > 0;
    b->anew += e->kind == FMB_EVENT_REBASE && b->paired;
}

/* Re-bases of a query about x1 = x2 and bounds around x3, x4 and x5, which the chooser takes first
 * if it may. *offered: columns at its first choice. */
static int rebases_beside(const fmb_rule *rule, int *offered)
{
    static const int64_t row[][6] = {{1, 0, 1, 0, 0, 3},  {-1, 0, -1, 1, 0, 2},
                                     {0, 1, 0, -1, 1, 4}, {0, -1, 1, 0, -1, 5},
                                     {0, 0, -1, 1, 1, 6}, {0, 0, 0, 0, -1, 1}};
    fmb_system *s = NULL;
    fmb_solver *v = open_solver("none", FMB_REBASE_AUTO);
    fmb_result r = {.size = sizeof r};
    bases b = {0};
    must(fmb_system_new(5, NULL, &s));
    must(fmb_system_add_int(s, (const int64_t[]){1, -1, 0, 0, 0}, FMB_EQ, 0));
    for (int i = 0; i < 6; i++)
        must(fmb_system_add_int(s, row[i], FMB_LE, row[i][5]));
    must(fmb_solver_add_rule(v, rule));
    *offered = 0;
    fmb_solver_set_chooser(v, (fmb_chooser){choose_last, offered});
    fmb_solver_set_sink(v, (fmb_sink){count_bases, &b});
    cr_expect_eq(ask(v, s, SOLVE, &r), FMB_OK);
    cr_expect_eq(r.verdict, FMB_FEASIBLE);
    fmb_solver_free(v);
    fmb_system_free(s);
    return b.anew;
}

/* Pairs before the equality is used up are what makes histories start anew. */
Test(chooser, beside_a_rule_of_one_base)
{
    static const fmb_rule many_bases = {.name = "many", .flags = FMB_RULE_NEEDS_HISTORY};
    int offered;
    cr_expect_gt(rebases_beside(&many_bases, &offered), 0, "else the test says nothing");
    cr_expect_eq(offered, 5);
    cr_expect_eq(rebases_beside(&one_base, &offered), 0);
    cr_expect_eq(offered, 2, "columns of the equality only");
}

/* ---- callbacks that fail --------------------------------------------------------------------- */

static size_t scratch_size;

static fmb_status want(const fmb_view *w)
{
    char *p = fmb_view_scratch(w, scratch_size);
    if (!p)
        return FMB_ERR_MEMORY;
    cr_expect_eq((uintptr_t)p % 16, 0);
    memset(p, 0x5a, scratch_size);
    return FMB_OK;
}

static void pairs_want(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    (void)state, (void)i, (void)drop;
    (void)want(w);
}

static bool row_wants(void *state, const fmb_view *w, size_t row)
{
    (void)state, (void)row;
    return want(w) != FMB_OK;
}

static fmb_status round_wants(void *state, const fmb_view *w, bool *drop)
{
    (void)state, (void)drop;
    return want(w);
}

static const fmb_rule wanting[] = {{.name = "pairs", .drop_pairs = pairs_want},
                                   {.name = "row", .drop_row = row_wants},
                                   {.name = "round", .end_round = round_wants}};

/* More than the limit: undecided; more than there is: no memory; and then all is well again. */
Test(scratch, limits)
{
    hook h = {0};
    fmb_alloc alloc = hook_alloc(&h);
    fmb_system *s = some();
    for (int k = 0; k < 3; k++)
        for (int query = SOLVE; query <= PROJECT; query++) {
            fmb_options o = {.size = sizeof o};
            fmb_solver *v = NULL;
            fmb_result r = {.size = sizeof r};
            o.method = FMB_METHOD_FM;
            o.rules = "none";
            o.max_bytes = 1 << 20;
            must(fmb_solver_new(&o, &alloc, &v));
            must(fmb_solver_add_rule(v, &wanting[k]));
            scratch_size = 2 << 20;
            cr_expect_eq(ask(v, s, query, &r), FMB_OK);
            cr_expect(r.verdict == (query == SOLVE ? FMB_UNKNOWN : FMB_FEASIBLE) &&
                          r.stop == FMB_STOP_BYTES,
                      "%s: %s, %s", wanting[k].name, fmb_verdict_text(r.verdict),
                      fmb_stop_text(r.stop));
            scratch_size = SIZE_MAX;
            cr_expect_eq(ask(v, s, query, &r), FMB_ERR_MEMORY, "%s", wanting[k].name);
            scratch_size = 1000;
            cr_expect_eq(ask(v, s, query, &r), FMB_OK);
            cr_expect(r.verdict == FMB_FEASIBLE && r.stop == FMB_STOP_DONE);
            fmb_solver_free(v);
            cr_expect_eq(h.live, 0);
        }
    fmb_system_free(s);
}

/* Every request for memory fails once: each callback gets its NULL. */
Test(scratch, failures)
{
    fmb_system *s = some();
    scratch_size = 100;
    for (int k = 0; k < 3; k++) {
        hook h = {0};
        fmb_alloc alloc = hook_alloc(&h);
        fmb_options o = {.size = sizeof o};
        fmb_solver *v = NULL;
        fmb_result r = {.size = sizeof r};
        o.method = FMB_METHOD_FM;
        must(fmb_solver_new(&o, &alloc, &v));
        must(fmb_solver_add_rule(v, &wanting[k]));
        fmb_status st = FMB_ERR_MEMORY;
        for (size_t at = 1; st == FMB_ERR_MEMORY; at++) {
            hook_arm(&h, at, false);
            st = ask(v, s, SOLVE, &r);
            cr_assert(st == FMB_ERR_MEMORY || st == FMB_OK, "%s, request %zu: %s", wanting[k].name,
                      at, fmb_status_text(st));
        }
        cr_expect_eq(r.verdict, FMB_FEASIBLE);
        hook_calm(&h);
        fmb_solver_free(v);
        cr_expect_eq(h.live, 0);
    }
    fmb_system_free(s);
}

/* What a rule returns is what the query returns. */
static fmb_status give_up(void *state, const fmb_view *w, bool *drop)
{
    (void)state, (void)w, (void)drop;
    return FMB_ERR_STATE;
}

/* Rules that go on until they are told to stop, in each of the callbacks. */
static void pairs_for_ever(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    (void)state, (void)i, (void)drop;
    while (!fmb_view_stop(w))
        continue;
}

static bool row_for_ever(void *state, const fmb_view *w, size_t row)
{
    (void)state, (void)row;
    while (!fmb_view_stop(w))
        continue;
    return true;
}

static fmb_status round_for_ever(void *state, const fmb_view *w, bool *drop)
{
    (void)state;
    while (!fmb_view_stop(w))
        continue;
    drop[0] = true;
    return FMB_OK;
}

Test(rules, stop_when_told)
{
    static const fmb_rule endless[] = {{.name = "pairs", .drop_pairs = pairs_for_ever},
                                       {.name = "row", .drop_row = row_for_ever},
                                       {.name = "round", .end_round = round_for_ever}};
    fmb_system *s = some();
    for (int i = 0; i < 3; i++) {
        fmb_options o = {.size = sizeof o};
        fmb_solver *v = NULL;
        fmb_result r = {.size = sizeof r};
        o.method = FMB_METHOD_FM;
        o.max_seconds = 100;
        must(fmb_solver_new(&o, NULL, &v));
        must(fmb_solver_add_rule(v, &endless[i]));
        counted_clock_start(0, NULL, NULL);
        fmb_status st = ask(v, s, SOLVE, &r);
        counted_clock_stop();
        cr_expect_eq(st, FMB_OK);
        cr_expect(r.stop == FMB_STOP_TIME && r.verdict == FMB_UNKNOWN, "%s", endless[i].name);
        fmb_solver_free(v);
    }
    fmb_system_free(s);
}

Test(rules, errors_arrive)
{
    static const fmb_rule tired = {.name = "tired", .end_round = give_up};
    fmb_system *s = some();
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = open_solver("none", FMB_REBASE_AUTO);
    must(fmb_solver_add_rule(v, &tired));
    cr_expect_eq(ask(v, s, SOLVE, &r), FMB_ERR_STATE);
    fmb_solver_free(v);
    fmb_system_free(s);
}
