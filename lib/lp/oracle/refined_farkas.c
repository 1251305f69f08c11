/* refined_farkas.c: see refined_farkas.h.
 *
 * A conflict is a combination of rows whose left side is that of the odd row, or its reverse, and
 * whose right side contradicts it. An implied row contradicts the rows that imply it once it is
 * reversed and its right side moved: so the same bounds prove implications, apart from the case of
 * equal right sides.
 */
#include "lp/oracle/refined_farkas.h"

#include "lp/oracle/refinement.h"

#define MOST_UNKNOWNS 256
#define CORRECTIONS   8

bool fmb_refined_farkas_is_worth_it(const fmb_vertex *v)
{
    for (size_t r = 0; r < v->n && v->n <= MOST_UNKNOWNS; r++)
        if (!fmb_vertex_is_unit(v, r) && v->p->row[v->basis[r]].value->z)
            return true;
    return false;
}

/* Multipliers of inequalities must have the sign opposite to *sign, and so must the remainder. */
static fmb_refined is_conflict_refined(fmb_refinement *t, int *sign)
{
    int common, remainder;
    bool differ;
    double error = fmb_refinement_bound_error(t);
    if (!fmb_refinement_common_sign(t, error, &common, &differ))
        return differ ? FMB_REFINED_FALSE : FMB_REFINED_UNKNOWN;
    remainder = fmb_refinement_sign_of_remainder(t, error);
    *sign = -remainder;
    return remainder != 0 && remainder * common >= 0 &&
                   (*sign > 0 || t->p->row[t->odd].rel == FMB_EQ)
               ? FMB_REFINED_TRUE
               : FMB_REFINED_UNKNOWN;
}

/* Are all right sides 0? Then the remainder is 0, too. */
static bool is_cone(const fmb_refinement *t)
{
    bool cone = true;
    for (size_t s = 0; s <= t->size && cone; s++) {
        const fmb_program_row *r = &t->p->row[s < t->size ? t->member[s] : t->odd];
        cone = fmb_vec_sgn(r->value, r->size) == 0;
    }
    return cone;
}

/* Multipliers of inequalities and the remainder must not be negative; and the remainder must be
 * positive if the odd row is the only strict one. */
static fmb_refined is_implication_refined(fmb_refinement *t, int *sign)
{
    int common, remainder;
    bool differ, meets = t->p->row[t->odd].rel != FMB_LT;
    double error = fmb_refinement_bound_error(t);
    bool known = fmb_refinement_common_sign(t, error, &common, &differ);
    *sign = 1;
    if (common < 0 || differ)
        return FMB_REFINED_FALSE;
    if (!known)
        return FMB_REFINED_UNKNOWN;
    for (size_t s = 0; s < t->size; s++)
        meets = meets || t->p->row[t->member[s]].rel == FMB_LT;
    if (is_cone(t))
        return meets ? FMB_REFINED_TRUE : FMB_REFINED_FALSE;
    remainder = fmb_refinement_sign_of_remainder(t, error);
    return remainder > 0   ? FMB_REFINED_TRUE
           : remainder < 0 ? FMB_REFINED_FALSE
                           : FMB_REFINED_UNKNOWN;
}

static fmb_status refine(fmb_refinement *t, fmb_refined (*judge)(fmb_refinement *, int *),
                         int *sign, fmb_refined *out)
{
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && *out == FMB_REFINED_UNKNOWN && k <= CORRECTIONS; k++) {
        if (k > 0)
            fmb_refinement_correct(t);
        fmb_refinement_find_rest(t);
        *out = judge(t, sign);
        st = fmb_integers_settle(&t->multiplier, t->run->mem);
        FMB_THEN(st, fmb_integers_settle(&t->left, t->run->mem));
        FMB_THEN(st, fmb_run_poll_now(t->run));
    }
    return st;
}

fmb_status fmb_refined_farkas(const fmb_vertex *v, size_t odd, int *sign, bool *sure)
{
    fmb_refinement t;
    bool good = false;
    fmb_refined out = FMB_REFINED_UNKNOWN;
    fmb_status st = fmb_refinement_open(&t, v->run, v->p, v->m, odd);
    if (st == FMB_OK && !v->p->row[odd].off && !fmb_vertex_holds(v, odd))
        st = fmb_refinement_of_basis(&t, v->basis, &good);
    if (st == FMB_OK && good)
        st = refine(&t, is_conflict_refined, sign, &out);
    *sure = out == FMB_REFINED_TRUE;
    fmb_refinement_close(&t);
    return st;
}

fmb_status fmb_refined_implication(fmb_run *run, const fmb_program *p, size_t i, size_t size,
                                   const size_t *row, fmb_refined *out)
{
    fmb_refinement t;
    int sign;
    *out = FMB_REFINED_UNKNOWN;
    fmb_status st = fmb_refinement_open(&t, run, p, p->m, i);
    if (st == FMB_OK && fmb_refinement_of_rows(&t, size, row))
        st = refine(&t, is_implication_refined, &sign, out);
    fmb_refinement_close(&t);
    return st;
}
