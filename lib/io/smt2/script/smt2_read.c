/* smt2_read.c: SMT-LIB 2 scripts whose assertions are a conjunction of linear constraints.
 *
 * All assertions of the text are one system; commands that ask, set or print are ignored. Facts
 * about Boolean unknowns hold for the whole text, which is read again with them (formula.h). A
 * script whose meaning depends on the order of its commands (push, pop, reset, assumptions) is
 * refused. Source: Barrett, Fontaine, Tinelli, The SMT-LIB Standard, version 2.6, 2017.
 */
#include "io/smt2/script/reading.h"
#include "system/system_private.h"

static fmb_status run_assert_command(fmb_smt *r, const char *open)
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
    FMB_TRY(fmb_smt_term(r, &v));
    FMB_TRY(fmb_smt_check_kind(r, &v, true));
    FMB_TRY(fmb_smt_close_command(r));
    FMB_TRY(fmb_form_assert(&r->forms, v.id, r->s));
    if (!r->named) {
        fmb_forms_forget(&r->forms, formulas);
        fmb_lin_forget(&r->lin, nodes);
    }
    return FMB_OK;
}

static fmb_status note_check_command(fmb_smt *r, const char *open)
{
    r->checked = true;
    return fmb_smt_leave(r->c, open);
}

/* The first objective counts. Behind its term there may be attributes. */
static fmb_status run_objective_command(fmb_smt *r, const char *open, fmb_sense sense)
{
    size_t nodes = r->lin.nodes, formulas = r->forms.nodes;
    fmb_smt_value v;
    if (fmb_system_sense(r->s) != FMB_SENSE_NONE) {
        fmb_io_warn(r->c, open, "ignored: another objective than the first");
        return fmb_smt_leave(r->c, open);
    }
    r->named = false;
    FMB_TRY(fmb_smt_term(r, &v));
    FMB_TRY(fmb_smt_check_kind(r, &v, false));
    FMB_TRY(fmb_smt_leave(r->c, open));
    FMB_TRY(fmb_lin_expand(&r->lin, open, v.id, &r->forms.row));
    FMB_TRY(fmb_draft_set_objective(r->c, open, &r->forms.row, sense, r->s));
    if (!r->named) {
        fmb_forms_forget(&r->forms, formulas);
        fmb_lin_forget(&r->lin, nodes);
    }
    return FMB_OK;
}

static fmb_status run_minimize_command(fmb_smt *r, const char *open)
{
    return run_objective_command(r, open, FMB_SENSE_MIN);
}

static fmb_status run_maximize_command(fmb_smt *r, const char *open)
{
    return run_objective_command(r, open, FMB_SENSE_MAX);
}

static fmb_status leave_at_exit(fmb_smt *r, const char *open)
{
    FMB_TRY(fmb_smt_leave(r->c, open));
    r->c->at = r->c->end;
    return FMB_OK;
}

static fmb_status refuse_command(fmb_smt *r, const char *open)
{
    char buf[FMB_QUOTE];
    return fmb_io_fail(r->c, open, "expected one question a script, found %s, which makes several",
                       fmb_quote(r->c, open, buf));
}

typedef struct command {
    const char *name;
    fmb_smt_command *run;
} command;

static const command commands[] = {
    {"assert", run_assert_command},
    {"declare-fun", fmb_smt_declare_fun},
    {"declare-const", fmb_smt_declare_const},
    {"define-fun", fmb_smt_define_fun},
    {"define-const", fmb_smt_define_const},
    {"define-sort", fmb_smt_define_sort},
    {"check-sat", note_check_command},
    {"check-sat-using", note_check_command},
    {"minimize", run_minimize_command},
    {"maximize", run_maximize_command},
    {"exit", leave_at_exit},
    {"push", refuse_command},
    {"pop", refuse_command},
    {"reset", refuse_command},
    {"reset-assertions", refuse_command},
    {"check-sat-assuming", refuse_command},
};

/* Commands that do not describe the system. */
static const char *const ignored[] = {"set-logic",
                                      "set-info",
                                      "set-option",
                                      "get-model",
                                      "get-value",
                                      "get-assertions",
                                      "get-assignment",
                                      "get-info",
                                      "get-interpolants",
                                      "get-objectives",
                                      "get-option",
                                      "get-proof",
                                      "get-unsat-assumptions",
                                      "get-unsat-core",
                                      "echo"};

