/* canon.c: see canon.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>

#include "canon.h"
#include "problem.h"

typedef struct table {
    mpq_t *cell; /* rows x (n + 1), right sides last */
    fmb_rel *rel;
    size_t rows, width;
} table;

static mpq_t *row_of(const table *t, size_t i)
{
    return t->cell + i * t->width;
}

/* Equalities first. */
static table table_of(const fmb_system *s)
{
    size_t n = (size_t)fmb_system_dim(s), m = fmb_system_rows(s), next = 0;
    table t = {need(calloc((m + 1) * (n + 1), sizeof *t.cell)), need(calloc(m + 1, sizeof *t.rel)),
               m, n + 1};
    mpq_t q;
    mpq_init(q);
    for (size_t i = 0; i < m * (n + 1); i++)
        mpq_init(t.cell[i]);
    for (int equal = 1; equal >= 0; equal--) {
        for (size_t i = 0; i < m; i++) {
            if ((fmb_system_rel(s, i) == FMB_EQ) != (equal == 1))
                continue;
            for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
                int j = fmb_system_term_q(s, i, k, q);
                mpq_set(row_of(&t, next)[j], q);
            }
            fmb_system_rhs_q(s, i, row_of(&t, next)[n]);
            t.rel[next++] = fmb_system_rel(s, i);
        }
    }
    mpq_clear(q);
    return t;
}

static void table_clear(table *t)
{
    for (size_t i = 0; i < t->rows * t->width; i++)
        mpq_clear(t->cell[i]);
    free(t->cell);
    free(t->rel);
}

/* row i -= factor * row k */
static void subtract(const table *t, size_t i, size_t k, const mpq_t factor)
{
    mpq_t f, v;
    mpq_init(f);
    mpq_init(v);
    mpq_set(f, factor);
    for (size_t j = 0; j < t->width; j++) {
        mpq_mul(v, f, row_of(t, k)[j]);
        mpq_sub(row_of(t, i)[j], row_of(t, i)[j], v);
    }
    mpq_clear(f);
    mpq_clear(v);
}

/* Divide row k by its entry in column j. */
static void normalize(const table *t, size_t k, size_t j)
{
    mpq_t pivot;
    mpq_init(pivot);
    mpq_set(pivot, row_of(t, k)[j]);
    for (size_t c = 0; c < t->width; c++)
        mpq_div(row_of(t, k)[c], row_of(t, k)[c], pivot);
    mpq_clear(pivot);
}

/* Gauss-Jordan elimination by the equalities; every other row becomes 0 in their pivots. */
static void reduce_by_equalities(const table *t)
{
    size_t equalities = 0, done = 0;
    while (equalities < t->rows && t->rel[equalities] == FMB_EQ)
        equalities++;
    for (size_t j = 0; j + 1 < t->width && done < equalities; j++) {
        size_t k = done;
        while (k < equalities && mpq_sgn(row_of(t, k)[j]) == 0)
            k++;
        if (k == equalities)
            continue;
        for (size_t c = 0; k != done && c < t->width; c++)
            mpq_swap(row_of(t, k)[c], row_of(t, done)[c]);
        normalize(t, done, j);
        for (size_t i = 0; i < t->rows; i++)
            if (i != done && mpq_sgn(row_of(t, i)[j]) != 0)
                subtract(t, i, done, row_of(t, i)[j]);
        done++;
    }
}

/* The row as primitive integers, "3 0 -1 <= 7\n"; NULL if it is constant (0 <= b) and these say
 * nothing. */
static char *row_text(mpq_t *row, size_t width, fmb_rel rel, bool constants)
{
    static const char *const word[] = {[FMB_LE] = "<=", [FMB_LT] = "<", [FMB_EQ] = "="};
    char *text = NULL;
    size_t size = 0;
    bool zero = true;
    mpz_t common, divisor, z;
    mpz_inits(common, divisor, z, NULL);
    mpz_set_ui(common, 1);
    for (size_t j = 0; j < width; j++)
        mpz_lcm(common, common, mpq_denref(row[j]));
    for (size_t j = 0; j < width; j++) {
        mpz_divexact(z, common, mpq_denref(row[j]));
        mpz_mul(z, z, mpq_numref(row[j]));
        mpz_gcd(divisor, divisor, z);
    }
    FILE *out = need(open_memstream(&text, &size));
    for (size_t j = 0; j < width; j++) {
        zero &= j + 1 == width || mpq_sgn(row[j]) == 0;
        mpz_divexact(z, common, mpq_denref(row[j]));
        mpz_mul(z, z, mpq_numref(row[j]));
        if (mpz_sgn(divisor) != 0)
            mpz_divexact(z, z, divisor);
        gmp_fprintf(out, j + 1 == width ? "%s %Zd\n" : "%s%Zd ", j + 1 == width ? word[rel] : "",
                    z);
    }
    fclose(out);
    mpz_clears(common, divisor, z, NULL);
    if (!zero || constants)
        return text;
    free(text);
    return NULL;
}

static int by_text(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static char *sorted_rows(const table *t, bool constants)
{
    char **line = need(calloc(t->rows + 1, sizeof *line)), *text = NULL;
    size_t lines = 0, size = 0;
    for (size_t i = 0; i < t->rows; i++) {
        line[lines] = row_text(row_of(t, i), t->width, t->rel[i], constants);
        lines += line[lines] != NULL;
    }
    qsort(line, lines, sizeof *line, by_text);
    FILE *out = need(open_memstream(&text, &size));
    for (size_t i = 0; i < lines; i++) {
        if (i == 0 || strcmp(line[i - 1], line[i]) != 0)
            fputs(line[i], out);
    }
    fclose(out);
    for (size_t i = 0; i < lines; i++)
        free(line[i]);
    free(line);
    return text;
}

char *canonical_text(const fmb_system *s)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_system *form = NULL;
    fmb_result r = {.size = sizeof r};
    int n = fmb_system_dim(s), *all = need(calloc((size_t)n + 1, sizeof *all));
    for (int j = 0; j < n; j++)
        all[j] = j;
    o.evidence = FMB_EVIDENCE_NONE;
    if (fmb_solver_new(&o, NULL, &v) != FMB_OK || fmb_project(v, s, all, n, &form, &r) != FMB_OK)
        need(NULL);
    fmb_solver_free(v);
    free(all);
    table t = table_of(form);
    char *text = r.verdict == FMB_INFEASIBLE ? need(strdup("empty\n")) : sorted_rows(&t, false);
    table_clear(&t);
    fmb_system_free(form);
    return text;
}

/* Does a row have a right side? */
static bool has_right_side(const table *t)
{
    for (size_t i = 0; i < t->rows; i++)
        if (mpq_sgn(row_of(t, i)[t->width - 1]) != 0)
            return true;
    return false;
}

char *canonical_list(const fmb_system *s, bool generators)
{
    table t = table_of(s);
    reduce_by_equalities(&t);
    char *text =
        generators && !has_right_side(&t) ? need(strdup("empty\n")) : sorted_rows(&t, generators);
    table_clear(&t);
    return text;
}
