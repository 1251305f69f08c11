/* declare.c: the commands of a script that give names a meaning; see term.h. */
#include "io/smt2/term.h"

/* ---- names and sorts ------------------------------------------------------------------------- */

static fmb_status read_known_sort(fmb_smt *r, fmb_smt_sort *out)
{
    fmb_smt_token t;
    size_t symbol;
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "the sort Real, Int or Bool", &t));
    FMB_TRY(fmb_smt_intern(&r->scope, t.text, &symbol));
    if (!r->scope.symbol[symbol].is_sort) {
        return fmb_io_expected(r->c, t.at, "the sort Real, Int or Bool");
    }
    *out = r->scope.symbol[symbol].sort;
    return FMB_OK;
}

/* ---- declarations ---------------------------------------------------------------------------- */

/* Declare a Boolean unknown: the next of the facts, perhaps known from an earlier reading. */
static fmb_status declare_boolean(fmb_smt *r, size_t number)
{
    fmb_smt_facts *facts = r->forms.facts;
    fmb_smt_symbol *symbol = &r->scope.symbol[number];
    if (facts->declared == facts->unknowns) {
        FMB_TRY(FMB_RESERVE(r->c->mem, &facts->truth, &facts->capacity, facts->unknowns + 1));
        facts->truth[facts->unknowns++] = FMB_SMT_OPEN_TRUTH;
    }
    symbol->meaning = FMB_SMT_UNKNOWN;
    symbol->index = facts->declared++;
    facts->open += facts->truth[symbol->index] == FMB_SMT_OPEN_TRUTH;
    return FMB_OK;
}

static fmb_status declare_unknown(fmb_smt *r, size_t symbol, const char *at)
{
    fmb_smt_sort sort = FMB_SMT_REAL;
    FMB_TRY(read_known_sort(r, &sort));
    FMB_TRY(fmb_smt_close_command(r));
    FMB_TRY(fmb_smt_give(&r->scope, symbol, false));
    if (sort == FMB_SMT_BOOL)
        return declare_boolean(r, symbol);
    fmb_smt_value v = {.at = at};
    int var;
    FMB_TRY(fmb_span_variable(r->c, r->scope.symbol[symbol].text, r->s, &var));
    if (sort == FMB_SMT_INT)
        FMB_TRY(fmb_system_set_integer(r->s, var, true));
    FMB_TRY(fmb_lin_variable(&r->lin, var, &v.id));
    r->scope.symbol[symbol].meaning = FMB_SMT_VALUE;
    r->scope.symbol[symbol].value = v;
    return FMB_OK;
}

fmb_status fmb_smt_declare_const(fmb_smt *r, const char *open)
{
    size_t symbol;
    const char *at;
    (void)open;
    FMB_TRY(fmb_smt_new_name(r, &symbol, &at));
    return declare_unknown(r, symbol, at);
}

fmb_status fmb_smt_declare_fun(fmb_smt *r, const char *open)
{
    size_t symbol;
    const char *at;
    fmb_smt_token t;
    (void)open;
    FMB_TRY(fmb_smt_new_name(r, &symbol, &at));
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_OPEN, "'(' and ')'", &t));
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')': unknown functions are not linear arithmetic",
                           &t));
    return declare_unknown(r, symbol, at);
}

fmb_status fmb_smt_define_sort(fmb_smt *r, const char *open)
{
    fmb_smt_token t;
    size_t symbol;
    fmb_smt_sort sort = FMB_SMT_REAL;
    (void)open;
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "the name of a sort", &t));
    FMB_TRY(fmb_smt_intern(&r->scope, t.text, &symbol));
    if (r->scope.symbol[symbol].is_sort)
        return fmb_io_fail(r->c, t.at, "expected a new name for a sort");
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_OPEN, "'(' and ')'", &t));
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')': sorts with parameters cannot be read", &t));
    FMB_TRY(read_known_sort(r, &sort));
    FMB_TRY(fmb_smt_give(&r->scope, symbol, true));
    r->scope.symbol[symbol].is_sort = true;
    r->scope.symbol[symbol].sort = sort;
    return fmb_smt_close_command(r);
}

/* ---- define-fun ------------------------------------------------------------------------------ */

/* Read the name of a parameter, which must be new: earlier parameters are bound, without a value,
 * until all are read. */
