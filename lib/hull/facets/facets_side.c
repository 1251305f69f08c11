/* facets_side.c: the side of a facet on which a generator lies: in doubles with the present normal,
 * then with one refreshed from its generators, and exactly if these are in doubt; see facets.h.
 */
#include "hull/facets/facets_private.h"

fmb_status fmb_facets_side(fmb_facets *f, size_t at, const fmb_vec *g, const double *near,
                           int *side)
{
    fmb_facet *a = &f->facet[at];
    if (fmb_facets_guess_side(f, a, near, side))
        return FMB_OK;
    if (!a->known && fmb_facets_refresh(f, a) && fmb_facets_guess_side(f, a, near, side))
        return FMB_OK;
    if (!a->known) {
        FMB_TRY(fmb_facets_need_normal(f, at));
        if (fmb_facets_guess_side(f, a, near, side))
            return FMB_OK;
    }
    *side = fmb_vec_product_sign(&a->normal, g, f->d, &f->num);
    return FMB_OK;
}
