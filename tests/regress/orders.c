/* orders.c: the systems of systems.c in every order of elimination, under every set of rules,
 * arithmetic and method: the answers stand, and every piece of evidence is accepted. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "property/random/options.h"
#include "systems.h"

/* The answers that the table gives. */
static void expect_table(agree *g, fmb_solver *v, const regress *r, const fmb_system *s,
                         const int *place)
{
    fmb_result result = {.size = sizeof result};
    must(fmb_solve(v, s, &result));
    cr_assert_eq(result.verdict, r->verdict, "%s: %s", r->name, fmb_verdict_text(result.verdict));
    if (r->keep < 0)
        return;
    fmb_system *p = NULL, *shadow = rows_none(1);
    int64_t a = r->shadow[0];
    must(fmb_system_add_int(shadow, &a, r->shadow_rel, r->shadow[1]));
    must(fmb_project(v, s, &place[r->keep], 1, &p, &result));
    cr_assert(p && agree_same(g, p, shadow), "%s: the projection is wrong", r->name);
    fmb_system_free(p);
    fmb_system_free(shadow);
}

static void expect_agreement(agree *g, fmb_solver *v, const regress *r, const truth *t)
{
    bool good = agree_solve(g, v, t) && agree_bound(g, v, t) && agree_reduce(g, v, t, NULL);
    for (int j = 0; good && j < r->dim; j++)
        good = agree_project(g, v, t, &j, 1, NULL);
    cr_assert(good, "%s: %s", r->name, g->why);
}

/* One numbering of the variables: the order "given" then eliminates in this order. Every third set
 * of options, from where the last numbering ended. */
static void try_place(agree *g, const regress *r, const int *place)
{
    static int turn;
    fmb_system *s = regress_build(r, place);
    truth t;
    truth_init(&t, s, g->max_rows);
    cr_assert_eq(t.verdict, r->verdict);
    for (int i = 0; i < options_count(); i++) {
        if (turn++ % 3 > 0)
            continue;
        fmb_options o = options_at(i);
        fmb_solver *v = NULL;
        must(fmb_solver_new(&o, NULL, &v));
        expect_table(g, v, r, s, place);
        expect_agreement(g, v, r, &t);
        fmb_solver_free(v);
    }
    truth_clear(&t);
    fmb_system_free(s);
}

/* Every permutation of place[done..dim). */
static void permute(agree *g, const regress *r, int *place, int done)
{
    if (done == r->dim)
        try_place(g, r, place);
    for (int j = done; j < r->dim && j < REGRESS_DIM; j++) {
        int keep = place[done];
        place[done] = place[j];
        place[j] = keep;
        permute(g, r, place, done + 1);
        place[j] = place[done];
        place[done] = keep;
    }
}

static void every_order(int i)
{
    int place[REGRESS_DIM] = {0, 1, 2, 3};
    agree g = {.max_rows = 5000};
    permute(&g, &regress_systems[i], place, 0);
    cr_assert_eq(g.unjudged, 0);
    cr_assert_eq(g.undecided, 0);
}

Test(regress, K)
{
    every_order(0);
}

Test(regress, D)
{
    every_order(1);
}

Test(regress, A)
{
    every_order(2);
}

Test(regress, A0)
{
    every_order(3);
}

Test(regress, B)
{
    every_order(4);
}

Test(regress, C)
{
    every_order(5);
}