fmb_status fmb_smt_run_command(fmb_smt *r, const char *open)
{
    fmb_smt_token t;
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "a command", &t));
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (fmb_span_is(t.text, commands[i].name))
            return commands[i].run(r, open);
    for (size_t i = 0; i < sizeof ignored / sizeof *ignored; i++)
        if (fmb_span_is(t.text, ignored[i]))
            return fmb_smt_leave(r->c, open);
    return fmb_io_expected(r->c, t.at, "a command that can be read");
}

/* A command failed. While Boolean unknowns are open, one that needs a choice between cases is
 * skipped, and after it any failing one: it may lack a name that the skipped one defines. */
static fmb_status pass_over_failed_command(fmb_smt *r, const char *open)
{
    fmb_smt_facts *facts = r->forms.facts;
    if (!facts->passed_over && (!facts->undecided || facts->open == 0))
        return FMB_ERR_PARSE;
    if (!facts->passed_over)
        facts->first = *r->c->where;
    facts->passed_over = true;
    facts->undecided = false;
    r->frames = r->values = r->names = r->scope.visible = 0;
    fmb_smt_unbind(&r->scope, 0);
    r->c->at = open;
    return fmb_smt_skip(r->c, "a command");
}

fmb_status fmb_smt_run(fmb_smt *r, const char *open, fmb_smt_command *run)
{
    fmb_status st = run(r, open);
    return st == FMB_ERR_PARSE ? pass_over_failed_command(r, open) : st;
}

static fmb_status run_all_commands(fmb_smt *r)
{
    for (;;) {
        fmb_smt_token t;
        FMB_TRY(fmb_smt_next(r->c, &t));
        if (t.kind == FMB_SMT_END)
            return FMB_OK;
        if (t.kind != FMB_SMT_OPEN) {
            return fmb_io_expected(r->c, t.at, "'(' of a command");
        }
        FMB_TRY(fmb_smt_run(r, t.at, fmb_smt_run_command));
    }
}

void fmb_smt_begin_reading(fmb_smt_facts *facts)
{
    facts->declared = facts->open = facts->tolds = 0;
    facts->learned = facts->undecided = facts->passed_over = false;
}

fmb_status fmb_smt_end_reading(fmb_cursor *c, const fmb_smt_facts *facts, fmb_status st,
                               bool *again)
{
    *again = false;
    if (!facts->passed_over || (st != FMB_OK && st != FMB_ERR_PARSE))
        return st;
    *c->where = facts->first;
    if (!facts->learned)
        return FMB_ERR_PARSE;
    if (fmb_io_charge(c, c->begin, FMB_SMT_BYTE_DIGITS * (size_t)(c->end - c->begin)) != FMB_OK)
        return fmb_io_fail(
            c, NULL,
            "expected fewer steps from one Boolean unknown to the next: each step is "
            "one more reading of the text");
    *again = true;
    return FMB_OK;
}

/* One reading of the text. *again: another one with more facts must follow; s has lost its rows. */
static fmb_status read_with_facts(fmb_cursor *c, fmb_system *s, fmb_smt_facts *facts, bool *again)
{
    fmb_smt r;
    fmb_smt_begin_reading(facts);
    fmb_status st = fmb_smt_init(&r, c, s, facts);
    FMB_THEN(st, run_all_commands(&r));
    fmb_smt_clear(&r);
    st = fmb_smt_end_reading(c, facts, st, again);
    if (!*again)
        return st;
    c->at = c->begin;
    while (fmb_system_rows(s) > 0)
        fmb_system_remove(s, fmb_system_rows(s) - 1);
    fmb_system_drop_objective(s);
    return FMB_OK;
}

fmb_status fmb_read_smt2(fmb_cursor *c, fmb_system *s)
{
    const fmb_reader *how = c->how;
    fmb_reader silent = *how; /* the first reading has given all warnings */
    fmb_smt_facts facts = {0};
    fmb_status st;
    bool again;
    silent.warn = NULL;
    do {
        st = read_with_facts(c, s, &facts, &again);
        c->how = &silent;
    } while (again);
    c->how = how;
    fmb_smt_facts_clear(&facts, c->mem);
    return st;
}
