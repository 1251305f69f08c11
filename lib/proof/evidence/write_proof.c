/* write_proof.c: evidence to its text form (docs/proof-format.md). */
#include <stdio.h> /* before <gmp.h>, for mpq_out_str */

#include "base/memory_stream.h"
#include "num/gcd.h"
#include "num/word.h"
#include "proof/evidence/form.h"
#include "proof/evidence/words.h"

/* A name, quoted if the reader would not take it for one bare word. */
static void write_name(FILE *out, const char *name)
{
    bool bare = true;
    for (const char *p = name; *p; p++)
        bare = bare && fmb_words_is_bare((unsigned char)*p);
    if (bare) {
        fputs(name, out);
        return;
    }
    fputc('"', out);
    for (const char *p = name; *p; p++) {
        unsigned char byte = (unsigned char)*p;
        if (byte < ' ' || byte == 0x7f)
            fprintf(out, "\\x%02x", byte);
        else
            fprintf(out, byte == '"' || byte == '\\' ? "\\%c" : "%c", byte);
    }
    fputc('"', out);
}

/* Is the number too long to be read back? */
static bool is_too_long(const mpq_t q)
{
    size_t digits = mpz_sizeinbase(mpq_numref(q), 10) + mpz_sizeinbase(mpq_denref(q), 10);
    return digits + 3 > FMB_PROOF_WORD_MAX;
}

/* Write |x| in digits ending before `end`; returns their start. */
static char *put_digits(char *end, uint64_t x)
{
    do
        *--end = (char)('0' + x % 10);
    while ((x /= 10) > 0);
    return end;
}

static void write_count(FILE *out, uint64_t x)
{
    char digits[24], *end = digits + sizeof digits, *from = put_digits(end, x);
    fwrite(from, 1, (size_t)(end - from), out);
}

/* Write a number; false if it is too long. There are many numbers, mostly short. */
static bool write_number(FILE *out, const mpq_t q)
{
    bool whole = mpz_cmp_ui(mpq_denref(q), 1) == 0;
    if (!fmb_integer_is_i64(mpq_numref(q)) || !fmb_integer_is_i64(mpq_denref(q))) {
        if (is_too_long(q))
            return false;
        mpq_out_str(out, 10, q);
        return true;
    }
    char text[48], *end = text + sizeof text, *from = end;
    if (!whole) {
        from = put_digits(from, (uint64_t)fmb_integer_get_i64(mpq_denref(q)));
        *--from = '/';
    }
    from = put_digits(from, fmb_abs64(fmb_integer_get_i64(mpq_numref(q))));
    if (mpq_sgn(q) < 0)
        *--from = '-';
    fwrite(from, 1, (size_t)(end - from), out);
    return true;
}

static bool has_var(const fmb_evidence *e, int var)
{
    return var >= 0 && var < e->dim;
}

/* Does the claim name a variable of the system, or have terms instead, but not both? */
static bool names_one_form(const fmb_evidence *e, const fmb_claim *c)
{
    return c->var == -1 || (has_var(e, c->var) && c->terms.size == 0);
}

/* Write names of variables; false if some do not exist. */
static bool write_names(FILE *out, const fmb_evidence *e, const fmb_system *s,
                        const fmb_sparse_vector *list)
{
    bool good = true;
    for (size_t k = 0; good && k < list->size; k++) {
        good = list->index[k] < (size_t)e->dim;
        fputc(' ', out);
        if (good)
            write_name(out, fmb_system_name(s, (int)list->index[k]));
    }
    return good;
}

static bool write_heading(FILE *out, const fmb_evidence *e, const fmb_system *s, const fmb_claim *c)
{
    const fmb_claim_form *form = &fmb_claim_forms[c->kind];
    bool bound = form->heading == FMB_HEADING_BOUND;
    bool good = true;
    fprintf(out, "claim %s", form->word);
    if (form->heading == FMB_HEADING_ROW) {
        fprintf(out, " %zu", c->row + 1);
        good = c->row < e->rows;
    }
    if (form->heading == FMB_HEADING_VARIABLES)
        good = write_names(out, e, s, &c->terms);
    if (form->heading == FMB_HEADING_END || bound) {
        fputs(c->side == FMB_UPPER ? " upper" : " lower", out);
        good = names_one_form(e, c) && !(bound && c->rel == FMB_EQ);
        if (good && c->var >= 0) {
            fputc(' ', out);
            write_name(out, fmb_system_name(s, c->var));
        }
    }
    if (bound || form->heading == FMB_HEADING_INEQUALITY) {
        fprintf(out, " %s ", fmb_form_relation(c->rel, bound ? c->side : FMB_UPPER));
        good = good && write_number(out, c->value);
    }
    fputc('\n', out);
    return good;
}

