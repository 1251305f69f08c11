/* six.c: the six systems of systems.c under all 64 sets of the six rules, with every arithmetic,
 * with histories started anew at once or when it pays, in all orders: the four that the library
 * chooses, each with every numbering of the variables, and every permutation that a caller can
 * choose. Each order takes a fifth of those in turn. Verdicts and projections are those of the
 * table, and all evidence is accepted. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "property/random/options.h"
#include "property/rules/mixes.h"
#include "systems.h"

/* What is asked again and again, with one numbering of the variables. */
typedef struct setting {
    const regress *r;
    truth t;
    fmb_system *shadow; /* the projection on variable keep, or NULL */
    int keep;
    const int *permutation; /* the order that the chooser follows, or NULL: options.order */
    agree g;
} setting;

static void expect(setting *w, const fmb_options *o, bool good)
{
    char text[200];
    options_text(o, text, sizeof text);
    cr_assert(good, "%s: %s: %s", w->r->name, text, w->g.why);
}

/* The first variable of the permutation that is still there. */
static int choose(void *self, const fmb_view *view, const int *col, size_t n)
{
    const setting *w = self;
    for (int k = 0; k < w->r->dim; k++)
        for (size_t i = 0; i < n; i++)
            if (fmb_view_variable(view, col[i]) == w->permutation[k])
                return col[i];
    return -1;
}

static void ask(setting *w, const fmb_options *o)
{
    fmb_solver *v = NULL;
    must(fmb_solver_new(o, NULL, &v));
    if (w->permutation)
        fmb_solver_set_chooser(v, (fmb_chooser){choose, w});
    expect(w, o, agree_solve(&w->g, v, &w->t));
    if (w->shadow) {
        fmb_system *p = NULL;
        expect(w, o, agree_project(&w->g, v, &w->t, &w->keep, 1, &p));
        expect(w, o, p && agree_same(&w->g, p, w->shadow));
        fmb_system_free(p);
    }
    fmb_solver_free(v);
}

/* All sets of rules, arithmetics and ways to re-base: every fifth, from where the last order ended.
 */
static void ask_all(setting *w, fmb_order order)
{
    static unsigned turn;
    fmb_options o = {.size = sizeof o};
    o.method = FMB_METHOD_FM;
    o.order = order;
    o.evidence = FMB_EVIDENCE_ALL;
    for (unsigned mix = 0; mix < MIX_SUBSETS; mix++) {
        o.rules = mix_text(mix, mix);
        for (int arith = FMB_ARITH_AUTO; arith <= FMB_ARITH_GMP; arith++)
            for (int rebase = FMB_REBASE_AUTO; rebase <= FMB_REBASE_ALWAYS; rebase++) {
                o.arith = (fmb_arith)arith;
                o.rebase = (fmb_rebase)rebase;
                o.presolve = mix % 2 == (unsigned)rebase ? "none" : NULL;
                if (turn++ % 5 == 0)
                    ask(w, &o);
            }
    }
}

/* Variable j of the table is variable place[j]. */
static void open_setting(setting *w, const regress *r, const int *place)
{
    *w = (setting){.r = r, .g = {.max_rows = 5000}};
    truth_init(&w->t, regress_build(r, place), w->g.max_rows);
    cr_assert_eq(w->t.verdict, r->verdict);
    if (r->keep >= 0) {
        int64_t a = r->shadow[0];
        w->keep = place[r->keep];
        w->shadow = rows_none(1);
        must(fmb_system_add_int(w->shadow, &a, r->shadow_rel, r->shadow[1]));
    }
}

static void close_setting(setting *w)
{
    fmb_system *s = (fmb_system *)w->t.s;
    cr_assert(w->g.unjudged == 0 && w->g.undecided == 0);
    truth_clear(&w->t);
    fmb_system_free(w->shadow);
    fmb_system_free(s);
}

static void renumbered(const regress *r, const int *place)
{
    setting w;
    open_setting(&w, r, place);
    for (int order = FMB_ORDER_PAIRS; order <= FMB_ORDER_FILL; order++)
        ask_all(&w, (fmb_order)order);
    close_setting(&w);
}

static void chosen(const regress *r, const int *permutation)
{
    static const int place[REGRESS_DIM] = {0, 1, 2, 3};
    setting w;
    open_setting(&w, r, place);
    w.permutation = permutation;
    ask_all(&w, FMB_ORDER_PAIRS);
    close_setting(&w);
}

/* Every permutation of p[done..dim). */
static void permute(const regress *r, int *p, int done, void (*visit)(const regress *, const int *))
{
    if (done == r->dim)
        visit(r, p);
    for (int j = done; j < r->dim && j < REGRESS_DIM; j++) {
        int keep = p[done];
        p[done] = p[j];
        p[j] = keep;
        permute(r, p, done + 1, visit);
        p[j] = p[done];
        p[done] = keep;
    }
}

static void every_set(int i, void (*visit)(const regress *, const int *))
{
    int p[REGRESS_DIM] = {0, 1, 2, 3};
    permute(&regress_systems[i], p, 0, visit);
}

/* Each system by itself, as they run side by side. */
Test(six, K)
{
    every_set(0, renumbered);
    every_set(0, chosen);
}

Test(six, D)
{
    every_set(1, renumbered);
    every_set(1, chosen);
}

Test(six, A)
{
    every_set(2, renumbered);
    every_set(2, chosen);
}

Test(six, A0)
{
    every_set(3, renumbered);
    every_set(3, chosen);
}

Test(six, B)
{
    every_set(4, renumbered);
    every_set(4, chosen);
}

Test(six, C)
{
    every_set(5, renumbered);
    every_set(5, chosen);
}
