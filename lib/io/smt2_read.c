/* smt2_read.c: SMT-LIB 2 scripts whose assertions are a conjunction of linear constraints.
 *
 * All assertions of the text are one system; commands that ask, set or print are ignored. A script
 * whose meaning depends on the order of its commands (push, pop, reset, assumptions) is refused.
 * Source: Barrett, Fontaine, Tinelli, The SMT-LIB Standard, version 2.6, 2017.
 */
#include "io/smt2_term.h"

/* ---- names and sorts ------------------------------------------------------------------------- */

fmb_status fmb_smt_new_name(fmb_smt *r, size_t *symbol, const char **at)
{
    fmb_smt_token t;
    fmb_status st = fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "a name", &t);
    if (st == FMB_OK)
        st = fmb_smt_intern(&r->scope, t.text, symbol);
    if (st != FMB_OK)
        return st;
    *at = t.at;
    if (t.text.n == 0)
        return fmb_io_fail(r->c, t.at, "expected a name that is not empty");
    if (r->scope.symbol[*symbol].meaning == FMB_SMT_NOTHING)
        return FMB_OK;
    char buf[FMB_QUOTE];
    return fmb_io_fail(r->c, t.at, "expected a new name, found %s, which has a meaning already",
                       fmb_quote(r->c, t.at, buf));
}

static fmb_status read_sort(fmb_smt *r, fmb_smt_sort *out)
{
    fmb_smt_token t;
    size_t symbol;
    fmb_status st = fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "the sort Real, Int or Bool", &t);
    if (st == FMB_OK)
        st = fmb_smt_intern(&r->scope, t.text, &symbol);
    if (st != FMB_OK)
        return st;
    if (!r->scope.symbol[symbol].is_sort) {
        char buf[FMB_QUOTE];
        return fmb_io_fail(r->c, t.at, "expected the sort Real, Int or Bool, found %s",
                           fmb_quote(r->c, t.at, buf));
    }
    *out = r->scope.symbol[symbol].sort;
    return FMB_OK;
}

static fmb_status close_command(fmb_smt *r)
{
    fmb_smt_token t;
    return fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')' to end the command", &t);
}

/* ---- declarations ---------------------------------------------------------------------------- */

static fmb_status declare(fmb_smt *r, size_t symbol, const char *at)
{
    fmb_smt_sort sort;
    fmb_status st = read_sort(r, &sort);
    if (st == FMB_OK)
        st = close_command(r);
    if (st != FMB_OK)
        return st;
    if (sort == FMB_SMT_BOOL) {
        r->scope.symbol[symbol].meaning = FMB_SMT_UNKNOWN;
        return FMB_OK;
    }
    if (sort == FMB_SMT_INT && !r->warned_int) {
        fmb_io_warn(r->c, at, "integrality is ignored: unknowns of sort Int are read as reals");
        r->warned_int = true;
    }
    fmb_smt_value v = {.at = at};
    int var;
    st = fmb_span_variable(r->c, r->scope.symbol[symbol].text, r->s, &var);
    if (st == FMB_OK)
        st = fmb_lin_variable(&r->lin, var, &v.id);
    if (st == FMB_OK) {
        r->scope.symbol[symbol].meaning = FMB_SMT_VALUE;
        r->scope.symbol[symbol].value = v;
    }
    return st;
}

static fmb_status declare_const(fmb_smt *r, const char *open)
{
    size_t symbol;
    const char *at;
    (void)open;
    fmb_status st = fmb_smt_new_name(r, &symbol, &at);
    return st == FMB_OK ? declare(r, symbol, at) : st;
}

static fmb_status declare_fun(fmb_smt *r, const char *open)
{
    size_t symbol;
    const char *at;
    fmb_smt_token t;
    (void)open;
    fmb_status st = fmb_smt_new_name(r, &symbol, &at);
    if (st == FMB_OK)
        st = fmb_smt_expect(r->c, FMB_SMT_OPEN, "'(' and ')'", &t);
    if (st == FMB_OK)
        st = fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')': unknown functions are not linear arithmetic",
                            &t);
    return st == FMB_OK ? declare(r, symbol, at) : st;
}

