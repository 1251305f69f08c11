/* ine_write.c: a system as a cddlib/lrslib H-representation. Names other than x1, x2, ... and
 * labels are lost; comments in front tell the names.
 */
#include <string.h>

#include "io/io.h"
#include "io/utf8.h"
#include "system/system.h"

static bool is_integer_row(const fmb_sysrow *r)
{
    mpz_t den;
    mpz_init(den);
    fmb_vec_get(&r->val, r->nnz + 1, den);
    bool yes = mpz_cmp_ui(den, 1) == 0;
    mpz_clear(den);
    return yes;
}

static bool is_integer(const fmb_system *s)
{
    for (size_t i = 0; i < s->rows; i++)
        if (!is_integer_row(&s->row[i]))
            return false;
    return true;
}

/* A name may hold any bytes; a comment is one line of text. */
static void write_comment(const char *name, int j, FILE *out)
{
    char usual[32];
    snprintf(usual, sizeof usual, "x%d", j + 1);
    if (strcmp(name, usual) == 0)
        return;
    fprintf(out, "* %s is ", usual);
    for (size_t left = strlen(name); left > 0;) {
        size_t n = fmb_utf8_printable(name, left);
        fwrite(n > 0 ? name : "?", 1, n > 0 ? n : 1, out);
        name += n > 0 ? n : 1;
        left -= n > 0 ? n : 1;
    }
    fputc('\n', out);
}

/* "word k i1 ... ik" with the rows of this relation, if there are any. */
static void write_rows_of(const fmb_system *s, fmb_rel rel, const char *word, FILE *out)
{
    size_t k = 0;
    for (size_t i = 0; i < s->rows; i++)
        k += s->row[i].rel == rel;
    if (k == 0)
        return;
    fprintf(out, "%s %zu", word, k);
    for (size_t i = 0; i < s->rows; i++)
        if (s->row[i].rel == rel)
            fprintf(out, " %zu", i + 1);
    fputc('\n', out);
}

/* a.x <= b is b - a.x >= 0. */
static void write_row(const fmb_system *s, size_t i, mpq_t q, FILE *out)
{
    size_t k = 0, n = fmb_system_terms(s, i);
    fmb_system_rhs_q(s, i, q);
    fmb_print_q(out, q);
    for (int j = 0; j < fmb_system_dim(s); j++) {
        fputc(' ', out);
        if (k < n && s->row[i].var[k] == j) {
            fmb_system_term_q(s, i, k++, q);
            mpq_neg(q, q);
            fmb_print_q(out, q);
        } else {
            fputc('0', out);
        }
    }
    fputc('\n', out);
}

static void write_marks(const fmb_system *s, FILE *out)
{
    int k = 0;
    if (!s->asks_projection)
        return;
    for (int j = 0; j < fmb_system_dim(s); j++)
        k += s->kept[j];
    fprintf(out, "project %d", k);
    for (int j = 0; j < fmb_system_dim(s); j++)
        if (s->kept[j])
            fprintf(out, " %d", j + 1);
    fputc('\n', out);
}

fmb_status fmb_write_ine(const fmb_system *s, FILE *out)
{
    mpq_t q;
    for (int j = 0; j < fmb_system_dim(s); j++)
        write_comment(fmb_system_name(s, j), j, out);
    fputs("H-representation\n", out);
    write_rows_of(s, FMB_EQ, "linearity", out);
    write_rows_of(s, FMB_LT, "strict_inequality", out);
    fprintf(out, "begin\n%zu %d %s\n", s->rows, fmb_system_dim(s) + 1,
            is_integer(s) ? "integer" : "rational");
    mpq_init(q);
    for (size_t i = 0; i < s->rows; i++)
        write_row(s, i, q, out);
    mpq_clear(q);
    fputs("end\n", out);
    write_marks(s, out);
    return FMB_OK;
}
