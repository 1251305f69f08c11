/* formula.c: making formulas; see formula.h. */
#include "io/smt2/formula.h"

static fmb_status new_formula_node(fmb_forms *f, const fmb_form_node *v, uint32_t *out)
{
    fmb_mem *mem = f->lin->c->mem;
    if (f->nodes > UINT32_MAX / 2)
        return FMB_ERR_MEMORY;
    FMB_TRY(FMB_RESERVE(mem, &f->node, &f->node_capacity, f->nodes + 1));
    f->node[f->nodes] = *v;
    *out = (uint32_t)(2 * f->nodes++);
    return FMB_OK;
}

fmb_status fmb_forms_init(fmb_forms *f, fmb_lin *lin, fmb_smt_facts *facts)
{
    uint32_t truth;
    *f = (fmb_forms){.lin = lin, .facts = facts};
    fmb_draft_init(&f->row, lin->c->mem);
    return new_formula_node(f, &(fmb_form_node){.kind = FMB_FORM_TRUE, .truth = FMB_SMT_IS_TRUE},
                            &truth);
}

void fmb_forms_clear(fmb_forms *f)
{
    fmb_mem *mem = f->lin->c->mem;
    fmb_draft_clear(&f->row);
    fmb_mem_put(mem, f->node, f->node_capacity, sizeof *f->node);
    fmb_mem_put(mem, f->child, f->child_capacity, sizeof *f->child);
    fmb_mem_put(mem, f->task, f->task_capacity, sizeof *f->task);
}

void fmb_forms_forget(fmb_forms *f, size_t nodes)
{
    for (; f->nodes > nodes; f->nodes--)
        f->children -= f->node[f->nodes - 1].n;
}

fmb_smt_truth fmb_form_truth(const fmb_forms *f, uint32_t literal)
{
    fmb_smt_truth t = f->node[literal / 2].truth;
    if (t == FMB_SMT_OPEN_TRUTH || literal % 2 == 0)
        return t;
    return t == FMB_SMT_IS_TRUE ? FMB_SMT_IS_FALSE : FMB_SMT_IS_TRUE;
}

/* number REL 0 */
static fmb_smt_truth truth_of_constant_atom(mpq_srcptr number, fmb_rel rel)
{
    int sign = mpq_sgn(number);
    bool holds = rel == FMB_LE ? sign <= 0 : rel == FMB_LT ? sign < 0 : sign == 0;
    return holds ? FMB_SMT_IS_TRUE : FMB_SMT_IS_FALSE;
}

fmb_status fmb_form_atom(fmb_forms *f, const char *at, uint32_t lin, fmb_rel rel, uint32_t *out)
{
    fmb_form_node v = {.kind = FMB_FORM_ATOM, .at = at, .lin = lin, .rel = rel};
    if (fmb_lin_is_bare(f->lin, lin))
        v.truth = truth_of_constant_atom(f->lin->node[lin].constant, rel);
    return new_formula_node(f, &v, out);
}

/* A node with n children, whose kind, place and word are set in v. */
static fmb_status new_node_with_children(fmb_forms *f, fmb_form_node *v, size_t n,
                                         const uint32_t *literal, uint32_t *out)
{
    if (n >= UINT32_MAX)
        return FMB_ERR_MEMORY;
    fmb_status st = FMB_RESERVE(f->lin->c->mem, &f->child, &f->child_capacity, f->children + n);
    v->first = f->children;
    v->n = (uint32_t)n;
    FMB_THEN(st, new_formula_node(f, v, out));
    if (st != FMB_OK)
        return st;
    for (size_t k = 0; k < n; k++)
        f->child[f->children++] = literal[k];
    return FMB_OK;
}

fmb_status fmb_form_and(fmb_forms *f, const char *at, const char *word, size_t n,
                        const uint32_t *literal, uint32_t *out)
{
    fmb_form_node v = {.kind = FMB_FORM_AND, .at = at, .word = word, .truth = FMB_SMT_IS_TRUE};
    for (size_t k = 0; k < n; k++) {
        fmb_smt_truth t = fmb_form_truth(f, literal[k]);
        if (t == FMB_SMT_IS_FALSE || v.truth == FMB_SMT_IS_TRUE)
            v.truth = t;
    }
    return new_node_with_children(f, &v, n, literal, out);
}

fmb_status fmb_form_label(fmb_forms *f, const char *at, fmb_span label, uint32_t literal,
                          uint32_t *out)
{
    fmb_form_node v = {.kind = FMB_FORM_LABEL, .at = at, .label = label};
    v.truth = fmb_form_truth(f, literal);
    return new_node_with_children(f, &v, 1, &literal, out);
}

fmb_status fmb_form_hard(fmb_forms *f, const char *at, const char *word, uint32_t *out)
{
    return new_formula_node(f, &(fmb_form_node){.kind = FMB_FORM_HARD, .at = at, .word = word},
                            out);
}

fmb_status fmb_form_unknown(fmb_forms *f, const char *at, size_t unknown, uint32_t *out)
{
    fmb_smt_truth truth = f->facts->truth[unknown];
    if (truth == FMB_SMT_OPEN_TRUTH)
        return new_formula_node(
            f, &(fmb_form_node){.kind = FMB_FORM_UNKNOWN, .at = at, .unknown = unknown}, out);
    *out = truth == FMB_SMT_IS_TRUE ? FMB_SMT_TRUE : FMB_SMT_FALSE;
    return FMB_OK;
}

fmb_status fmb_form_undecided(fmb_forms *f, const char *at, const char *what)
{
    f->facts->undecided = true;
    return fmb_io_fail(f->lin->c, at, "not a conjunction: %s needs a search over cases", what);
}