static fmb_status define_sort(fmb_smt *r, const char *open)
{
    fmb_smt_token t;
    size_t symbol;
    fmb_smt_sort sort;
    (void)open;
    fmb_status st = fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "the name of a sort", &t);
    if (st == FMB_OK)
        st = fmb_smt_intern(&r->scope, t.text, &symbol);
    if (st == FMB_OK && r->scope.symbol[symbol].is_sort)
        st = fmb_io_fail(r->c, t.at, "expected a new name for a sort");
    if (st == FMB_OK)
        st = fmb_smt_expect(r->c, FMB_SMT_OPEN, "'(' and ')'", &t);
    if (st == FMB_OK)
        st = fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')': sorts with parameters cannot be read", &t);
    if (st == FMB_OK)
        st = read_sort(r, &sort);
    if (st != FMB_OK)
        return st;
    r->scope.symbol[symbol].is_sort = true;
    r->scope.symbol[symbol].sort = sort;
    return close_command(r);
}

/* ---- define-fun ------------------------------------------------------------------------------ */

/* (x Real) (y Bool) ... up to ')'; *n of them. */
static fmb_status read_params(fmb_smt *r, size_t *n)
{
    for (*n = 0;; ++*n) {
        fmb_smt_token t;
        fmb_smt_param p;
        fmb_smt_sort sort;
        fmb_status st = fmb_smt_next(r->c, &t);
        if (st != FMB_OK || t.kind == FMB_SMT_CLOSE)
            return st;
        if (t.kind != FMB_SMT_OPEN)
            return fmb_io_fail(r->c, t.at, "expected '(' of a parameter, or ')' after the last");
        st = fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "the name of a parameter", &t);
        if (st == FMB_OK)
            st = fmb_smt_intern(&r->scope, t.text, &p.symbol);
        if (st == FMB_OK)
            st = read_sort(r, &sort);
        if (st == FMB_OK)
            st = fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')' after the parameter", &t);
        if (st == FMB_OK)
            st = fmb_mem_reserve(r->c->mem, (void **)&r->param, &r->param_capacity, r->params + 1,
                                 sizeof *r->param);
        if (st != FMB_OK)
            return st;
        p.formula = sort == FMB_SMT_BOOL;
        r->param[r->params++] = p;
    }
}

/* With parameters only the place of the body is kept. */
static fmb_status define_macro(fmb_smt *r, size_t symbol, size_t n, bool formula)
{
    fmb_smt_macro m = {.first = r->params - n, .n = n, .formula = formula, .body = r->c->at};
    fmb_status st = fmb_smt_skip(r->c, "the body of the function");
    m.bytes = (size_t)(r->c->at - m.body);
    if (st == FMB_OK)
        st = fmb_mem_reserve(r->c->mem, (void **)&r->macro, &r->macro_capacity, r->macros + 1,
                             sizeof *r->macro);
    if (st != FMB_OK)
        return st;
    r->macro[r->macros] = m;
    r->scope.symbol[symbol].meaning = FMB_SMT_MACRO;
    r->scope.symbol[symbol].index = r->macros++;
    return close_command(r);
}

static fmb_status check_kind(fmb_smt *r, const fmb_smt_value *v, bool formula)
{
    if (v->formula == formula)
        return FMB_OK;
    return fmb_io_fail(r->c, v->at, "expected a %s, found a %s", formula ? "formula" : "number",
                       formula ? "number" : "formula");
}

static fmb_status define_value(fmb_smt *r, size_t symbol, bool formula)
{
    fmb_smt_value v;
    fmb_status st = fmb_smt_term(r, &v);
    if (st == FMB_OK)
        st = check_kind(r, &v, formula);
    if (st != FMB_OK)
        return st;
    r->named = true;
    r->scope.symbol[symbol].meaning = FMB_SMT_VALUE;
    r->scope.symbol[symbol].value = v;
    return close_command(r);
}

static fmb_status define_const(fmb_smt *r, const char *open)
{
    size_t symbol;
    const char *at;
    fmb_smt_sort sort;
    (void)open;
    fmb_status st = fmb_smt_new_name(r, &symbol, &at);
    if (st == FMB_OK)
        st = read_sort(r, &sort);
    return st == FMB_OK ? define_value(r, symbol, sort == FMB_SMT_BOOL) : st;
}

static fmb_status define_fun(fmb_smt *r, const char *open)
{
    size_t symbol, n = 0;
    const char *at;
    fmb_smt_token t;
    fmb_smt_sort sort;
    (void)open;
    fmb_status st = fmb_smt_new_name(r, &symbol, &at);
    if (st == FMB_OK)
        st = fmb_smt_expect(r->c, FMB_SMT_OPEN, "'(' before the parameters", &t);
    if (st == FMB_OK)
        st = read_params(r, &n);
    if (st == FMB_OK)
        st = read_sort(r, &sort);
    if (st != FMB_OK)
        return st;
    return n == 0 ? define_value(r, symbol, sort == FMB_SMT_BOOL)
                  : define_macro(r, symbol, n, sort == FMB_SMT_BOOL);
}

