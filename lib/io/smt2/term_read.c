/* term_read.c: reading one term; see term.h.
 *
 * Each open parenthesis is a frame; a finished term is handed to the frame on top, which may finish
 * another one, and so on.
 */
#include "io/smt2/term.h"

static fmb_status push_open_frame(fmb_smt *r, fmb_smt_frame_kind kind, const char *at)
{
    FMB_TRY(FMB_RESERVE(r->c->mem, &r->frame, &r->frame_capacity, r->frames + 1));
    r->frame[r->frames++] = (fmb_smt_frame){
        .kind = kind, .at = at, .values = r->values, .locals = r->scope.locals, .names = r->names};
    return FMB_OK;
}

static fmb_status push_argument_value(fmb_smt *r, fmb_smt_value v)
{
    FMB_TRY(FMB_RESERVE(r->c->mem, &r->value, &r->value_capacity, r->values + 1));
    r->value[r->values++] = v;
    return FMB_OK;
}

static fmb_status expect_closing(fmb_smt *r, const char *what)
{
    fmb_smt_token t;
    return fmb_smt_expect(r->c, FMB_SMT_CLOSE, what, &t);
}

/* ---- let ------------------------------------------------------------------------------------- */

/* All bindings were read: they become visible together. */
static fmb_status bind_let_names(fmb_smt *r, fmb_smt_frame *f)
{
    for (size_t k = 0; f->values + k < r->values; k++) {
        size_t symbol = r->name[f->names + k];
        size_t newest = r->scope.symbol[symbol].newest;
        if (newest != FMB_SMT_NONE && newest >= f->locals)
            return fmb_io_fail(r->c, f->at, "expected different names in one let");
        FMB_TRY(fmb_smt_bind(&r->scope, symbol, r->value[f->values + k]));
    }
    r->values = f->values;
    r->names = f->names;
    f->kind = FMB_SMT_BODY;
    return FMB_OK;
}

/* After a binding, or the parenthesis that opens the list: read the next name, or the end. */
static fmb_status read_next_binding(fmb_smt *r)
{
    fmb_smt_token t;
    FMB_TRY(fmb_smt_next(r->c, &t));
    if (t.kind == FMB_SMT_CLOSE)
        return bind_let_names(r, &r->frame[r->frames - 1]);
    if (t.kind != FMB_SMT_OPEN)
        return fmb_io_expected(r->c, t.at, "'(' of a binding, or ')' after the last");
    size_t symbol;
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "the name of a binding", &t));
    FMB_TRY(fmb_smt_intern(&r->scope, t.text, &symbol));
    FMB_TRY(FMB_RESERVE(r->c->mem, &r->name, &r->name_capacity, r->names + 1));
    r->name[r->names++] = symbol;
    return FMB_OK;
}

/* ---- annotations ----------------------------------------------------------------------------- */

/* :named gives the term a name for later, and its rows a label. */
static fmb_status take_named_attribute(fmb_smt *r, fmb_smt_value *v)
{
    size_t symbol;
    const char *at;
    FMB_TRY(fmb_smt_new_name(r, &symbol, &at));
    FMB_TRY(fmb_smt_give(&r->scope, symbol, false));
    r->scope.symbol[symbol].meaning = FMB_SMT_VALUE;
    r->scope.symbol[symbol].value = *v;
    r->named = true;
    if (!v->formula)
        return FMB_OK;
    return fmb_form_label(&r->forms, v->at, r->scope.symbol[symbol].text, v->id, &v->id);
}

/* Attributes up to ')': keywords, each with at most one value. */
static fmb_status take_all_attributes(fmb_smt *r, fmb_smt_value *v)
{
    for (;;) {
        fmb_smt_token t;
        fmb_status st = fmb_smt_next(r->c, &t);
        if (st != FMB_OK || t.kind == FMB_SMT_CLOSE)
            return st;
        if (t.kind != FMB_SMT_KEYWORD) {
            return fmb_io_expected(r->c, t.at, "an attribute or ')'");
        }
        if (fmb_span_is(t.text, "named")) {
            st = take_named_attribute(r, v);
        } else {
            const char *before = r->c->at;
            st = fmb_smt_next(r->c, &t);
            r->c->at = before;
            if (st == FMB_OK && t.kind != FMB_SMT_KEYWORD && t.kind != FMB_SMT_CLOSE)
                st = fmb_smt_skip(r->c, "the value of an attribute");
        }
        if (st != FMB_OK)
            return st;
    }
}

