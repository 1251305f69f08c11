/* options.c: every line of the options table: its default, good, bad and boundary values. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/fmb.h>

/* What one option takes and refuses. */
typedef struct values {
    const char *name;
    const char *good[8], *bad[10];
} values;

static const values TABLE[] = {
    {"arith", {"auto", "int", "gmp"}, {"", "INT", "float", "int ", "in"}},
    {"method", {"auto", "fm", "lp"}, {"", "simplex", "fmplex", "fm,lp", "0"}},
    {"order", {"pairs", "given", "min", "fill"}, {"", "max", "pair"}},
    {"rules",
     {"none", "kohler", "duplicate", "duplicate,kohler", "chernikov,imbert,box,dominated,lp"},
     {NULL}},
    {"rebase", {"auto", "always", "never"}, {"", "sometimes", "Auto", "1"}},
    {"presolve",
     {"none", "equalities", "components", "onesided", "bounds", "refute", "refute,equalities"},
     {NULL}},
    {"simd", {"auto", "plain"}, {"", "sse", "avx", "512"}},
    {"trace_rows", {"true", "false"}, {"", "yes", "1", "TRUE"}},
    {"evidence", {"none", "all", "verdict", "whole"}, {"", "true", "2", "-1"}},
    {"max_seconds",
     {"0", "2.5", "1000", "0.001"},
     {"", "-1", "nan", "inf", "1e", "1s", "two", "1,5", "."}},
    {"max_rows",
     {"0", "1", "1000000", "18446744073709551615"},
     {"", "-1", "1.5", "x", "18446744073709551616", "99999999999999999999999", "1 2"}},
    {"max_bytes",
     {"0", "1", "1000000", "18446744073709551615"},
     {"", "-1", "1.5", "x", "18446744073709551616", "1e30"}},
    {"symmetry", {"auto", "none"}, {"", "yes", "all", "1"}},
    {"threads", {"0", "1", "3", "64"}, {"", "-1", "1.5", "x", "18446744073709551616"}},
};

enum { LINES = sizeof TABLE / sizeof *TABLE };

Test(options, table_is_complete)
{
    size_t n = 0;
    for (const fmb_option_info *i; (i = fmb_options_describe(n)) != NULL; n++) {
        bool found = false;
        for (size_t k = 0; k < LINES; k++)
            found = found || strcmp(TABLE[k].name, i->name) == 0;
        cr_expect(found, "no test for option %s", i->name);
        cr_expect(i->values && *i->values && i->initial && i->meaning && *i->meaning);
    }
    cr_expect_eq(n, LINES);
    cr_expect_null(fmb_options_describe(SIZE_MAX));
}

Test(options, good_values)
{
    for (size_t k = 0; k < LINES; k++)
        for (int i = 0; i < 8 && TABLE[k].good[i]; i++) {
            fmb_options o = {.size = sizeof o};
            fmb_solver *v = NULL;
            cr_expect_eq(fmb_options_set(&o, TABLE[k].name, TABLE[k].good[i]), FMB_OK, "%s = %s",
                         TABLE[k].name, TABLE[k].good[i]);
            cr_expect_eq(fmb_solver_new(&o, NULL, &v), FMB_OK, "%s = %s", TABLE[k].name,
                         TABLE[k].good[i]);
            fmb_solver_free(v);
        }
}

Test(options, bad_values)
{
    fmb_options untouched = {.size = sizeof untouched};
    for (size_t k = 0; k < LINES; k++)
        for (int i = 0; i < 10 && TABLE[k].bad[i]; i++) {
            fmb_options o = {.size = sizeof o};
            cr_expect_eq(fmb_options_set(&o, TABLE[k].name, TABLE[k].bad[i]), FMB_ERR_ARG,
                         "%s = '%s'", TABLE[k].name, TABLE[k].bad[i]);
            cr_expect(o.arith == untouched.arith && o.method == untouched.method &&
                      o.order == untouched.order && o.rules == untouched.rules &&
                      o.evidence == untouched.evidence && o.max_rows == untouched.max_rows &&
                      o.max_bytes == untouched.max_bytes && o.rebase == untouched.rebase &&
                      o.simd == untouched.simd && o.trace_rows == untouched.trace_rows &&
                      o.max_seconds <= untouched.max_seconds);
        }
    fmb_options o = {.size = sizeof o};
    cr_expect_eq(fmb_options_set(&o, "max-rows", "1"), FMB_ERR_ARG);
    cr_expect_eq(fmb_options_set(&o, "", "1"), FMB_ERR_ARG);
    cr_expect_eq(fmb_options_set(&o, "speed", "1"), FMB_ERR_ARG);
}

