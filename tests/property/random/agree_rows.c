/* agree_rows.c: projections and irredundant systems against the ground truth. See agree.h.
 *
 * Two systems have the same solutions if every row of one follows from the other and vice versa; a
 * row follows from s if s with the row negated is infeasible, which the ground truth decides. The
 * projection P of s on K: every row of P must follow from s (P is large enough), and every row of
 * the ground truth's projection from P (P is small enough). Every way has the same P, to the
 * letter.
 */
#include <stdlib.h>

#include "agree_inside.h"

/* Is s with row i of from (changed) infeasible? true also where the ground truth cannot say. */
static bool clash(agree *g, const fmb_system *s, const fmb_system *from, size_t i,
                  row_change change, const int *map)
{
    fmb_system *t = rows_with(s, SIZE_MAX, from, i, change, map);
    fmb_verdict v = FMB_UNKNOWN;
    must(study_textbook_solve(t, g->max_rows, &v));
    fmb_system_free(t);
    g->unjudged += v == FMB_UNKNOWN;
    return v != FMB_FEASIBLE;
}

static bool follows(agree *g, const fmb_system *a, const fmb_system *b, size_t i, const int *map)
{
    for (size_t k = 0; !map && k < fmb_system_rows(a); k++)
        if (rows_equal(a, k, b, i))
            return true;
    switch (fmb_system_rel(b, i)) {
    case FMB_LE:
        return clash(g, a, b, i, ROW_ABOVE, map);
    case FMB_LT:
        return clash(g, a, b, i, ROW_REACHED, map);
    default:
        return clash(g, a, b, i, ROW_ABOVE, map) && clash(g, a, b, i, ROW_BELOW, map);
    }
}

bool agree_implies(agree *g, const fmb_system *a, const fmb_system *b, const int *map)
{
    for (size_t i = 0; i < fmb_system_rows(b); i++)
        if (!follows(g, a, b, i, map))
            return differ(g, "row %zu of the other system does not follow", i + 1);
    return true;
}

bool agree_same(agree *g, const fmb_system *a, const fmb_system *b)
{
    return fmb_system_dim(a) == fmb_system_dim(b)
               ? agree_implies(g, a, b, NULL) && agree_implies(g, b, a, NULL)
               : differ(g, "another dimension");
}

/* Some point of s without row `but` has this changed row; true where the ground truth cannot say.
 */
static bool reachable(agree *g, const fmb_system *s, size_t but, size_t i, row_change change)
{
    fmb_system *t = rows_with(s, but, s, i, change, NULL);
    fmb_verdict v = FMB_UNKNOWN;
    must(study_textbook_solve(t, g->max_rows, &v));
    fmb_system_free(t);
    g->unjudged += v == FMB_UNKNOWN;
    return v != FMB_INFEASIBLE;
}

bool agree_irredundant(agree *g, const fmb_system *s)
{
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        fmb_rel rel = fmb_system_rel(s, i);
        bool needed = reachable(g, s, i, i, rel == FMB_LT ? ROW_REACHED : ROW_ABOVE) ||
                      (rel == FMB_EQ && reachable(g, s, i, i, ROW_BELOW));
        if (!needed)
            return differ(g, "row %zu of the result is redundant", i + 1);
        if (rel == FMB_LE && !reachable(g, s, SIZE_MAX, i, ROW_BELOW))
            return differ(g, "row %zu of the result is an equality in disguise", i + 1);
    }
    return true;
}

bool agree_form(agree *g, const fmb_system *p, const fmb_system *q)
{
    return !p || !q || rows_all_equal(p, q) || differ(g, "the same set in other rows");
}

/* Is p what a solver with the usual options makes of s? */
static bool has_usual_form(agree *g, const fmb_system *s, const fmb_system *p, const int *keep,
                           int n)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_system *usual = NULL;
    fmb_result r = {.size = sizeof r};
    o.evidence = FMB_EVIDENCE_NONE;
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, s, keep, n, &usual, &r));
    bool good = agree_form(g, p, r.stop == FMB_STOP_DONE ? usual : NULL);
    fmb_system_free(usual);
    fmb_solver_free(v);
    return good;
}

/* The one row 0 <= -1. */
static bool is_empty_set(agree *g, const fmb_system *s)
{
    mpq_t q;
    mpq_init(q);
    bool good =
        fmb_system_rows(s) == 1 && fmb_system_terms(s, 0) == 0 && fmb_system_rel(s, 0) == FMB_LE;
    if (good)
        fmb_system_rhs_q(s, 0, q);
    good = good && mpq_cmp_si(q, -1, 1) == 0;
    mpq_clear(q);
    return good || differ(g, "the result of an infeasible system is not the row 0 <= -1");
}