/* ---- define-fun with parameters -------------------------------------------------------------- */

/* The top frame, whose arguments are read, becomes the body of the macro. Reading it again is
 * charged to the budget: nested macros can make a short text very long. */
static fmb_status enter_macro_body(fmb_smt *r, const fmb_smt_macro *m)
{
    fmb_smt_frame *f = &r->frame[r->frames - 1];
    size_t n = r->values - f->values;
    if (n != m->n)
        return fmb_io_fail(r->c, f->at, "expected %zu argument%s, found %zu", m->n,
                           m->n == 1 ? "" : "s", n);
    fmb_status st = fmb_io_charge(r->c, f->at, FMB_SMT_BYTE_DIGITS * m->bytes);
    if (st == FMB_ERR_PARSE)
        return fmb_io_fail(r->c, f->at,
                           "expected fewer uses of functions: written out, those up "
                           "to here are far longer than the text");
    for (size_t k = 0; st == FMB_OK && k < n; k++) {
        const fmb_smt_param *p = &r->param[m->first + k];
        fmb_smt_value v = r->value[f->values + k];
        if (v.formula != p->formula)
            st = fmb_io_fail(r->c, v.at, "expected a %s as argument, found a %s",
                             p->formula ? "formula" : "number", v.formula ? "formula" : "number");
        else
            st = fmb_smt_bind(&r->scope, p->symbol, v);
    }
    f->kind = FMB_SMT_CALL;
    f->visible = r->scope.visible;
    f->back = r->c->at;
    r->scope.visible = f->locals;
    r->values = f->values;
    r->c->at = m->body;
    return st;
}

/* The body is read: return to the place where the macro is used. */
static fmb_status leave_macro_body(fmb_smt *r, const fmb_smt_frame *f, fmb_smt_value *v)
{
    bool formula = r->macro[r->scope.symbol[f->symbol].index].formula;
    r->c->at = f->back;
    r->scope.visible = f->visible;
    v->at = f->at;
    if (v->formula == formula)
        return FMB_OK;
    return fmb_io_fail(r->c, f->at, "expected a %s from this function, found a %s",
                       formula ? "formula" : "number", formula ? "number" : "formula");
}

/* ---- the machine ----------------------------------------------------------------------------- */

static void leave_top_frame(fmb_smt *r)
{
    const fmb_smt_frame *f = &r->frame[--r->frames];
    fmb_smt_unbind(&r->scope, f->locals);
}

/* Hand v to the frames above base; *done if it is the term asked for. */
static fmb_status deliver_to_open_frames(fmb_smt *r, size_t base, fmb_smt_value *v, bool *done)
{
    fmb_status st = FMB_OK;
    while (st == FMB_OK && r->frames > base) {
        fmb_smt_frame *f = &r->frame[r->frames - 1];
        switch (f->kind) {
        case FMB_SMT_APPLY:
            return push_argument_value(r, *v);
        case FMB_SMT_LET:
            st = push_argument_value(r, *v);
            FMB_THEN(st, expect_closing(r, "')' after the binding"));
            return st == FMB_OK ? read_next_binding(r) : st;
        case FMB_SMT_BODY:
            st = expect_closing(r, "')' after the body of let");
            break;
        case FMB_SMT_NOTE:
            st = take_all_attributes(r, v);
            break;
        case FMB_SMT_CALL:
            st = leave_macro_body(r, f, v);
            break;
        }
        leave_top_frame(r);
    }
    *done = st == FMB_OK;
    return st;
}

/* ')' after arguments: an operator gives a value, a macro continues with its body. */
static fmb_status close_application(fmb_smt *r, size_t base, const fmb_smt_token *t,
                                    fmb_smt_value *v, bool *ready)
{
    if (r->frames == base || r->frame[r->frames - 1].kind != FMB_SMT_APPLY)
        return fmb_io_fail(r->c, t->at, "expected a term, found ')'");
    fmb_smt_frame *f = &r->frame[r->frames - 1];
    const fmb_smt_symbol *head = &r->scope.symbol[f->symbol];
    if (head->meaning == FMB_SMT_MACRO)
        return enter_macro_body(r, &r->macro[head->index]);
    size_t n = r->values - f->values; /* without any there may be no array yet */
    const fmb_smt_application k = {fmb_smt_operator_at(head->index), f->at,
                                   n > 0 ? &r->value[f->values] : NULL, n};
    fmb_status st = fmb_smt_operate(r, &k, v);
    r->values = f->values;
    leave_top_frame(r);
    *ready = st == FMB_OK;
    return st;
}

