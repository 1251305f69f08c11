/* ops.c: the operators of Core and Reals that keep terms linear; see term.h. */
#include "io/smt2/term.h"

static fmb_status reserve_literals(fmb_smt *r, size_t n)
{
    return FMB_RESERVE(r->c->mem, &r->literal, &r->literal_capacity, n);
}

/* ---- terms ----------------------------------------------------------------------------------- */

/* +, and - with `swap`: then all but the first of several arguments are subtracted. */
static fmb_status apply_sum_or_difference(fmb_smt *r, const fmb_smt_application *k,
                                          fmb_smt_value *out)
{
    fmb_lin_begin(&r->lin);
    for (size_t i = 0; i < k->n; i++) {
        bool minus = k->op->swap && (i > 0 || k->n == 1);
        mpq_set_si(r->number, minus ? -1 : 1, 1);
        FMB_TRY(fmb_lin_add(&r->lin, k->at, k->arg[i].id, r->number));
    }
    return fmb_lin_end(&r->lin, &out->id);
}

static fmb_status scale_linear_node(fmb_smt *r, const char *at, uint32_t node, mpq_srcptr by,
                                    uint32_t *out)
{
    fmb_lin_begin(&r->lin);
    FMB_TRY(fmb_lin_add(&r->lin, at, node, by));
    return fmb_lin_end(&r->lin, out);
}

/* Multiply *node by arg; one of them must be a number. */
static fmb_status multiply_by_number(fmb_smt *r, const char *at, const fmb_smt_value *arg,
                                     uint32_t *node)
{
    bool number;
    FMB_TRY(fmb_lin_constant(&r->lin, arg->at, arg->id, &number, r->number));
    if (number)
        return scale_linear_node(r, at, *node, r->number, node);
    FMB_TRY(fmb_lin_constant(&r->lin, at, *node, &number, r->number));
    if (number)
        return scale_linear_node(r, at, arg->id, r->number, node);
    return fmb_io_fail(r->c, at,
                       "not linear: expected a product with at most one factor that "
                       "is not a number");
}

static fmb_status apply_product(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    out->id = k->arg[0].id;
    for (size_t i = 1; i < k->n; i++)
        FMB_TRY(multiply_by_number(r, k->at, &k->arg[i], &out->id));
    return FMB_OK;
}

static fmb_status apply_quotient(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    out->id = k->arg[0].id;
    for (size_t i = 1; i < k->n; i++) {
        bool number;
        FMB_TRY(fmb_lin_constant(&r->lin, k->arg[i].at, k->arg[i].id, &number, r->number));
        if (!number)
            return fmb_io_fail(r->c, k->arg[i].at, "not linear: expected a number as divisor");
        if (mpq_sgn(r->number) == 0)
            return fmb_io_fail(r->c, k->arg[i].at,
                               "expected a divisor other than zero: SMT-LIB gives x/0 no value");
        mpq_inv(r->number, r->number);
        FMB_TRY(scale_linear_node(r, k->at, out->id, r->number, &out->id));
    }
    return FMB_OK;
}

static fmb_status apply_identity(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    (void)r;
    out->id = k->arg[0].id;
    return FMB_OK;
}

static fmb_status apply_nonlinear(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    (void)out;
    return fmb_io_fail(r->c, k->at, "not linear: '%s' cannot be read", k->op->name);
}

/* ---- comparisons ----------------------------------------------------------------------------- */

static fmb_status compare_two_terms(fmb_smt *r, const char *at, uint32_t a, uint32_t b, fmb_rel rel,
                                    uint32_t *out)
{
    uint32_t difference;
    fmb_lin_begin(&r->lin);
    mpq_set_si(r->number, 1, 1);
    fmb_status st = fmb_lin_add(&r->lin, at, a, r->number);
    mpq_set_si(r->number, -1, 1);
    FMB_THEN(st, fmb_lin_add(&r->lin, at, b, r->number));
    FMB_THEN(st, fmb_lin_end(&r->lin, &difference));
    return st == FMB_OK ? fmb_form_atom(&r->forms, at, difference, rel, out) : st;
}

/* a REL b REL c ... */
static fmb_status apply_comparison_chain(fmb_smt *r, const fmb_smt_application *k,
                                         fmb_smt_value *out)
{
    FMB_TRY(reserve_literals(r, k->n - 1));
    for (size_t i = 0; i + 1 < k->n; i++) {
        uint32_t a = k->arg[i].id, b = k->arg[i + 1].id;
        FMB_TRY(compare_two_terms(r, k->at, k->op->swap ? b : a, k->op->swap ? a : b, k->op->rel,
                                  &r->literal[i]));
    }
    if (k->n == 2)
        out->id = r->literal[0];
    else
        FMB_TRY(fmb_form_and(&r->forms, k->at, k->op->name, k->n - 1, r->literal, &out->id));
    return FMB_OK;
}

