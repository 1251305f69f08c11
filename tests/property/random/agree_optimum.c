/* agree_optimum.c: optima against the ground truth: the end of a variable that is the form. See
 * agree.h. */
#include "agree_inside.h"

/* ---- forms ----------------------------------------------------------------------------------- */

/* A form over at most 64 variables; choice decides on everything. */
typedef struct form {
    mpq_t coef[64], constant;
    int var[64], dim;
    fmb_sense sense;
    bool doubles; /* all its numbers are, too */
} form;

/* splitmix64, from lo to hi. */
static long between(uint64_t *seed, long lo, long hi)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return lo + (long)((z ^ z >> 31) % (uint64_t)(hi - lo + 1));
}

/* Small integers, zeros among them; or fractions; now and then a large one. */
static void form_number(uint64_t *seed, bool fractions, mpq_t q)
{
    long large = between(seed, 0, 30) == 0 ? 1000000007 : 1;
    mpq_set_si(q, large * between(seed, -3, 3), 1);
    if (fractions)
        mpq_set_si(q, between(seed, -30, 30), (unsigned long)between(seed, 1, 7));
    mpq_canonicalize(q);
}

static void form_init(form *f, int dim, uint64_t choice)
{
    uint64_t seed = choice * 31 + 5;
    f->dim = dim;
    f->sense = between(&seed, 0, 1) ? FMB_SENSE_MAX : FMB_SENSE_MIN;
    f->doubles = between(&seed, 0, 1);
    for (int j = 0; j < dim; j++) {
        f->var[j] = j;
        mpq_init(f->coef[j]);
        if (between(&seed, 0, 4) > 0)
            form_number(&seed, !f->doubles, f->coef[j]);
    }
    mpq_init(f->constant);
    if (between(&seed, 0, 1))
        form_number(&seed, !f->doubles, f->constant);
}

static void form_clear(form *f)
{
    for (int j = 0; j < f->dim; j++)
        mpq_clear(f->coef[j]);
    mpq_clear(f->constant);
}

/* Give s the form. */
static void form_set(form *f, fmb_system *s)
{
    fmb_objective_q o = {f->sense, (size_t)f->dim, f->var, f->coef, f->constant};
    must(fmb_system_set_objective_q(s, &o));
}

/* As doubles, as rationals, or as what the system carries: all the same. */
static fmb_status ask_form(form *f, fmb_solver *v, const fmb_system *s, uint64_t choice,
                           fmb_optimum **out, fmb_result *r)
{
    fmb_objective_q o = {f->sense, (size_t)f->dim, f->var, f->coef, f->constant};
    if (f->doubles) {
        double coef[64];
        for (int j = 0; j < f->dim; j++)
            coef[j] = mpq_get_d(f->coef[j]);
        return fmb_optimize(v, s, &(fmb_objective){f->sense, coef, mpq_get_d(f->constant)}, out, r);
    }
    if (choice & 1)
        return fmb_optimize_q(v, s, &o, out, r);
    fmb_system *t = NULL;
    must(fmb_system_copy(s, &t));
    form_set(f, t);
    fmb_status st = fmb_optimize(v, t, NULL, out, r);
    fmb_system_free(t);
    return st;
}

/* form(x), of a direction without the constant; sum is initialised. */
static void form_value(const form *f, const fmb_optimum *o, bool ray, mpq_t sum)
{
    mpq_t q;
    mpq_init(q);
    if (ray)
        mpq_set_ui(sum, 0, 1);
    else
        mpq_set(sum, f->constant);
    for (int j = 0; j < f->dim; j++) {
        if (ray)
            fmb_optimum_ray_q(o, j, q);
        else
            fmb_optimum_coordinate_q(o, j, q);
        mpq_mul(q, q, f->coef[j]);
        mpq_add(sum, sum, q);
    }
    mpq_clear(q);
}

/* ---- the truth ------------------------------------------------------------------------------- */

/* [give] s, and a variable behind all others that is the form. */
static fmb_system *with_form_as_variable(const fmb_system *s, form *f)
{
    fmb_system *t = NULL;
    int z = 0, var[65];
    mpq_t coef[65], rhs;
    must(fmb_system_copy(s, &t));
    must(fmb_system_add_variable(t, NULL, &z));
    mpq_init(rhs);
    mpq_neg(rhs, f->constant);
    for (int j = 0; j <= f->dim; j++) {
        var[j] = j < f->dim ? j : z;
        mpq_init(coef[j]);
        if (j < f->dim)
            mpq_set(coef[j], f->coef[j]);
        else
            mpq_set_si(coef[j], -1, 1);
    }
    must(fmb_system_add_q(t, (size_t)f->dim + 1, var, coef, FMB_EQ, rhs));
    for (int j = 0; j <= f->dim; j++)
        mpq_clear(coef[j]);
    mpq_clear(rhs);
    return t;
}

