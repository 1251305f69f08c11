/* reference.c: see reference.h.
 *
 * Words for a projection: on one variable its exact interval; on more the sorted rows of an
 * irredundant system, which are unique up to scaling if the projection is full-dimensional; else
 * the numbers of equalities and inequalities, which are unique then.
 */
#include "study/reference/reference.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>

fmb_status study_reference_open(study_reference *j, double max_seconds)
{
    fmb_options o = {.size = sizeof o};
    *j = (study_reference){0};
    o.evidence = FMB_EVIDENCE_ALL;
    o.max_seconds = max_seconds;
    fmb_status st = fmb_solver_new(&o, NULL, &j->projection);
    o.method = FMB_METHOD_LP;
    if (st == FMB_OK)
        st = fmb_solver_new(&o, NULL, &j->oracle);
    return st;
}

void study_reference_close(study_reference *j)
{
    fmb_solver_free(j->oracle);
    fmb_solver_free(j->projection);
}

/* Does the checker accept what v has just found about s? */
static fmb_status check(study_reference *j, const fmb_solver *v, const fmb_system *s)
{
    fmb_evidence *e = NULL;
    fmb_judgement say = {.size = sizeof say};
    fmb_status st = fmb_solver_evidence(v, &e);
    if (st == FMB_OK)
        st = fmb_check(s, e, &say);
    if (st == FMB_OK && !say.accepted)
        j->rejected++;
    fmb_evidence_free(e);
    return st;
}

fmb_status study_reference_verdict(study_reference *j, const fmb_system *s, fmb_verdict *out)
{
    fmb_result r = {.size = sizeof r};
    fmb_status st = fmb_solve(j->oracle, s, &r);
    if (st == FMB_OK && r.verdict != FMB_UNKNOWN)
        st = check(j, j->oracle, s);
    if (st == FMB_OK)
        *out = r.verdict;
    return st;
}

/* ---- on one variable ------------------------------------------------------------------------- */

static char *interval_words(const fmb_box *b)
{
    char *text = NULL, *end[2] = {NULL, NULL};
    mpq_t q;
    mpq_init(q);
    for (int k = FMB_LOWER; k <= FMB_UPPER; k++)
        end[k] = fmb_box_end_q(b, 0, (fmb_side)k, q) ? mpq_get_str(NULL, 10, q) : NULL;
    mpq_clear(q);
    size_t size = 16;
    FILE *f = open_memstream(&text, &size);
    for (int k = FMB_LOWER; f && k <= FMB_UPPER; k++)
        fprintf(f, "%s%s ", end[k] ? end[k] : "inf",
                fmb_box_end(b, 0, (fmb_side)k).attained ? " attained" : "");
    if (f)
        fclose(f);
    free(end[0]);
    free(end[1]);
    return text;
}

static fmb_status bound_words(study_reference *j, const fmb_system *s, int var, bool mine,
                              char **out)
{
    fmb_result r = {.size = sizeof r};
    fmb_box *b = NULL;
    fmb_status st = fmb_bound(j->oracle, s, &var, 1, &b, &r);
    if (st == FMB_OK && mine && r.verdict != FMB_UNKNOWN)
        st = check(j, j->oracle, s);
    char *text = NULL;
    if (st == FMB_OK && r.stop == FMB_STOP_DONE) {
        text = b ? interval_words(b) : strdup("empty");
        st = text ? FMB_OK : FMB_ERR_MEMORY;
    }
    fmb_box_free(b);
    if (st == FMB_OK)
        *out = text;
    return st;
}

/* ---- on more --------------------------------------------------------------------------------- */

/* Row i, its first coefficient made 1 or -1. */
static char *row_words(const fmb_system *s, size_t i)
{
    char *text = NULL;
    size_t size;
    mpq_t q, unit;
    FILE *f = open_memstream(&text, &size);
    if (!f)
        return NULL;
    mpq_inits(q, unit, NULL);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int var = fmb_system_term_q(s, i, k, q);
        if (k == 0)
            mpq_abs(unit, q);
        mpq_div(q, q, unit);
        char *number = mpq_get_str(NULL, 10, q);
        fprintf(f, "%s x%d ", number, var);
        free(number);
    }
    fmb_system_rhs_q(s, i, q);
    if (mpq_sgn(unit) != 0)
        mpq_div(q, q, unit);
    char *number = mpq_get_str(NULL, 10, q);
    fprintf(f, "%d %s\n", (int)fmb_system_rel(s, i), number);
    free(number);
    mpq_clears(q, unit, NULL);
    fclose(f);
    return text;
}

static int compare_words(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static char *join(char **word, size_t n)
{
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    for (size_t i = 0; f && i < n; i++)
        if (word[i])
            fputs(word[i], f);
    if (f)
        fclose(f);
    return text;
}

static char *rows_words(const fmb_system *p)
{
    size_t n = fmb_system_rows(p), equalities = 0;
    char **word = calloc(n + 1, sizeof *word);
    char *text = NULL;
    for (size_t i = 0; i < n; i++)
        equalities += fmb_system_rel(p, i) == FMB_EQ;
    if (word && equalities > 0) {
        word[0] = malloc(64);
        if (word[0])
            snprintf(word[0], 64, "%zu equalities of %zu", equalities, n);
        text = join(word, 1);
    } else if (word) {
        bool whole = true;
        for (size_t i = 0; i < n; i++)
            whole = (word[i] = row_words(p, i)) != NULL && whole;
        qsort(word, whole ? n : 0, sizeof *word, compare_words);
        text = whole ? join(word, n) : NULL;
    }
    for (size_t i = 0; word && i < n; i++)
        free(word[i]);
    free(word);
    return text;
}

fmb_status study_reference_words(study_reference *j, const fmb_system *p, char **out)
{
    if (fmb_system_dim(p) == 1)
        return bound_words(j, p, 0, false, out);
    char *text = rows_words(p);
    if (!text)
        return FMB_ERR_MEMORY;
    *out = text;
    return FMB_OK;
}

fmb_status study_reference_projection(study_reference *j, const fmb_system *s, const int *keep,
                                      int n, char **out)
{
    fmb_result r = {.size = sizeof r};
    fmb_system *p = NULL;
    char *text = NULL;
    if (n == 1)
        return bound_words(j, s, keep[0], true, out);
    fmb_status st = fmb_project(j->projection, s, keep, n, &p, &r);
    if (st == FMB_OK && p)
        st = check(j, j->projection, s);
    if (st == FMB_OK && p && r.stop == FMB_STOP_DONE)
        st = study_reference_words(j, p, &text);
    fmb_system_free(p);
    if (st == FMB_OK)
        *out = text;
    return st;
}
