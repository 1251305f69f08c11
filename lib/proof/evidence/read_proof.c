/* read_proof.c: reads evidence from its text form (docs/proof-format.md).
 *
 * Memory is bounded by the length of the text and the size of the system: the shape in the header
 * must be that of the system, a line has at most one number, and `seen` has a mark for each part
 * and key. In a truncated text the final number of claims is missing.
 */
#include <string.h>

#include "base/memory_stream.h"
#include "proof/evidence/form.h"
#include "proof/evidence/words.h"
#include "system/system_private.h"

typedef struct reader {
    fmb_words words;
    const fmb_system *s;
    fmb_evidence *e;
    /* seen[part][key] == number of claims so far: the key was used in this claim */
    size_t *seen[FMB_PARTS];
    mpq_t number; /* scratch */
} reader;

/* Numbers of keys with marks: lines of claims are in ascending order and need none. */
static size_t keys(const reader *r, fmb_form_part part)
{
    fmb_part_key by = fmb_part_forms[part].key;
    return by == FMB_KEY_CLAIM ? 0 : by == FMB_KEY_ROW ? r->e->rows : (size_t)r->e->dim;
}

/* ---- pieces of a line ------------------------------------------------------------------------ */

/* The variable that the current word names. */
static fmb_status find_variable(reader *r, int *out)
{
    int j = r->words.size > 0 ? fmb_system_find(r->s, r->words.text) : -1;
    if (j < 0)
        return fmb_words_expected(&r->words, "the name of a variable of the system");
    *out = j;
    return FMB_OK;
}

static fmb_status read_variable(reader *r, int *out)
{
    FMB_TRY(fmb_words_next(&r->words));
    return find_variable(r, out);
}

static fmb_status read_row(reader *r, size_t *out)
{
    size_t number = 1;
    FMB_TRY(fmb_words_next(&r->words));
    FMB_TRY(fmb_words_count(&r->words, "a row", r->e->rows, &number));
    *out = number - 1;
    return FMB_OK;
}

static fmb_status read_number(reader *r, mpq_t out)
{
    FMB_TRY(fmb_words_next(&r->words));
    return fmb_words_rational(&r->words, out);
}

static fmb_status read_side(reader *r, fmb_side *out)
{
    FMB_TRY(fmb_words_next(&r->words));
    bool upper = fmb_words_is(&r->words, "upper");
    if (!upper && !fmb_words_is(&r->words, "lower"))
        return fmb_words_expected(&r->words, "'lower' or 'upper'");
    *out = upper ? FMB_UPPER : FMB_LOWER;
    return FMB_OK;
}

/* The index of the current word among the first n relations; -1: it is none. */
static int relation_of_word(const reader *r, fmb_side side, int n)
{
    int rel = n - 1;
    while (rel >= 0 && !fmb_words_is(&r->words, fmb_form_relation((fmb_rel)rel, side)))
        rel--;
    return rel;
}

/* Read one of the first n relations <=, <, =, as written for that end of an interval. */
static fmb_status read_relation(reader *r, fmb_side side, int n, fmb_rel *out)
{
    FMB_TRY(fmb_words_next(&r->words));
    int rel = relation_of_word(r, side, n);
    if (rel >= 0) {
        *out = (fmb_rel)rel;
        return FMB_OK;
    }
    return fmb_words_expected(&r->words, "'%s'%s '%s'%s", fmb_form_relation(FMB_LE, side),
                              n > 2 ? "," : " or", fmb_form_relation(FMB_LT, side),
                              n > 2 ? " or '='" : "");
}

/* ---- claims ---------------------------------------------------------------------------------- */

/* "[VARIABLE]" */
static fmb_status read_end_heading(reader *r, fmb_claim *c)
{
    FMB_TRY(fmb_words_next(&r->words));
    return r->words.size > 0 ? find_variable(r, &c->var) : FMB_OK;
}

