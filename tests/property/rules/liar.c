/* liar.c: a user's rule that drops rows for no reason and says that this is sound. The library
 * cannot know; but it neither crashes nor hangs, and the evidence check tells: whatever is accepted
 * is right. */
#include <criterion/criterion.h>

#include "make.h"
#include "mixes.h"
#include "property/random/agree.h"
#include "way.h"

enum { SYSTEMS = 1500 };

typedef struct liar {
    support_rng g;
} liar;

static bool drop_row(void *state, const fmb_view *w, size_t row)
{
    liar *l = state;
    return l && w && support_chance(&l->g, row % 2 ? 40 : 20);
}

static void drop_pairs(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    liar *l = state;
    for (size_t j = 0; j < fmb_view_uppers(w); j++)
        if (support_chance(&l->g, i % 2 ? 40 : 20))
            drop[j / 64] |= (uint64_t)1 << (j % 64);
}

/* Honest as long as many rows are there. */
static void drop_last(void *state, const fmb_view *w, size_t i, uint64_t *drop)
{
    (void)state;
    (void)i;
    for (size_t j = 0; j < fmb_view_uppers(w) && fmb_view_rows(w) < 24; j++)
        drop[j / 64] |= (uint64_t)1 << (j % 64);
}

static fmb_status end_round(void *state, const fmb_view *w, bool *drop)
{
    liar *l = state;
    for (size_t i = 0; i < fmb_view_rows(w); i++)
        drop[i] = support_chance(&l->g, 30);
    return FMB_OK;
}

static const fmb_rule LIAR[] = {
    {.name = "liar-row", .source = "none", .state_bytes = sizeof(liar), .drop_row = drop_row},
    {.name = "liar-pairs", .source = "none", .state_bytes = sizeof(liar), .drop_pairs = drop_pairs},
    {.name = "liar-last", .source = "none", .drop_pairs = drop_last},
    {.name = "liar-round", .source = "none", .state_bytes = sizeof(liar), .end_round = end_round},
    {.name = "liar-rebased",
     .source = "none",
     .flags = FMB_RULE_BREAKS_HISTORY,
     .state_bytes = sizeof(liar),
     .end_round = end_round},
};

enum { LIARS = sizeof LIAR / sizeof *LIAR };

/* What the checker accepts is the truth. */
static int judge(fmb_solver *v, const fmb_system *s, const fmb_result *r, fmb_verdict known)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    if (fmb_solver_evidence(v, &e) == FMB_OK)
        must(fmb_check(s, e, &j));
    fmb_evidence_free(e);
    bool wrong = r->verdict != FMB_UNKNOWN && r->verdict != known;
    cr_expect(!wrong || !j.accepted || j.verdict != r->verdict, "a lie was accepted");
    cr_expect(!j.accepted || j.verdict == FMB_UNKNOWN || j.verdict == known);
    return wrong;
}

static fmb_status ask(fmb_solver *v, const fmb_system *s, int kind, fmb_result *r)
{
    static const int keep[] = {0, 1};
    fmb_system *out = NULL;
    fmb_box *box = NULL;
    fmb_status st = kind == 0   ? fmb_solve(v, s, r)
                    : kind == 1 ? fmb_project(v, s, keep, 2, &out, r)
                    : kind == 2 ? fmb_bound(v, s, NULL, 0, &box, r)
                                : fmb_reduce(v, s, NULL, &out, r);
    fmb_system_free(out);
    fmb_box_free(box);
    return st;
}

/* How many answers were wrong. */
static int one_system(uint64_t seed, fmb_system *s, fmb_verdict known)
{
    support_rng g = {seed};
    int wrong = 0;
    for (int k = 0; k < LIARS; k++) {
        fmb_options o = way_at(&g, mix_at(support_between(&g, 0, MIX_SMALL - 1)) |
                                       (support_chance(&g, 50) ? MIX_LP : 0));
        fmb_solver *v = NULL;
        o.method = support_chance(&g, 70) ? FMB_METHOD_FM : FMB_METHOD_AUTO;
        must(fmb_solver_new(&o, NULL, &v));
        must(fmb_solver_add_rule(v, &LIAR[k]));
        for (int kind = 0; kind < 4; kind++) {
            fmb_result r = {.size = sizeof r};
            must(ask(v, s, kind, &r));
            wrong += judge(v, s, &r, known);
        }
        fmb_solver_free(v);
    }
    return wrong;
}

Test(liar, is_caught)
{
    int wrong = 0;
    for (uint64_t seed = 0; seed < SYSTEMS; seed++) {
        fmb_system *s = make_system(seed);
        fmb_verdict known = FMB_UNKNOWN;
        must(study_textbook_solve(s, 500, &known));
        if (known != FMB_UNKNOWN)
            wrong += one_system(seed, s, known);
        fmb_system_free(s);
    }
    cr_expect_gt(wrong, 10, "the liar did no harm: %d wrong answers", wrong);
}
