/* ine_write.c: a system as a cddlib/lrslib H-representation; comments in front keep names and
 * labels.
 */
#include <string.h>

#include "io/core/io_private.h"
#include "io/core/number.h"
#include "system/system_private.h"

static bool is_integer_row(const fmb_sysrow *r)
{
    mpz_t den;
    mpz_init(den);
    fmb_vec_get(&r->val, r->nnz + 1, den);
    bool yes = mpz_cmp_ui(den, 1) == 0;
    mpz_clear(den);
    return yes;
}

static bool are_all_rows_integer(const fmb_system *s)
{
    for (size_t i = 0; i < s->rows; i++)
        if (!is_integer_row(&s->row[i]))
            return false;
    return true;
}

/* Comments with the names other than x1, x2, ... and the labels; ine_names.c reads them. */
static void write_name_comments(const fmb_system *s, FILE *out)
{
    for (int j = 0; j < fmb_system_dim(s); j++) {
        char usual[32];
        snprintf(usual, sizeof usual, "x%d", j + 1);
        if (strcmp(fmb_system_name(s, j), usual) == 0)
            continue;
        fprintf(out, "* %s is ", usual);
        fmb_print_quoted(fmb_system_name(s, j), out);
        fputc('\n', out);
    }
    for (size_t i = 0; i < s->rows; i++) {
        if (!s->row[i].label)
            continue;
        fprintf(out, "* row %zu is ", i + 1);
        fmb_print_quoted(s->row[i].label, out);
        fputc('\n', out);
    }
}

/* "word k i1 ... ik" with the rows of this relation, if there are any. */
static void write_rows_of_relation(const fmb_system *s, fmb_rel rel, const char *word, FILE *out)
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
static void write_matrix_row(const fmb_system *s, size_t i, mpq_t q, FILE *out)
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

static void write_project_line(const fmb_system *s, FILE *out)
{
    int k = 0;
    if (!s->asks_projection)
        return;
    for (int j = 0; j < fmb_system_dim(s); j++)
        k += s->mark[j].kept;
    fprintf(out, "project %d", k);
    for (int j = 0; j < fmb_system_dim(s); j++)
        if (s->mark[j].kept)
            fprintf(out, " %d", j + 1);
    fputc('\n', out);
}

/* "maximize", then the constant and a coefficient for each variable. */
static void write_objective_lines(const fmb_system *s, mpq_t q, FILE *out)
{
    size_t k = 0, n = fmb_system_objective_terms(s);
    if (s->sense == FMB_SENSE_NONE)
        return;
    fputs(s->sense == FMB_SENSE_MAX ? "maximize\n" : "minimize\n", out);
    fmb_system_objective_constant_q(s, q);
    fmb_print_q(out, q);
    for (int j = 0; j < fmb_system_dim(s); j++) {
        mpq_set_ui(q, 0, 1);
        if (k < n && s->objective.var[k] == j)
            fmb_system_objective_term_q(s, k++, q);
        fputc(' ', out);
        fmb_print_q(out, q);
    }
    fputc('\n', out);
}

fmb_status fmb_write_ine(const fmb_system *s, FILE *out)
{
    mpq_t q;
    write_name_comments(s, out);
    fputs("H-representation\n", out);
    write_rows_of_relation(s, FMB_EQ, "linearity", out);
    write_rows_of_relation(s, FMB_LT, "strict_inequality", out);
    fprintf(out, "begin\n%zu %d %s\n", s->rows, fmb_system_dim(s) + 1,
            are_all_rows_integer(s) ? "integer" : "rational");
    mpq_init(q);
    for (size_t i = 0; i < s->rows; i++)
        write_matrix_row(s, i, q, out);
    fputs("end\n", out);
    write_project_line(s, out);
    write_objective_lines(s, q, out);
    mpq_clear(q);
    return FMB_OK;
}
