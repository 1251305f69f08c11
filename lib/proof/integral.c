/* integral.c: see integral.h. */
#include "proof/integral.h"

#include "system/system_private.h"

bool fmb_point_is_integral(const fmb_system *s, const fmb_sparse_vector *point)
{
    bool integral = true;
    for (size_t k = 0; integral && k < point->size; k++)
        integral = !fmb_system_is_integer(s, (int)point->index[k]) ||
                   mpz_divisible_p(mpq_numref(point->value[k]), mpq_denref(point->value[k]));
    return integral;
}

/* Does the claim name all integer variables? A variable is in it at most once. */
static bool names_all_integers(const fmb_system *s, const fmb_claim *q)
{
    size_t named = 0, all = 0;
    for (size_t k = 0; k < q->terms.size; k++)
        named += fmb_system_is_integer(s, (int)q->terms.index[k]);
    for (int j = 0; j < fmb_system_dim(s); j++)
        all += fmb_system_is_integer(s, j);
    return named == all;
}

bool fmb_claim_is_integral(const fmb_system *s, const fmb_claim *q, bool solution)
{
    switch (q->kind) {
    case FMB_CLAIM_FEASIBLE:
    case FMB_CLAIM_IRREDUNDANT:
        return fmb_point_is_integral(s, &q->point);
    case FMB_CLAIM_BOUND:
        return q->rel == FMB_LE && fmb_point_is_integral(s, &q->point);
    case FMB_CLAIM_UNBOUNDED:
        return solution;
    case FMB_CLAIM_WHOLE:
        return names_all_integers(s, q);
    default:
        return true;
    }
}
