/* bounds.c: boxes by method fm: all together equal one by one, with less than half of the rows. */
#include <criterion/criterion.h>
#include <stdio.h>

#include "property/random/agree.h"
#include "support.h"

enum { DIM = 8 };

/* [give] Between two parallel planes in each of DIM directions that are nearly the axes. */
static fmb_system *cube(support_rng *g, int percent)
{
    fmb_system *s = rows_none(DIM);
    for (int i = 0; i < DIM; i++) {
        int64_t a[DIM], back[DIM];
        for (int j = 0; j < DIM; j++)
            a[j] = support_chance(g, percent) ? support_between(g, -2, 2) : 0;
        a[i] = 3;
        for (int j = 0; j < DIM; j++)
            back[j] = -a[j];
        must(fmb_system_add_int(s, a, FMB_LE, support_between(g, 3, 9)));
        must(fmb_system_add_int(s, back, FMB_LE, support_between(g, 3, 9)));
    }
    return s;
}

/* [give] A box, and rows that name two variables. */
static fmb_system *cut_box(support_rng *g, int cuts)
{
    fmb_system *s = rows_none(DIM);
    for (int i = 0; i < 2 * DIM; i++) {
        int64_t a[DIM] = {0};
        a[i / 2] = i % 2 ? 1 : -1;
        must(fmb_system_add_int(s, a, FMB_LE, support_between(g, 5, 20)));
    }
    for (int i = 0; i < cuts; i++) {
        int64_t a[DIM] = {0};
        a[support_between(g, 0, DIM - 1)] = support_between(g, 1, 2);
        a[support_between(g, 0, DIM - 1)] = -support_between(g, 1, 3);
        must(fmb_system_add_int(s, a, support_chance(g, 20) ? FMB_LT : FMB_LE,
                                support_between(g, 1, 10)));
    }
    return s;
}

static fmb_solver *solver(void)
{
    fmb_solver *v = NULL;
    fmb_options o = {.size = sizeof o};
    o.method = FMB_METHOD_FM;
    must(fmb_solver_new(&o, NULL, &v));
    return v;
}

static bool same_ends(const fmb_box *a, int i, const fmb_box *b, int k)
{
    bool same = true;
    mpq_t p, q;
    mpq_inits(p, q, NULL);
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        fmb_end x = fmb_box_end(a, i, (fmb_side)side), y = fmb_box_end(b, k, (fmb_side)side);
        same = same && x.kind == y.kind && x.attained == y.attained &&
               fmb_box_end_q(a, i, (fmb_side)side, p) == fmb_box_end_q(b, k, (fmb_side)side, q) &&
               mpq_equal(p, q);
    }
    mpq_clears(p, q, NULL);
    return same;
}

/* Rows combined for the box: all at once, and variable by variable; without the decision, which
 * every query begins with. */
typedef struct cost {
    uint64_t together, apart;
} cost;

static cost compare(const fmb_system *s)
{
    fmb_solver *v = solver();
    fmb_result r = {.size = sizeof r};
    fmb_box *all = NULL;
    cost c = {0};
    must(fmb_solve(v, s, &r));
    cr_assert_eq(r.verdict, FMB_FEASIBLE);
    uint64_t decision = r.stats.rows_made;
    must(fmb_bound(v, s, NULL, 0, &all, &r));
    c.together = r.stats.rows_made - decision;
    for (int j = 0; j < DIM; j++) {
        fmb_box *one = NULL;
        must(fmb_bound(v, s, &j, 1, &one, &r));
        c.apart += r.stats.rows_made - decision;
        cr_assert(same_ends(all, j, one, 0), "x%d", j + 1);
        fmb_box_free(one);
    }
    fmb_box_free(all);
    fmb_solver_free(v);
    return c;
}

static void print_cost(const char *name, const cost *c)
{
    printf("%s: %llu rows for all variables at once, %llu one by one (%.0f %%)\n", name,
           (unsigned long long)c->together, (unsigned long long)c->apart,
           100 * (double)c->together / (double)c->apart);
}

