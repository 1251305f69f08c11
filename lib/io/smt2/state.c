/* state.c: creating and clearing the state of reading an SMT-LIB text, predefined names, and small
 * steps that commands and terms share. */
#include <string.h>

#include "io/smt2/term.h"

static fmb_status intern_known_name(fmb_smt *r, const char *name, fmb_smt_symbol **out)
{
    size_t symbol;
    FMB_TRY(fmb_smt_intern(&r->scope, (fmb_span){name, strlen(name)}, &symbol));
    *out = &r->scope.symbol[symbol];
    return FMB_OK;
}

static fmb_status intern_known_sort(fmb_smt *r, const char *name, fmb_smt_sort sort)
{
    fmb_smt_symbol *s;
    FMB_TRY(intern_known_name(r, name, &s));
    s->is_sort = true;
    s->sort = sort;
    return FMB_OK;
}

static fmb_status intern_truth_value(fmb_smt *r, const char *name, uint32_t literal)
{
    fmb_smt_symbol *s;
    FMB_TRY(intern_known_name(r, name, &s));
    s->meaning = FMB_SMT_VALUE;
    s->value = (fmb_smt_value){.formula = true, .id = literal};
    return FMB_OK;
}

fmb_status fmb_smt_init(fmb_smt *r, fmb_cursor *c, fmb_system *s, fmb_smt_facts *facts)
{
    *r = (fmb_smt){.c = c, .s = s};
    mpq_init(r->number);
    fmb_lin_init(&r->lin, c);
    fmb_smt_scope_init(&r->scope, c->mem);
    FMB_TRY(fmb_forms_init(&r->forms, &r->lin, facts));
    FMB_TRY(intern_known_sort(r, "Real", FMB_SMT_REAL));
    FMB_TRY(intern_known_sort(r, "Int", FMB_SMT_INT));
    FMB_TRY(intern_known_sort(r, "Bool", FMB_SMT_BOOL));
    FMB_TRY(intern_truth_value(r, "true", FMB_SMT_TRUE));
    FMB_TRY(intern_truth_value(r, "false", FMB_SMT_FALSE));
    const fmb_smt_operator *op;
    for (size_t i = 0; (op = fmb_smt_operator_at(i)) != NULL; i++) {
        fmb_smt_symbol *known;
        FMB_TRY(intern_known_name(r, op->name, &known));
        known->meaning = FMB_SMT_OPERATOR;
        known->index = i;
    }
    return FMB_OK;
}

void fmb_smt_clear(fmb_smt *r)
{
    fmb_mem *mem = r->c->mem;
    fmb_mem_put(mem, r->frame, r->frame_capacity, sizeof *r->frame);
    fmb_mem_put(mem, r->value, r->value_capacity, sizeof *r->value);
    fmb_mem_put(mem, r->name, r->name_capacity, sizeof *r->name);
    fmb_mem_put(mem, r->macro, r->macro_capacity, sizeof *r->macro);
    fmb_mem_put(mem, r->param, r->param_capacity, sizeof *r->param);
    fmb_mem_put(mem, r->literal, r->literal_capacity, sizeof *r->literal);
    fmb_smt_scope_clear(&r->scope);
    fmb_forms_clear(&r->forms);
    fmb_lin_clear(&r->lin);
    mpq_clear(r->number);
}

/* ---- what commands and terms share ----------------------------------------------------------- */

fmb_status fmb_smt_new_name(fmb_smt *r, size_t *symbol, const char **at)
{
    fmb_smt_token t;
    FMB_TRY(fmb_smt_expect(r->c, FMB_SMT_SYMBOL, "a name", &t));
    FMB_TRY(fmb_smt_intern(&r->scope, t.text, symbol));
    *at = t.at;
    if (t.text.n == 0)
        return fmb_io_fail(r->c, t.at, "expected a name that is not empty");
    if (r->scope.symbol[*symbol].meaning == FMB_SMT_NOTHING)
        return FMB_OK;
    char buf[FMB_QUOTE];
    return fmb_io_fail(r->c, t.at, "expected a new name, found %s, which has a meaning already",
                       fmb_quote(r->c, t.at, buf));
}

fmb_status fmb_smt_close_command(fmb_smt *r)
{
    fmb_smt_token t;
    return fmb_smt_expect(r->c, FMB_SMT_CLOSE, "')' to end the command", &t);
}

fmb_status fmb_smt_check_kind(fmb_smt *r, const fmb_smt_value *v, bool formula)
{
    if (v->formula == formula)
        return FMB_OK;
    return fmb_io_fail(r->c, v->at, "expected a %s, found a %s", formula ? "formula" : "number",
                       formula ? "number" : "formula");
}
