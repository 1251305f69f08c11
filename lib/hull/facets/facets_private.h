/* facets_private.h: what the files of the facets share; see facets.h. */
#ifndef FMB_HULL_FACETS_PRIVATE_H
#define FMB_HULL_FACETS_PRIVATE_H

#include "hull/facets/facets.h"

/* ---- facets_slots.c -------------------------------------------------------------------------- */

/* A facet without anything on it and without neighbours, alive; its normal is undefined. */
fmb_status fmb_facets_open_slot(fmb_facets *f, uint32_t *out);
void fmb_facets_close_slot(fmb_facets *f, uint32_t a);
/* Room for more generators in all sets. */
fmb_status fmb_facets_widen_sets(fmb_facets *f);
/* Append b to the neighbours of a, and a to those of b. */
fmb_status fmb_facets_join(fmb_facets *f, uint32_t a, uint32_t b);
/* b is no neighbour of a any more. */
void fmb_facets_part(fmb_facets *f, uint32_t a, uint32_t b);
/* Append to one of the lists. */
fmb_status fmb_facets_list(fmb_facets *f, uint32_t **list, size_t *size, size_t *capacity,
                           uint32_t a);
static inline void fmb_facet_put_on(fmb_facet *a, size_t generator)
{
    a->ons += !fmb_facet_holds(a, generator);
    fmb_set_put(a->on, generator);
}

/* v.g for the generator at hand, as the last entry of v. */
static inline fmb_status fmb_facets_evaluate(fmb_facets *f, fmb_vec *v)
{
    return fmb_vec_set_product(v, f->d, f->d + 1, &f->g, &f->num);
}
/* facets_raise.c: the last entry of v, a combination or what was in lowest terms, is 0 again, and v
 * in lowest terms. */
fmb_status fmb_facets_tidy(fmb_facets *f, fmb_vec *v);

/* ---- facets_roughly.c ------------------------------------------------------------------------ */

/* out[n] = v, up to a positive factor. */
void fmb_facets_round(const fmb_vec *v, size_t n, double *out);
/* The normal of a facet is known: round it. */
void fmb_facets_round_normal(const fmb_facets *f, fmb_facet *a);
/* Roughly, the normal of a is that combination of n's and v's which is 0 on the generator at hand,
 * positive on n and negative on v. */
void fmb_facets_combine_roughly(fmb_facets *f, fmb_facet *a, const fmb_facet *n,
                                const fmb_facet *v);
/* The sign of a facet's normal on a generator that is near[d] roughly, up to a positive factor,
 * entry by entry within 2^-50. Is it sure? */
bool fmb_facets_guess_side(const fmb_facets *f, fmb_facet *a, const double *near, int *side);

/* ---- facets_normal.c ------------------------------------------------------------------------- */

/* What it takes to find a normal. */
typedef struct fmb_normal_tools {
    fmb_num *num;
    mpz_t *minor; /* [2^d] scratch, or NULL */
} fmb_normal_tools;

/* Of a facet whose normal is not known. Several threads may, each with its own tools. */
fmb_status fmb_facets_find_normal(const fmb_facets *f, fmb_facet *a, fmb_normal_tools *by);
void fmb_normal_tools_clear(const fmb_facets *f, fmb_normal_tools *by);

/* The next larger set of as many columns. */
static inline uint32_t fmb_facets_next_set(uint32_t set)
{
    uint32_t low = set & -set, up = set + low;
    return up | ((set ^ up) / low) >> 2;
}

/* ---- facets_refresh.c ------------------------------------------------------------------------ */

/* Times a power of two, so that |x_j| <= 1. */
void fmb_facets_scale_down(double *x, size_t d);
/* Roughly, the normal of a facet from what is on it, once. False: it is not known any better. */
bool fmb_facets_refresh(const fmb_facets *f, fmb_facet *a);

/* ---- facets_side.c --------------------------------------------------------------------------- */

/* The same for sure: the generator is g[d], and near it. */
fmb_status fmb_facets_side(fmb_facets *f, size_t at, const fmb_vec *g, const double *near,
                           int *side);

/* ---- facets_add.c ---------------------------------------------------------------------------- */

/* Take in v, which is beyond facet `at`. */
fmb_status fmb_facets_add_beyond(fmb_facets *f, const fmb_vec *v, size_t at);
/* Does some equation say something of v? */
bool fmb_facets_is_off_span(fmb_facets *f, const fmb_vec *v);

/* ---- one generator more ---------------------------------------------------------------------- */

/* facets_raise.c: it is not in the span, where equation e says something of it. */
fmb_status fmb_facets_raise(fmb_facets *f, size_t e, size_t generator);
/* facets_cut.c: it is, and sides are known; those that see it are listed in f->seen, those whose
 * hyperplane holds it in f->touched. */
fmb_status fmb_facets_cut(fmb_facets *f, size_t generator);
/* facets_ridges.c: ridges between those in f->made and f->touched. */
fmb_status fmb_facets_join_new(fmb_facets *f);

#endif
