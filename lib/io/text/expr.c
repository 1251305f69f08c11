/* expr.c: linear expressions of the .fmb format, by recursive descent; see text.h.
 *
 *   expression = term {("+" | "-") term}
 *   term       = factor {("*" | "/" | nothing) factor}      nothing: before a name or "("
 *   factor     = {"+" | "-"} (number | name | "(" expression ")")
 *
 * A subexpression, once read, is a constant plus the terms coef[from..n) of the draft. A product is
 * linear if one of its factors has no terms. Every product and sum of long numbers is charged.
 */
#include "io/text/text.h"

static fmb_status read_sum_of_terms(fmb_text *t, fmb_draft *d, mpq_t constant, int depth);

/* A minus sign: ASCII, or U+2212. */
static bool accept_minus_sign(fmb_cursor *c)
{
    return fmb_accept(c, "-") || fmb_accept(c, "\xE2\x88\x92");
}

static fmb_status read_variable_factor(fmb_text *t, fmb_draft *d)
{
    const char *p = t->c->at;
    fmb_span name;
    int j = 0;
    FMB_TRY(fmb_text_scan_name(t, &name));
    FMB_TRY(fmb_text_variable(t, p, name, &j));
    mpq_ptr slot;
    FMB_TRY(fmb_draft_term(d, j, &slot));
    mpq_set_ui(slot, 1, 1);
    return FMB_OK;
}

static fmb_status read_parenthesis(fmb_text *t, fmb_draft *d, mpq_t constant, int depth)
{
    fmb_cursor *c = t->c;
    if (depth >= FMB_TEXT_DEPTH)
        return fmb_io_fail(c, c->at, "expected at most %d parentheses inside each other",
                           FMB_TEXT_DEPTH);
    c->at++;
    FMB_TRY(read_sum_of_terms(t, d, constant, depth + 1));
    return !fmb_accept(c, ")") ? fmb_io_expected(c, c->at, "an operator or ')'") : FMB_OK;
}

/* A product costs more than reading a number: (x + y + ...)*1*1*1 and 1e99999*1e99999*... must not
 * take long. Each entry is charged PRODUCT_ENTRY, and a multiple of its digits. */
#define PRODUCT_ENTRY 16
#define PRODUCT_DIGIT 4

/* a = a q. A new name has coefficient 1: then q is only copied. */
static fmb_status multiply_entry(fmb_cursor *c, mpq_ptr a, mpq_srcptr q)
{
    size_t weight = mpq_cmp_ui(a, 1, 1) == 0 ? 1 : PRODUCT_DIGIT;
    mpq_mul(a, a, q);
    return fmb_io_charge(c, c->at, PRODUCT_ENTRY + weight * fmb_io_digits(a));
}

/* Multiply constant and the terms from `from` on by q. */
static fmb_status scale_linear_piece(fmb_text *t, fmb_draft *d, size_t from, mpq_t constant,
                                     const mpq_t q)
{
    FMB_TRY(multiply_entry(t->c, constant, q));
    for (size_t k = from; k < d->n; k++)
        FMB_TRY(multiply_entry(t->c, d->coef[k], q));
    return FMB_OK;
}

static void negate_linear_piece(fmb_draft *d, size_t from, mpq_t constant)
{
    mpq_neg(constant, constant);
    for (size_t k = from; k < d->n; k++)
        mpq_neg(d->coef[k], d->coef[k]);
}

/* `1e` may be 1 times e, or a number whose exponent was cut off: ambiguous, hence refused, unless
 * variables are declared. */
static fmb_status refuse_cut_exponent(const fmb_text *t, const char *number)
{
    fmb_cursor *c = t->c;
    char found[FMB_QUOTE];
    if (t->declared || (fmb_peek(c) | 32) != 'e' ||
        fmb_text_name_char(c->at + 1, (size_t)(c->end - c->at) - 1, false) > 0)
        return FMB_OK;
    return fmb_io_fail(c, c->at,
                       "expected '*' or the digits of an exponent: %s may be a product with the "
                       "variable %c, or a number that was cut off",
                       fmb_quote(c, number, found), *c->at);
}

