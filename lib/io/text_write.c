/* text_write.c: a system in the .fmb format: a vars line, what is asked for, then the rows. */
#include <string.h>

#include "io/text.h"
#include "io/utf8.h"

/* "text" with escapes for quotes, backslashes, control bytes and what is not UTF-8. */
static void write_quoted(const char *text, FILE *out)
{
    fputc('"', out);
    for (size_t left = strlen(text); left > 0;) {
        size_t n = fmb_utf8_printable(text, left);
        if (n == 0)
            fprintf(out, "\\x%02x", (unsigned char)*text);
        else if (*text == '"' || *text == '\\')
            fprintf(out, "\\%c", *text);
        else
            fwrite(text, 1, n, out);
        text += n > 0 ? n : 1;
        left -= n > 0 ? n : 1;
    }
    fputc('"', out);
}

static void write_name(const char *name, FILE *out)
{
    size_t size = strlen(name), i = 0, n;
    while ((n = fmb_text_name_char(name + i, size - i, i == 0)) > 0)
        i += n;
    if (i == size)
        fputs(name, out);
    else
        write_quoted(name, out);
}

static void write_label(const char *label, FILE *out)
{
    size_t size = strlen(label), i = 0, n;
    while ((n = fmb_utf8_printable(label + i, size - i)) > 0 && !strchr(":#<>=\"", label[i]))
        i += n;
    bool plain = i == size && size > 0 && label[0] != ' ' && label[size - 1] != ' ' &&
                 !fmb_text_is_reserved((fmb_span){label, size});
    if (plain)
        fputs(label, out);
    else
        write_quoted(label, out);
    fputs(": ", out);
}

static void write_names(const fmb_system *s, const char *word, bool only_kept, FILE *out)
{
    fputs(word, out);
    for (int j = 0; j < fmb_system_dim(s); j++) {
        if (only_kept && !fmb_system_is_kept(s, j))
            continue;
        fputc(' ', out);
        write_name(fmb_system_name(s, j), out);
    }
    fputc('\n', out);
}

/* The k-th term; q is scratch. A blank between number and name: 2 e3 is not 2e3. */
static void write_term(const fmb_system *s, size_t i, size_t k, mpq_t q, FILE *out)
{
    int j = fmb_system_term_q(s, i, k, q);
    bool minus = mpq_sgn(q) < 0;
    fputs(k == 0 ? (minus ? "-" : "") : (minus ? " - " : " + "), out);
    mpq_abs(q, q);
    if (mpq_cmp_ui(q, 1, 1) != 0) {
        fmb_print_q(out, q);
        fputc(' ', out);
    }
    write_name(fmb_system_name(s, j), out);
}

static void write_row(const fmb_system *s, size_t i, mpq_t q, FILE *out)
{
    static const char *const rel[] = {[FMB_LE] = " <= ", [FMB_LT] = " < ", [FMB_EQ] = " = "};
    size_t n = fmb_system_terms(s, i);
    if (fmb_system_label(s, i))
        write_label(fmb_system_label(s, i), out);
    for (size_t k = 0; k < n; k++)
        write_term(s, i, k, q, out);
    if (n == 0)
        fputc('0', out);
    fputs(rel[fmb_system_rel(s, i)], out);
    fmb_system_rhs_q(s, i, q);
    fmb_print_q(out, q);
    fputc('\n', out);
}

fmb_status fmb_write_text(const fmb_system *s, FILE *out)
{
    mpq_t q;
    mpq_init(q);
    if (fmb_system_dim(s) > 0)
        write_names(s, "vars:", false, out);
    if (fmb_system_asks_projection(s))
        write_names(s, "project:", true, out);
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        write_row(s, i, q, out);
    mpq_clear(q);
    return FMB_OK;
}
