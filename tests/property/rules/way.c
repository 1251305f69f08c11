/* way.c: see way.h. */
#include <fmb/solve.h>

#include "mixes.h"
#include "way.h"

fmb_simd way_widest(void)
{
    fmb_options o = {.size = sizeof o};
    for (int level = FMB_SIMD_AVX512;; level--) {
        fmb_solver *v = NULL;
        o.simd = (fmb_simd)level;
        bool good = fmb_solver_new(&o, NULL, &v) == FMB_OK;
        fmb_solver_free(v);
        if (good || level == FMB_SIMD_AUTO)
            return (fmb_simd)level;
    }
}

static const char *presolve(support_rng *g)
{
    static const char *const step[] = {"equalities", "components", "onesided", "bounds", "refute"};
    if (support_chance(g, 65))
        return "none";
    return support_chance(g, 50) ? NULL : step[support_between(g, 0, 4)];
}

fmb_options way_at(support_rng *g, unsigned mix)
{
    static int widest = -1;
    if (widest < 0)
        widest = (int)way_widest();
    fmb_options o = {.size = sizeof o};
    o.method = FMB_METHOD_FM;
    o.evidence = FMB_EVIDENCE_ALL;
    o.rules = mix_text(mix, (unsigned)support_between(g, 0, MIX_TURNS - 1));
    o.order = support_chance(g, 40)
                  ? FMB_ORDER_GIVEN
                  : (fmb_order)support_between(g, FMB_ORDER_PAIRS, FMB_ORDER_FILL);
    o.arith = support_chance(g, 10) ? FMB_ARITH_GMP : FMB_ARITH_INT;
    o.rebase = support_chance(g, 80) ? FMB_REBASE_ALWAYS : FMB_REBASE_AUTO;
    o.presolve = presolve(g);
    o.simd = (fmb_simd)support_between(g, FMB_SIMD_AUTO, widest);
    o.max_rows = 500;
    o.max_bytes = (size_t)16 << 20;
    return o;
}
