/* rows.c: build one system from the rows of another. See rows.h. */
#include <stdlib.h>

#include "rows.h"

fmb_system *rows_none(int dim)
{
    fmb_system *s = NULL;
    must(fmb_system_new(dim, NULL, &s));
    return s;
}

/* One row as separate numbers. */
typedef struct terms {
    int *var;
    mpq_t *coef;
    mpq_t rhs;
    size_t n;
} terms;

static terms terms_of(const fmb_system *s, size_t i)
{
    terms t = {.n = fmb_system_terms(s, i)};
    t.var = malloc((t.n + 1) * sizeof *t.var);
    t.coef = malloc((t.n + 1) * sizeof *t.coef);
    for (size_t k = 0; k < t.n; k++) {
        mpq_init(t.coef[k]);
        t.var[k] = fmb_system_term_q(s, i, k, t.coef[k]);
    }
    mpq_init(t.rhs);
    fmb_system_rhs_q(s, i, t.rhs);
    return t;
}

static void terms_clear(terms *t)
{
    for (size_t k = 0; k < t->n; k++)
        mpq_clear(t->coef[k]);
    mpq_clear(t->rhs);
    free(t->coef);
    free(t->var);
}

void rows_append(fmb_system *to, const fmb_system *from, size_t i, row_change change,
                 const int *map)
{
    terms t = terms_of(from, i);
    fmb_rel rel = change == ROW_SAME ? fmb_system_rel(from, i) : FMB_LT;
    if (change == ROW_REACHED)
        rel = FMB_LE;
    if (change == ROW_ABOVE || change == ROW_REACHED) {
        for (size_t k = 0; k < t.n; k++)
            mpq_neg(t.coef[k], t.coef[k]);
        mpq_neg(t.rhs, t.rhs);
    }
    for (size_t k = 0; map && k < t.n; k++)
        t.var[k] = map[t.var[k]];
    must(fmb_system_add_q(to, t.n, t.var, t.coef, rel, t.rhs));
    terms_clear(&t);
}

void rows_append_but(fmb_system *to, const fmb_system *from, size_t but, const int *map)
{
    for (size_t i = 0; i < fmb_system_rows(from); i++)
        if (i != but)
            rows_append(to, from, i, ROW_SAME, map);
}

fmb_system *rows_with(const fmb_system *s, size_t but, const fmb_system *from, size_t i,
                      row_change change, const int *map)
{
    fmb_system *t = rows_none(fmb_system_dim(s));
    rows_append_but(t, s, but, NULL);
    rows_append(t, from, i, change, map);
    return t;
}

bool rows_equal(const fmb_system *a, size_t i, const fmb_system *b, size_t k)
{
    terms s = terms_of(a, i), t = terms_of(b, k);
    bool same =
        s.n == t.n && fmb_system_rel(a, i) == fmb_system_rel(b, k) && mpq_equal(s.rhs, t.rhs) != 0;
    for (size_t j = 0; same && j < s.n; j++)
        same = s.var[j] == t.var[j] && mpq_equal(s.coef[j], t.coef[j]) != 0;
    terms_clear(&s);
    terms_clear(&t);
    return same;
}

bool rows_all_equal(const fmb_system *a, const fmb_system *b)
{
    bool same = fmb_system_rows(a) == fmb_system_rows(b);
    for (size_t i = 0; same && i < fmb_system_rows(a); i++)
        same = rows_equal(a, i, b, i);
    return same;
}

void rows_print(const fmb_system *s, FILE *out)
{
    static const char *const rel[] = {"<=", "<", "="};
    fprintf(out, "vars:");
    for (int j = 0; j < fmb_system_dim(s); j++)
        fprintf(out, " %s", fmb_system_name(s, j));
    fprintf(out, "\n");
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        terms t = terms_of(s, i);
        for (size_t k = 0; k < t.n; k++)
            gmp_fprintf(out, "%s%Qd %s", k ? " + " : "", t.coef[k], fmb_system_name(s, t.var[k]));
        gmp_fprintf(out, "%s %s %Qd\n", t.n ? "" : "0", rel[fmb_system_rel(s, i)], t.rhs);
        terms_clear(&t);
    }
}
