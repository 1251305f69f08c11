/* contacts.c: see contacts.h.
 *
 * Frames that meet: their verdict is proved by a certificate (study/reference/proofs.h), their
 * depth by the facets of M. Frames that are apart: two points at one time, each in its frame by its
 * shares of the axes, or where these depend on each other by evidence that fmb_check accepts, show
 * that M comes as near as their difference; and no point of M is on the near side of the plane
 * through it, at right angles to it.
 */
#include "fmb-validate/contacts.h"

#include <math.h>
#include <stdlib.h>

#include <fmb/proximity.h>
#include <fmb/solve.h>

#include "fmb-validate/boundary.h"
#include "fmb-validate/watch.h"
#include "study/reference/equations.h"
#include "study/reference/proofs.h"

enum { MOST = VALIDATE_MOST_DIM };

struct validate_contacts {
    study_validation v;
    study_proofs *proofs;
    fmb_solver *solver, *prover;
    validate_difference m;
    validate_claim claim;
    mpq_t origin[MOST], axis[MOST * MOST], sum, part;
    mpz_t whole[MOST], scale, least, reach;
    study_equations shares;
};

/* ---- life ------------------------------------------------------------------------------------ */

static void for_each_of_claim(validate_claim *c, void (*what)(mpq_ptr))
{
    what(c->square);
    what(c->time);
    for (int j = 0; j < MOST; j++) {
        what(c->shift[j]);
        what(c->point[0][j]);
        what(c->point[1][j]);
    }
}

static void start_number(mpq_ptr x)
{
    mpq_init(x);
}

static void end_number(mpq_ptr x)
{
    mpq_clear(x);
}

void validate_claim_init(validate_claim *c)
{
    for_each_of_claim(c, start_number);
}

void validate_claim_clear(validate_claim *c)
{
    for_each_of_claim(c, end_number);
}

static void init_numbers(validate_contacts *b)
{
    validate_difference_init(&b->m);
    validate_claim_init(&b->claim);
    study_equations_init(&b->shares);
    for (int j = 0; j < MOST; j++) {
        mpq_init(b->origin[j]);
        mpz_init(b->whole[j]);
    }
    for (int i = 0; i < MOST * MOST; i++)
        mpq_init(b->axis[i]);
    mpq_inits(b->sum, b->part, NULL);
    mpz_inits(b->scale, b->least, b->reach, NULL);
}

fmb_status validate_contacts_open(const study_validation *v, validate_contacts **out)
{
    validate_contacts *b = calloc(1, sizeof *b);
    if (!b)
        return FMB_ERR_MEMORY;
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_ALL;
    b->v = *v;
    init_numbers(b);
    fmb_status st = study_proofs_open(v->plan.dim, &b->proofs);
    if (st == FMB_OK)
        st = fmb_solver_new(NULL, NULL, &b->solver);
    if (st == FMB_OK)
        st = fmb_solver_new(&o, NULL, &b->prover);
    if (st == FMB_OK)
        *out = b;
    else
        validate_contacts_close(b);
    return st;
}

void validate_contacts_close(validate_contacts *b)
{
    if (!b)
        return;
    fmb_solver_free(b->solver);
    fmb_solver_free(b->prover);
    study_proofs_close(b->proofs);
    validate_difference_clear(&b->m);
    validate_claim_clear(&b->claim);
    study_equations_clear(&b->shares);
    for (int j = 0; j < MOST; j++) {
        mpq_clear(b->origin[j]);
        mpz_clear(b->whole[j]);
    }
    for (int i = 0; i < MOST * MOST; i++)
        mpq_clear(b->axis[i]);
    mpq_clears(b->sum, b->part, NULL);
    mpz_clears(b->scale, b->least, b->reach, NULL);
    free(b);
}

/* ---- measures -------------------------------------------------------------------------------- */

/* Is the square that of the shift, and the length the double nearest to its root, or next to it? */
static bool is_measured(validate_contacts *b, const validate_claim *c)
{
    mpq_set_ui(b->sum, 0, 1);
    for (int j = 0; j < b->m.dim; j++) {
        mpq_mul(b->part, c->shift[j], c->shift[j]);
        mpq_add(b->sum, b->sum, b->part);
    }
    if (!mpq_equal(b->sum, c->square) || !isfinite(c->length) || c->length < 0)
        return false;
    mpq_set_d(b->part, fmax(nextafter(c->length, 0), 0));
    mpq_mul(b->part, b->part, b->part);
    bool good = mpq_cmp(b->part, c->square) <= 0;
    mpq_set_d(b->part, nextafter(c->length, INFINITY));
    mpq_mul(b->part, b->part, b->part);
    return good && mpq_cmp(b->part, c->square) >= 0;
}

/* x 2^-exponent */
static void scale_by_power(mpq_t out, mpq_srcptr x, int exponent)
{
    if (exponent >= 0)
        mpq_div_2exp(out, x, (mp_bitcnt_t)exponent);
    else
        mpq_mul_2exp(out, x, (mp_bitcnt_t)-exponent);
}