/* ---- formulas -------------------------------------------------------------------------------- */

/* All of them, those from number `plain` on negated. */
static fmb_status connect_formulas(fmb_smt *r, const fmb_smt_application *k, size_t plain,
                                   fmb_smt_value *out)
{
    FMB_TRY(reserve_literals(r, k->n));
    for (size_t i = 0; i < k->n; i++)
        r->literal[i] = k->arg[i].id ^ (i >= plain);
    return fmb_form_and(&r->forms, k->at, k->op->name, k->n, r->literal, &out->id);
}

static fmb_status apply_conjunction(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    return connect_formulas(r, k, k->n, out);
}

/* or and =>, by not(and(...)) with all parts negated except the premises of =>. */
static fmb_status apply_disjunction(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    fmb_status st = connect_formulas(r, k, k->op->swap ? k->n - 1 : 0, out);
    out->id ^= st == FMB_OK;
    return st;
}

static fmb_status apply_negation(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    (void)r;
    out->id = k->arg[0].id ^ 1;
    return FMB_OK;
}

/* An odd number of them, as long as at most one is open. */
static fmb_status apply_exclusive_or(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    size_t open = 0;
    uint32_t rest = FMB_SMT_FALSE, odd = 0;
    for (size_t i = 0; i < k->n; i++) {
        fmb_smt_truth t = fmb_form_truth(&r->forms, k->arg[i].id);
        odd ^= t == FMB_SMT_IS_TRUE;
        if (t == FMB_SMT_OPEN_TRUTH) {
            open++;
            rest = k->arg[i].id;
        }
    }
    out->id = rest ^ odd;
    return open <= 1 ? FMB_OK : fmb_form_hard(&r->forms, k->at, "'xor' here", &out->id);
}

/* All alike, as long as the truth of one is known or all are the same. */
static fmb_status apply_equivalence(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    bool same = true;
    for (size_t i = 0; i < k->n; i++) {
        fmb_smt_truth t = fmb_form_truth(&r->forms, k->arg[i].id);
        if (t != FMB_SMT_OPEN_TRUTH)
            return connect_formulas(r, k, t == FMB_SMT_IS_TRUE ? k->n : 0, out);
        same = same && k->arg[i].id == k->arg[0].id;
    }
    out->id = FMB_SMT_TRUE;
    return same ? FMB_OK : fmb_form_hard(&r->forms, k->at, "'=' between formulas", &out->id);
}

static fmb_status apply_equality(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    return (k->arg[0].formula ? apply_equivalence : apply_comparison_chain)(r, k, out);
}

static fmb_status apply_distinct(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    if (k->n == 2) {
        fmb_status st = apply_equality(r, k, out);
        out->id ^= st == FMB_OK;
        return st;
    }
    out->id = FMB_SMT_FALSE; /* of three formulas, two are alike */
    return k->arg[0].formula ? FMB_OK
                             : fmb_form_hard(&r->forms, k->at, "'distinct' here", &out->id);
}

/* ite(c, a, b) with a known is `c or b` or `not c and b`; with b known, `not c or a` or `c and a`.
 */
static fmb_status choose_formula(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    bool first = fmb_form_truth(&r->forms, k->arg[1].id) != FMB_SMT_OPEN_TRUTH;
    fmb_smt_truth known = fmb_form_truth(&r->forms, k->arg[first ? 1 : 2].id);
    if (known == FMB_SMT_OPEN_TRUTH)
        return fmb_form_hard(&r->forms, k->at, "'ite' here", &out->id);
    uint32_t negated = known == FMB_SMT_IS_TRUE;
    uint32_t part[2] = {k->arg[0].id ^ first, k->arg[first ? 2 : 1].id ^ negated};
    fmb_status st = fmb_form_and(&r->forms, k->at, k->op->name, 2, part, &out->id);
    out->id ^= st == FMB_OK && negated;
    return st;
}

static fmb_status apply_if_then_else(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    if (!k->arg[0].formula || k->arg[1].formula != k->arg[2].formula)
        return fmb_io_fail(r->c, k->at,
                           "expected a formula, then two terms or two formulas, in 'ite'");
    fmb_smt_truth t = fmb_form_truth(&r->forms, k->arg[0].id);
    bool same = k->arg[1].id == k->arg[2].id;
    out->formula = k->arg[1].formula;
    out->id = k->arg[t == FMB_SMT_IS_FALSE ? 2 : 1].id;
    if (t != FMB_SMT_OPEN_TRUTH || same)
        return FMB_OK;
    if (k->arg[1].formula)
        return choose_formula(r, k, out);
    return fmb_form_undecided(&r->forms, k->at, "'ite' here");
}