/* The text of the default sets the default. */
Test(options, defaults)
{
    fmb_options d = {.size = sizeof d};
    const fmb_option_info *i;
    for (size_t n = 0; (i = fmb_options_describe(n)) != NULL; n++) {
        fmb_options o = d;
        if (strcmp(i->name, "rules") != 0 && strcmp(i->name, "presolve") != 0)
            cr_expect_eq(fmb_options_set(&o, i->name, i->initial), FMB_OK, "%s = %s", i->name,
                         i->initial);
        cr_expect(o.arith == d.arith && o.method == d.method && o.order == d.order &&
                      o.evidence == d.evidence && o.max_rows == d.max_rows &&
                      o.max_bytes == d.max_bytes && o.rebase == d.rebase && o.simd == d.simd &&
                      o.trace_rows == d.trace_rows,
                  "%s", i->name);
        cr_expect_float_eq(o.max_seconds, d.max_seconds, 0);
    }
    cr_expect(!d.rules && !d.presolve);
}

Test(options, values_arrive)
{
    fmb_options o = {.size = sizeof o};
    cr_expect_eq(fmb_options_set(&o, "arith", "gmp"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "method", "lp"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "order", "fill"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "rules", "kohler"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "rebase", "never"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "presolve", "bounds"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "simd", "avx2"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "trace_rows", "true"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "evidence", "verdict"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "max_seconds", "2.5"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "max_rows", "7"), FMB_OK);
    cr_expect_eq(fmb_options_set(&o, "max_bytes", "18446744073709551615"), FMB_OK);
    cr_expect(o.arith == FMB_ARITH_GMP && o.method == FMB_METHOD_LP && o.order == FMB_ORDER_FILL);
    cr_expect(strcmp(o.rules, "kohler") == 0 && strcmp(o.presolve, "bounds") == 0);
    cr_expect_eq(o.evidence, FMB_EVIDENCE_VERDICT);
    cr_expect(o.rebase == FMB_REBASE_NEVER && o.simd == FMB_SIMD_AVX2 && o.trace_rows);
    cr_expect(o.max_rows == 7 && o.max_bytes == SIZE_MAX);
    cr_expect_float_eq(o.max_seconds, 2.5, 0);
}

Test(options, seconds)
{
    static const struct {
        const char *text;
        double seconds; /* -1: refused */
    } table[] = {{"0", 0},        {"1e3", 1000},  {"2.5E+1", 25}, {"25e-1", 2.5}, {".5", 0.5},
                 {"1e-9", 1e-9},  {"1.", 1},      {"1e", -1},     {"e3", -1},     {"", -1},
                 {".", -1},       {"1e1000", -1}, {"1e-400", -1}, {"-1", -1},     {"1e16", -1},
                 {"1e--1", -1},   {"1 ", -1},     {"0x10", -1},   {"nan", -1},    {"1.2.3", -1},
                 {"1e-0009", -1}, {"1e5x", -1}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        fmb_options o = {.size = sizeof o, .max_seconds = -1};
        fmb_status st = fmb_options_set(&o, "max_seconds", table[i].text);
        cr_expect_eq(st, table[i].seconds < 0 ? FMB_ERR_ARG : FMB_OK, "%s", table[i].text);
        cr_expect_float_eq(o.max_seconds, table[i].seconds, 0, "%s", table[i].text);
    }
}

/* What fmb_solver_new refuses. */
static void expect_refused(fmb_options o, fmb_status status)
{
    fmb_solver *const mark = (fmb_solver *)&o, *v = mark;
    cr_expect_eq(fmb_solver_new(&o, NULL, &v), status, "rules %s", o.rules ? o.rules : "default");
    cr_expect_eq(v, mark);
}

Test(options, solver_refuses)
{
    fmb_options o = {.size = sizeof o};
    o.max_seconds = -1;
    expect_refused(o, FMB_ERR_ARG);
    o.max_seconds = NAN;
    expect_refused(o, FMB_ERR_ARG);
    o = (fmb_options){.size = sizeof(fmb_options)};
    o.arith = (fmb_arith)77;
    expect_refused(o, FMB_ERR_ARG);
    o = (fmb_options){.size = sizeof(fmb_options)};
    o.method = (fmb_method)-1;
    expect_refused(o, FMB_ERR_ARG);
    o = (fmb_options){.size = sizeof(fmb_options)};
    o.order = (fmb_order)4;
    expect_refused(o, FMB_ERR_ARG);
    o = (fmb_options){.size = sizeof(fmb_options)};
    o.rebase = (fmb_rebase)3;
    expect_refused(o, FMB_ERR_ARG);
    o = (fmb_options){.size = sizeof(fmb_options)};
    o.simd = (fmb_simd)4;
    expect_refused(o, FMB_ERR_ARG);
    static const char *const bad[] = {
        "koehler", "none,none",         ",",       "none,kohler",   "kohler,kohlr",
        "k",       "kohler, duplicate", "kohlerx", "kohler kohler", "KOHLER"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        o = (fmb_options){.size = sizeof(fmb_options)};
        o.rules = bad[i];
        expect_refused(o, FMB_ERR_RULE);
    }
    static const char *const steps[] = {"equality", "none,bounds", ",",     "bounds,",
                                        "",         "bounds box",  "BOUNDS"};
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        o = (fmb_options){.size = sizeof(fmb_options)};
        o.presolve = steps[i];
        expect_refused(o, FMB_ERR_ARG);
    }
}