static fmb_status fail_unknown_name(fmb_smt *r, const fmb_smt_token *t)
{
    return fmb_io_expected(r->c, t->at, "a declared name");
}

/* '(' and a name that is no reserved word. */
static fmb_status open_application(fmb_smt *r, const char *at, const fmb_smt_token *t)
{
    size_t symbol;
    FMB_TRY(fmb_smt_intern(&r->scope, t->text, &symbol));
    fmb_smt_meaning m = r->scope.symbol[symbol].meaning;
    if (fmb_smt_find_local(&r->scope, symbol) || m == FMB_SMT_VALUE || m == FMB_SMT_UNKNOWN)
        return fmb_io_fail(r->c, t->at, "expected an operator or a function with arguments");
    if (m == FMB_SMT_NOTHING)
        return fail_unknown_name(r, t);
    FMB_TRY(push_open_frame(r, FMB_SMT_APPLY, at));
    r->frame[r->frames - 1].symbol = symbol;
    return FMB_OK;
}

static fmb_status open_parenthesis(fmb_smt *r, const char *at)
{
    fmb_smt_token t;
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "an operator", &t));
    if (fmb_smt_is_word(&t, "!"))
        return push_open_frame(r, FMB_SMT_NOTE, at);
    if (fmb_smt_is_word(&t, "let")) {
        FMB_TRY(push_open_frame(r, FMB_SMT_LET, at));
        FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_OPEN, "'(' before the bindings of let", &t));
        return read_next_binding(r);
    }
    if (fmb_smt_is_word(&t, "forall") || fmb_smt_is_word(&t, "exists"))
        return fmb_io_fail(r->c, at, "not a conjunction: a quantifier cannot be read");
    if (fmb_smt_is_word(&t, "_") || fmb_smt_is_word(&t, "as") || fmb_smt_is_word(&t, "match"))
        return fmb_io_fail(r->c, at, "expected linear arithmetic, found '(%.*s'", (int)t.text.n,
                           t.text.p);
    return open_application(r, at, &t);
}

static fmb_status value_of_name(fmb_smt *r, const fmb_smt_token *t, fmb_smt_value *v)
{
    size_t symbol;
    FMB_TRY(fmb_smt_intern(&r->scope, t->text, &symbol));
    const fmb_smt_local *local = fmb_smt_find_local(&r->scope, symbol);
    const fmb_smt_symbol *known = &r->scope.symbol[symbol];
    *v = local ? local->value : known->value;
    v->at = t->at;
    if (local || known->meaning == FMB_SMT_VALUE)
        return FMB_OK;
    v->formula = true;
    if (known->meaning == FMB_SMT_UNKNOWN)
        return fmb_form_unknown(&r->forms, t->at, known->index, &v->id);
    if (known->meaning == FMB_SMT_NOTHING)
        return fail_unknown_name(r, t);
    char buf[FMB_QUOTE];
    return fmb_io_fail(r->c, t->at, "expected '(' and arguments around %s",
                       fmb_quote(r->c, t->at, buf));
}

static fmb_status value_of_numeral(fmb_smt *r, const fmb_smt_token *t, fmb_smt_value *v)
{
    r->c->at = t->at;
    *v = (fmb_smt_value){.at = t->at};
    FMB_TRY(fmb_scan_number(r->c, FMB_NUM_DECIMAL, "a number", r->number));
    return fmb_lin_number(&r->lin, r->number, &v->id);
}

fmb_status fmb_smt_term(fmb_smt *r, fmb_smt_value *out)
{
    size_t base = r->frames;
    bool done = false;
    while (!done) {
        fmb_smt_token t;
        fmb_smt_value v;
        bool ready = false;
        FMB_TRY(fmb_smt_next(r->c, &t));
        if (t.kind == FMB_SMT_OPEN) {
            FMB_TRY(open_parenthesis(r, t.at));
        } else if (t.kind == FMB_SMT_CLOSE) {
            FMB_TRY(close_application(r, base, &t, &v, &ready));
        } else {
            ready = true;
            FMB_TRY(t.kind == FMB_SMT_SYMBOL   ? value_of_name(r, &t, &v)
                    : t.kind == FMB_SMT_NUMBER ? value_of_numeral(r, &t, &v)
                                               : fmb_io_expected(r->c, t.at, "a term"));
        }
        if (ready)
            FMB_TRY(deliver_to_open_frames(r, base, &v, &done));
        if (done)
            *out = v;
    }
    return FMB_OK;
}
