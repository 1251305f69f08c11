/* lp_write.c: a system as a CPLEX LP file.
 *
 * The objective names every variable, with coefficient 0 if need be, which fixes their order; all
 * are declared free, and rows bound them. A system without an objective gets one of zeros.
 */
#include <string.h>

#include "io/core/utf8.h"
#include "io/lp/token.h"
#include "io/program/export.h"

/* Terms of a line. */
enum { TERMS_A_LINE = 8 };

/* Is the name one token for the scanner in any place, no keyword, and not read as an exponent? */
static bool spells_lp(const char *name)
{
    fmb_where where;
    fmb_mem mem;
    fmb_lp_token t = {0};
    mpq_t value;
    size_t size = strlen(name);
    fmb_mem_init(&mem, NULL, 0);
    fmb_cursor c =
        fmb_io_cursor(name, size, &(fmb_reader){.size = sizeof(fmb_reader)}, &mem, &where);
    if ((*name | 32) == 'e' && (name[1] == '\0' || strspn(name + 1, "0123456789.") > 0))
        return false;
    if (fmb_span_is_nocase((fmb_span){name, size}, "free") ||
        fmb_span_is_nocase((fmb_span){name, size}, "inf") ||
        fmb_span_is_nocase((fmb_span){name, size}, "infinity"))
        return false;
    if (fmb_io_check(&c) != FMB_OK)
        return false;
    mpq_init(value);
    bool plain = size > 0 && fmb_lp_scan(&c, &t, value) == FMB_OK && t.kind == FMB_LP_NAME &&
                 t.text.n == size;
    mpq_clear(value);
    for (size_t i = 0, n; plain && i < size; i += n) {
        n = fmb_utf8_printable(name + i, size - i);
        plain = n > 0;
    }
    return plain;
}

/* The k-th term of a sum, e->q times e->scale times variable j. */
static void write_lp_term(fmb_export *e, size_t k, int j)
{
    bool minus = mpq_sgn(e->q) < 0;
    fputs(k > 0 && k % TERMS_A_LINE == 0 ? "\n " : "", e->out);
    fputs(minus ? " - " : k > 0 ? " + " : " ", e->out);
    mpq_abs(e->q, e->q);
    mpq_mul(e->q, e->q, e->scale);
    if (mpq_cmp_ui(e->q, 1, 1) != 0) {
        fmb_print_decimal(e->out, e->q);
        fputc(' ', e->out);
    }
    fputs(e->column.name[j], e->out);
}

static void write_lp_objective(fmb_export *e)
{
    size_t k = 0;
    bool max = fmb_system_sense(e->s) == FMB_SENSE_MAX;
    fprintf(e->out, "%s\n %s:", max ? "Maximize" : "Minimize", e->row.name[fmb_system_rows(e->s)]);
    mpq_set_ui(e->scale, 1, 1);
    for (int j = 0; j < fmb_system_dim(e->s); j++) {
        bool asked = fmb_system_objective_term_q(e->s, k, e->q) == j;
        if (!asked)
            mpq_set_ui(e->q, 0, 1);
        k += asked;
        write_lp_term(e, (size_t)j, j);
    }
    fmb_system_objective_constant_q(e->s, e->q);
    if (mpq_sgn(e->q) != 0) {
        fputs(mpq_sgn(e->q) < 0 ? " - " : " + ", e->out);
        mpq_abs(e->q, e->q);
        fmb_print_decimal(e->out, e->q);
    }
    fputc('\n', e->out);
}

/* A row without terms is written with 0 times the first variable. */
static void write_lp_row(fmb_export *e, size_t i)
{
    fprintf(e->out, " %s:", e->row.name[i]);
    fmb_export_scale(e, i);
    for (size_t k = 0; k < fmb_system_terms(e->s, i); k++) {
        int j = fmb_system_term_q(e->s, i, k, e->q);
        write_lp_term(e, k, j);
    }
    if (fmb_system_terms(e->s, i) == 0)
        fprintf(e->out, " 0 %s", e->column.name[0]);
    fputs(fmb_system_rel(e->s, i) == FMB_EQ ? " = " : " <= ", e->out);
    fmb_system_rhs_q(e->s, i, e->q);
    fmb_export_print(e);
    fputc('\n', e->out);
}

fmb_status fmb_write_lp(const fmb_system *s, FILE *out)
{
    fmb_export e;
    bool any = false;
    fmb_status st = fmb_export_open(&e, s, spells_lp, out);
    if (st == FMB_OK) {
        write_lp_objective(&e);
        fputs("Subject To\n", out);
        for (size_t i = 0; i < fmb_system_rows(s); i++)
            write_lp_row(&e, i);
        fputs("Bounds\n", out);
        for (int j = 0; j < fmb_system_dim(s); j++)
            fprintf(out, " %s free\n", e.column.name[j]);
        for (int j = 0; j < fmb_system_dim(s); j++) {
            if (fmb_system_is_integer(s, j))
                fprintf(out, "%s %s\n", any ? "" : "General\n", e.column.name[j]);
            any = any || fmb_system_is_integer(s, j);
        }
        fputs("End\n", out);
    }
    fmb_export_close(&e);
    return st;
}
