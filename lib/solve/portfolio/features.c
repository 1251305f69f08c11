/* features.c: see features.h. */
#include "solve/portfolio/features.h"

bool fmb_features_is_long(const fmb_reduced_part *h)
{
    bool wide = false, long_all = true;
    for (size_t i = 0; i < h->e.live.size; i++) {
        const fmb_vec *v = &h->e.row[h->e.live.row[i]].v;
        wide |= fmb_vec_is_wide(v);
        long_all &= fmb_vec_is_wide(v) || v->bits > FMB_LAZY_BITS;
    }
    return wide || long_all;
}

size_t fmb_features_minor_bits(const fmb_reduced_part *h)
{
    return fmb_elim_minor_bits(&h->e);
}

size_t fmb_features_rows(const fmb_reduced_part *h)
{
    return h->e.live.size;
}

size_t fmb_features_entries(const fmb_reduced_part *h)
{
    size_t nonzero = 0;
    for (size_t i = 0; i < h->e.live.size; i++)
        nonzero += (size_t)fmb_elim_count_variables(&h->e, &h->e.row[h->e.live.row[i]]);
    return nonzero;
}

size_t fmb_features_bounds(const fmb_reduced_part *h)
{
    size_t bounds = 0;
    for (size_t i = 0; i < h->e.live.size; i++)
        bounds += fmb_elim_count_variables(&h->e, &h->e.row[h->e.live.row[i]]) == 1;
    return bounds;
}

bool fmb_features_has_origin(const fmb_reduced_part *h)
{
    for (size_t i = 0; i < h->e.live.size; i++) {
        const fmb_derived *r = &h->e.row[h->e.live.row[i]];
        int side = fmb_vec_sgn(&r->v, (size_t)h->p->n);
        if (side < 0 || (r->strict && side == 0) || (r->equality && side != 0))
            return false;
    }
    return true;
}

size_t fmb_features_columns(const fmb_reduced_part *h)
{
    return (size_t)h->p->n - (size_t)h->e.rounds;
}

size_t fmb_features_freedom(const fmb_reduced_part *h)
{
    size_t rows = h->e.live.size, d = fmb_features_columns(h) + 1;
    return rows > d && rows - d > d ? d : rows > d ? rows - d : 0;
}