/* ---- assertions and the rest ----------------------------------------------------------------- */

static fmb_status assert_term(fmb_smt *r, const char *open)
{
    size_t nodes = r->lin.nodes, formulas = r->forms.nodes;
    fmb_smt_value v;
    if (r->checked && !r->warned_late) {
        fmb_io_warn(r->c, open,
                    "assertions after a check-sat: all assertions are read as one "
                    "system");
        r->warned_late = true;
    }
    r->named = false;
    fmb_status st = fmb_smt_term(r, &v);
    if (st == FMB_OK)
        st = check_kind(r, &v, true);
    if (st == FMB_OK)
        st = close_command(r);
    if (st == FMB_OK)
        st = fmb_form_assert(&r->forms, v.id, r->s);
    if (st == FMB_OK && !r->named) {
        fmb_forms_forget(&r->forms, formulas);
        fmb_lin_forget(&r->lin, nodes);
    }
    return st;
}

static fmb_status ignore(fmb_smt *r, const char *open)
{
    return fmb_smt_leave(r->c, open);
}

static fmb_status ignore_check(fmb_smt *r, const char *open)
{
    r->checked = true;
    return fmb_smt_leave(r->c, open);
}

static fmb_status ignore_objective(fmb_smt *r, const char *open)
{
    fmb_io_warn(r->c, open, "the objective is ignored");
    return fmb_smt_leave(r->c, open);
}

static fmb_status leave(fmb_smt *r, const char *open)
{
    fmb_status st = fmb_smt_leave(r->c, open);
    if (st == FMB_OK)
        r->c->at = r->c->end;
    return st;
}

static fmb_status refuse(fmb_smt *r, const char *open)
{
    char buf[FMB_QUOTE];
    return fmb_io_fail(r->c, open, "expected one question a script, found %s, which makes several",
                       fmb_quote(r->c, open, buf));
}

typedef struct command {
    const char *name;
    fmb_status (*run)(fmb_smt *r, const char *open);
} command;

static const command table[] = {
    {"assert", assert_term},
    {"declare-fun", declare_fun},
    {"declare-const", declare_const},
    {"define-fun", define_fun},
    {"define-const", define_const},
    {"define-sort", define_sort},
    {"set-logic", ignore},
    {"set-info", ignore},
    {"set-option", ignore},
    {"check-sat", ignore_check},
    {"check-sat-using", ignore_check},
    {"get-model", ignore},
    {"get-value", ignore},
    {"get-assertions", ignore},
    {"get-assignment", ignore},
    {"get-info", ignore},
    {"get-interpolants", ignore},
    {"get-objectives", ignore},
    {"get-option", ignore},
    {"get-proof", ignore},
    {"get-unsat-assumptions", ignore},
    {"get-unsat-core", ignore},
    {"echo", ignore},
    {"minimize", ignore_objective},
    {"maximize", ignore_objective},
    {"exit", leave},
    {"push", refuse},
    {"pop", refuse},
    {"reset", refuse},
    {"reset-assertions", refuse},
    {"check-sat-assuming", refuse},
};

static fmb_status read_command(fmb_smt *r, const char *open)
{
    fmb_smt_token t;
    fmb_status st = fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "a command", &t);
    if (st != FMB_OK)
        return st;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (fmb_span_is(t.text, table[i].name))
            return table[i].run(r, open);
    char buf[FMB_QUOTE];
    return fmb_io_fail(r->c, t.at, "expected a command that can be read, found %s",
                       fmb_quote(r->c, t.at, buf));
}

static fmb_status read_script(fmb_smt *r)
{
    for (;;) {
        fmb_smt_token t;
        fmb_status st = fmb_smt_next(r->c, &t);
        if (st != FMB_OK || t.kind == FMB_SMT_END)
            return st;
        if (t.kind != FMB_SMT_OPEN) {
            char buf[FMB_QUOTE];
            return fmb_io_fail(r->c, t.at, "expected '(' of a command, found %s",
                               fmb_quote(r->c, t.at, buf));
        }
        st = read_command(r, t.at);
        if (st != FMB_OK)
            return st;
    }
}

fmb_status fmb_read_smt2(fmb_cursor *c, fmb_system *s)
{
    fmb_smt r;
    fmb_status st = fmb_smt_init(&r, c, s);
    if (st == FMB_OK)
        st = read_script(&r);
    fmb_smt_clear(&r);
    return st;
}