static fmb_status read_parameter_name(fmb_smt *r, size_t *symbol)
{
    fmb_smt_token t;
    char buf[FMB_QUOTE];
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "the name of a parameter", &t));
    FMB_TRY(fmb_smt_intern(&r->scope, t.text, symbol));
    if (fmb_smt_find_local(&r->scope, *symbol))
        return fmb_io_fail(r->c, t.at, "expected different names of parameters, found %s again",
                           fmb_quote(r->c, t.at, buf));
    return fmb_smt_bind(&r->scope, *symbol, (fmb_smt_value){.at = t.at});
}

/* (x Real) (y Bool) ... up to ')'; *n of them. */
static fmb_status read_parameters(fmb_smt *r, size_t *n)
{
    for (*n = 0;; ++*n) {
        fmb_smt_token t;
        fmb_smt_param p;
        fmb_smt_sort sort = FMB_SMT_BOOL;
        FMB_TRY(fmb_smt_next(r->c, &t));
        if (t.kind == FMB_SMT_CLOSE)
            fmb_smt_unbind(&r->scope, r->scope.locals - *n);
        if (t.kind == FMB_SMT_CLOSE)
            return FMB_OK;
        if (t.kind != FMB_SMT_OPEN)
            return fmb_io_fail(r->c, t.at, "expected '(' of a parameter, or ')' after the last");
        FMB_TRY(read_parameter_name(r, &p.symbol));
        FMB_TRY(read_known_sort(r, &sort));
        FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')' after the parameter", &t));
        FMB_TRY(FMB_RESERVE(r->c->mem, &r->param, &r->param_capacity, r->params + 1));
        p.formula = sort == FMB_SMT_BOOL;
        r->param[r->params++] = p;
    }
}

/* With parameters only the place of the body is kept. */
static fmb_status define_macro_body(fmb_smt *r, size_t symbol, size_t n, bool formula)
{
    fmb_smt_macro m = {.first = r->params - n, .n = n, .formula = formula, .body = r->c->at};
    fmb_status st = fmb_smt_skip(r->c, "the body of the function");
    m.bytes = (size_t)(r->c->at - m.body);
    FMB_THEN(st, FMB_RESERVE(r->c->mem, &r->macro, &r->macro_capacity, r->macros + 1));
    FMB_THEN(st, fmb_smt_give(&r->scope, symbol, false));
    if (st != FMB_OK)
        return st;
    r->macro[r->macros] = m;
    r->scope.symbol[symbol].meaning = FMB_SMT_MACRO;
    r->scope.symbol[symbol].index = r->macros++;
    return fmb_smt_close_command(r);
}

static fmb_status define_named_value(fmb_smt *r, size_t symbol, bool formula)
{
    fmb_smt_value v;
    FMB_TRY(fmb_smt_term(r, &v));
    FMB_TRY(fmb_smt_check_kind(r, &v, formula));
    FMB_TRY(fmb_smt_give(&r->scope, symbol, false));
    r->named = true;
    r->scope.symbol[symbol].meaning = FMB_SMT_VALUE;
    r->scope.symbol[symbol].value = v;
    return fmb_smt_close_command(r);
}

fmb_status fmb_smt_define_const(fmb_smt *r, const char *open)
{
    size_t symbol;
    const char *at;
    fmb_smt_sort sort = FMB_SMT_REAL;
    (void)open;
    FMB_TRY(fmb_smt_new_name(r, &symbol, &at));
    FMB_TRY(read_known_sort(r, &sort));
    return define_named_value(r, symbol, sort == FMB_SMT_BOOL);
}

fmb_status fmb_smt_define_fun(fmb_smt *r, const char *open)
{
    size_t symbol, n = 0;
    const char *at;
    fmb_smt_token t;
    fmb_smt_sort sort = FMB_SMT_REAL;
    (void)open;
    FMB_TRY(fmb_smt_new_name(r, &symbol, &at));
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_OPEN, "'(' before the parameters", &t));
    FMB_TRY(read_parameters(r, &n));
    FMB_TRY(read_known_sort(r, &sort));
    return n == 0 ? define_named_value(r, symbol, sort == FMB_SMT_BOOL)
                  : define_macro_body(r, symbol, n, sort == FMB_SMT_BOOL);
}
