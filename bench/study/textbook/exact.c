/* exact.c: verdict, interval and projection by textbook elimination; see exact.h. */
#include "study/textbook/exact.h"

#include "study/textbook/table.h"
#include "system/system_private.h"

/* A table of s with marks for the kept variables. */
typedef struct problem {
    fmb_mem mem;
    study_table table;
    bool *keep; /* [dim] */
    size_t dim;
} problem;

static fmb_status open_problem(problem *p, const fmb_system *s, size_t max_rows)
{
    fmb_mem_init(&p->mem, &s->mem.alloc, 0);
    p->dim = (size_t)fmb_system_dim(s);
    p->keep = fmb_mem_zero(&p->mem, p->dim, sizeof *p->keep);
    if (!p->keep)
        return FMB_ERR_MEMORY;
    fmb_status st = study_table_init(&p->table, s, max_rows, &p->mem);
    if (st != FMB_OK)
        fmb_mem_put(&p->mem, p->keep, p->dim, sizeof *p->keep);
    return st;
}

static void close_problem(problem *p)
{
    study_table_clear(&p->table);
    fmb_mem_put(&p->mem, p->keep, p->dim, sizeof *p->keep);
}

/* Eliminate all variables of a copy: no row remains, or a false one. */
static fmb_status decide(const problem *p, fmb_verdict *out)
{
    study_table t;
    fmb_mem mem = p->mem;
    bool *none = fmb_mem_zero(&mem, p->dim, sizeof *none);
    if (!none)
        return FMB_ERR_MEMORY;
    fmb_status st = study_table_copy(&t, &p->table);
    if (st == FMB_OK) {
        st = study_table_project(&t, none);
        if (st == FMB_OK)
            *out = study_table_is_false(&t) ? FMB_INFEASIBLE : FMB_FEASIBLE;
        study_table_clear(&t);
    }
    fmb_mem_put(&mem, none, p->dim, sizeof *none);
    return st;
}

/* The limit on rows is an answer, not an error. */
static fmb_status answer(fmb_status st, fmb_verdict verdict, fmb_verdict *out)
{
    if (st == FMB_OK || st == FMB_LIMIT)
        *out = st == FMB_OK ? verdict : FMB_UNKNOWN;
    return st == FMB_LIMIT ? FMB_OK : st;
}

fmb_status study_textbook_solve(const fmb_system *s, size_t max_rows, fmb_verdict *out)
{
    problem p;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = open_problem(&p, s, max_rows);
    if (st != FMB_OK)
        return st;
    st = decide(&p, &verdict);
    close_problem(&p);
    return answer(st, verdict, out);
}

/* Read the ends of a feasible interval off rows over var alone: x <= b, -x <= b or x = b, at most
 * one of each sort. An equality comes first and settles both ends. */
static void read_ends(const study_table *t, size_t var, study_textbook_end end[2])
{
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        end[side].kind = FMB_END_INFINITE;
        end[side].attained = false;
    }
    for (size_t i = 0; i < t->rows; i++) {
        const study_table_row *r = &t->row[i];
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
            bool bounds = r->rel == FMB_EQ || (mpq_sgn(r->a[var]) > 0) == (side == FMB_UPPER);
            if (!bounds || end[side].kind == FMB_END_FINITE)
                continue;
            end[side].kind = FMB_END_FINITE;
            end[side].attained = r->rel != FMB_LT;
            mpq_div(end[side].value, r->a[t->width - 1], r->a[var]);
        }
    }
}

fmb_status study_textbook_bound(const fmb_system *s, int var, size_t max_rows,
                                study_textbook_end end[2], fmb_verdict *out)
{
    if (var < 0 || var >= fmb_system_dim(s))
        return FMB_ERR_ARG;
    problem p;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = open_problem(&p, s, max_rows);
    if (st != FMB_OK)
        return st;
    p.keep[var] = true;
    st = study_table_project(&p.table, p.keep);
    if (st == FMB_OK)
        st = decide(&p, &verdict);
    if (st == FMB_OK && verdict == FMB_FEASIBLE)
        read_ends(&p.table, (size_t)var, end);
    close_problem(&p);
    return answer(st, verdict, out);
}

/* ---- projection ------------------------------------------------------------------------------ */

/* Append row r, whose variables are among keep[0..n), with scratch for n terms. */
static fmb_status add_row(fmb_system *out, const study_table *t, const study_table_row *r,
                          const int *keep, int n, int *var, mpq_t *coef)
{
    size_t terms = 0;
    for (int k = 0; k < n; k++) {
        if (mpq_sgn(r->a[keep[k]]) == 0)
            continue;
        var[terms] = k;
        mpq_set(coef[terms++], r->a[keep[k]]);
    }
    return fmb_system_add_q(out, terms, var, coef, r->rel, r->a[t->width - 1]);
}

static fmb_status add_rows(fmb_system *out, const study_table *t, const int *keep, int n)
{
    size_t size = (size_t)n;
    int *var = fmb_mem_get(&out->mem, size, sizeof *var);
    mpq_t *coef = fmb_mem_get(&out->mem, size, sizeof *coef);
    fmb_status st = var && coef ? FMB_OK : FMB_ERR_MEMORY;
    for (size_t k = 0; coef && k < size; k++)
        mpq_init(coef[k]);
    for (size_t i = 0; st == FMB_OK && i < t->rows; i++)
        st = add_row(out, t, &t->row[i], keep, n, var, coef);
    for (size_t k = 0; coef && k < size; k++)
        mpq_clear(coef[k]);
    fmb_mem_put(&out->mem, var, size, sizeof *var);
    fmb_mem_put(&out->mem, coef, size, sizeof *coef);
    return st;
}

/* [give] The table as a system over keep[0..n), named as in s. */
static fmb_status to_system(const fmb_system *s, const study_table *t, const int *keep, int n,
                            fmb_system **out)
{
    fmb_system *made;
    fmb_status st = fmb_system_new(0, &s->mem.alloc, &made);
    if (st != FMB_OK)
        return st;
    for (int k = 0; st == FMB_OK && k < n; k++)
        st = fmb_system_add_variable(made, fmb_system_name(s, keep[k]), NULL);
    if (st == FMB_OK)
        st = add_rows(made, t, keep, n);
    if (st == FMB_OK)
        *out = made;
    else
        fmb_system_free(made);
    return st;
}

fmb_status study_textbook_project(const fmb_system *s, const int *keep, int n, size_t max_rows,
                                  fmb_system **out, fmb_verdict *verdict)
{
    for (int k = 0; k < n; k++)
        if (keep[k] <= (k > 0 ? keep[k - 1] : -1) || keep[k] >= fmb_system_dim(s))
            return FMB_ERR_ARG;
    problem p;
    fmb_verdict found = FMB_UNKNOWN;
    fmb_status st = open_problem(&p, s, max_rows);
    if (st != FMB_OK)
        return st;
    for (int k = 0; k < n; k++)
        p.keep[keep[k]] = true;
    st = study_table_project(&p.table, p.keep);
    if (st == FMB_OK)
        st = decide(&p, &found);
    if (st == FMB_OK)
        st = to_system(s, &p.table, keep, n, out);
    close_problem(&p);
    return answer(st, found, verdict);
}
