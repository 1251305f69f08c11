/* strict_interior.c: strict rows, by the widest margin.
 *
 * With one more column t, rows a.x < b become a.x + w t <= b, w > 0, and t <= 1. The largest t is
 * positive if and only if some x satisfies all strict rows; if it is not, its multipliers y combine
 * the rows to t <= 0: then sum y_i a_i = 0, the w y of strict rows add up to 1, and sum y_i b_i <=
 * 0, a conflict.
 *
 * On the face of an optimum there is one more row, -C.x <= -V, with multiplier mu. Then sum y_i a_i
 * = mu C and sum y_i b_i <= mu V. mu > 0, as the y alone would be a conflict of rows that have a
 * solution; so y / mu proves C.x < V, where C.x <= V is known to be best possible.
 */
#include "lp/oracle/oracle_state.h"

#include <limits.h>

#include "num/gcd.h"

/* Any positive coefficients of t are valid: if columns are scaled, those in proportion to the sizes
 * of the rows, or a row with a margin of 2^-1000 would determine t. */
static fmb_status load_widened_rows(fmb_oracle *o, fmb_program *q)
{
    const fmb_program *p = o->p;
    int *size, least = INT_MAX;
    FMB_TRY(FMB_GET_ZERO(o->run->mem, size, p->m));
    if (o->backend)
        fmb_backend_sizes(o->backend, size);
    for (size_t i = 0; i < p->m; i++)
        least = p->row[i].rel == FMB_LT && size[i] < least ? size[i] : least;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < p->m; i++)
        st = fmb_program_add_interior_row(q, p, i, size[i] > least ? size[i] - least : 0);
    fmb_mem_put(o->run->mem, size, p->m, sizeof *size);
    return st;
}

/* Load the rows, the face's row if any, and t <= 1. */
static fmb_status load_interior_rows(fmb_oracle *o, bool face, fmb_program *q)
{
    fmb_integers z;
    fmb_status st = fmb_integers_init(&z, o->n + 2, o->run->mem);
    FMB_THEN(st, load_widened_rows(o, q));
    if (st == FMB_OK && face) {
        mpq_t value;
        mpq_init(value);
        st = fmb_oracle_value(o, value);
        mpz_set(z.z[o->n + 1], mpq_numref(value));
        mpz_mul(z.z[o->n + 1], z.z[o->n + 1], o->cost_unit);
        mpz_neg(z.z[o->n + 1], z.z[o->n + 1]);
        for (size_t j = 0; j < o->n; j++) {
            mpz_mul(z.z[j], o->cost.z[j], mpq_denref(value));
            mpz_neg(z.z[j], z.z[j]);
        }
        FMB_THEN(st, fmb_program_add_integers(q, z.z, FMB_LE));
        mpq_clear(value);
    }
    for (size_t j = 0; j < z.size; j++)
        mpz_set_ui(z.z[j], j >= o->n);
    FMB_THEN(st, fmb_program_add_integers(q, z.z, FMB_LE));
    fmb_integers_clear(&z, o->run->mem);
    return st;
}

/* The multipliers of the given rows; for a face, divided by mu times the denominator by which its
 * row was multiplied, and by the unit of the cost. */
static fmb_status take_interior_weights(fmb_oracle *o, const fmb_oracle *t, bool face)
{
    fmb_weights w = {0};
    mpq_t scale, value;
    mpq_inits(scale, value, NULL);
    mpq_set_ui(scale, 1, 1);
    const fmb_poll poll = fmb_run_asked(o->run);
    fmb_status st = fmb_oracle_multipliers(t, &w);
    for (size_t k = 0; st == FMB_OK && face && k < w.size; k++)
        if (w.index[k] == o->p->m) {
            st = fmb_oracle_value(o, value);
            mpz_mul(mpq_denref(value), mpq_numref(w.value[k]), mpq_denref(value));
            mpz_mul(mpq_denref(value), mpq_denref(value), o->cost_unit);
            mpq_set_z(scale, mpq_denref(w.value[k]));
            FMB_THEN(st, fmb_long_divide(scale, mpq_denref(value), &poll));
        }
    fmb_weights_clear(&o->interior_proof, o->run->mem);
    for (size_t k = 0; st == FMB_OK && k < w.size; k++) {
        mpq_mul(value, w.value[k], scale);
        if (w.index[k] < o->p->m)
            st = fmb_weights_add(&o->interior_proof, w.index[k], value, o->run->mem);
    }
    o->has_interior_proof = true;
    fmb_weights_clear(&w, o->run->mem);
    mpq_clears(scale, value, NULL);
    return st;
}

static fmb_status take_inner_point(fmb_oracle *o, const fmb_oracle *t)
{
    for (size_t j = 0; j < o->n; j++)
        mpz_set(o->point.z[j], t->point.z[j]);
    mpz_set(o->point_den, t->point_den);
    return fmb_integers_settle(&o->point, o->run->mem);
}

/* Maximize t, unless the first point found has a positive one. */
static fmb_status widen_interior(fmb_oracle *o, fmb_oracle *t, bool face, bool *room)
{
    fmb_weights cost = {0};
    fmb_pivot_walk_end end;
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    fmb_status st = fmb_weights_add(&cost, (uint32_t)o->n, one, o->run->mem);
    FMB_THEN(st, fmb_closure_approach(t, &cost, &end));
    if (st == FMB_OK && mpz_sgn(t->point.z[o->n]) <= 0)
        st = fmb_closure_climb(t, &end);
    if (st == FMB_OK) {
        *room = mpz_sgn(t->point.z[o->n]) > 0;
        st = *room ? take_inner_point(o, t) : take_interior_weights(o, t, face);
    }
    fmb_weights_clear(&cost, o->run->mem);
    mpq_clear(one);
    return st;
}

fmb_status fmb_oracle_find_strict_interior(fmb_oracle *o, bool face, bool *room)
{
    fmb_program q;
    fmb_oracle *t = NULL;
    fmb_program_init(&q, o->run->mem, (int)o->n + 1);
    fmb_status st = load_interior_rows(o, face, &q);
    FMB_THEN(st, fmb_oracle_new(o->run, &q, &t));
    FMB_THEN(st, widen_interior(o, t, face, room));
    fmb_oracle_free(t);
    fmb_program_clear(&q);
    return st;
}
