/* write.c: evidence to its text form (docs/proof-format.md). */
#include <stdio.h> /* before <gmp.h>, for mpq_out_str */

#include "proof/form.h"
#include "proof/words.h"

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

/* False if the number is too long to be read back. */
static bool write_number(FILE *out, const mpq_t q)
{
    size_t digits = mpz_sizeinbase(mpq_numref(q), 10) + mpz_sizeinbase(mpq_denref(q), 10);
    if (digits + 3 > FMB_PROOF_WORD_MAX)
        return false;
    mpq_out_str(out, 10, q);
    return true;
}

static bool has_var(const fmb_evidence *e, int var)
{
    return var >= 0 && var < e->dim;
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
    if (form->heading == FMB_HEADING_END || bound) {
        fputs(c->side == FMB_UPPER ? " upper " : " lower ", out);
        good = has_var(e, c->var) && !(bound && c->rel == FMB_EQ);
        if (good)
            write_name(out, fmb_system_name(s, c->var));
    }
    if (bound || form->heading == FMB_HEADING_INEQUALITY) {
        fprintf(out, " %s ", fmb_form_relation(c->rel, bound ? c->side : FMB_UPPER));
        good = good && write_number(out, c->value);
    }
    fputc('\n', out);
    return good;
}

static bool write_part(FILE *out, const fmb_system *s, fmb_part part, size_t key, const mpq_t value)
{
    fprintf(out, "%s ", fmb_part_forms[part].word);
    if (fmb_part_forms[part].by_row)
        fprintf(out, "%zu", key + 1);
    else
        write_name(out, fmb_system_name(s, (int)key));
    fputc(' ', out);
    bool good = write_number(out, value);
    fputc('\n', out);
    return good;
}

/* All lines of one part. False if it is missing, or about what the system does not have. */
static bool write_parts(FILE *out, const fmb_evidence *e, const fmb_system *s, fmb_claim *c,
                        fmb_part part)
{
    size_t keys = fmb_part_forms[part].by_row ? e->rows : (size_t)e->dim;
    if (fmb_part_forms[part].dense) {
        mpq_t *vector = *fmb_form_vector(c, part);
        bool good = vector != NULL;
        for (size_t j = 0; good && j < keys; j++)
            good = write_part(out, s, part, j, vector[j]);
        return good;
    }
    const fmb_sparse *list = fmb_form_list(c, part);
    for (size_t k = 0; k < list->size; k++)
        if (list->index[k] >= keys || !write_part(out, s, part, list->index[k], list->value[k]))
            return false;
    return true;
}

static bool write_claim(FILE *out, const fmb_evidence *e, const fmb_system *s, fmb_claim *c)
{
    if (c->kind <= FMB_CLAIM_NONE || c->kind > FMB_CLAIM_IRREDUNDANT)
        return false;
    bool good = write_heading(out, e, s, c);
    for (fmb_part part = 0; good && part < FMB_PARTS; part++)
        if (fmb_claim_forms[c->kind].part[part])
            good = write_parts(out, e, s, c, part);
    fputs("end\n", out);
    return good;
}

fmb_status fmb_evidence_write(const fmb_evidence *e, const fmb_system *s, FILE *out)
{
    if (e->dim != fmb_system_dim(s) || e->rows != fmb_system_rows(s))
        return FMB_ERR_ARG;
    fprintf(out, "fmb-proof 1\nsystem %zu rows %d variables\n", e->rows, e->dim);
    for (size_t i = 0; i < e->claims; i++)
        if (!write_claim(out, e, s, &e->claim[i]))
            return FMB_ERR_ARG;
    return ferror(out) ? FMB_ERR_IO : FMB_OK;
}
