/* facets_private.h: shared by the files of the facets; see facets.h. */
#ifndef FMB_HULL_FACETS_PRIVATE_H
#define FMB_HULL_FACETS_PRIVATE_H

#include "hull/facets/facets.h"

/* ---- facets_slots.c -------------------------------------------------------------------------- */

/* A live facet with no generators and no neighbours; its normal is undefined. */
fmb_status fmb_facets_open_slot(fmb_facets *f, uint32_t *out);
void fmb_facets_close_slot(fmb_facets *f, uint32_t a);
/* Enlarge all sets for more generators. */
fmb_status fmb_facets_widen_sets(fmb_facets *f);
/* Make a and b neighbours of each other. */
fmb_status fmb_facets_join(fmb_facets *f, uint32_t a, uint32_t b);
/* Remove b from the neighbours of a. */
void fmb_facets_part(fmb_facets *f, uint32_t a, uint32_t b);
/* Append a to one of the lists. */
fmb_status fmb_facets_list(fmb_facets *f, uint32_t **list, size_t *size, size_t *capacity,
                           uint32_t a);
static inline void fmb_facet_put_on(fmb_facet *a, size_t generator)
{
    a->ons += !fmb_facet_holds(a, generator);
    fmb_set_put(a->on, generator);
}

/* The last entry of v becomes v.g, for the generator g being added. */
static inline fmb_status fmb_facets_evaluate(fmb_facets *f, fmb_vec *v)
{
    return fmb_vec_set_product(v, f->d, f->d + 1, &f->g, &f->num);
}
/* facets_raise.c: reset the last entry of v to 0 and bring v to lowest terms, where v is a
 * combination or was in lowest terms before that entry was set. */
fmb_status fmb_facets_tidy(fmb_facets *f, fmb_vec *v);

/* ---- facets_roughly.c ------------------------------------------------------------------------ */

/* out[n] = v up to a positive factor, in doubles. */
void fmb_facets_round(const fmb_vec *v, size_t n, double *out);
/* Set the rough normal of a facet from its known normal. */
void fmb_facets_round_normal(const fmb_facets *f, fmb_facet *a);
/* Set the rough normal of a to the combination of those of n and v that is 0 on the generator being
 * added, which is on the positive side of n and on the negative side of v. */
void fmb_facets_combine_roughly(fmb_facets *f, fmb_facet *a, const fmb_facet *n,
                                const fmb_facet *v);
/* Is the sign of a facet's normal on a generator certain in doubles? If so, *side is that sign. The
 * entries of near[d] are those of the generator times a positive factor, within 2^-50. */
bool fmb_facets_guess_side(const fmb_facets *f, fmb_facet *a, const double *near, int *side);

/* ---- facets_normal.c ------------------------------------------------------------------------- */

/* Scratch for computing a normal. */
typedef struct fmb_normal_tools {
    fmb_num *num;
    mpz_t *minor; /* [2^d] scratch, or NULL */
} fmb_normal_tools;

/* Compute a normal that is not known. Several threads may, each with its own tools. */
fmb_status fmb_facets_find_normal(const fmb_facets *f, fmb_facet *a, fmb_normal_tools *by);
void fmb_normal_tools_clear(const fmb_facets *f, fmb_normal_tools *by);

/* The next larger set with the same number of columns. */
static inline uint32_t fmb_facets_next_set(uint32_t set)
{
    uint32_t low = set & -set, up = set + low;
    return up | ((set ^ up) / low) >> 2;
}

/* ---- facets_refresh.c ------------------------------------------------------------------------ */

/* Scale x by a power of two so that |x_j| <= 1. */
void fmb_facets_scale_down(double *x, size_t d);
/* Recompute the rough normal of a facet from its generators, once. False: no improvement. */
bool fmb_facets_refresh(const fmb_facets *f, fmb_facet *a);

/* ---- facets_side.c --------------------------------------------------------------------------- */

/* The exact sign of facet `at` on the generator g[d], whose rounded form is near[d]. */
fmb_status fmb_facets_side(fmb_facets *f, size_t at, const fmb_vec *g, const double *near,
                           int *side);

/* ---- facets_add.c ---------------------------------------------------------------------------- */

/* Add v, which is beyond facet `at`. */
fmb_status fmb_facets_add_beyond(fmb_facets *f, const fmb_vec *v, size_t at);
/* Is v outside the span of the generators? */
bool fmb_facets_is_off_span(fmb_facets *f, const fmb_vec *v);

/* ---- adding a generator ---------------------------------------------------------------------- */

/* facets_raise.c: a generator outside the span, which violates equation e. */
fmb_status fmb_facets_raise(fmb_facets *f, size_t e, size_t generator);
/* facets_cut.c: a generator in the span, once sides are known: f->seen lists the facets visible
 * from it, f->touched those whose hyperplane contains it. */
fmb_status fmb_facets_cut(fmb_facets *f, size_t generator);
/* facets_ridges.c: find the ridges between facets in f->made and f->touched. */
fmb_status fmb_facets_join_new(fmb_facets *f);

#endif