static bool write_part(FILE *out, const fmb_system *s, fmb_form_part part, size_t key,
                       const mpq_t value)
{
    fputs(fmb_part_forms[part].word, out);
    fputc(' ', out);
    if (fmb_part_forms[part].key != FMB_KEY_VARIABLE)
        write_count(out, key + 1);
    else
        write_name(out, fmb_system_name(s, (int)key));
    fputc(' ', out);
    bool good = write_number(out, value);
    fputc('\n', out);
    return good;
}

/* Write all lines of one part; false if it refers to something that the system lacks. */
static bool write_parts(FILE *out, const fmb_evidence *e, const fmb_system *s, fmb_claim *c,
                        fmb_form_part part)
{
    fmb_part_key by = fmb_part_forms[part].key;
    size_t keys = by == FMB_KEY_CLAIM ? e->claims : by == FMB_KEY_ROW ? e->rows : (size_t)e->dim;
    const fmb_sparse_vector *list = fmb_form_list(c, part);
    for (size_t k = 0; k < list->size; k++)
        if (list->index[k] >= keys || !write_part(out, s, part, list->index[k], list->value[k]))
            return false;
    return true;
}

static bool write_claim(FILE *out, const fmb_evidence *e, const fmb_system *s, fmb_claim *c)
{
    if (c->kind <= FMB_CLAIM_NONE || c->kind > FMB_CLAIM_FOLLOWS)
        return false;
    bool good = write_heading(out, e, s, c);
    for (fmb_form_part part = 0; good && part < FMB_PARTS; part++)
        if (fmb_form_allows(c, part))
            good = write_parts(out, e, s, c, part);
    fputs("end\n", out);
    return good;
}

static bool has_long_number(fmb_claim *c)
{
    bool found = is_too_long(c->value);
    for (fmb_form_part part = 0; part < FMB_PARTS; part++) {
        const fmb_sparse_vector *list = fmb_form_list(c, part);
        for (size_t k = 0; !found && k < list->size; k++)
            found = is_too_long(list->value[k]);
    }
    return found;
}

fmb_status fmb_evidence_write(const fmb_evidence *e, const fmb_system *s, FILE *out)
{
    if (!out || !fmb_evidence_fits(e, s))
        return FMB_ERR_ARG;
    fprintf(out, "fmb-proof 5\nsystem %zu rows %d variables\n", e->rows, e->dim);
    for (size_t i = 0; i < e->claims; i++)
        if (!write_claim(out, e, s, &e->claim[i]))
            return has_long_number(&e->claim[i]) ? FMB_ERR_RANGE : FMB_ERR_ARG;
    fprintf(out, "claims %zu\n", e->claims);
    return ferror(out) ? FMB_ERR_IO : FMB_OK;
}

/* ---- in words -------------------------------------------------------------------------------- */

/* Where claims are written in words, and how their numbers are written. */
typedef struct telling {
    FILE *out;
    const fmb_system *s;
    const fmb_number_style *style;
} telling;

static void put_fraction(void *self, mpq_srcptr q, FILE *out)
{
    (void)self;
    mpq_out_str(out, 10, q);
}

static void tell_number(const telling *t, mpq_srcptr q)
{
    t->style->put(t->style->self, q, t->out);
}

/* "x + 2 y": the left side of a claim. */
static void tell_form(const telling *t, const fmb_claim *c)
{
    FILE *out = t->out;
    const fmb_system *s = t->s;
    mpq_t one;
    mpq_init(one);
    if (c->var >= 0)
        write_name(out, fmb_system_name(s, c->var));
    else if (c->terms.size == 0)
        fputc('0', out);
    for (size_t k = 0; k < c->terms.size; k++) {
        int sign = mpq_sgn(c->terms.value[k]);
        mpq_abs(one, c->terms.value[k]);
        fputs(k > 0 ? (sign < 0 ? " - " : " + ") : sign < 0 ? "-" : "", out);
        if (mpq_cmp_ui(one, 1, 1) != 0) {
            tell_number(t, one);
            fputc(' ', out);
        }
        write_name(out, fmb_system_name(s, (int)c->terms.index[k]));
    }
    mpq_clear(one);
}

static void tell_inequality(const telling *t, const fmb_claim *c)
{
    tell_form(t, c);
    fprintf(t->out, " %s ", fmb_form_relation(c->rel, FMB_UPPER));
    tell_number(t, c->value);
}

/* "x, y" */
static void tell_variables(FILE *out, const fmb_system *s, const fmb_sparse_vector *list)
{
    for (size_t k = 0; k < list->size; k++) {
        fputs(k > 0 ? ", " : "", out);
        write_name(out, fmb_system_name(s, (int)list->index[k]));
    }
    fputs(list->size > 0 ? "" : "no variable", out);
}

