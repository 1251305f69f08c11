/* facets_cut.c: adds a generator beyond some facets; see facets.h.
 *
 * Facets visible from the generator g are removed. Each ridge between a visible facet v and one
 * with g strictly inside, n, spans a new facet with g: the combination of both normals that is 0 on
 * g. A touched facet, whose hyperplane contains g, gets g, too; it is adjacent to a visible one. On
 * a new facet are, besides g, the generators on both v and n: the combination is 0 exactly where
 * both are. Ridges between new and touched facets are found last (facets_ridges.c).
 */
#include "hull/facets/facets_private.h"
#include "num/bitset.h"

/* Combinations with at most so many bits stay small. */
#define EXACT_BITS 56

/* ---- new facets ------------------------------------------------------------------------------ */

static fmb_status need_value(fmb_facets *f, fmb_facet *a)
{
    if (a->valued)
        return FMB_OK;
    a->valued = true;
    return fmb_facets_evaluate(f, &a->normal);
}

/* Short integers are faster than doubles with bounds; and if there are equations, normals are not
 * determined by the generators on their facets. */
static bool is_combination_exact(const fmb_facets *f, const fmb_facet *n, const fmb_facet *v)
{
    const fmb_vec *p = &n->normal, *q = &v->normal, *g = &f->g;
    bool is_short = !p->z && !q->z && !g->z && p->bits + q->bits + g->bits < EXACT_BITS;
    return n->known && v->known && (is_short || f->rank < f->d || f->d > FMB_FACETS_FEW);
}

static fmb_status combine_exactly(fmb_facets *f, fmb_facet *a, fmb_facet *n, fmb_facet *v)
{
    fmb_status st = need_value(f, n);
    FMB_THEN(st, need_value(f, v));
    FMB_THEN(st, fmb_vec_cancel(&a->normal, &n->normal, &v->normal, f->d + 1, f->d, &f->num));
    FMB_THEN(st, fmb_facets_tidy(f, &a->normal));
    a->known = st == FMB_OK;
    fmb_run_count(f->run, 3 * fmb_vec_work(&a->normal, f->d + 1));
    fmb_facets_round_normal(f, a);
    return st;
}

static fmb_status combine_normals(fmb_facets *f, uint32_t at, uint32_t n, uint32_t v)
{
    fmb_facet *a = &f->facet[at], *p = &f->facet[n], *q = &f->facet[v];
    if (is_combination_exact(f, p, q))
        return combine_exactly(f, a, p, q);
    fmb_facets_combine_roughly(f, a, p, q);
    return FMB_OK;
}

static fmb_status make_facet_over_ridge(fmb_facets *f, uint32_t v, uint32_t n, size_t generator)
{
    uint32_t at;
    FMB_TRY(fmb_facets_open_slot(f, &at));
    FMB_TRY(combine_normals(f, at, n, v));
    fmb_facet *a = &f->facet[at];
    fmb_run_count(f->run, 100 + 12 * f->d + 2 * f->words);
    for (size_t w = 0; w < f->words; w++) {
        a->on[w] = f->facet[v].on[w] & f->facet[n].on[w];
        a->ons += fmb_ones64(a->on[w]);
    }
    fmb_facet_put_on(a, generator);
    fmb_facets_part(f, n, v);
    FMB_TRY(fmb_facets_join(f, at, n));
    return fmb_facets_list(f, &f->made, &f->mades, &f->made_capacity, at);
}

static fmb_status replace_visible_facets(fmb_facets *f, size_t generator)
{
    f->mades = 0;
    for (size_t i = 0; i < f->seens; i++) {
        uint32_t v = f->seen[i];
        for (size_t k = 0; k < f->facet[v].nexts; k++) {
            uint32_t n = f->facet[v].next[k];
            if (f->facet[n].side > 0)
                FMB_TRY(make_facet_over_ridge(f, v, n, generator));
            else if (f->facet[n].side == 0)
                fmb_facets_part(f, n, v);
        }
        FMB_TRY(fmb_run_poll(f->run));
    }
    return FMB_OK;
}

/* ---- the whole cut --------------------------------------------------------------------------- */

/* Remaining facets were valued for a new facet, whose first neighbour they are. */
static fmb_status forget_values(fmb_facets *f)
{
    for (size_t i = 0; i < f->mades; i++) {
        fmb_facet *n = &f->facet[f->facet[f->made[i]].next[0]];
        if (!n->valued)
            continue;
        n->valued = false;
        FMB_TRY(fmb_facets_tidy(f, &n->normal));
    }
    return FMB_OK;
}

fmb_status fmb_facets_cut(fmb_facets *f, size_t generator)
{
    for (size_t i = 0; i < f->toucheds; i++)
        fmb_facet_put_on(&f->facet[f->touched[i]], generator);
    FMB_TRY(replace_visible_facets(f, generator));
    for (size_t i = 0; i < f->seens; i++)
        fmb_facets_close_slot(f, f->seen[i]);
    FMB_TRY(forget_values(f));
    return fmb_facets_join_new(f);
}
