/* reading_state.c: beginning, marking and undoing an incremental reading; see reading.h. */
#include "io/smt2/script/reading.h"

#include "system/system_private.h"

fmb_smt_reading fmb_smt_reading_of(const char *text, size_t size, const fmb_reader *how,
                                   fmb_mem *mem)
{
    fmb_smt_reading g = {.silent = *how};
    g.silent.warn = NULL;
    g.c = fmb_io_cursor(text, size, how, mem, NULL);
    return g;
}

/* Discard all that was read, but keep the facts. */
static void discard_system_read(fmb_smt_reading *g)
{
    if (!g->s)
        return;
    fmb_smt_clear(&g->r);
    fmb_system_free(g->s);
    g->s = NULL;
}

fmb_status fmb_smt_reading_begin(fmb_smt_reading *g)
{
    g->c.where = &g->at;
    discard_system_read(g);
    fmb_smt_begin_reading(&g->facts);
    FMB_TRY(fmb_system_new(0, g->silent.mem, &g->s));
    return fmb_smt_init(&g->r, &g->c, g->s, &g->facts);
}

void fmb_smt_reading_drop(fmb_smt_reading *g)
{
    size_t tokens = g->c.tokens;
    discard_system_read(g);
    fmb_smt_facts_clear(&g->facts, g->c.mem);
    g->c = fmb_io_cursor(g->c.begin, (size_t)(g->c.end - g->c.begin), g->c.how, g->c.mem, NULL);
    g->c.tokens = tokens;
}

fmb_smt_mark fmb_smt_reading_mark(const fmb_smt_reading *g)
{
    const fmb_smt *r = &g->r;
    return (fmb_smt_mark){.rows = fmb_system_rows(g->s),
                          .nodes = r->lin.nodes,
                          .formulas = r->forms.nodes,
                          .givens = r->scope.givens,
                          .macros = r->macros,
                          .params = r->params,
                          .budget = g->c.budget,
                          .tolds = g->facts.tolds,
                          .declared = g->facts.declared,
                          .open = g->facts.open,
                          .dim = fmb_system_dim(g->s),
                          .learned = g->facts.learned,
                          .objective = fmb_system_sense(g->s) != FMB_SENSE_NONE};
}

static void unlearn_facts(fmb_smt_facts *facts, const fmb_smt_mark *m)
{
    while (facts->tolds > m->tolds)
        facts->truth[facts->told[--facts->tolds]] = FMB_SMT_OPEN_TRUTH;
    facts->unknowns = facts->declared = m->declared;
    facts->open = m->open;
    facts->learned = m->learned;
}

void fmb_smt_reading_return(fmb_smt_reading *g, const fmb_smt_mark *m)
{
    fmb_smt *r = &g->r;
    while (fmb_system_rows(g->s) > m->rows)
        fmb_system_remove(g->s, fmb_system_rows(g->s) - 1);
    if (!m->objective)
        fmb_system_drop_objective(g->s);
    while (fmb_system_dim(g->s) > m->dim)
        fmb_system_drop_last_variable(g->s);
    fmb_smt_take_back(&r->scope, m->givens);
    fmb_forms_forget(&r->forms, m->formulas);
    fmb_lin_forget(&r->lin, m->nodes);
    r->macros = m->macros;
    r->params = m->params;
    g->c.budget = m->budget;
    unlearn_facts(&g->facts, m);
}