/* "[VARIABLE] REL VALUE". A variable may be named like a relation: then a relation follows it. */
static fmb_status read_bound_heading(reader *r, fmb_claim *c)
{
    fmb_status st = fmb_words_next(&r->words);
    if (st != FMB_OK)
        return st;
    int first = relation_of_word(r, c->side, 2), second = -1;
    if (first >= 0 && (st = fmb_words_next(&r->words)) == FMB_OK)
        second = relation_of_word(r, c->side, 2);
    if (st == FMB_OK && first >= 0 && second < 0) {
        c->rel = (fmb_rel)first;
        return fmb_words_rational(&r->words, c->value);
    }
    if (st == FMB_OK && first >= 0) {
        c->var = fmb_system_find(r->s, fmb_form_relation((fmb_rel)first, c->side));
        c->rel = (fmb_rel)second;
        if (c->var < 0)
            st = fmb_words_expected(&r->words, "a number");
    } else if (st == FMB_OK) {
        st = find_variable(r, &c->var);
        FMB_THEN(st, read_relation(r, c->side, 2, &c->rel));
    }
    return st == FMB_OK ? read_number(r, c->value) : st;
}

/* Mark the key as used in that part of this claim; it must be new there. */
static fmb_status mark_key(reader *r, fmb_form_part part, size_t key)
{
    const fmb_part_form *form = &fmb_part_forms[part];
    if (r->seen[part][key] == r->e->claims)
        return fmb_words_expected(&r->words, "each %s at most once in the lines '%s'",
                                  form->key == FMB_KEY_ROW ? "row" : "variable", form->word);
    r->seen[part][key] = r->e->claims;
    return FMB_OK;
}

/* "[VARIABLE ...]" up to the end of the line, as terms. */
static fmb_status read_variables(reader *r, fmb_claim *c)
{
    fmb_status st;
    mpq_set_ui(r->number, 1, 1);
    while ((st = fmb_words_next(&r->words)) == FMB_OK && r->words.size > 0) {
        int var = 0;
        st = find_variable(r, &var);
        FMB_THEN(st, mark_key(r, FMB_PART_TERM, (size_t)var));
        FMB_THEN(st, fmb_evidence_push(r->e, &c->terms, (size_t)var, r->number));
        if (st != FMB_OK)
            break;
    }
    return st;
}

static fmb_status read_heading(reader *r, fmb_claim *c)
{
    fmb_heading heading = fmb_claim_forms[c->kind].heading;
    fmb_status st = FMB_OK;
    if (heading == FMB_HEADING_ROW)
        st = read_row(r, &c->row);
    if (heading == FMB_HEADING_END || heading == FMB_HEADING_BOUND)
        st = read_side(r, &c->side);
    if (st == FMB_OK && heading == FMB_HEADING_END)
        st = read_end_heading(r, c);
    if (st == FMB_OK && heading == FMB_HEADING_BOUND)
        st = read_bound_heading(r, c);
    if (heading == FMB_HEADING_INEQUALITY) {
        st = read_relation(r, FMB_UPPER, 3, &c->rel);
        FMB_THEN(st, read_number(r, c->value));
    }
    if (heading == FMB_HEADING_VARIABLES)
        return read_variables(r, c);
    return st == FMB_OK ? fmb_words_end(&r->words) : st;
}

/* Read the number of an earlier claim, larger than those so far in this list. */
static fmb_status read_claim_number(reader *r, const fmb_sparse_vector *list, size_t *out)
{
    size_t number = 1;
    fmb_status st = fmb_words_next(&r->words);
    FMB_THEN(st, fmb_words_count(&r->words, "a claim before this one", r->e->claims - 1, &number));
    if (st == FMB_OK && list->size > 0 && number - 1 <= list->index[list->size - 1])
        return fmb_words_expected(&r->words, "claims in ascending order in the lines 'implied'");
    *out = number - 1;
    return st;
}

/* Read the key of a part, which must be new in this claim. */
static fmb_status read_key(reader *r, fmb_claim *c, fmb_form_part part, size_t *out)
{
    fmb_part_key by = fmb_part_forms[part].key;
    int var = 0;
    if (by == FMB_KEY_CLAIM)
        return read_claim_number(r, fmb_form_list(c, part), out);
    FMB_TRY(by == FMB_KEY_ROW ? read_row(r, out) : read_variable(r, &var));
    if (by == FMB_KEY_VARIABLE)
        *out = (size_t)var;
    return mark_key(r, part, *out);
}

