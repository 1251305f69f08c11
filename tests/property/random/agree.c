/* agree.c: verdicts and boxes against the ground truth. See agree.h. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

#include "agree_inside.h"

bool differ(agree *g, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(g->why, sizeof g->why, format, list);
    va_end(list);
    return false;
}

/* Ends of all variables, or NULL if one of them is out of reach. */
static study_textbook_end (*ends_of(const fmb_system *s, size_t max_rows))[2]
{
    int dim = fmb_system_dim(s), reached = 0;
    study_textbook_end(*end)[2] = calloc((size_t)dim + 1, sizeof *end);
    for (; end && reached < dim; reached++) {
        fmb_verdict v = FMB_UNKNOWN;
        mpq_init(end[reached][0].value);
        mpq_init(end[reached][1].value);
        must(study_textbook_bound(s, reached, max_rows, end[reached], &v));
        if (v != FMB_FEASIBLE)
            break;
    }
    if (reached == dim)
        return end;
    for (int j = 0; j <= reached; j++)
        mpq_clears(end[j][0].value, end[j][1].value, NULL);
    free(end);
    return NULL;
}

void truth_init(truth *t, const fmb_system *s, size_t max_rows)
{
    *t = (truth){.s = s};
    must(study_textbook_solve(s, max_rows, &t->verdict));
    if (t->verdict == FMB_FEASIBLE)
        t->end = ends_of(s, max_rows);
}

void truth_clear(truth *t)
{
    for (int j = 0; t->end && j < fmb_system_dim(t->s); j++)
        mpq_clears(t->end[j][0].value, t->end[j][1].value, NULL);
    free(t->end);
    *t = (truth){0};
}

/* How many claims of that kind there are. */
static size_t claims_of(const fmb_evidence *e, fmb_claim_kind kind)
{
    size_t n = 0;
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        n += fmb_evidence_kind(e, i) == kind;
    return n;
}

bool judge_result(agree *g, fmb_status st, const fmb_result *r, const truth *t)
{
    g->questions++;
    if (st != FMB_OK)
        return differ(g, "status: %s", fmb_status_text(st));
    if (r->stop != FMB_STOP_DONE) {
        g->undecided++;
        if (r->verdict == FMB_UNKNOWN)
            return true;
    }
    if (r->stop == FMB_STOP_DONE && r->verdict == FMB_UNKNOWN)
        return differ(g, "done, but the verdict is unknown");
    if (t->verdict == FMB_UNKNOWN)
        g->unjudged++;
    else if (r->verdict != t->verdict)
        return differ(g, "verdict %s, truth %s", fmb_verdict_text(r->verdict),
                      fmb_verdict_text(t->verdict));
    if (r->trust != FMB_TRUST_EXACT)
        return differ(g, "an answer that is not exact");
    return true;
}

bool judge_evidence(agree *g, fmb_solver *v, const fmb_system *s, const fmb_result *r,
                    fmb_evidence **out)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_status st = fmb_solver_evidence(v, &e);
    if (st != FMB_OK)
        return differ(g, "no evidence: %s", fmb_status_text(st));
    must(fmb_check(s, e, &j));
    bool good = j.accepted || fmb_evidence_claims(e) == 0;
    if (!good)
        differ(g, "evidence rejected: claim %zu: %s", j.claim, j.reason);
    else if (r->verdict == FMB_INFEASIBLE && claims_of(e, FMB_CLAIM_INFEASIBLE) == 0)
        good = differ(g, "no claim proves the conflict");
    else if (j.verdict != r->verdict && j.verdict != FMB_UNKNOWN)
        good = differ(g, "evidence says %s", fmb_verdict_text(j.verdict));
    if (good)
        *out = e;
    else
        fmb_evidence_free(e);
    return good;
}

bool judge_claims(agree *g, const fmb_evidence *e, fmb_claim_kind a, fmb_claim_kind b, size_t count)
{
    size_t found = claims_of(e, a) + (b != a ? claims_of(e, b) : 0);
    return found == count || differ(g, "%zu claims of the right kind, %zu expected", found, count);
}

bool agree_solve(agree *g, fmb_solver *v, const truth *t)
{
    fmb_result r = {.size = sizeof r};
    fmb_evidence *e = NULL;
    if (!judge_result(g, fmb_solve(v, t->s, &r), &r, t))
        return false;
    if (r.verdict == FMB_UNKNOWN)
        return true;
    fmb_claim_kind kind = r.verdict == FMB_FEASIBLE ? FMB_CLAIM_FEASIBLE : FMB_CLAIM_INFEASIBLE;
    bool good = judge_evidence(g, v, t->s, &r, &e) && judge_claims(g, e, kind, kind, 1);
    fmb_evidence_free(e);
    return good;
}

