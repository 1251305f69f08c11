/* orbits.h: vectors over the kept columns, in orbits of a group of symmetries.
 *
 * A vector has a fixed entry, then one for each kept column: a point (den, x), or a normal (h0, h1
 * ... hk). Invariant: vectors are distinct; one that is not the first of its orbit is the image of
 * the vector `from`, an earlier one, under generator `by`.
 */
#ifndef FMB_SYMMETRY_ORBITS_H
#define FMB_SYMMETRY_ORBITS_H

#include "num/weights.h"
#include "symmetry/group.h"

#define FMB_ORBIT_ROOT UINT32_MAX

typedef struct fmb_orbit_vector {
    fmb_vec v;         /* [k + 1] */
    uint32_t from, by; /* from: FMB_ORBIT_ROOT for the first of its orbit */
    size_t tag;        /* free for the owner of the orbits; SIZE_MAX: not set */
} fmb_orbit_vector;

typedef struct fmb_orbits {
    fmb_run *run;
    const fmb_group *group;
    size_t k;
    uint32_t *place;        /* [generators][k] entry j + 1 moves to this place plus 1 */
    fmb_orbit_vector *item; /* [size] */
    size_t size, capacity;
    uint32_t *slot; /* [slots] a hash table of items, UINT32_MAX: free; slots a power of two */
    size_t slots;
} fmb_orbits;

/* The group must outlive the orbits; kept[k] increases. Errors: MEMORY, LIMIT. The caller must call
 * fmb_orbits_clear even then. */
fmb_status fmb_orbits_init(fmb_orbits *o, fmb_run *run, const fmb_group *group, const int *kept,
                           size_t k);
void fmb_orbits_clear(fmb_orbits *o);

/* Add v[k + 1] and its images; the new ones are the items from the old o->size on. If there are
 * very many images, only some are added. Errors: MEMORY, LIMIT. */
fmb_status fmb_orbits_add(fmb_orbits *o, const fmb_vec *v, size_t tag);
/* The item that equals v; SIZE_MAX if there is none. */
size_t fmb_orbits_find(const fmb_orbits *o, const fmb_vec *v);
/* The first of the orbit of an item. */
size_t fmb_orbits_root(const fmb_orbits *o, size_t item);
/* Append to `to` the images of multipliers `from` of that first vector: multipliers of the item. */
fmb_status fmb_orbits_move_weights(const fmb_orbits *o, size_t item, const fmb_weights *from,
                                   fmb_weights *to);

#endif