/* "max x = 5/2", "sup x = 5/2, not attained" */
static void tell_bound(const telling *t, const fmb_claim *c)
{
    static const char *const word[][2] = {{"inf ", "sup "}, {"min ", "max "}};
    fputs(word[c->rel == FMB_LE][c->side], t->out);
    tell_form(t, c);
    fputs(" = ", t->out);
    tell_number(t, c->value);
    if (c->rel != FMB_LE)
        fputs(", not attained", t->out);
}

static void tell_claim(const telling *t, const fmb_claim *c)
{
    FILE *out = t->out;
    static const char *const said[FMB_CLAIM_FOLLOWS + 1] = {
        [FMB_CLAIM_FEASIBLE] = "a point satisfies every row",
        [FMB_CLAIM_INFEASIBLE] = "no point satisfies every row",
        [FMB_CLAIM_UNBOUNDED] = " has no end",
        [FMB_CLAIM_IMPLIED] = " follows",
        [FMB_CLAIM_REDUNDANT] = " follows from the other rows",
        [FMB_CLAIM_EQUALITY] = " always holds with equality",
        [FMB_CLAIM_IRREDUNDANT] = " does not follow from the kept rows",
        [FMB_CLAIM_CORNER] = " satisfies every row where < is read as <=",
        [FMB_CLAIM_WHOLE] = ": no row of the projection on these is missing",
        [FMB_CLAIM_FOLLOWS] = " follows from claims"};
    if (c->kind == FMB_CLAIM_BOUND)
        tell_bound(t, c);
    else if (c->kind == FMB_CLAIM_UNBOUNDED)
        tell_form(t, c);
    else if (c->kind == FMB_CLAIM_IMPLIED || c->kind == FMB_CLAIM_FOLLOWS)
        tell_inequality(t, c);
    else if (fmb_claim_forms[c->kind].heading == FMB_HEADING_ROW)
        fprintf(out, "row %zu", c->row + 1);
    else if (c->kind == FMB_CLAIM_CORNER)
        fputs(c->ray.size > 0 ? "a direction" : "a point", out);
    else if (c->kind == FMB_CLAIM_WHOLE)
        tell_variables(out, t->s, &c->terms);
    fputs(said[c->kind] ? said[c->kind] : "", out);
    if (c->kind == FMB_CLAIM_UNBOUNDED)
        fputs(c->side == FMB_UPPER ? " above" : " below", out);
}

/* Are the row, the variable and the terms of the claim those of the system? */
static bool is_about(const fmb_evidence *e, const fmb_claim *c)
{
    fmb_heading heading = fmb_claim_forms[c->kind].heading;
    bool good = heading != FMB_HEADING_ROW || c->row < e->rows;
    if (heading == FMB_HEADING_END || heading == FMB_HEADING_BOUND)
        good = names_one_form(e, c);
    for (size_t k = 0; k < c->terms.size; k++)
        good = good && c->terms.index[k] < (size_t)e->dim;
    return good;
}

fmb_status fmb_evidence_tell_with(const fmb_evidence *e, const fmb_system *s, size_t i,
                                  const fmb_number_style *style, FILE *out)
{
    bool known = out && style && style->put && fmb_evidence_fits(e, s) && i < e->claims &&
                 e->claim[i].kind > FMB_CLAIM_NONE && e->claim[i].kind <= FMB_CLAIM_FOLLOWS;
    if (!known || !is_about(e, &e->claim[i]))
        return FMB_ERR_ARG;
    const telling t = {.out = out, .s = s, .style = style};
    tell_claim(&t, &e->claim[i]);
    fputc('\n', out);
    return ferror(out) ? FMB_ERR_IO : FMB_OK;
}

fmb_status fmb_evidence_tell(const fmb_evidence *e, const fmb_system *s, size_t i, FILE *out)
{
    static const fmb_number_style fraction = {.put = put_fraction};
    return fmb_evidence_tell_with(e, s, i, &fraction, out);
}

/* ---- in memory ------------------------------------------------------------------------------- */

typedef struct evidence_about {
    const fmb_evidence *e;
    const fmb_system *s;
    size_t claim;
} evidence_about;

static fmb_status write_evidence_about(const void *self, FILE *out)
{
    const evidence_about *w = self;
    return fmb_evidence_write(w->e, w->s, out);
}

fmb_status fmb_evidence_print(const fmb_evidence *e, const fmb_system *s, char *text, size_t size,
                              size_t *length)
{
    return fmb_memory_print(write_evidence_about, &(evidence_about){e, s, 0}, text, size, length);
}

static fmb_status tell_claim_about(const void *self, FILE *out)
{
    const evidence_about *w = self;
    return fmb_evidence_tell(w->e, w->s, w->claim, out);
}

fmb_status fmb_evidence_print_claim(const fmb_evidence *e, const fmb_system *s, size_t i,
                                    char *text, size_t size, size_t *length)
{
    return fmb_memory_print(tell_claim_about, &(evidence_about){e, s, i}, text, size, length);
}
