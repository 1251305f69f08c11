/* ops.c: the operators of Core and Reals that keep terms linear; see term.h. */
#include "io/smt2/term.h"

static fmb_status reserve_literals(fmb_smt *r, size_t n)
{
    return FMB_RESERVE(r->c->mem, &r->literal, &r->literal_capacity, n);
}

/* ---- terms ----------------------------------------------------------------------------------- */

/* +, and - with `swap`: then all but the first of several arguments are subtracted. */
static fmb_status apply_sum_or_difference(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                          const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    fmb_lin_begin(&r->lin);
    for (size_t i = 0; i < n; i++) {
        bool minus = op->swap && (i > 0 || n == 1);
        mpq_set_si(r->number, minus ? -1 : 1, 1);
        FMB_TRY(fmb_lin_add(&r->lin, at, arg[i].id, r->number));
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

static fmb_status apply_product(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    (void)op;
    out->id = arg[0].id;
    for (size_t i = 1; i < n; i++)
        FMB_TRY(multiply_by_number(r, at, &arg[i], &out->id));
    return FMB_OK;
}

static fmb_status apply_quotient(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                 const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    (void)op;
    out->id = arg[0].id;
    for (size_t i = 1; i < n; i++) {
        bool number;
        FMB_TRY(fmb_lin_constant(&r->lin, arg[i].at, arg[i].id, &number, r->number));
        if (!number)
            return fmb_io_fail(r->c, arg[i].at, "not linear: expected a number as divisor");
        if (mpq_sgn(r->number) == 0)
            return fmb_io_fail(r->c, arg[i].at,
                               "expected a divisor other than zero: SMT-LIB gives x/0 no value");
        mpq_inv(r->number, r->number);
        FMB_TRY(scale_linear_node(r, at, out->id, r->number, &out->id));
    }
    return FMB_OK;
}

static fmb_status apply_identity(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                 const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    (void)r, (void)op, (void)at, (void)n;
    out->id = arg[0].id;
    return FMB_OK;
}

static fmb_status apply_nonlinear(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                  const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    (void)arg, (void)n, (void)out;
    return fmb_io_fail(r->c, at, "not linear: '%s' cannot be read", op->name);
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
static fmb_status apply_comparison_chain(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                         const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    FMB_TRY(reserve_literals(r, n - 1));
    for (size_t i = 0; i + 1 < n; i++) {
        uint32_t a = arg[i].id, b = arg[i + 1].id;
        FMB_TRY(
            compare_two_terms(r, at, op->swap ? b : a, op->swap ? a : b, op->rel, &r->literal[i]));
    }
    if (n == 2)
        out->id = r->literal[0];
    else
        FMB_TRY(fmb_form_and(&r->forms, at, op->name, n - 1, r->literal, &out->id));
    return FMB_OK;
}

/* ---- formulas -------------------------------------------------------------------------------- */

/* and; or and =>, both by not(and(...)) with all parts negated except premises. */
static fmb_status connect_formulas(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                   const fmb_smt_value *arg, size_t n, size_t plain,
                                   fmb_smt_value *out)
{
    FMB_TRY(reserve_literals(r, n));
    for (size_t i = 0; i < n; i++)
        r->literal[i] = arg[i].id ^ (i >= plain);
    return fmb_form_and(&r->forms, at, op->name, n, r->literal, &out->id);
}

static fmb_status apply_conjunction(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                    const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    return connect_formulas(r, op, at, arg, n, n, out);
}

static fmb_status apply_disjunction(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                    const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    fmb_status st = connect_formulas(r, op, at, arg, n, 0, out);
    out->id ^= st == FMB_OK;
    return st;
}

static fmb_status apply_implies(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    fmb_status st = connect_formulas(r, op, at, arg, n, n - 1, out);
    out->id ^= st == FMB_OK;
    return st;
}

static fmb_status apply_negation(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                 const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    (void)r, (void)op, (void)at, (void)n;
    out->id = arg[0].id ^ 1;
    return FMB_OK;
}

/* An odd number of them, as long as at most one is open. */
static fmb_status apply_exclusive_or(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                     const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    size_t open = 0;
    uint32_t rest = FMB_SMT_FALSE, odd = 0;
    (void)op;
    for (size_t i = 0; i < n; i++) {
        fmb_smt_truth t = fmb_form_truth(&r->forms, arg[i].id);
        odd ^= t == FMB_SMT_IS_TRUE;
        if (t == FMB_SMT_OPEN_TRUTH) {
            open++;
            rest = arg[i].id;
        }
    }
    out->id = rest ^ odd;
    return open <= 1 ? FMB_OK : fmb_form_hard(&r->forms, at, "'xor' here", &out->id);
}

/* All alike, as long as the truth of one is known or all are the same. */
static fmb_status apply_equivalence(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                    const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    bool same = true;
    for (size_t i = 0; i < n; i++) {
        fmb_smt_truth t = fmb_form_truth(&r->forms, arg[i].id);
        if (t != FMB_SMT_OPEN_TRUTH)
            return connect_formulas(r, op, at, arg, n, t == FMB_SMT_IS_TRUE ? n : 0, out);
        same = same && arg[i].id == arg[0].id;
    }
    out->id = FMB_SMT_TRUE;
    return same ? FMB_OK : fmb_form_hard(&r->forms, at, "'=' between formulas", &out->id);
}

static fmb_status apply_equality(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                 const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    return (arg[0].formula ? apply_equivalence : apply_comparison_chain)(r, op, at, arg, n, out);
}

static fmb_status apply_distinct(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                 const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    if (n == 2) {
        fmb_status st = apply_equality(r, op, at, arg, n, out);
        out->id ^= st == FMB_OK;
        return st;
    }
    out->id = FMB_SMT_FALSE; /* of three formulas, two are alike */
    return arg[0].formula ? FMB_OK : fmb_form_hard(&r->forms, at, "'distinct' here", &out->id);
}

/* ite(c, a, b) with a known is `c or b` or `not c and b`; with b known, `not c or a` or `c and a`.
 */
static fmb_status choose_formula(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                 const fmb_smt_value *arg, fmb_smt_value *out)
{
    bool first = fmb_form_truth(&r->forms, arg[1].id) != FMB_SMT_OPEN_TRUTH;
    fmb_smt_truth known = fmb_form_truth(&r->forms, arg[first ? 1 : 2].id);
    if (known == FMB_SMT_OPEN_TRUTH)
        return fmb_form_hard(&r->forms, at, "'ite' here", &out->id);
    uint32_t negated = known == FMB_SMT_IS_TRUE;
    uint32_t part[2] = {arg[0].id ^ first, arg[first ? 2 : 1].id ^ negated};
    fmb_status st = fmb_form_and(&r->forms, at, op->name, 2, part, &out->id);
    out->id ^= st == FMB_OK && negated;
    return st;
}

static fmb_status apply_if_then_else(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                                     const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    (void)n;
    if (!arg[0].formula || arg[1].formula != arg[2].formula)
        return fmb_io_fail(r->c, at,
                           "expected a formula, then two terms or two formulas, in 'ite'");
    fmb_smt_truth t = fmb_form_truth(&r->forms, arg[0].id);
    bool same = arg[1].id == arg[2].id;
    out->formula = arg[1].formula;
    out->id = arg[t == FMB_SMT_IS_FALSE ? 2 : 1].id;
    if (t != FMB_SMT_OPEN_TRUTH || same)
        return FMB_OK;
    if (arg[1].formula)
        return choose_formula(r, op, at, arg, out);
    return fmb_form_undecided(&r->forms, at, "'ite' here");
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
    {"=>", FMB_SMT_FORMULAS, 2, SIZE_MAX, apply_implies, FMB_LE, false},
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
static fmb_status check_argument_kinds(fmb_smt *r, const fmb_smt_operator *op,
                                       const fmb_smt_value *arg, size_t n)
{
    bool formula = op->takes == FMB_SMT_EITHER ? arg[0].formula : op->takes == FMB_SMT_FORMULAS;
    for (size_t i = 0; i < n && op->apply != apply_if_then_else; i++)
        if (arg[i].formula != formula)
            return fmb_io_fail(r->c, arg[i].at, "expected a %s as argument of '%s', found a %s",
                               formula ? "formula" : "number", op->name,
                               formula ? "number" : "formula");
    return FMB_OK;
}

fmb_status fmb_smt_operate(fmb_smt *r, const fmb_smt_operator *op, const char *at,
                           const fmb_smt_value *arg, size_t n, fmb_smt_value *out)
{
    if (n < op->least || n > op->most)
        return fmb_io_fail(r->c, at, "expected %s%zu argument%s of '%s', found %zu",
                           op->least == op->most ? "" : "at least ", op->least,
                           op->least == 1 ? "" : "s", op->name, n);
    FMB_TRY(check_argument_kinds(r, op, arg, n));
    bool compares = op->rel != FMB_LE || op->apply == apply_comparison_chain;
    *out = (fmb_smt_value){.formula = compares || op->takes == FMB_SMT_FORMULAS, .at = at};
    return op->apply(r, op, at, arg, n, out);
}