/* Does M reach, along sign times the shift, as far as the shift is long (sign 1), or no nearer to 0
 * than that (-1)? With y a whole multiple of the shift, y = scale shift: is the largest y.m the
 * same as sign y.shift? */
static bool reaches_shift(validate_contacts *b, const validate_claim *c, int sign)
{
    mpz_set_ui(b->scale, 1);
    for (int j = 0; j < b->m.dim; j++)
        mpz_lcm(b->scale, b->scale, mpq_denref(c->shift[j]));
    for (int j = 0; j < b->m.dim; j++) {
        mpz_divexact(b->whole[j], b->scale, mpq_denref(c->shift[j]));
        mpz_mul(b->whole[j], b->whole[j], mpq_numref(c->shift[j]));
        mpz_mul_2exp(b->whole[j], b->whole[j], (mp_bitcnt_t)b->m.finer[j]);
        mpz_mul_si(b->whole[j], b->whole[j], sign);
    }
    validate_ends(&b->m, b->whole, b->least, b->reach);
    mpq_set_z(b->sum, b->scale);
    mpq_mul(b->sum, b->sum, c->square);
    scale_by_power(b->sum, b->sum, b->m.unit);
    mpz_mul_si(b->reach, b->reach, sign);
    return mpq_cmp_z(b->sum, b->reach) == 0;
}

/* ---- frames that meet ------------------------------------------------------------------------ */

static fmb_status judge_depth(validate_contacts *b, const fmb_frame *f, const validate_claim *c,
                              bool *good)
{
    study_verdicts verdicts = {0};
    unsigned faults = 0;
    uint64_t solved = 0;
    const size_t index = 0;
    fmb_status st =
        study_proofs_run(b->proofs, 1, &f[0], &f[1], &index, &verdicts, &faults, &solved);
    *good = verdicts.proved[FMB_CONTACT_CLOSED] == FMB_FEASIBLE &&
            (mpq_sgn(c->square) == 0 || reaches_shift(b, c, 1));
    scale_by_power(b->sum, c->square, 2 * b->m.unit);
    *good = *good && validate_depth_is(&b->m, b->sum);
    return st;
}

/* ---- frames that are apart ------------------------------------------------------------------- */

/* Is the point that b->origin, the corner where frame k is then, reaches by shares of its axes one
 * of the frame? Only if these are independent, and span the space, *good says so. */
static bool has_shares(validate_contacts *b, const fmb_frame *f, const validate_claim *c, int k,
                       bool *good)
{
    int dim = f->dim;
    study_equations *e = &b->shares;
    if (f->naxes != dim)
        return false;
    for (int j = 0; j < dim; j++) {
        mpq_sub(b->part, c->point[k][j], b->origin[j]);
        scale_by_power(b->part, b->part, b->m.unit + b->m.finer[j]);
        for (int i = 0; i < dim; i++)
            mpz_mul(e->a[j][i], b->m.axis[k][i][j], mpq_denref(b->part));
        mpz_mul_si(e->x[j], mpq_numref(b->part), k == 0 ? 1 : -1);
    }
    if (!study_equations_factor(e, dim))
        return false;
    study_equations_solve(e);
    *good = true;
    mpz_set_ui(b->scale, 0);
    for (int i = 0; i < dim; i++) {
        *good &= mpz_sgn(e->x[i]) >= 0 && mpz_cmp(e->x[i], e->divisor) <= 0;
        mpz_add(b->scale, b->scale, e->x[i]);
    }
    *good &= f->shape == FMB_CUBOID || mpz_cmp(b->scale, e->divisor) <= 0;
    return true;
}

/* Is there evidence for a point of frame k, whose corner is b->origin? */
static fmb_status has_evidence(validate_contacts *b, const fmb_frame *f, const validate_claim *c,
                               int k, bool *good)
{
    mpq_t *x = (mpq_t *)c->point[k];
    fmb_system *rows = NULL;
    fmb_evidence *e = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_judgement j = {.size = sizeof j};
    for (int i = 0; i < f->naxes * f->dim; i++)
        mpq_set_d(b->axis[i], f->axes[i]);
    const fmb_frame_q both[2] = {{f->shape, f->dim, f->naxes, b->origin, b->axis, NULL},
                                 {FMB_CUBOID, f->dim, 0, x, NULL, NULL}};
    fmb_status st =
        fmb_system_from_frames_q(both, 2, FMB_COORDINATES_EACH, FMB_CONTACT_CLOSED, NULL, &rows);
    if (st == FMB_OK)
        st = fmb_solve(b->prover, rows, &res);
    if (st == FMB_OK && res.verdict == FMB_FEASIBLE)
        st = fmb_solver_evidence(b->prover, &e);
    if (st == FMB_OK && e)
        st = fmb_check(rows, e, &j);
    *good = j.accepted && j.verdict == FMB_FEASIBLE;
    fmb_evidence_free(e);
    fmb_system_free(rows);
    return st;
}