static fmb_status read_part(reader *r, fmb_claim *c, fmb_form_part part)
{
    size_t key = 0;
    FMB_TRY(read_key(r, c, part, &key));
    FMB_TRY(read_number(r, r->number));
    FMB_TRY(fmb_words_end(&r->words));
    return fmb_evidence_push(r->e, fmb_form_list(c, part), key, r->number);
}

/* The part whose line begins with the current word, if the claim may have it; else FMB_PARTS. */
static fmb_form_part find_part(const reader *r, const fmb_claim *c)
{
    fmb_form_part part = 0;
    while (part < FMB_PARTS &&
           !(fmb_form_allows(c, part) && fmb_words_is(&r->words, fmb_part_forms[part].word)))
        part++;
    return part;
}

/* "'row', 'point' or 'end'" */
static fmb_status expected_part(reader *r, const fmb_claim *c)
{
    char list[96];
    size_t n = 0;
    for (fmb_form_part part = 0; part < FMB_PARTS; part++)
        if (fmb_form_allows(c, part))
            n += (size_t)snprintf(list + n, sizeof list - n, "%s'%s'", n > 0 ? ", " : "",
                                  fmb_part_forms[part].word);
    return fmb_words_expected(&r->words, "%s or 'end'", list);
}

static fmb_status read_parts(reader *r, fmb_claim *c)
{
    fmb_status st;
    while ((st = fmb_words_line(&r->words)) == FMB_OK && !fmb_words_is(&r->words, "end")) {
        fmb_form_part part = find_part(r, c);
        st = part < FMB_PARTS ? read_part(r, c, part) : expected_part(r, c);
        if (st != FMB_OK)
            return st;
    }
    return st == FMB_OK ? fmb_words_end(&r->words) : st;
}

/* The kind named by the current word, or NONE. */
static fmb_claim_kind find_kind(const reader *r)
{
    fmb_claim_kind kind = FMB_CLAIM_FOLLOWS;
    while (kind > FMB_CLAIM_NONE && !fmb_words_is(&r->words, fmb_claim_forms[kind].word))
        kind--;
    return kind;
}

static fmb_status read_claim(reader *r)
{
    fmb_claim *c = NULL;
    FMB_TRY(fmb_words_next(&r->words));
    fmb_claim_kind kind = find_kind(r);
    if (kind == FMB_CLAIM_NONE)
        return fmb_words_expected(&r->words, "a kind of claim, such as 'feasible' or 'bound'");
    FMB_TRY(fmb_evidence_claim(r->e, kind, &c));
    FMB_TRY(read_heading(r, c));
    return read_parts(r, c);
}

/* ---- the whole text -------------------------------------------------------------------------- */

static fmb_status read_shape(reader *r)
{
    size_t rows = r->e->rows, dim = (size_t)r->e->dim;
    char text[2][24];
    snprintf(text[0], sizeof text[0], "%zu", rows);
    snprintf(text[1], sizeof text[1], "%zu", dim);
    const char *words[] = {text[0], "rows", text[1], "variables"};
    for (int i = 0; i < 4; i++) {
        FMB_TRY(fmb_words_next(&r->words));
        if (!fmb_words_is(&r->words, words[i]))
            FMB_TRY(fmb_words_expected(
                &r->words, "'system %zu rows %zu variables', as the system has", rows, dim));
    }
    return fmb_words_end(&r->words);
}

static fmb_status read_line_keyword(reader *r, const char *word)
{
    FMB_TRY(fmb_words_line(&r->words));
    return !fmb_words_is(&r->words, word) ? fmb_words_expected(&r->words, "'%s'", word) : FMB_OK;
}

/* "claims 12", behind the last claim. */
static fmb_status read_count(reader *r)
{
    char count[24];
    snprintf(count, sizeof count, "%zu", r->e->claims);
    FMB_TRY(fmb_words_next(&r->words));
    if (!fmb_words_is(&r->words, count))
        FMB_TRY(fmb_words_expected(&r->words, "'claims %s', as there are", count));
    FMB_TRY(fmb_words_end(&r->words));
    FMB_TRY(fmb_words_line(&r->words));
    return r->words.size > 0 ? fmb_words_expected(&r->words, "the end of the text") : FMB_OK;
}

