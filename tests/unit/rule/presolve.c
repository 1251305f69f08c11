/* presolve.c: without each step, with each step alone, with none and all: the same answers as the
 * ground truth; and every choice of re-basing. */
#include <criterion/criterion.h>

#include "property/random/agree.h"
#include "support.h"

static const char *const STEPS[] = {NULL,
                                    "none",
                                    "equalities",
                                    "components",
                                    "onesided",
                                    "bounds",
                                    "refute",
                                    "components,onesided,bounds,refute",
                                    "equalities,onesided,bounds,refute",
                                    "equalities,components,bounds,refute",
                                    "equalities,components,onesided,refute",
                                    "equalities,components,onesided,bounds"};

enum { WAYS = sizeof STEPS / sizeof *STEPS, CASES = 150 };

static void ask(agree *g, const truth *t, const fmb_options *o, uint64_t seed)
{
    static const int keep[] = {0};
    fmb_solver *v = NULL;
    must(fmb_solver_new(o, NULL, &v));
    bool good = agree_solve(g, v, t) && agree_bound(g, v, t) &&
                (fmb_system_dim(t->s) == 0 || agree_project(g, v, t, keep, 1, NULL)) &&
                agree_reduce(g, v, t, NULL);
    cr_expect(good, "seed %d, rules %s, presolve %s, rebase %d: %s", (int)seed,
              o->rules ? o->rules : "(default)", o->presolve ? o->presolve : "(default)", o->rebase,
              g->why);
    fmb_solver_free(v);
}

static void ask_all(fmb_options o, uint64_t offset)
{
    agree g = {.max_rows = 2000};
    for (uint64_t seed = 0; seed < CASES; seed++) {
        support_shape shape = {2 + (int)(seed % 3), 4 + (int)(seed % 5), 0};
        support_family family = (support_family)(seed % SUPPORT_FAMILIES);
        support_case c = support_make(family, offset + seed, &shape);
        truth t;
        truth_init(&t, c.s, g.max_rows);
        o.method = seed % 2 ? FMB_METHOD_FM : FMB_METHOD_AUTO;
        o.order = (fmb_order)(seed / 2 % 4);
        ask(&g, &t, &o, offset + seed);
        truth_clear(&t);
        support_case_clear(&c);
    }
    cr_expect_gt(g.questions, CASES);
}

Test(presolve, any_step_may_be_left_out)
{
    for (int way = 0; way < WAYS; way++) {
        fmb_options o = {.size = sizeof o};
        o.presolve = STEPS[way];
        ask_all(o, 1000 * (uint64_t)way);
    }
}

/* never: only with rules that go together. */
Test(presolve, any_way_to_rebase)
{
    static const char *const rules[] = {NULL, "kohler,chernikov,imbert,box,duplicate,dominated,lp",
                                        "imbert,dominated"};
    for (int k = 0; k < 3; k++)
        for (int rebase = FMB_REBASE_AUTO; rebase <= FMB_REBASE_ALWAYS; rebase++) {
            fmb_options o = {.size = sizeof o};
            o.rules = rules[k];
            o.rebase = (fmb_rebase)rebase;
            ask_all(o, 100000 + 1000 * (uint64_t)k);
        }
    fmb_options o = {.size = sizeof o};
    o.rebase = FMB_REBASE_NEVER;
    o.rules = "kohler,chernikov,imbert,box";
    ask_all(o, 200000);
    o.rules = "duplicate,dominated,box,lp";
    ask_all(o, 300000);
}
