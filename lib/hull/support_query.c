/* support_query.c: one query; see support.h.
 *
 * First a guess in doubles, made a vertex exactly: mostly it is beyond the facet already, and how
 * far the optimum is does not matter. Only where it is not the optimum is wanted, and its proof.
 */
#include "hull/support_inside.h"

/* ---- generators ------------------------------------------------------------------------------ */

/* The kept coordinates of s->x after x0, which is first. */
static fmb_status add_shadow(fmb_support *s, const mpz_t first, bool *grown)
{
    mpz_set(s->g.z[0], first);
    for (size_t j = 0; j < s->k; j++)
        mpz_set(s->g.z[j + 1], s->x.z[s->kept[j]]);
    return fmb_facets_add(&s->hull, s->g.z, grown);
}

/* A point of the closure need not be a solution where rows are strict. */
static fmb_status note_inner_point(fmb_support *s)
{
    fmb_mem *mem = s->run->mem;
    if (!s->proves || s->strict)
        return FMB_OK;
    fmb_status st = fmb_mem_reserve(mem, (void **)&s->point, &s->point_capacity, s->points + 1,
                                    sizeof *s->point);
    if (st != FMB_OK)
        return st;
    fmb_integers *x = &s->point[s->points++];
    st = fmb_integers_init(x, s->n + 1, mem);
    for (size_t j = 0; st == FMB_OK && j < s->n; j++)
        mpz_set(x->z[j], s->x.z[j]);
    if (st != FMB_OK)
        return st;
    mpz_set(x->z[s->n], s->den);
    return fmb_integers_settle(x, mem);
}

fmb_status fmb_support_add_point(fmb_support *s)
{
    bool grown;
    fmb_oracle_point_integers(s->oracle, s->x.z, s->den);
    fmb_status st = add_shadow(s, s->den, &grown);
    return st == FMB_OK && grown ? note_inner_point(s) : st;
}

static fmb_status add_ray(fmb_support *s)
{
    bool grown;
    fmb_oracle_ray_integers(s->oracle, s->x.z);
    mpz_set_ui(s->den, 0);
    return add_shadow(s, s->den, &grown);
}

/* ---- queries --------------------------------------------------------------------------------- */

/* The form that a query makes large: - sign (h1 x1 + ...). */
static fmb_status write_cost(fmb_support *s, const fmb_vec *h, int sign, fmb_weights *cost)
{
    fmb_status st = FMB_OK;
    mpq_t q;
    mpq_init(q);
    for (size_t j = 0; st == FMB_OK && j < s->k; j++) {
        fmb_vec_get_q(h, j + 1, q);
        if (sign > 0)
            mpq_neg(q, q);
        if (mpq_sgn(q) != 0)
            st = fmb_weights_add(cost, (uint32_t)s->kept[j], q, s->run->mem);
    }
    mpq_clear(q);
    return st;
}

/* Is the point at which the oracle stands beyond h? */
static bool is_point_beyond(fmb_support *s, const fmb_vec *h, int sign)
{
    fmb_oracle_point_integers(s->oracle, s->x.z, s->den);
    fmb_vec_get(h, 0, s->t);
    mpz_mul(s->den, s->den, s->t);
    for (size_t j = 0; j < s->k; j++) {
        fmb_vec_get(h, j + 1, s->t);
        mpz_addmul(s->den, s->x.z[s->kept[j]], s->t);
    }
    return mpz_sgn(s->den) * sign < 0;
}

/* It is the optimum, and not beyond h. */
static fmb_status prove_row(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row)
{
    bool attained = true;
    fmb_status st = row->rel == FMB_EQ ? FMB_OK : fmb_oracle_attain(s->oracle, &attained);
    if (st == FMB_OK && sign > 0)
        st = fmb_support_write_row(s, h, row);
    if (st == FMB_OK && !attained)
        row->rel = FMB_LT;
    if (st == FMB_OK && s->proves)
        st = fmb_oracle_multipliers(s->oracle, sign > 0 ? &row->proof : &row->reverse);
    return st;
}

fmb_status fmb_support_query(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row,
                             bool *stands)
{
    fmb_weights cost = {0};
    fmb_oracle_end end;
    bool beyond = false;
    *stands = false;
    fmb_status st = write_cost(s, h, sign, &cost);
    if (st == FMB_OK)
        st = fmb_oracle_approach(s->oracle, &cost, &end);
    if (st == FMB_OK && end == FMB_ORACLE_OPTIMUM)
        beyond = is_point_beyond(s, h, sign);
    if (st == FMB_OK && end == FMB_ORACLE_OPTIMUM && !beyond) {
        st = fmb_oracle_climb(s->oracle, &end);
        beyond = st == FMB_OK && end == FMB_ORACLE_OPTIMUM && is_point_beyond(s, h, sign);
    }
    fmb_weights_clear(&cost, s->run->mem);
    if (st != FMB_OK)
        return st;
    if (end == FMB_ORACLE_UNBOUNDED)
        return add_ray(s);
    if (beyond)
        return fmb_support_add_point(s);
    *stands = true;
    return prove_row(s, h, sign, row);
}
