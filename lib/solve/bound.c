/* bound.c: the tightest interval of each variable.
 *
 * Each end is a linear program in the variable's own part, from the dictionary of the end before.
 * With method fm the part's other variables are eliminated instead, and the rows that remain are
 * the ends.
 */
#include "elim/derive.h"
#include "elim/witness.h"
#include "solve/box.h"
#include "solve/solver.h"

/* One end being worked on: variable, side, sign 1 for the upper end, and where the answer goes. */
typedef struct job {
    fmb_query *q;
    const fmb_part *p;
    int var, column;
    fmb_side side;
    int sign;
    fmb_exact_side *end;
} job;

/* ---- claims ---------------------------------------------------------------------------------- */

/* w proves the end; the query's x is a point at it. */
static fmb_status claim_bound(job *j, const fmb_weights *w)
{
    fmb_query *q = j->q;
    fmb_claim *claim;
    fmb_status st = fmb_evidence_claim(q->evidence, FMB_CLAIM_BOUND, &claim);
    if (st != FMB_OK)
        return st;
    claim->var = j->var;
    claim->side = j->side;
    claim->rel = j->end->attained ? FMB_LE : FMB_LT;
    mpq_set(claim->value, j->end->value);
    st = fmb_query_push(q, j->p, w, SIZE_MAX, 1, &claim->multipliers);
    if (st == FMB_OK)
        st = fmb_query_attach_point(q, claim, j->p, j->q->x);
    if (st != FMB_OK)
        fmb_evidence_drop_last(q->evidence);
    return st;
}

/* The query's x is a ray of the part, or the variable is in no part. */
static fmb_status claim_unbounded(job *j)
{
    fmb_claim *claim;
    if (!j->q->evidence)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(j->q->evidence, FMB_CLAIM_UNBOUNDED, &claim);
    if (st != FMB_OK)
        return st;
    claim->var = j->var;
    claim->side = j->side;
    st = fmb_evidence_vector(j->q->evidence, &claim->ray);
    if (st != FMB_OK)
        fmb_evidence_drop_last(j->q->evidence);
    else if (j->p)
        fmb_query_scatter(j->p, j->q->x, claim->ray);
    else
        mpq_set_si(claim->ray[j->var], j->sign, 1);
    return st;
}

/* ---- by the oracle --------------------------------------------------------------------------- */

static fmb_status finish_optimum(job *j, const fmb_lp *lp)
{
    int step;
    fmb_weights w = {0};
    fmb_lp_value(lp, j->end->value, &step);
    j->end->attained = step == 0;
    fmb_status st = FMB_OK;
    if (j->q->evidence) {
        st = fmb_lp_optimum(lp, j->sign, &w);
        if (st == FMB_OK)
            st = fmb_lp_point(lp, !j->end->attained, j->q->x);
        if (st == FMB_OK)
            st = claim_bound(j, &w);
    }
    fmb_weights_clear(&w, j->q->run.mem);
    if (st == FMB_OK)
        j->end->kind = FMB_END_FINITE;
    return st;
}

static fmb_status ask_oracle(job *j, int part)
{
    fmb_lp *lp;
    fmb_lp_end end;
    fmb_status st = fmb_query_oracle(j->q, part, &lp);
    if (st == FMB_OK)
        st = fmb_lp_extreme(lp, j->column, j->sign, &end);
    if (st != FMB_OK)
        return st;
    if (end == FMB_LP_OPTIMUM)
        return finish_optimum(j, lp);
    if (j->q->evidence)
        fmb_lp_ray(lp, j->q->x);
    st = claim_unbounded(j);
    if (st == FMB_OK)
        j->end->kind = FMB_END_INFINITE;
    return st;
}

/* ---- by elimination -------------------------------------------------------------------------- */

/* The live row that is tightest on this side, its bound in value; FMB_NO_ROW if none bounds it. A
 * row that is an equality bounds both sides. Of equal bounds a strict one counts. */
static uint32_t tightest(const job *j, const fmb_elim *e, mpq_t value)
{
    uint32_t best = FMB_NO_ROW;
    mpq_t t, a;
    mpq_inits(t, a, NULL);
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        int s = fmb_vec_sgn(&r->v, (size_t)j->column);
        if (s == 0 || (!r->equality && s != j->sign))
            continue;
        fmb_vec_get(&r->v, (size_t)e->n, mpq_numref(t));
        mpz_set_ui(mpq_denref(t), 1);
        fmb_vec_get(&r->v, (size_t)j->column, mpq_numref(a));
        mpz_set_ui(mpq_denref(a), 1);
        mpq_div(t, t, a);
        int order = best == FMB_NO_ROW ? -1 : mpq_cmp(t, value) * j->sign;
        if (order < 0 || (order == 0 && r->strict && !e->row[best].strict)) {
            best = e->live.row[i];
            mpq_set(value, t);
        }
    }
    mpq_clears(t, a, NULL);
    return best;
}

