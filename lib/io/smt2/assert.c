/* assert.c: an asserted formula, flattened to rows; see formula.h.
 *
 * `a and b` gives the rows of both; not(a and b) is a conjunction only if all but one of its parts
 * are known. A conjunction that occurs again within one assertion has given its rows already: so
 * sharing never multiplies the work.
 */
#include "io/smt2/formula.h"

static fmb_status push_assertion_task(fmb_forms *f, size_t *n, uint32_t literal, fmb_span label)
{
    FMB_TRY(FMB_RESERVE(f->lin->c->mem, &f->task, &f->task_capacity, *n + 1));
    f->task[(*n)++] = (fmb_form_task){literal, label};
    return FMB_OK;
}

/* A term of a row takes the memory of about so many digits. Sharing can turn a short text into many
 * long rows, so terms are charged to the budget. */
#define TERM_DIGITS 32

static fmb_status append_paid_row(fmb_forms *f, const char *at, fmb_rel rel, fmb_span label,
                                  fmb_system *s)
{
    fmb_status st = fmb_io_charge(f->lin->c, at, TERM_DIGITS * f->row.n);
    if (st == FMB_ERR_PARSE)
        return fmb_io_fail(f->lin->c, at,
                           "expected less sharing: written out, the rows up to here "
                           "are far longer than the text");
    st = fmb_draft_append(f->lin->c, at, &f->row, rel, s);
    if (st == FMB_OK && label.p)
        st = fmb_span_label(f->lin->c, label, s, fmb_system_rows(s) - 1);
    return st;
}

/* 0 <= -1 */
static fmb_status append_false_row(fmb_forms *f, const char *at, fmb_span label, fmb_system *s)
{
    fmb_draft_reset(&f->row);
    mpq_set_si(f->row.rhs, -1, 1);
    return append_paid_row(f, at, FMB_LE, label, s);
}

/* Record that a Boolean unknown is true, or false. */
static fmb_status learn_fact(fmb_forms *f, const fmb_form_task *k, fmb_system *s)
{
    const fmb_form_node *v = &f->node[k->literal / 2];
    fmb_smt_truth *known = &f->facts->truth[v->unknown];
    fmb_smt_truth said = k->literal % 2 ? FMB_SMT_IS_FALSE : FMB_SMT_IS_TRUE;
    if (*known != FMB_SMT_OPEN_TRUTH)
        return *known == said ? FMB_OK : append_false_row(f, v->at, k->label, s);
    fmb_smt_facts *facts = f->facts;
    FMB_TRY(FMB_RESERVE(f->lin->c->mem, &facts->told, &facts->told_capacity, facts->tolds + 1));
    facts->told[facts->tolds++] = v->unknown;
    *known = said;
    facts->learned = true;
    facts->open--;
    return FMB_OK;
}

/* Append t REL 0, or its negation: not(t <= 0) is -t < 0, and so on. */
static fmb_status append_atom_row(fmb_forms *f, const fmb_form_task *k, fmb_system *s)
{
    const fmb_form_node *v = &f->node[k->literal / 2];
    bool negated = k->literal % 2 == 1;
    if (negated && v->rel == FMB_EQ && v->truth == FMB_SMT_IS_FALSE)
        return FMB_OK;
    if (negated && v->rel == FMB_EQ && v->truth == FMB_SMT_IS_TRUE)
        return append_false_row(f, v->at, k->label, s);
    fmb_status st = fmb_lin_expand(f->lin, v->at, v->lin, &f->row);
    if (st != FMB_OK || !negated)
        return st == FMB_OK ? append_paid_row(f, v->at, v->rel, k->label, s) : st;
    if (v->rel == FMB_EQ)
        return fmb_form_undecided(f, v->at, "the negation of '='");
    fmb_draft_negate(&f->row);
    return append_paid_row(f, v->at, v->rel == FMB_LE ? FMB_LT : FMB_LE, k->label, s);
}

/* Assert all parts; of a conjunction known to be false, only a false part. */
static fmb_status push_all_parts(fmb_forms *f, const fmb_form_node *v, fmb_span label, size_t *n)
{
    for (uint32_t k = v->n; k-- > 0;) {
        uint32_t part = f->child[v->first + k];
        if (v->truth != FMB_SMT_IS_FALSE || fmb_form_truth(f, part) == FMB_SMT_IS_FALSE)
            FMB_TRY(push_assertion_task(f, n, part, label));
    }
    return FMB_OK;
}

/* Assert that some part is false: a conjunction only if a single part is open. */
static fmb_status push_only_open_part(fmb_forms *f, const fmb_form_node *v, fmb_span label,
                                      size_t *n)
{
    size_t open = 0;
    uint32_t last = FMB_SMT_TRUE;
    for (uint32_t k = 0; k < v->n; k++) {
        uint32_t part = f->child[v->first + k];
        if (fmb_form_truth(f, part) == FMB_SMT_OPEN_TRUTH) {
            open += open == 0 || part != last;
            last = part;
        }
    }
    if (open == 1)
        return push_assertion_task(f, n, last ^ 1, label);
    char what[32];
    snprintf(what, sizeof what, "'%s' here", v->word);
    return fmb_form_undecided(f, v->at, what);
}

static fmb_status take_assertion_task(fmb_forms *f, const fmb_form_task *k, size_t *n,
                                      fmb_system *s)
{
    fmb_form_node *v = &f->node[k->literal / 2];
    fmb_smt_truth truth = fmb_form_truth(f, k->literal);
    uint32_t negated = k->literal % 2;
    switch (v->kind) {
    case FMB_FORM_TRUE:
        return negated ? append_false_row(f, f->lin->c->at, k->label, s) : FMB_OK;
    case FMB_FORM_ATOM:
        return append_atom_row(f, k, s);
    case FMB_FORM_UNKNOWN:
        return learn_fact(f, k, s);
    case FMB_FORM_LABEL:
        return push_assertion_task(f, n, f->child[v->first] ^ negated, v->label);
    case FMB_FORM_HARD:
        return fmb_form_undecided(f, v->at, v->word);
    case FMB_FORM_AND:
        break;
    }
    if (v->stamp[negated] == f->stamp)
        return FMB_OK;
    v->stamp[negated] = f->stamp;
    if (!negated)
        return push_all_parts(f, v, k->label, n);
    if (truth == FMB_SMT_IS_TRUE)
        return FMB_OK;
    return truth == FMB_SMT_IS_FALSE ? append_false_row(f, v->at, k->label, s)
                                     : push_only_open_part(f, v, k->label, n);
}

fmb_status fmb_form_assert(fmb_forms *f, uint32_t literal, fmb_system *s)
{
    size_t n = 0;
    f->stamp++;
    FMB_TRY(push_assertion_task(f, &n, literal, (fmb_span){NULL, 0}));
    while (n > 0) {
        const fmb_form_task k = f->task[--n];
        FMB_TRY(take_assertion_task(f, &k, &n, s));
    }
    return FMB_OK;
}