static bool judge_projection(agree *g, const truth *t, fmb_verdict verdict, const fmb_system *p,
                             const int *keep, int n)
{
    fmb_system *e = NULL;
    fmb_verdict v = FMB_UNKNOWN;
    if (fmb_system_dim(p) != n)
        return differ(g, "the projection has %d variables, not %d", fmb_system_dim(p), n);
    if (verdict == FMB_INFEASIBLE)
        return is_empty_set(g, p);
    if (!agree_implies(g, t->s, p, keep) || !agree_irredundant(g, p) ||
        !has_usual_form(g, t->s, p, keep, n))
        return false;
    must(study_textbook_project(t->s, keep, n, g->max_rows, &e, &v));
    g->unjudged += v == FMB_UNKNOWN;
    bool good = !e || agree_implies(g, p, e, NULL);
    fmb_system_free(e);
    return good;
}

bool agree_project(agree *g, fmb_solver *v, const truth *t, const int *keep, int n,
                   fmb_system **out)
{
    fmb_system *p = NULL;
    fmb_result r = {.size = sizeof r};
    bool good = judge_result(g, fmb_project(v, t->s, keep, n, &p, &r), &r, t);
    if (good && !p)
        good = differ(g, "no projection");
    if (good && r.stop != FMB_STOP_DONE) { /* an outer one */
        fmb_system_free(p);
        p = NULL;
    }
    if (good && p) {
        fmb_evidence *e = NULL;
        good = judge_evidence(g, v, t->s, &r, &e) && judge_projection(g, t, r.verdict, p, keep, n);
        if (good && r.verdict == FMB_FEASIBLE)
            good = judge_claims(g, e, FMB_CLAIM_IMPLIED, FMB_CLAIM_IMPLIED, fmb_system_rows(p));
        fmb_evidence_free(e);
    }
    if (good && out)
        *out = p;
    else
        fmb_system_free(p);
    return good;
}

/* The result holds the rows that stay, in their order, and fate tells which. */
static bool judge_fates(agree *g, const fmb_system *s, const fmb_fate *fate, const fmb_system *out)
{
    size_t k = 0;
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        if (fate[i] == FMB_FATE_REDUNDANT)
            continue;
        if (fate[i] == FMB_FATE_UNKNOWN)
            return differ(g, "row %zu has no fate", i + 1);
        if (k == fmb_system_rows(out))
            return differ(g, "row %zu should have stayed", i + 1);
        bool turned = fate[i] == FMB_FATE_EQUALITY;
        if (turned ? fmb_system_rel(out, k) != FMB_EQ || fmb_system_rel(s, i) != FMB_LE
                   : !rows_equal(s, i, out, k))
            return differ(g, "row %zu of the result is not row %zu", k + 1, i + 1);
        k++;
    }
    return k == fmb_system_rows(out) || differ(g, "the result has rows of its own");
}

/* Each row's fate is claimed; but an equality of s that stays needs no claim. */
static bool judge_fate_claims(agree *g, const fmb_evidence *e, const fmb_system *s,
                              const fmb_fate *fate)
{
    static const fmb_claim_kind kind[] = {[FMB_FATE_UNKNOWN] = FMB_CLAIM_NONE,
                                          [FMB_FATE_KEPT] = FMB_CLAIM_IRREDUNDANT,
                                          [FMB_FATE_EQUALITY] = FMB_CLAIM_EQUALITY,
                                          [FMB_FATE_REDUNDANT] = FMB_CLAIM_REDUNDANT};
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        bool claimed = fate[i] == FMB_FATE_KEPT && fmb_system_rel(s, i) == FMB_EQ;
        for (size_t k = 0; k < fmb_evidence_claims(e); k++)
            claimed = claimed ||
                      (fmb_evidence_row(e, k) == i && fmb_evidence_kind(e, k) == kind[fate[i]]);
        if (!claimed)
            return differ(g, "no claim proves the fate of row %zu", i + 1);
    }
    return true;
}

static bool judge_reduced(agree *g, fmb_solver *v, const truth *t, const fmb_result *r,
                          const fmb_fate *fate, const fmb_system *out)
{
    fmb_evidence *e = NULL;
    if (!judge_evidence(g, v, t->s, r, &e))
        return false;
    bool good = r->verdict == FMB_INFEASIBLE
                    ? is_empty_set(g, out)
                    : judge_fate_claims(g, e, t->s, fate) && judge_fates(g, t->s, fate, out) &&
                          agree_same(g, t->s, out) && agree_irredundant(g, out);
    fmb_evidence_free(e);
    return good;
}

bool agree_reduce(agree *g, fmb_solver *v, const truth *t, fmb_system **out)
{
    fmb_system *p = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_fate *fate = calloc(fmb_system_rows(t->s) + 1, sizeof *fate);
    bool good = judge_result(g, fmb_reduce(v, t->s, fate, &p, &r), &r, t);
    if (good && r.stop == FMB_STOP_DONE)
        good = judge_reduced(g, v, t, &r, fate, p);
    free(fate);
    if (good && out)
        *out = p;
    else
        fmb_system_free(p);
    return good;
}
