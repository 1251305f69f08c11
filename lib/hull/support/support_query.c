/* support_query.c: one query; see support.h.
 *
 * First the oracle guesses in doubles and makes the guess an exact vertex: mostly it is beyond the
 * facet already, and need not be optimal. Otherwise the optimum is computed, with its proof.
 */
#include "base/ways.h"
#include "hull/support/support_private.h"

/* ---- generators ------------------------------------------------------------------------------ */

static fmb_status note_inner_point(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    if (!s->proves)
        return FMB_OK;
    FMB_TRY(FMB_RESERVE(mem, &s->point, &s->point_capacity, s->points + 1));
    fmb_integers *x = &s->point[s->points];
    FMB_TRY(fmb_integers_init(x, s->n + 1, mem));
    s->points++;
    for (size_t j = 0; j < s->n; j++)
        mpz_set(x->z[j], s->seen.x.z[j]);
    mpz_set(x->z[s->n], s->seen.den);
    return fmb_integers_settle(x, mem);
}

/* Note the last generator of the hull, and the facets that it made or touched.
 */
static fmb_status note_near(fmb_support *s)
{
    fmb_support_near *near = &s->near;
    const fmb_facets *f = &s->hull;
    FMB_TRY(FMB_RESERVE(s->run->mem, &near->slot, &near->capacity, f->mades + f->toucheds));
    near->generator = f->generators - 1;
    near->slots = f->mades + f->toucheds;
    for (size_t k = 0; k < near->slots; k++)
        near->slot[k] = k < f->mades ? f->made[k] : f->touched[k - f->mades];
    return FMB_OK;
}

fmb_status fmb_support_take(fmb_support *s, size_t at)
{
    bool grown;
    mpz_set(s->g.z[0], s->seen.den);
    for (size_t j = 0; j < s->k; j++)
        mpz_set(s->g.z[j + 1], s->seen.x.z[s->kept[j]]);
    FMB_TRY(fmb_facets_add_near(&s->hull, at, s->g.z, &grown));
    if (!grown)
        return FMB_OK;
    FMB_TRY(note_near(s));
    FMB_TRY(note_inner_point(s));
    return fmb_support_take_images(s);
}

/* ---- a query --------------------------------------------------------------------------------- */

/* The form that a query maximizes: - sign (h1 x1 + ...). */
static fmb_status write_cost(const fmb_support *s, const fmb_vec *h, int sign, fmb_weights *cost,
                             fmb_mem *mem)
{
    fmb_status st = FMB_OK;
    mpq_t q;
    mpq_init(q);
    for (size_t j = 0; st == FMB_OK && j < s->k; j++) {
        fmb_vec_get_q(h, j + 1, q);
        if (sign > 0)
            mpq_neg(q, q);
        if (mpq_sgn(q) != 0)
            st = fmb_weights_add(cost, (uint32_t)s->kept[j], q, mem);
    }
    mpq_clear(q);
    return st;
}

/* Is the oracle's current point beyond h? */
static bool is_point_beyond(fmb_support *s, const fmb_vec *h, int sign)
{
    fmb_oracle_point_integers(s->oracle, s->seen.x.z, s->seen.den);
    fmb_vec_get(h, 0, s->t);
    mpz_mul(s->seen.den, s->seen.den, s->t);
    for (size_t j = 0; j < s->k; j++) {
        fmb_vec_get(h, j + 1, s->t);
        mpz_addmul(s->seen.den, s->seen.x.z[s->kept[j]], s->t);
    }
    return mpz_sgn(s->seen.den) * sign < 0;
}

/* The point is the optimum, and not beyond h: write the proved row. */
static fmb_status prove_row(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row)
{
    bool attained = true;
    FMB_TRY(row->rel == FMB_EQ ? FMB_OK : fmb_oracle_attain(s->oracle, &attained));
    if (sign > 0)
        FMB_TRY(fmb_support_write_row(s, h, row, s->run->mem));
    if (!attained)
        row->rel = FMB_LT;
    if (s->proves)
        FMB_TRY(fmb_oracle_multipliers(s->oracle, sign > 0 ? &row->proof : &row->reverse));
    return FMB_OK;
}

/* fmb_support_query, but s->seen is not added. */
static fmb_status look_at_form(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row,
                               bool *stands)
{
    fmb_weights cost = {0};
    fmb_oracle_end end;
    bool beyond = false;
    *stands = false;
    fmb_status st = write_cost(s, h, sign, &cost, s->run->mem);
    FMB_THEN(st, fmb_oracle_approach(s->oracle, &cost, &end));
    if (st == FMB_OK && end == FMB_ORACLE_OPTIMUM)
        beyond = is_point_beyond(s, h, sign);
    if (st == FMB_OK && end == FMB_ORACLE_OPTIMUM && !beyond) {
        st = fmb_oracle_climb(s->oracle, &end);
        beyond = st == FMB_OK && end == FMB_ORACLE_OPTIMUM && is_point_beyond(s, h, sign);
    }
    fmb_weights_clear(&cost, s->run->mem);
    if (st != FMB_OK)
        return st;
    *stands = end == FMB_ORACLE_OPTIMUM && !beyond;
    if (*stands)
        return prove_row(s, h, sign, row);
    if (end == FMB_ORACLE_OPTIMUM) {
        fmb_oracle_point_integers(s->oracle, s->seen.x.z, s->seen.den);
    } else {
        fmb_oracle_ray_integers(s->oracle, s->seen.x.z);
        mpz_set_ui(s->seen.den, 0);
    }
    return FMB_OK;
}

fmb_status fmb_support_query(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row,
                             bool *stands)
{
    FMB_TRY(look_at_form(s, h, sign, row, stands));
    return !*stands ? fmb_support_take(s, 0) : FMB_OK;
}

/* ---- facets ---------------------------------------------------------------------------------- */

/* Is the facet x0 >= 0, the face at infinity? */
static bool is_at_infinity(const fmb_support *s, const fmb_vec *normal)
{
    for (size_t j = 1; j <= s->k; j++)
        if (fmb_vec_sgn(normal, j) != 0)
            return false;
    return true;
}

static bool is_row_known(const fmb_support *s, const fmb_vec *normal)
{
    bool known = s->known && fmb_way(FMB_WAY_KNOWN) && fmb_support_is_known(s, normal);
    fmb_way_answered(FMB_WAY_KNOWN, known);
    return known;
}

fmb_status fmb_support_settle(fmb_support *s, const fmb_facet *a, fmb_support_row *row,
                              fmb_support_answer *answer)
{
    bool stands = false;
    *answer = FMB_SUPPORT_NO_ROW;
    if (is_at_infinity(s, &a->normal) || is_row_known(s, &a->normal))
        return FMB_OK;
    fmb_status st = look_at_form(s, &a->normal, 1, row, &stands);
    *answer = stands ? FMB_SUPPORT_ROW : FMB_SUPPORT_BEYOND;
    return st;
}