/* sign x_var <= sign value is the row divided by |its coefficient|; an equality may be turned
 * round. */
static fmb_status claim_row(job *j, const fmb_elim *e, uint32_t row)
{
    const fmb_derived *r = &e->row[row];
    fmb_weights w = {0};
    mpq_t t;
    mpq_init(t);
    mpz_set_si(mpq_numref(t), j->sign);
    fmb_vec_get(&r->v, (size_t)j->column, mpq_denref(t));
    mpq_canonicalize(t);
    fmb_status st = fmb_weights_add(&w, row, t, j->q->run.mem);
    if (st == FMB_OK)
        st = fmb_elim_derive(e, &w);
    if (st == FMB_OK) {
        mpq_set(j->q->x[j->column], j->end->value);
        st = fmb_elim_point(e, j->end->attained ? FMB_POINT_INSIDE : FMB_POINT_CLOSURE, j->q->x);
    }
    if (st == FMB_OK)
        st = claim_bound(j, &w);
    fmb_weights_clear(&w, j->q->run.mem);
    mpq_clear(t);
    return st;
}

static fmb_status read_end(job *j, const fmb_elim *e)
{
    fmb_status st = FMB_OK;
    uint32_t row = tightest(j, e, j->end->value);
    if (row != FMB_NO_ROW) {
        j->end->attained = !e->row[row].strict;
        st = j->q->evidence ? claim_row(j, e, row) : FMB_OK;
    } else if (j->q->evidence) {
        mpq_set_si(j->q->x[j->column], j->sign, 1);
        st = fmb_elim_point(e, FMB_POINT_RAY, j->q->x);
        if (st == FMB_OK)
            st = claim_unbounded(j);
    }
    if (st == FMB_OK)
        j->end->kind = row != FMB_NO_ROW ? FMB_END_FINITE : FMB_END_INFINITE;
    return st;
}

static fmb_status eliminate_others(const job *j, fmb_elim *e)
{
    fmb_query *q = j->q;
    bool *drop = fmb_arena_get(&q->v->arena, (size_t)j->p->n, sizeof *drop);
    if (!drop)
        return fmb_mem_status(q->run.mem);
    for (int i = 0; i < j->p->n; i++)
        drop[i] = i != j->column;
    fmb_status st = fmb_query_load(q, j->p, true, e);
    return st == FMB_OK ? fmb_elim_eliminate(e, drop) : st;
}

/* ---- both ends of one variable --------------------------------------------------------------- */

static fmb_status bound_variable(fmb_query *q, int var, fmb_exact_side *side)
{
    int part = q->parts.of_var[var];
    job j = {.q = q, .var = var};
    fmb_elim e = {.run = &q->run};
    bool fm = part >= 0 && fmb_query_eliminates(q);
    fmb_status st = FMB_OK;
    if (part >= 0) {
        j.p = &q->parts.part[part];
        j.column = q->parts.place[var];
    }
    if (fm)
        st = eliminate_others(&j, &e);
    for (int k = FMB_LOWER; st == FMB_OK && k <= FMB_UPPER; k++) {
        j.side = (fmb_side)k;
        j.sign = k == FMB_LOWER ? -1 : 1;
        j.end = &side[k];
        if (part >= 0) {
            st = fm ? read_end(&j, &e) : ask_oracle(&j, part);
        } else {
            st = claim_unbounded(&j);
            j.end->kind = st == FMB_OK ? FMB_END_INFINITE : FMB_END_UNKNOWN;
        }
    }
    if (fm)
        fmb_elim_clear(&e);
    return st;
}

static fmb_status bound_all(fmb_query *q, fmb_box *box)
{
    fmb_status st = FMB_OK;
    for (int i = 0; st == FMB_OK && i < box->size; i++)
        st = bound_variable(q, box->var[i], box->side[i]);
    return st;
}

static bool are_variables(const fmb_system *s, const int *vars, int n)
{
    bool good = n >= 0;
    for (int i = 0; vars && i < n; i++)
        good = good && vars[i] >= 0 && vars[i] < fmb_system_dim(s);
    return good;
}

fmb_status fmb_bound(fmb_solver *v, const fmb_system *s, const int *vars, int n, fmb_box **out,
                     fmb_result *res)
{
    fmb_query q;
    fmb_box *box = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    if (!out || !are_variables(s, vars, n))
        return FMB_ERR_ARG;
    fmb_status st = fmb_query_begin(&q, v, s, "bound");
    if (st == FMB_OK)
        st = fmb_query_decide(&q, !fmb_query_eliminates(&q), &verdict);
    if (st == FMB_OK && verdict == FMB_FEASIBLE) {
        st = fmb_box_new(vars, vars ? n : fmb_system_dim(s), &v->mem.alloc, &box);
        if (st == FMB_OK)
            st = bound_all(&q, box);
    }
    st = fmb_query_end(&q, st, verdict, res);
    if (st == FMB_OK)
        *out = box;
    else
        fmb_box_free(box);
    return st;
}
