/* options.c: every way to solve. See options.h. */
#include <stdio.h>

#include "options.h"

static const struct {
    const char *names;
    fmb_rebase rebase;
} RULES[] = {
    {NULL, FMB_REBASE_AUTO},
    {"none", FMB_REBASE_AUTO},
    {"duplicate", FMB_REBASE_AUTO},
    {"kohler", FMB_REBASE_AUTO},
    {"duplicate,kohler", FMB_REBASE_ALWAYS},
    {"lp", FMB_REBASE_AUTO},
    {"chernikov,dominated", FMB_REBASE_ALWAYS},
    {"imbert,box", FMB_REBASE_AUTO},
    {"box,lp,kohler,chernikov,imbert,duplicate,dominated", FMB_REBASE_ALWAYS},
};
static const fmb_order ORDERS[] = {FMB_ORDER_GIVEN, FMB_ORDER_PAIRS, FMB_ORDER_MIN, FMB_ORDER_FILL};
static const fmb_arith ARITHS[] = {FMB_ARITH_INT, FMB_ARITH_GMP};
static const fmb_method METHODS[] = {FMB_METHOD_AUTO, FMB_METHOD_FM, FMB_METHOD_LP, FMB_METHOD_HULL,
                                     FMB_METHOD_DD};

enum {
    N_RULES = sizeof RULES / sizeof *RULES,
    N_ORDERS = sizeof ORDERS / sizeof *ORDERS,
    N_ARITHS = sizeof ARITHS / sizeof *ARITHS,
    N_METHODS = sizeof METHODS / sizeof *METHODS
};

int options_count(void)
{
    return 1 + N_RULES * N_ORDERS * N_ARITHS * N_METHODS;
}

fmb_options options_at(int i)
{
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_ALL;
    if (i == 0)
        return o;
    i -= 1;
    o.rules = RULES[i % N_RULES].names;
    o.rebase = RULES[i % N_RULES].rebase;
    i /= N_RULES;
    o.order = ORDERS[i % N_ORDERS];
    i /= N_ORDERS;
    o.arith = ARITHS[i % N_ARITHS];
    i /= N_ARITHS;
    o.method = METHODS[i % N_METHODS];
    return o;
}

void options_text(const fmb_options *o, char *out, size_t size)
{
    static const char *const arith[] = {"auto", "int", "gmp"},
                             *const method[] = {"auto", "fm", "lp", "hull", "dd"},
                             *const order[] = {"pairs", "given", "min", "fill"},
                             *const rebase[] = {"auto", "always", "never"},
                             *const simd[] = {"auto", "plain", "avx2", "avx512"};
    snprintf(out, size, "method=%s arith=%s order=%s rules=%s rebase=%s presolve=%s simd=%s",
             method[o->method], arith[o->arith], order[o->order], o->rules ? o->rules : "(default)",
             rebase[o->rebase], o->presolve ? o->presolve : "(default)", simd[o->simd]);
}
