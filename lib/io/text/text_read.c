/* text_read.c: the lines of the .fmb format; see text.h. */
#include <string.h>

#include "io/text/text.h"

/* ---- labels ---------------------------------------------------------------------------------- */

/* The ':' that ends a label on this line, or NULL. Quoted text is skipped; the first byte that a
 * label cannot have ends the search. */
static const char *find_label_colon(const fmb_cursor *c)
{
    for (const char *p = c->at; p < c->end && *p != '\n'; p++) {
        if (*p == ':')
            return p;
        if (memchr("#<>=", *p, 4))
            return NULL;
        if (*p != '"')
            continue;
        for (p++; p < c->end && *p != '"' && *p != '\n'; p++)
            p += *p == '\\' && p + 1 < c->end && p[1] != '\n';
        if (p >= c->end || *p == '\n')
            return NULL;
    }
    return NULL;
}

/* The label before colon, at c; c is then past the colon. *quoted: it is not the name of a line. */
static fmb_status read_row_label(fmb_text *t, const char *colon, fmb_span *out, bool *quoted)
{
    fmb_cursor *c = t->c;
    fmb_status st = FMB_OK;
    *quoted = fmb_peek(c) == '"';
    if (*quoted) {
        st = fmb_scan_quoted(c, &t->label, out);
        fmb_skip_blanks(c);
        if (st == FMB_OK && c->at != colon)
            st = fmb_io_fail(c, c->at, "expected ':' after a label in quotes");
    } else {
        const char *end = colon;
        while (end > c->at && (end[-1] == ' ' || end[-1] == '\t'))
            end--;
        *out = (fmb_span){c->at, (size_t)(end - c->at)};
        if (out->n == 0)
            st = fmb_io_fail(c, colon, "expected a label before ':'");
    }
    c->at = colon + 1;
    return st;
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* The relation at c, if there is one. */
static bool accept_relation(fmb_cursor *c, fmb_rel *out)
{
    static const struct {
        const char *text;
        fmb_rel rel;
    } table[] = {
        {"<=", FMB_LE}, {"=<", FMB_LE}, {"\xE2\x89\xA4", FMB_LE},
        {">=", FMB_GE}, {"=>", FMB_GE}, {"\xE2\x89\xA5", FMB_GE},
        {"<", FMB_LT},  {">", FMB_GT},  {"==", FMB_EQ},
        {"=", FMB_EQ},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        if (fmb_accept(c, table[i].text)) {
            *out = table[i].rel;
            return true;
        }
    }
    return false;
}

/* "x != y" and "x <> y" have no convex set of solutions. */
static fmb_status fail_at_relation(fmb_cursor *c)
{
    const char *p = c->at;
    if (fmb_accept(c, "!=") || fmb_accept(c, "<>") || fmb_accept(c, "\xE2\x89\xA0"))
        return fmb_io_fail(c, p, "expected <=, <, =, > or >=: 'not equal' is not a linear row");
    return fmb_io_expected(c, p, "an operator or one of <= < = > >=");
}

/* Terms of d, times -1 if minus, and its constant to the other side. */
static fmb_status move_side_to_row(fmb_draft *row, const fmb_draft *d, bool minus)
{
    for (size_t k = 0; k < d->n; k++) {
        mpq_ptr slot;
        FMB_TRY(fmb_draft_term(row, d->var[k], &slot));
        mpq_set(slot, d->coef[k]);
        if (minus)
            mpq_neg(slot, slot);
    }
    if (minus)
        mpq_add(row->rhs, row->rhs, d->rhs);
    else
        mpq_sub(row->rhs, row->rhs, d->rhs);
    return FMB_OK;
}

/* left REL right as a row of the system. */
static fmb_status append_chain_link(fmb_text *t, fmb_rel rel, const char *start,
                                    const fmb_span *label)
{
    fmb_draft_reset(&t->row);
    FMB_TRY(move_side_to_row(&t->row, &t->left, false));
    FMB_TRY(move_side_to_row(&t->row, &t->right, true));
    FMB_TRY(fmb_draft_append(t->c, start, &t->row, rel, t->s));
    if (!label)
        return FMB_OK;
    FMB_TRY(fmb_io_charge(t->c, start, label->n));
    return fmb_span_label(t->c, *label, t->s, fmb_system_rows(t->s) - 1);
}

/* The left side, without a relation, is the objective if the label is one such as "max". */
static fmb_status take_objective_line(fmb_text *t, fmb_span label)
{
    if (fmb_system_sense(t->s) != FMB_SENSE_NONE)
        return fmb_io_fail(t->c, label.p, "expected one objective, found another");
    mpq_neg(t->left.rhs, t->left.rhs);
    return fmb_draft_set_objective(t->c, label.p, &t->left, fmb_text_sense(label), t->s);
}

/* `x >= 1  y >= 2` is x >= 1 y >= 2, or two rows whose line break was lost: ambiguous. */
static fmb_status fail_at_blank_product(fmb_text *t)
{
    char left[FMB_QUOTE], right[FMB_QUOTE];
    const char *const *at = t->blank_product;
    return fmb_io_fail(t->c, at[1],
                       "expected '*' or a line break: between relations %s and %s "
                       "may be a product, or the ends of two rows",
                       fmb_quote(t->c, at[0], left), fmb_quote(t->c, at[1], right));
}

/* expression REL expression {REL expression}: a row for each link. plain: the label has no quotes.
 */
static fmb_status read_relation_chain(fmb_text *t, const fmb_span *label, bool plain)
{
    fmb_cursor *c = t->c;
    const char *start = c->at;
    fmb_rel r;
    FMB_TRY(fmb_text_expression(t, &t->left));
    if (!accept_relation(c, &r))
        return plain && label && fmb_text_sense(*label) ? take_objective_line(t, *label)
                                                        : fail_at_relation(c);
    for (bool more = true; more;) {
        if (fmb_peek(c) == '>' && c->at[-1] == '<') {
            c->at--;
            return fail_at_relation(c);
        }
        FMB_TRY(fmb_text_expression(t, &t->right));
        FMB_TRY(append_chain_link(t, r, start, label));
        fmb_draft d = t->left;
        t->left = t->right;
        t->right = d;
        more = accept_relation(c, &r);
        if (more && t->blank_product[1])
            return fail_at_blank_product(t);
    }
    return FMB_OK;
}

/* ---- other lines ----------------------------------------------------------------------------- */

/* vars: names, which are new. */
static fmb_status declare_new_name(fmb_text *t, const char *p, fmb_span name)
{
    char found[FMB_QUOTE];
    int j = -1;
    FMB_TRY(fmb_span_find(t->c, name, t->s, &j));
    if (j >= 0)
        return fmb_io_fail(t->c, p, "expected a new name, found %s again",
                           fmb_quote(t->c, p, found));
    return fmb_span_variable(t->c, name, t->s, &j);
}

/* project: and eliminate: names. */
static fmb_status mark_named_variable(fmb_text *t, const char *p, fmb_span name)
{
    int j = 0;
    FMB_TRY(fmb_text_variable(t, p, name, &j));
    FMB_TRY(FMB_RESERVE(t->c->mem, &t->mark, &t->mark_capacity, t->marks + 1));
    t->mark[t->marks++] = j;
    return FMB_OK;
}

/* integer: names. */
static fmb_status mark_integer_variable(fmb_text *t, const char *p, fmb_span name)
{
    int j = 0;
    FMB_TRY(fmb_text_variable(t, p, name, &j));
    return fmb_system_set_integer(t->s, j, true);
}

/* Names up to the end of the line, with blanks or commas between them. */
static fmb_status read_list_of_names(fmb_text *t,
                                     fmb_status take(fmb_text *, const char *, fmb_span))
{
    fmb_cursor *c = t->c;
    for (;;) {
        while (fmb_skip_blanks(c), fmb_peek(c) == ',')
            c->at++;
        if (fmb_peek(c) < 0 || fmb_peek(c) == '\n' || fmb_peek(c) == '#')
            return FMB_OK;
        fmb_span name;
        const char *p = c->at;
        FMB_TRY(fmb_text_scan_name(t, &name));
        FMB_TRY(take(t, p, name));
    }
}

/* A line that begins with one of the reserved words. */
static fmb_status read_reserved_line(fmb_text *t, fmb_span word)
{
    if (fmb_span_is(word, "vars")) {
        if (!t->declared && fmb_system_dim(t->s) > 0)
            return fmb_io_fail(t->c, word.p, "expected the vars line before all other names");
        if (fmb_system_rows(t->s) > 0)
            return fmb_io_fail(t->c, word.p, "expected the vars line before the first row");
        t->declared = true;
        return read_list_of_names(t, declare_new_name);
    }
    if (fmb_span_is(word, "integer"))
        return read_list_of_names(t, mark_integer_variable);
    if (t->asked.n > 0 && t->asked.n != word.n)
        return fmb_io_fail(t->c, word.p, "expected project or eliminate lines, found both");
    t->asked = word;
    return read_list_of_names(t, mark_named_variable);
}

static void set_kept_variables(fmb_text *t)
{
    bool keep = fmb_span_is(t->asked, "project");
    for (int j = 0; t->asked.n > 0 && j < fmb_system_dim(t->s); j++)
        fmb_system_set_kept(t->s, j, !keep);
    for (size_t k = 0; k < t->marks; k++)
        fmb_system_set_kept(t->s, t->mark[k], keep);
}

static fmb_status read_text_line(fmb_text *t)
{
    fmb_cursor *c = t->c;
    fmb_span label = {0};
    bool quoted = true;
    const char *colon = find_label_colon(c);
    if (colon)
        FMB_TRY(read_row_label(t, colon, &label, &quoted));
    FMB_TRY(!quoted && fmb_text_is_reserved(label)
                ? read_reserved_line(t, label)
                : read_relation_chain(t, colon ? &label : NULL, !quoted));
    fmb_skip_blanks(c);
    if (fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && fmb_peek(c) != '#')
        return fail_at_relation(c);
    return FMB_OK;
}

fmb_status fmb_read_text(fmb_cursor *c, fmb_system *s)
{
    fmb_text t = {.c = c, .s = s};
    fmb_draft *const drafts[] = {&t.left, &t.right, &t.row};
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < 3; i++)
        fmb_draft_init(drafts[i], c->mem);
    for (; st == FMB_OK && c->at < c->end; fmb_next_line(c)) {
        fmb_skip_blanks(c);
        if (fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && fmb_peek(c) != '#')
            st = read_text_line(&t);
    }
    if (st == FMB_OK) {
        set_kept_variables(&t);
        fmb_text_warn_of_near_duplicates(&t);
    }
    for (size_t i = 0; i < 3; i++)
        fmb_draft_clear(drafts[i]);
    fmb_mem_put(c->mem, t.name.p, t.name.capacity, 1);
    fmb_mem_put(c->mem, t.label.p, t.label.capacity, 1);
    fmb_mem_put(c->mem, t.mark, t.mark_capacity, sizeof *t.mark);
    fmb_mem_put(c->mem, t.use, t.use_capacity, sizeof *t.use);
    return st;
}