/* Sets constant. */
static fmb_status read_signed_factor(fmb_text *t, fmb_draft *d, mpq_t constant, int depth)
{
    fmb_cursor *c = t->c;
    bool minus = false;
    size_t from = d->n;
    for (fmb_skip_blanks(c);; fmb_skip_blanks(c)) {
        if (accept_minus_sign(c))
            minus = !minus;
        else if (!fmb_accept(c, "+"))
            break;
    }
    mpq_set_ui(constant, 0, 1);
    if (fmb_peek(c) == '(') {
        FMB_TRY(read_parenthesis(t, d, constant, depth));
    } else if (fmb_text_is_at_name(c)) {
        FMB_TRY(read_variable_factor(t, d));
    } else {
        const char *number = c->at;
        FMB_TRY(fmb_scan_number(c, FMB_NUM_DECIMAL | FMB_NUM_EXPONENT | FMB_NUM_FRACTION,
                                "a number, a name or '('", constant));
        FMB_TRY(refuse_cut_exponent(t, number));
    }
    if (minus)
        negate_linear_piece(d, from, constant);
    return FMB_OK;
}

/* Multiply or divide the factor (from.., a) by the factor (middle.., b), which begins at p. */
static fmb_status combine_factors(fmb_text *t, fmb_draft *d, size_t from, size_t middle, mpq_t a,
                                  mpq_t b, bool divide, const char *p)
{
    bool first = middle > from, second = d->n > middle;
    if (second && (first || divide))
        return fmb_io_fail(t->c, p,
                           divide ? "expected a constant divisor: rows are linear"
                                  : "expected a constant factor: rows are linear");
    if (divide) {
        if (mpq_sgn(b) == 0)
            return fmb_io_fail(t->c, p, "expected a divisor other than zero");
        mpq_inv(b, b);
    }
    if (!second)
        return scale_linear_piece(t, d, from, a, b);
    mpq_swap(a, b);
    return scale_linear_piece(t, d, from, a, b);
}

/* Skip the operator of a product, if there is one. After a name it is required, so that x(1) is not
 * read as a product. */
static bool accept_product_sign(fmb_cursor *c, bool after_name, bool *divide)
{
    fmb_skip_blanks(c);
    *divide = fmb_peek(c) == '/';
    if (fmb_accept(c, "*") || fmb_accept(c, "/"))
        return true;
    return !after_name && (fmb_peek(c) == '(' || fmb_text_is_at_name(c));
}

/* Only blanks stand for the operator before the cursor: perhaps another row was meant to begin
 * there. */
static void note_blank_product(fmb_text *t, const char *factor, const char *end, int depth)
{
    const char *at = t->c->at;
    if (depth == 0 && at > end && at[-1] != '*' && at[-1] != '/' && !t->blank_product[1]) {
        t->blank_product[0] = factor;
        t->blank_product[1] = at;
    }
}

/* Sets constant. */
static fmb_status read_product_term(fmb_text *t, fmb_draft *d, mpq_t constant, int depth)
{
    fmb_cursor *c = t->c;
    size_t from = d->n;
    bool divide;
    mpq_t other;
    mpq_init(other);
    fmb_skip_blanks(c);
    const char *p = c->at;
    fmb_status st = read_signed_factor(t, d, constant, depth);
    const char *end = c->at;
    bool group = end > c->begin && end[-1] == ')';
    while (st == FMB_OK && accept_product_sign(c, d->n > from && !group, &divide)) {
        size_t middle = d->n;
        note_blank_product(t, p, end, depth);
        fmb_skip_blanks(c);
        p = c->at;
        st = read_signed_factor(t, d, other, depth);
        end = c->at;
        group = c->at > c->begin && c->at[-1] == ')';
        FMB_THEN(st, combine_factors(t, d, from, middle, constant, other, divide, p));
    }
    mpq_clear(other);
    return st;
}

/* Adds to constant. */
static fmb_status read_sum_of_terms(fmb_text *t, fmb_draft *d, mpq_t constant, int depth)
{
    fmb_cursor *c = t->c;
    mpq_t part;
    mpq_init(part);
    fmb_status st;
    bool more, minus = false;
    do {
        size_t from = d->n;
        st = read_product_term(t, d, part, depth);
        if (st == FMB_OK && minus)
            negate_linear_piece(d, from, part);
        if (st == FMB_OK && mpq_sgn(part) != 0) {
            mpq_add(constant, constant, part);
            st = fmb_io_charge(c, c->at, fmb_io_digits(constant));
        }
        fmb_skip_blanks(c);
        minus = st == FMB_OK && accept_minus_sign(c);
        more = st == FMB_OK && (minus || fmb_accept(c, "+"));
    } while (more);
    mpq_clear(part);
    return st;
}

fmb_status fmb_text_expression(fmb_text *t, fmb_draft *d)
{
    fmb_draft_reset(d);
    t->blank_product[0] = t->blank_product[1] = NULL;
    return read_sum_of_terms(t, d, d->rhs, 0);
}
