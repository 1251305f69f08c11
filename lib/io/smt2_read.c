/* smt2_read.c: SMT-LIB 2 scripts whose assertions are a conjunction of linear constraints.
 *
 * All assertions of the text are one system; commands that ask, set or print are ignored. A script
 * whose meaning depends on the order of its commands (push, pop, reset, assumptions) is refused.
 * Source: Barrett, Fontaine, Tinelli, The SMT-LIB Standard, version 2.6, 2017.
 */
#include "io/smt2_term.h"

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
        st = fmb_smt_check_kind(r, &v, true);
    if (st == FMB_OK)
        st = fmb_smt_close_command(r);
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
    fmb_smt_command *run;
} command;

static const command table[] = {
    {"assert", assert_term},
    {"declare-fun", fmb_smt_declare_fun},
    {"declare-const", fmb_smt_declare_const},
    {"define-fun", fmb_smt_define_fun},
    {"define-const", fmb_smt_define_const},
    {"define-sort", fmb_smt_define_sort},
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