static bool judge_value(agree *g, const fmb_optimum *o, const fmb_end *end,
                        const study_textbook_end *known)
{
    bool good = true;
    mpq_t q;
    mpq_init(q);
    if (fmb_optimum_value_q(o, q) != (end->kind == FMB_END_FINITE))
        good = differ(g, "the optimum: finite or not?");
    else if (end->kind != known->kind)
        good = differ(g, "the optimum: kind %d, truth %d", (int)end->kind, (int)known->kind);
    else if (end->kind == FMB_END_FINITE && !mpq_equal(q, known->value))
        good = differ(g, "the optimum: about %g, truth %g", mpq_get_d(q), mpq_get_d(known->value));
    else if (end->attained != (known->kind == FMB_END_FINITE && known->attained))
        good = differ(g, "the optimum: attained or not?");
    mpq_clear(q);
    return good;
}

/* ---- point and ray --------------------------------------------------------------------------- */

/* Does row i hold for the point, strictly only where that is asked? Or for the ray? */
static bool keeps_row(const fmb_system *s, size_t i, const fmb_optimum *o, bool ray, bool strictly)
{
    mpq_t sum, coef, x;
    mpq_inits(sum, coef, x, NULL);
    if (!ray) {
        fmb_system_rhs_q(s, i, sum);
        mpq_neg(sum, sum);
    }
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int j = fmb_system_term_q(s, i, k, coef);
        if (ray)
            fmb_optimum_ray_q(o, j, x);
        else
            fmb_optimum_coordinate_q(o, j, x);
        mpq_mul(x, x, coef);
        mpq_add(sum, sum, x);
    }
    int sign = mpq_sgn(sum);
    mpq_clears(sum, coef, x, NULL);
    fmb_rel rel = fmb_system_rel(s, i);
    return rel == FMB_EQ ? sign == 0 : rel == FMB_LT && strictly ? sign < 0 : sign <= 0;
}

static bool judge_point_and_ray(agree *g, const fmb_system *s, const form *f, const fmb_optimum *o)
{
    fmb_end end = fmb_optimum_end(o);
    bool endless = end.kind == FMB_END_INFINITE, strictly = endless || end.attained, good = true;
    int up = f->sense == FMB_SENSE_MAX ? 1 : -1;
    mpq_t value, at;
    mpq_inits(value, at, NULL);
    for (size_t i = 0; good && i < fmb_system_rows(s); i++) {
        if (!keeps_row(s, i, o, false, strictly))
            good = differ(g, "the point of the optimum violates row %zu", i + 1);
        else if (endless && !keeps_row(s, i, o, true, false))
            good = differ(g, "the ray of the optimum leaves row %zu", i + 1);
    }
    form_value(f, o, endless, at);
    if (good && endless && mpq_sgn(at) != up)
        good = differ(g, "the ray does not make the form better");
    if (good && !endless && (!fmb_optimum_value_q(o, value) || !mpq_equal(value, at)))
        good = differ(g, "the point is not at the optimum");
    mpq_clears(value, at, NULL);
    return good;
}

/* ---- all ------------------------------------------------------------------------------------- */

/* The claims are about this form. */
static bool judge_demand(agree *g, const fmb_system *s, form *f, const fmb_evidence *e)
{
    fmb_system *t = NULL;
    bool meets = false;
    char why[160];
    must(fmb_system_copy(s, &t));
    form_set(f, t);
    must(fmb_evidence_meets(e, s, FMB_DEMAND_OPTIMUM, t, &meets, why, sizeof why));
    fmb_system_free(t);
    return meets || differ(g, "evidence: %s", why);
}

static bool judge_optimum(agree *g, const truth *t, form *f, const fmb_optimum *o)
{
    fmb_end end = fmb_optimum_end(o);
    fmb_system *wide = with_form_as_variable(t->s, f);
    study_textbook_end known[2];
    fmb_verdict verdict = FMB_UNKNOWN;
    mpq_inits(known[0].value, known[1].value, NULL);
    must(study_textbook_bound(wide, fmb_system_dim(t->s), g->max_rows, known, &verdict));
    g->unjudged += verdict != FMB_FEASIBLE;
    bool good = verdict != FMB_FEASIBLE ||
                judge_value(g, o, &end, &known[f->sense == FMB_SENSE_MAX ? 1 : 0]);
    mpq_clears(known[0].value, known[1].value, NULL);
    fmb_system_free(wide);
    if (fmb_optimum_sense(o) != f->sense)
        return differ(g, "the optimum goes the other way");
    return good && judge_point_and_ray(g, t->s, f, o);
}

bool agree_optimize(agree *g, fmb_solver *v, const truth *t, uint64_t choice)
{
    form f;
    fmb_optimum *o = NULL;
    fmb_evidence *e = NULL;
    fmb_result r = {.size = sizeof r};
    form_init(&f, fmb_system_dim(t->s), choice);
    bool good = judge_result(g, ask_form(&f, v, t->s, choice, &o, &r), &r, t);
    if (good && r.stop == FMB_STOP_DONE) {
        good = (o != NULL) == (r.verdict == FMB_FEASIBLE) ||
               differ(g, "an optimum for an infeasible system, or none for a feasible one");
        good = good && judge_evidence(g, v, t->s, &r, &e) && judge_demand(g, t->s, &f, e);
        if (good && o)
            good = judge_claims(g, e, FMB_CLAIM_BOUND, FMB_CLAIM_UNBOUNDED, 1) &&
                   judge_optimum(g, t, &f, o);
    }
    fmb_evidence_free(e);
    fmb_optimum_free(o);
    form_clear(&f);
    return good;
}
