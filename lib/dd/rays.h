/* rays.h: the rays of a cone, each with the set of rows in which it is positive.
 *
 * Invariants: ray i < size has the vector v[i] of `width` entries and the support, a bit set of
 * `words` words at fmb_rays_support(r, i). From `size` on there are spare vectors: small, and with
 * memory for `width` entries. Vectors may move whenever a ray is added.
 */
#ifndef FMB_DD_RAYS_H
#define FMB_DD_RAYS_H

#include "base/arena.h"
#include "num/vec.h"

typedef struct fmb_rays {
    fmb_mem *mem;
    fmb_arena arena; /* small entries */
    size_t width, words;
    size_t size, made; /* rays; vectors with allocated entries */
    size_t capacity, capacity_words;
    fmb_vec *v;        /* [capacity] */
    uint64_t *support; /* [capacity_words] */
} fmb_rays;

void fmb_rays_init(fmb_rays *r, fmb_mem *mem, size_t width, size_t words);
void fmb_rays_clear(fmb_rays *r);

static inline uint64_t *fmb_rays_support(const fmb_rays *r, size_t i)
{
    return r->support + i * r->words;
}

/* Add n rays, with small, undefined vectors and empty supports. Errors: MEMORY, LIMIT. */
fmb_status fmb_rays_add_many(fmb_rays *r, size_t n);
static inline fmb_status fmb_rays_add(fmb_rays *r)
{
    return fmb_rays_add_many(r, 1);
}
/* Remove ray i; the last ray takes its place. */
void fmb_rays_remove(fmb_rays *r, size_t i);
/* Make supports large enough for this many bits. Errors: MEMORY, LIMIT. */
fmb_status fmb_rays_reserve_bits(fmb_rays *r, size_t bits);
/* Remove entry c of every vector; the last entry takes its place. Errors: MEMORY, LIMIT. */
fmb_status fmb_rays_drop_entry(fmb_rays *r, size_t c);
/* Bytes held by rays `from` to `to` - 1 outside the arena. */
size_t fmb_rays_bytes_of(const fmb_rays *r, size_t from, size_t to);

#endif