/* Texts of versions 2 to 4 still have the same meaning. */
static fmb_status read_version(reader *r)
{
    FMB_TRY(fmb_words_next(&r->words));
    if (!fmb_words_is(&r->words, "2") && !fmb_words_is(&r->words, "3") &&
        !fmb_words_is(&r->words, "4") && !fmb_words_is(&r->words, "5"))
        FMB_TRY(fmb_words_expected(&r->words, "'5', '4', '3' or '2'"));
    return FMB_OK;
}

static fmb_status read_text(reader *r)
{
    fmb_status st = read_line_keyword(r, "fmb-proof");
    FMB_THEN(st, read_version(r));
    FMB_THEN(st, fmb_words_end(&r->words));
    FMB_THEN(st, read_line_keyword(r, "system"));
    FMB_THEN(st, read_shape(r));
    while (st == FMB_OK && (st = fmb_words_line(&r->words)) == FMB_OK &&
           fmb_words_is(&r->words, "claim"))
        st = read_claim(r);
    if (st != FMB_OK)
        return st;
    return fmb_words_is(&r->words, "claims")
               ? read_count(r)
               : fmb_words_expected(&r->words, "'claim' or, at the end, 'claims %zu'",
                                    r->e->claims);
}

/* Read the whole text, with the memory that this needs. */
static fmb_status read_into(reader *r, FILE *in, const fmb_poll *poll, fmb_where *where)
{
    bool ready = true;
    fmb_words_init(&r->words, in, &r->e->mem, poll, where);
    mpq_init(r->number);
    for (fmb_form_part part = 0; ready && part < FMB_PARTS; part++) {
        r->seen[part] = fmb_mem_zero(&r->e->mem, keys(r, part), sizeof **r->seen);
        ready = r->seen[part] != NULL;
    }
    fmb_status st = ready ? read_text(r) : fmb_mem_status(&r->e->mem);
    for (fmb_form_part part = 0; part < FMB_PARTS; part++)
        fmb_mem_put(&r->e->mem, r->seen[part], keys(r, part), sizeof **r->seen);
    mpq_clear(r->number);
    fmb_words_clear(&r->words);
    return r->words.is_cut ? FMB_LIMIT : st;
}

fmb_status fmb_evidence_read_within(FILE *in, const fmb_system *s, const fmb_patience *patience,
                                    fmb_evidence **out, fmb_stop *stop, fmb_where *where)
{
    fmb_where unwanted;
    fmb_guard guard;
    reader r = {.s = s};
    if (!in || !s || !out || !stop)
        return FMB_ERR_ARG;
    FMB_TRY(fmb_evidence_new(fmb_system_dim(s), fmb_system_rows(s), &s->mem.alloc, &r.e));
    fmb_status st = fmb_guard_begin(&guard, patience, &r.e->mem);
    const fmb_poll poll = fmb_guard_poll(&guard);
    FMB_THEN(st, read_into(&r, in, &poll, where ? where : &unwanted));
    r.e->mem.limit = 0;
    if (st != FMB_OK) {
        fmb_evidence_free(r.e);
        r.e = NULL;
    }
    if (st == FMB_OK || st == FMB_LIMIT) {
        *stop = st == FMB_OK ? FMB_STOP_DONE : fmb_guard_stop(&guard);
        *out = r.e;
        st = FMB_OK;
    }
    return st;
}

fmb_status fmb_evidence_parse_within(const char *text, size_t size, const fmb_system *s,
                                     const fmb_patience *patience, fmb_evidence **out,
                                     fmb_stop *stop, fmb_where *where)
{
    if (!text && size > 0)
        return FMB_ERR_ARG;
    FILE *in = fmb_memory_stream(text, size);
    if (!in)
        return FMB_ERR_MEMORY;
    fmb_status st = fmb_evidence_read_within(in, s, patience, out, stop, where);
    fclose(in);
    return st;
}

fmb_status fmb_evidence_parse(const char *text, size_t size, const fmb_system *s,
                              fmb_evidence **out, fmb_where *where)
{
    fmb_stop stop;
    return fmb_evidence_parse_within(text, size, s, NULL, out, &stop, where);
}

fmb_status fmb_evidence_read(FILE *in, const fmb_system *s, fmb_evidence **out, fmb_where *where)
{
    fmb_stop stop;
    return fmb_evidence_read_within(in, s, NULL, out, &stop, where);
}
