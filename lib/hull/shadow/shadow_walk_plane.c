/* shadow_walk_plane.c: directions and places in the plane of the shadow, and the way along an edge;
 * see shadow_walk.c. */
#include "hull/shadow/shadow_walk_private.h"

#include "lp/dictionary/exact_simplex.h"

/* x = sum (c_xj / d_x) N_j, and so for y: both are multiplied by d_x d_y. */
void fmb_shadow_walk_direction(fmb_shadow_walk *w, size_t j, mpz_t *r)
{
    for (int axis = X; axis <= Y; axis++) {
        fmb_vec_get(fmb_shadow_walk_row_of(w, axis), j, r[axis]);
        fmb_vec_get(fmb_shadow_walk_row_of(w, 1 - axis), fmb_lp_place(w->lp, FMB_LP_OWN), w->t);
        mpz_mul(r[axis], r[axis], w->t);
        mpz_neg(r[axis], r[axis]);
    }
}

int fmb_shadow_walk_cross(fmb_shadow_walk *w, mpz_t *a, mpz_t *b)
{
    mpz_mul(w->t, a[X], b[Y]);
    mpz_mul(w->u, a[Y], b[X]);
    return mpz_cmp(w->t, w->u);
}

int fmb_shadow_walk_dot(fmb_shadow_walk *w, mpz_t *a, mpz_t *b)
{
    mpz_mul(w->t, a[X], b[X]);
    mpz_mul(w->u, a[Y], b[Y]);
    mpz_add(w->t, w->t, w->u);
    return mpz_sgn(w->t);
}

void fmb_shadow_walk_locate(fmb_shadow_walk *w, mpq_t *point)
{
    for (int axis = X; axis <= Y; axis++) {
        fmb_vec_get(fmb_shadow_walk_row_of(w, axis), fmb_lp_place(w->lp, FMB_LP_K),
                    mpq_numref(point[axis]));
        fmb_vec_get(fmb_shadow_walk_row_of(w, axis), fmb_lp_place(w->lp, FMB_LP_OWN),
                    mpq_denref(point[axis]));
        mpz_neg(mpq_denref(point[axis]), mpq_denref(point[axis]));
        mpq_canonicalize(point[axis]);
    }
}

/* The column that moves the shadow towards goal, or exactly along it, of least variable (Bland's
 * rule: no cycles); SIZE_MAX if none does. */
static size_t find_column_towards(fmb_shadow_walk *w, mpz_t *goal, bool exactly)
{
    const fmb_lp *lp = w->lp;
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        if (!fmb_lp_may_enter(lp, j))
            continue;
        fmb_shadow_walk_direction(w, j, w->r);
        if ((!exactly || fmb_shadow_walk_cross(w, goal, w->r) == 0) &&
            fmb_shadow_walk_dot(w, goal, w->r) > 0 &&
            (best == SIZE_MAX || lp->column[j] < lp->column[best]))
            best = j;
    }
    return best;
}

fmb_status fmb_shadow_walk_push(fmb_shadow_walk *w, mpz_t *goal, bool exactly, bool *unbounded)
{
    *unbounded = false;
    for (;;) {
        size_t j = find_column_towards(w, goal, exactly);
        if (j == SIZE_MAX)
            return FMB_OK;
        size_t block = fmb_lp_find_block(w->lp, j, 1);
        *unbounded = block == SIZE_MAX;
        if (*unbounded)
            fmb_shadow_walk_direction(w, j, w->r);
        fmb_status st = *unbounded ? FMB_OK : fmb_lp_pivot(w->lp, block, j);
        if (st != FMB_OK || *unbounded)
            return st;
    }
}