/* Is it a point of frame k at that time? */
static fmb_status is_point_of(validate_contacts *b, const fmb_frame *f, const validate_claim *c,
                              int k, bool *good)
{
    for (int i = 0; i < f->dim; i++) {
        mpq_set_d(b->origin[i], f->origin[i]);
        mpq_set_d(b->part, f->speed ? f->speed[i] : 0);
        mpq_mul(b->part, b->part, c->time);
        mpq_add(b->origin[i], b->origin[i], b->part);
    }
    return has_shares(b, f, c, k, good) ? FMB_OK : has_evidence(b, f, c, k, good);
}

static fmb_status judge_distance(validate_contacts *b, const fmb_frame *f, const validate_claim *c,
                                 bool *good)
{
    bool moves = f[0].speed || f[1].speed;
    *good = mpq_sgn(c->square) > 0 && reaches_shift(b, c, -1) && mpq_sgn(c->time) >= 0 &&
            mpq_cmp_ui(c->time, moves ? 1 : 0, 1) <= 0;
    for (int j = 0; j < f->dim; j++) {
        mpq_sub(b->part, c->point[0][j], c->point[1][j]);
        *good &= mpq_equal(b->part, c->shift[j]) != 0;
    }
    fmb_status st = FMB_OK;
    for (int k = 0; k < 2 && st == FMB_OK && *good; k++)
        st = is_point_of(b, &f[k], c, k, good);
    return st;
}

fmb_status validate_judge(validate_contacts *b, const fmb_frame *f, const validate_claim *c,
                          bool *good)
{
    validate_difference_load(&b->m, &f[0], &f[1]);
    *good = is_measured(b, c);
    return !*good ? FMB_OK : (c->deep ? judge_depth : judge_distance)(b, f, c, good);
}

/* ---- what the library says ------------------------------------------------------------------- */

static void read_claim(const fmb_proximity *p, bool deep, validate_claim *c)
{
    c->deep = deep;
    c->length = fmb_proximity_length(p);
    fmb_proximity_measure_q(p, c->square);
    fmb_proximity_time_q(p, c->time);
    for (int j = 0; j < fmb_proximity_dim(p); j++) {
        fmb_proximity_shift_q(p, j, c->shift[j]);
        for (int k = 0; k < 2; k++)
            fmb_proximity_point_q(p, k, j, c->point[k][j]);
    }
}

fmb_status validate_claim_ask(fmb_solver *v, const fmb_frame *f, validate_claim *c, bool *said)
{
    fmb_proximity *p = NULL;
    fmb_result res = {.size = sizeof res};
    fmb_status st = fmb_depth(v, f, FMB_NORM_EUCLIDEAN, &p, &res);
    bool deep = res.verdict == FMB_FEASIBLE;
    if (st == FMB_OK && !deep)
        st = fmb_distance(v, f, FMB_NORM_EUCLIDEAN, &p, &res);
    *said = st == FMB_OK && p && res.verdict == (deep ? FMB_FEASIBLE : FMB_INFEASIBLE);
    if (*said)
        read_claim(p, deep, c);
    fmb_proximity_free(p);
    return st;
}

/* ---- many pairs ------------------------------------------------------------------------------ */

static fmb_status add_fault(uint64_t k, study_tally *tally, study_findings *found, size_t from)
{
    study_finding *f = NULL;
    for (size_t i = from; i < found->n; i++)
        f = found->item[i].k == k ? &found->item[i] : f;
    if (!f) {
        fmb_status st = study_findings_add(found, &(study_finding){.k = k});
        if (st != FMB_OK)
            return st;
        f = &found->item[found->n - 1];
        tally->disagreeing++;
    }
    f->faults |= STUDY_FAULT_NEAR;
    for (int i = 0; i < STUDY_FAULTS; i++)
        tally->fault[i] += STUDY_FAULT_NEAR >> i & 1;
    return FMB_OK;
}

fmb_status validate_contacts_run(validate_contacts *b, uint64_t first, size_t n, study_tally *tally,
                                 study_findings *found, size_t from)
{
    fmb_status st = FMB_OK;
    study_pair pair;
    for (uint64_t k = first; k < first + n && st == FMB_OK && !validate_watch_interrupted(); k++) {
        bool good = false;
        study_pair_draw(&b->v.plan, b->v.seed, k, &pair);
        const fmb_frame f[2] = {k % 2 ? pair.q : pair.p, k % 2 ? pair.p : pair.q};
        st = validate_claim_ask(b->solver, f, &b->claim, &good);
        if (st == FMB_OK && good)
            st = validate_judge(b, f, &b->claim, &good);
        if (st == FMB_OK && !good)
            st = add_fault(k, tally, found, from);
    }
    tally->contacts += n;
    tally->contacts_open += 2 * n;
    return st;
}
