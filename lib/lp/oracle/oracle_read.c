/* oracle_read.c: the answers of an oracle as rationals; see oracle.h. */
#include "lp/oracle/oracle_state.h"

#include "num/gcd.h"

static fmb_status set_ratio(const fmb_oracle *o, mpq_t to, const mpz_t num, const mpz_t den)
{
    const fmb_poll poll = fmb_run_asked(o->run);
    mpq_set_z(to, num);
    return fmb_long_divide(to, den, &poll);
}

/* Is q = num / den already? Two products are faster than a greatest common divisor. */
static bool is_ratio(const mpq_t q, const mpz_t num, const mpz_t den)
{
    if (mpz_sgn(num) == 0 || mpz_sgn(num) != mpq_sgn(q))
        return mpz_sgn(num) == mpq_sgn(q);
    mpz_t a, b;
    mpz_inits(a, b, NULL);
    mpz_mul(a, num, mpq_denref(q));
    mpz_mul(b, mpq_numref(q), den);
    bool is = mpz_cmp(a, b) == 0;
    mpz_clears(a, b, NULL);
    return is;
}

static fmb_status set_ratios(const fmb_oracle *o, mpq_t *x, mpz_t *num, const mpz_t den)
{
    for (size_t j = 0; j < o->n; j++)
        if (!is_ratio(x[j], num[j], den))
            FMB_TRY(set_ratio(o, x[j], num[j], den));
    return FMB_OK;
}

fmb_status fmb_oracle_point(const fmb_oracle *o, mpq_t *x)
{
    return set_ratios(o, x, o->point.z, o->point_den);
}

fmb_status fmb_oracle_ray(const fmb_oracle *o, mpq_t *x)
{
    return set_ratios(o, x, o->w.ray.z, o->w.ray_den);
}

void fmb_oracle_point_integers(const fmb_oracle *o, mpz_t *x, mpz_t den)
{
    for (size_t j = 0; j < o->n; j++)
        mpz_set(x[j], o->point.z[j]);
    mpz_set(den, o->point_den);
}

void fmb_oracle_ray_integers(const fmb_oracle *o, mpz_t *x)
{
    for (size_t j = 0; j < o->n; j++)
        mpz_set(x[j], o->w.ray.z[j]);
}

/* Add sign times the prices of the basis, over `unit`, as weights of its rows. */
static fmb_status add_prices(const fmb_oracle *o, const mpz_t unit, int sign, fmb_weights *w)
{
    const fmb_vertex *v = &o->v;
    fmb_status st = FMB_OK;
    mpq_t q;
    mpq_init(q);
    for (size_t r = 0; st == FMB_OK && r < v->n; r++) {
        if (mpz_sgn(v->y.z[r]) == 0)
            continue;
        st = set_ratio(o, q, v->y.z[r], unit);
        if (sign < 0)
            mpq_neg(q, q);
        FMB_THEN(st, fmb_weights_add(w, (uint32_t)v->basis[r], q, o->run->mem));
    }
    mpq_clear(q);
    return st;
}

static fmb_status add_interior_weights(const fmb_oracle *o, fmb_weights *w)
{
    for (size_t k = 0; k < o->interior_proof.size; k++)
        FMB_TRY(fmb_weights_add(w, o->interior_proof.index[k], o->interior_proof.value[k],
                                o->run->mem));
    return FMB_OK;
}

fmb_status fmb_oracle_multipliers(const fmb_oracle *o, fmb_weights *w)
{
    if (o->has_interior_proof)
        return add_interior_weights(o, w);
    mpz_t unit;
    mpz_init(unit);
    mpz_mul(unit, o->v.unit, o->cost_unit);
    fmb_status st = add_prices(o, unit, 1, w);
    mpz_clear(unit);
    return st;
}

/* sum_r y_r b_r, divided by the units of the prices and of the cost. */
fmb_status fmb_oracle_value(const fmb_oracle *o, mpq_t value)
{
    const fmb_vertex *v = &o->v;
    const fmb_poll poll = fmb_run_asked(o->run);
    fmb_status st = FMB_OK;
    mpz_t b;
    mpz_init(b);
    mpq_set_ui(value, 0, 1);
    for (size_t r = 0; st == FMB_OK && r < v->n; r++) {
        if (mpz_sgn(v->y.z[r]) == 0)
            continue;
        fmb_program_get(v->p, v->basis[r], v->p->row[v->basis[r]].size, b);
        mpz_addmul(mpq_numref(value), v->y.z[r], b);
        st = fmb_run_poll_long(o->run, mpq_numref(value));
    }
    mpz_mul(b, v->unit, o->cost_unit);
    FMB_THEN(st, fmb_long_divide(value, b, &poll));
    mpz_clear(b);
    return st;
}

/* sign a_odd - sum_r y_r a_r = 0, and the same combination of right sides is negative. */
fmb_status fmb_oracle_conflict(fmb_oracle *o, fmb_weights *w)
{
    mpq_t one;
    if (o->has_interior_proof)
        return add_interior_weights(o, w);
    FMB_TRY(fmb_pivot_walk_price_conflict(&o->w));
    mpq_init(one);
    mpq_set_si(one, o->w.sign, 1);
    fmb_status st = fmb_weights_add(w, (uint32_t)o->w.odd, one, o->run->mem);
    mpq_clear(one);
    return st == FMB_OK ? add_prices(o, o->v.unit, -1, w) : st;
}