/* ---- table ----------------------------------------------------------------------------------- */

static const fmb_smt_operator table[] = {
    {"+", FMB_SMT_TERMS, 1, SIZE_MAX, apply_sum_or_difference, FMB_LE, false},
    {"-", FMB_SMT_TERMS, 1, SIZE_MAX, apply_sum_or_difference, FMB_LE, true},
    {"*", FMB_SMT_TERMS, 1, SIZE_MAX, apply_product, FMB_LE, false},
    {"/", FMB_SMT_TERMS, 2, SIZE_MAX, apply_quotient, FMB_LE, false},
    {"<=", FMB_SMT_TERMS, 2, SIZE_MAX, apply_comparison_chain, FMB_LE, false},
    {"<", FMB_SMT_TERMS, 2, SIZE_MAX, apply_comparison_chain, FMB_LT, false},
    {">=", FMB_SMT_TERMS, 2, SIZE_MAX, apply_comparison_chain, FMB_LE, true},
    {">", FMB_SMT_TERMS, 2, SIZE_MAX, apply_comparison_chain, FMB_LT, true},
    {"=", FMB_SMT_EITHER, 2, SIZE_MAX, apply_equality, FMB_EQ, false},
    {"distinct", FMB_SMT_EITHER, 2, SIZE_MAX, apply_distinct, FMB_EQ, false},
    {"and", FMB_SMT_FORMULAS, 1, SIZE_MAX, apply_conjunction, FMB_LE, false},
    {"or", FMB_SMT_FORMULAS, 1, SIZE_MAX, apply_disjunction, FMB_LE, false},
    {"not", FMB_SMT_FORMULAS, 1, 1, apply_negation, FMB_LE, false},
    {"=>", FMB_SMT_FORMULAS, 2, SIZE_MAX, apply_disjunction, FMB_LE, true},
    {"xor", FMB_SMT_FORMULAS, 2, SIZE_MAX, apply_exclusive_or, FMB_LE, false},
    {"ite", FMB_SMT_EITHER, 3, 3, apply_if_then_else, FMB_LE, false},
    {"to_real", FMB_SMT_TERMS, 1, 1, apply_identity, FMB_LE, false},
    {"div", FMB_SMT_TERMS, 0, SIZE_MAX, apply_nonlinear, FMB_LE, false},
    {"mod", FMB_SMT_TERMS, 0, SIZE_MAX, apply_nonlinear, FMB_LE, false},
    {"abs", FMB_SMT_TERMS, 0, SIZE_MAX, apply_nonlinear, FMB_LE, false},
    {"to_int", FMB_SMT_TERMS, 0, SIZE_MAX, apply_nonlinear, FMB_LE, false},
    {"is_int", FMB_SMT_TERMS, 0, SIZE_MAX, apply_nonlinear, FMB_LE, false},
};

const fmb_smt_operator *fmb_smt_operator_at(size_t i)
{
    return i < sizeof table / sizeof *table ? &table[i] : NULL;
}

/* Check that arguments are terms or formulas as the operator needs them; if it takes either, all
 * must be alike except the condition of ite, which is checked elsewhere. */
static fmb_status check_argument_kinds(fmb_smt *r, const fmb_smt_application *k)
{
    const fmb_smt_operator *op = k->op;
    bool formula = op->takes == FMB_SMT_EITHER ? k->arg[0].formula : op->takes == FMB_SMT_FORMULAS;
    for (size_t i = 0; i < k->n && op->apply != apply_if_then_else; i++)
        if (k->arg[i].formula != formula)
            return fmb_io_fail(r->c, k->arg[i].at, "expected a %s as argument of '%s', found a %s",
                               formula ? "formula" : "number", op->name,
                               formula ? "number" : "formula");
    return FMB_OK;
}

fmb_status fmb_smt_operate(fmb_smt *r, const fmb_smt_application *k, fmb_smt_value *out)
{
    const fmb_smt_operator *op = k->op;
    if (k->n < op->least || k->n > op->most)
        return fmb_io_fail(r->c, k->at, "expected %s%zu argument%s of '%s', found %zu",
                           op->least == op->most ? "" : "at least ", op->least,
                           op->least == 1 ? "" : "s", op->name, k->n);
    FMB_TRY(check_argument_kinds(r, k));
    bool compares = op->rel != FMB_LE || op->apply == apply_comparison_chain;
    *out = (fmb_smt_value){.formula = compares || op->takes == FMB_SMT_FORMULAS, .at = k->at};
    return op->apply(r, k, out);
}