static void add(cost *sum, fmb_system *s)
{
    cost c = compare(s);
    sum->together += c.together;
    sum->apart += c.apart;
    fmb_system_free(s);
}

Test(bounds, fewer_rows)
{
    support_rng g = {7};
    cost slanted = {0}, cut = {0};
    for (int i = 0; i < 24; i++) {
        add(&slanted, cube(&g, 25 + 2 * i));
        add(&cut, cut_box(&g, 8 + i / 4));
    }
    print_cost("slanted cubes", &slanted);
    print_cost("boxes with cuts", &cut);
    cr_expect_lt(2 * cut.together, cut.apart);
    cr_expect_lt(2 * (slanted.together + cut.together), slanted.apart + cut.apart);
}

/* ---- in every way ---------------------------------------------------------------------------- */

static void keep_text(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    char **text = state;
    (void)w, (void)i, (void)drop;
    if (!*text)
        *text = calloc(1, 1);
}

static void drop_text(void *state)
{
    char **text = state;
    free(*text);
}

/* A rule with a state of its own, which cannot be copied. */
static const fmb_rule OWNER = {.name = "owner",
                               .source = "none",
                               .state_bytes = sizeof(char *),
                               .drop_pairs = keep_text,
                               .clear = drop_text};

static void expect_agreement(const fmb_options *o, const fmb_rule *rule, uint64_t seed)
{
    agree g = {.max_rows = 2000};
    support_case c =
        support_make((support_family)(seed % SUPPORT_FAMILIES), seed, &(support_shape){5, 9, 0});
    fmb_solver *v = NULL;
    truth t;
    truth_init(&t, c.s, g.max_rows);
    must(fmb_solver_new(o, NULL, &v));
    if (rule)
        must(fmb_solver_add_rule(v, rule));
    cr_assert(agree_bound(&g, v, &t), "seed %llu: %s", (unsigned long long)seed, g.why);
    fmb_solver_free(v);
    truth_clear(&t);
    support_case_clear(&c);
}

Test(bounds, in_every_way)
{
    static const char *const rules[] = {"none", "kohler", "imbert,dominated", "lp", NULL};
    for (uint64_t seed = 0; seed < 300 / WATCHED; seed++) {
        fmb_options o = {.size = sizeof o};
        o.method = FMB_METHOD_FM;
        o.evidence = FMB_EVIDENCE_ALL;
        o.order = (fmb_order)(seed % 4);
        o.arith = seed % 3 ? FMB_ARITH_INT : FMB_ARITH_GMP;
        o.rebase = seed % 2 ? FMB_REBASE_ALWAYS : FMB_REBASE_AUTO;
        o.rules = rules[seed % 5];
        o.presolve = seed % 7 ? NULL : "none";
        expect_agreement(&o, seed % 11 ? NULL : &OWNER, seed);
    }
}

/* A variable that is asked for twice, in another order, and one that no row names. */
Test(bounds, any_list)
{
    support_rng g = {11};
    static const int vars[] = {5, 2, 8, 5};
    fmb_system *s = rows_none(DIM + 1);
    fmb_system *t = cut_box(&g, 12);
    rows_append_but(s, t, SIZE_MAX, NULL);
    fmb_solver *v = solver();
    fmb_box *all = NULL, *some = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_bound(v, s, NULL, 0, &all, &r));
    must(fmb_bound(v, s, vars, 4, &some, &r));
    for (int i = 0; i < 4; i++)
        cr_expect(fmb_box_var(some, i) == vars[i] && same_ends(some, i, all, vars[i]), "%d", i);
    cr_expect_eq(fmb_box_end(some, 2, FMB_UPPER).kind, FMB_END_INFINITE);
    fmb_box_free(all);
    fmb_box_free(some);
    fmb_solver_free(v);
    fmb_system_free(s);
    fmb_system_free(t);
}
