/* claims.c: see claims.h. */
#include <criterion/criterion.h>

#include "claims.h"

fmb_status scene_hear_redundant(void *self, size_t i, const fmb_weights *w)
{
    scene_listener *l = self;
    const scene *c = l->c;
    bool strict = false;
    mpq_t sum, want;
    mpq_inits(sum, want, NULL);
    for (size_t k = 0; k < w->size; k++) {
        cr_assert(!l->gone[w->index[k]] && w->index[k] != i);
        cr_assert(mpq_sgn(w->value[k]) > 0 || c->rel[w->index[k]] == FMB_EQ);
        strict |= c->rel[w->index[k]] == FMB_LT && mpq_sgn(w->value[k]) > 0;
    }
    for (size_t j = 0; j <= c->n; j++) {
        scene_combine(c, w->index, w->value, w->size, j, sum);
        fmb_vec_get_q(c->row[i].v, j, want);
        int order = mpq_cmp(sum, want);
        if (j < c->n || c->rel[i] == FMB_EQ)
            cr_assert_eq(order, 0);
        else
            cr_assert(order < 0 || (order == 0 && (strict || c->rel[i] == FMB_LE)));
    }
    mpq_clears(sum, want, NULL);
    l->gone[i] = true;
    l->claims++;
    return FMB_OK;
}

fmb_status scene_hear_equality(void *self, size_t i, const fmb_weights *w)
{
    scene_listener *l = self;
    const scene *c = l->c;
    mpq_t sum, want;
    mpq_inits(sum, want, NULL);
    for (size_t k = 0; k < w->size; k++)
        cr_assert(!l->gone[w->index[k]] &&
                  (mpq_sgn(w->value[k]) > 0 || c->rel[w->index[k]] == FMB_EQ));
    for (size_t j = 0; j <= c->n; j++) {
        scene_combine(c, w->index, w->value, w->size, j, sum);
        fmb_vec_get_q(c->row[i].v, j, want);
        mpq_neg(want, want);
        cr_assert_eq(mpq_cmp(sum, want), 0);
    }
    mpq_clears(sum, want, NULL);
    c->rel[i] = FMB_EQ;
    return FMB_OK;
}

fmb_status scene_hear_irredundant(void *self, size_t i, mpq_t *x)
{
    scene_listener *l = self;
    for (size_t k = 0; k < l->c->m; k++)
        cr_assert(l->gone[k] || scene_holds(l->c, k, x) == (k != i));
    l->claims++;
    return FMB_OK;
}
