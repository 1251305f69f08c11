/* levels.c: instructions, orders, presolve and sets of rules change the work, never the answer;
 * instructions do not even change the work: every counter is the same; and mixes that need to
 * re-base are refused where that is forbidden. */
#include <criterion/criterion.h>

#include "make.h"
#include "mixes.h"
#include "property/random/agree.h"
#include "way.h"

enum { SYSTEMS = 400 };

static fmb_stats ask(const fmb_system *s, const fmb_options *o, fmb_verdict *verdict)
{
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_solver_new(o, NULL, &v));
    must(fmb_solve(v, s, &r));
    *verdict = r.verdict;
    cr_expect(r.stop == FMB_STOP_DONE || r.verdict == FMB_UNKNOWN);
    fmb_solver_free(v);
    return r.stats;
}

static void expect_same(const fmb_stats *a, const fmb_stats *b, uint64_t seed)
{
    cr_expect_eq(a->rounds, b->rounds, "seed %lu: rounds", (unsigned long)seed);
    cr_expect_eq(a->pairs, b->pairs, "seed %lu: pairs", (unsigned long)seed);
    cr_expect_eq(a->rows_made, b->rows_made, "seed %lu: rows made", (unsigned long)seed);
    cr_expect_eq(a->rows_kept, b->rows_kept, "seed %lu: rows kept", (unsigned long)seed);
    cr_expect_eq(a->rows_dropped, b->rows_dropped, "seed %lu: rows dropped", (unsigned long)seed);
    cr_expect_eq(a->rows_peak, b->rows_peak, "seed %lu: rows at once", (unsigned long)seed);
    cr_expect_eq(a->promotions, b->promotions, "seed %lu: promotions", (unsigned long)seed);
    cr_expect_eq(a->pivots, b->pivots, "seed %lu: pivots", (unsigned long)seed);
    cr_expect_eq(a->lps, b->lps, "seed %lu: programs", (unsigned long)seed);
}

/* Each level of instructions that this machine has. */
Test(levels, same_work)
{
    for (uint64_t seed = 0; seed < SYSTEMS; seed++) {
        support_rng g = {seed};
        fmb_system *s = make_system(seed);
        for (unsigned mix = 0; mix < MIX_SUBSETS; mix += 3) {
            fmb_options o = way_at(&g, mix);
            fmb_verdict plain, other;
            o.simd = FMB_SIMD_PLAIN;
            fmb_stats first = ask(s, &o, &plain);
            for (int level = FMB_SIMD_AVX2; level <= (int)way_widest(); level++) {
                o.simd = (fmb_simd)level;
                fmb_stats more = ask(s, &o, &other);
                cr_expect_eq(plain, other);
                expect_same(&first, &more, seed);
            }
        }
        fmb_system_free(s);
    }
}

/* Any two ways that decide agree. */
Test(levels, same_answer)
{
    for (uint64_t seed = SYSTEMS; seed < 2 * SYSTEMS; seed++) {
        support_rng g = {seed};
        fmb_system *s = make_system(seed);
        fmb_verdict known = FMB_UNKNOWN, verdict;
        for (unsigned mix = 0; mix < MIX_SUBSETS; mix++) {
            fmb_options o = way_at(&g, mix);
            ask(s, &o, &verdict);
            cr_expect(known == FMB_UNKNOWN || verdict == FMB_UNKNOWN || known == verdict,
                      "seed %lu: %s: %s, but %s otherwise", (unsigned long)seed, o.rules,
                      fmb_verdict_text(verdict), fmb_verdict_text(known));
            known = verdict == FMB_UNKNOWN ? known : verdict;
        }
        fmb_system_free(s);
    }
}

Test(levels, refused)
{
    fmb_system *s = make_system(1);
    for (unsigned mix = 0; mix < 2 * MIX_SUBSETS; mix++) {
        fmb_options o = {.size = sizeof o};
        fmb_solver *v = NULL;
        fmb_result r = {.size = sizeof r};
        o.rebase = FMB_REBASE_NEVER;
        o.rules = mix_text(mix, 0);
        must(fmb_solver_new(&o, NULL, &v));
        fmb_status st = fmb_solve(v, s, &r);
        cr_expect_eq(st, mix_needs_rebase(mix) ? FMB_ERR_RULE : FMB_OK, "%s: %s", o.rules,
                     fmb_status_text(st));
        cr_expect_eq(fmb_solver_trouble(v)[0] != '\0', mix_needs_rebase(mix), "%s", o.rules);
        fmb_solver_free(v);
    }
    fmb_system_free(s);
}
