/* text_write.c: a system in the .fmb format: a vars line, project or eliminate, then the rows. */
#include <string.h>

#include "io/core/utf8.h"
#include "io/text/text.h"
#include "system/system_private.h"

static void write_text_name(const char *name, FILE *out)
{
    size_t size = strlen(name), i = 0, n;
    while ((n = fmb_text_name_char(name + i, size - i, i == 0)) > 0)
        i += n;
    if (i == size)
        fputs(name, out);
    else
        fmb_print_quoted(name, out);
}

static void write_row_label(const char *label, FILE *out)
{
    size_t size = strlen(label), i = 0, n;
    while ((n = fmb_utf8_printable(label + i, size - i)) > 0 && !strchr(":#<>=\"", label[i]))
        i += n;
    bool plain = i == size && size > 0 && label[0] != ' ' && label[size - 1] != ' ' &&
                 !fmb_text_is_reserved((fmb_span){label, size});
    if (plain)
        fputs(label, out);
    else
        fmb_print_quoted(label, out);
    fputs(": ", out);
}

/* Write the variables whose mark is true; mark NULL: all. */
static void write_line_of_names(const fmb_system *s, const char *word,
                                bool mark(const fmb_system *, int), FILE *out)
{
    fputs(word, out);
    for (int j = 0; j < fmb_system_dim(s); j++) {
        if (mark && !mark(s, j))
            continue;
        fputc(' ', out);
        write_text_name(fmb_system_name(s, j), out);
    }
    fputc('\n', out);
}

/* Write the k-th term, q times variable j, with a blank between: 2 e3 is not 2e3. */
static void write_signed_term(const fmb_system *s, size_t k, int j, mpq_t q, FILE *out)
{
    bool minus = mpq_sgn(q) < 0;
    fputs(k == 0 ? (minus ? "-" : "") : (minus ? " - " : " + "), out);
    mpq_abs(q, q);
    if (mpq_cmp_ui(q, 1, 1) != 0) {
        fmb_print_q(out, q);
        fputc(' ', out);
    }
    write_text_name(fmb_system_name(s, j), out);
}

static void write_text_row(const fmb_system *s, size_t i, mpq_t q, FILE *out)
{
    static const char *const rel[] = {[FMB_LE] = " <= ", [FMB_LT] = " < ", [FMB_EQ] = " = "};
    size_t n = fmb_system_terms(s, i);
    if (fmb_system_label(s, i))
        write_row_label(fmb_system_label(s, i), out);
    for (size_t k = 0; k < n; k++) {
        int j = fmb_system_term_q(s, i, k, q);
        write_signed_term(s, k, j, q, out);
    }
    if (n == 0)
        fputc('0', out);
    fputs(rel[fmb_system_rel(s, i)], out);
    fmb_system_rhs_q(s, i, q);
    fmb_print_q(out, q);
    fputc('\n', out);
}

/* "max: 3 x + 2 y + 5" */
static void write_objective_line(const fmb_system *s, mpq_t q, FILE *out)
{
    size_t n = fmb_system_objective_terms(s);
    fputs(fmb_system_sense(s) == FMB_SENSE_MAX ? "max: " : "min: ", out);
    for (size_t k = 0; k < n; k++) {
        int j = fmb_system_objective_term_q(s, k, q);
        write_signed_term(s, k, j, q, out);
    }
    fmb_system_objective_constant_q(s, q);
    if (n > 0 && mpq_sgn(q) != 0)
        fputs(mpq_sgn(q) < 0 ? " - " : " + ", out);
    if (n > 0)
        mpq_abs(q, q);
    if (n == 0 || mpq_sgn(q) != 0)
        fmb_print_q(out, q);
    fputc('\n', out);
}

fmb_status fmb_write_text(const fmb_system *s, FILE *out)
{
    mpq_t q;
    mpq_init(q);
    if (fmb_system_dim(s) > 0)
        write_line_of_names(s, "vars:", NULL, out);
    if (fmb_system_asks_projection(s))
        write_line_of_names(s, "project:", fmb_system_is_kept, out);
    if (fmb_system_first_integer(s) >= 0)
        write_line_of_names(s, "integer:", fmb_system_is_integer, out);
    if (fmb_system_sense(s) != FMB_SENSE_NONE)
        write_objective_line(s, q, out);
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        write_text_row(s, i, q, out);
    if (fmb_system_dim(s) == 0 && fmb_system_rows(s) == 0)
        fputs("0 <= 0\n", out); /* an empty text would be no system */
    mpq_clear(q);
    return FMB_OK;
}