/* The double is the outward neighbour of the exact end, or the end itself. */
static bool outward(const fmb_end *end, mpq_t exact, fmb_side side)
{
    mpq_t q;
    mpq_init(q);
    double out = side == FMB_LOWER ? -INFINITY : INFINITY;
    int sign = side == FMB_LOWER ? 1 : -1, near = 1;
    if (isfinite(end->value)) {
        mpq_set_d(q, end->value);
        near = sign * mpq_cmp(q, exact) <= 0;
    }
    double inner = nextafter(end->value, -out);
    if (near && isfinite(inner)) {
        mpq_set_d(q, inner);
        near = sign * mpq_cmp(q, exact) > 0;
    }
    mpq_clear(q);
    return near != 0;
}

/* known: the truth, or NULL. */
static bool judge_end(agree *g, const fmb_box *box, int i, fmb_side side,
                      const study_textbook_end *known)
{
    static const char *const word[] = {"lower", "upper"};
    fmb_end end = fmb_box_end(box, i, side);
    bool good = true;
    mpq_t q;
    mpq_init(q);
    if (fmb_box_end_q(box, i, side, q) != (end.kind == FMB_END_FINITE))
        good = differ(g, "%s end of x%d: finite or not?", word[side], fmb_box_var(box, i) + 1);
    else if (end.kind == FMB_END_FINITE && !outward(&end, q, side))
        good = differ(g, "%s end of x%d: rounded to %a", word[side], fmb_box_var(box, i) + 1,
                      end.value);
    if (good && known && end.kind != known->kind)
        good = differ(g, "%s end of x%d: kind %d, truth %d", word[side], fmb_box_var(box, i) + 1,
                      (int)end.kind, (int)known->kind);
    if (good && known && end.kind == FMB_END_FINITE && !mpq_equal(q, known->value))
        good = differ(g, "%s end of x%d: about %g, truth %g", word[side], fmb_box_var(box, i) + 1,
                      mpq_get_d(q), mpq_get_d(known->value));
    if (good && known && end.attained != (known->kind == FMB_END_FINITE && known->attained))
        good = differ(g, "%s end of x%d: attained or not?", word[side], fmb_box_var(box, i) + 1);
    mpq_clear(q);
    return good;
}

static bool judge_box(agree *g, const fmb_box *box, const truth *t)
{
    int dim = fmb_system_dim(t->s);
    if (fmb_box_size(box) != dim)
        return differ(g, "%d intervals", fmb_box_size(box));
    g->unjudged += t->end == NULL;
    for (int i = 0; i < dim; i++)
        if (fmb_box_var(box, i) != i ||
            !judge_end(g, box, i, FMB_LOWER, t->end ? &t->end[i][FMB_LOWER] : NULL) ||
            !judge_end(g, box, i, FMB_UPPER, t->end ? &t->end[i][FMB_UPPER] : NULL))
            return false;
    return true;
}

bool agree_bound(agree *g, fmb_solver *v, const truth *t)
{
    fmb_box *box = NULL;
    fmb_evidence *e = NULL;
    fmb_result r = {.size = sizeof r};
    bool good = judge_result(g, fmb_bound(v, t->s, NULL, 0, &box, &r), &r, t);
    if (good && r.stop == FMB_STOP_DONE) {
        good = (box != NULL) == (r.verdict == FMB_FEASIBLE) ||
               differ(g, "a box for an infeasible system, or none for a feasible one");
        good = good && judge_evidence(g, v, t->s, &r, &e);
        if (good && box)
            good = judge_box(g, box, t) && judge_claims(g, e, FMB_CLAIM_BOUND, FMB_CLAIM_UNBOUNDED,
                                                        2 * (size_t)fmb_system_dim(t->s));
    }
    fmb_evidence_free(e);
    fmb_box_free(box);
    return good;
}

bool agree_end(agree *g, fmb_solver *v, const truth *t, int var)
{
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    bool good = judge_result(g, fmb_bound(v, t->s, &var, 1, &box, &r), &r, t);
    fmb_evidence *e = NULL;
    if (good && box && r.stop == FMB_STOP_DONE) {
        study_textbook_end end[2];
        fmb_verdict known = FMB_UNKNOWN;
        mpq_inits(end[0].value, end[1].value, NULL);
        must(study_textbook_bound(t->s, var, g->max_rows, end, &known));
        g->unjudged += known != FMB_FEASIBLE;
        good = judge_evidence(g, v, t->s, &r, &e) &&
               judge_claims(g, e, FMB_CLAIM_BOUND, FMB_CLAIM_UNBOUNDED, 2);
        for (int side = 0; good && side < 2; side++)
            good = judge_end(g, box, 0, (fmb_side)side, known == FMB_FEASIBLE ? &end[side] : NULL);
        mpq_clears(end[0].value, end[1].value, NULL);
    }
    fmb_evidence_free(e);
    fmb_box_free(box);
    return good;
}
