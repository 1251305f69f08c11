/* rays.c: the rays of a cone; see rays.h. */
#include "dd/rays.h"

#include <string.h>

void fmb_rays_init(fmb_rays *r, fmb_mem *mem, size_t width, size_t words)
{
    *r = (fmb_rays){.mem = mem, .width = width, .words = words};
    fmb_arena_init(&r->arena, mem);
}

void fmb_rays_clear(fmb_rays *r)
{
    for (size_t i = 0; i < r->size; i++)
        fmb_vec_clear(&r->v[i], r->width, r->mem);
    fmb_mem_put(r->mem, r->v, r->capacity, sizeof *r->v);
    fmb_mem_put(r->mem, r->support, r->capacity_words, sizeof *r->support);
    fmb_arena_clear(&r->arena);
    *r = (fmb_rays){.mem = r->mem};
}

fmb_status fmb_rays_add_many(fmb_rays *r, size_t n)
{
    size_t size = r->size + n;
    FMB_TRY(FMB_RESERVE(r->mem, &r->v, &r->capacity, size));
    FMB_TRY(FMB_RESERVE(r->mem, &r->support, &r->capacity_words, size * r->words));
    for (; r->made < size; r->made++) {
        int64_t *s;
        FMB_TRY(FMB_ARENA_GET(&r->arena, s, r->width));
        r->v[r->made] = (fmb_vec){.s = s};
    }
    for (; r->size < size; r->size++)
        memset(fmb_rays_support(r, r->size), 0, r->words * sizeof *r->support);
    return FMB_OK;
}

void fmb_rays_remove(fmb_rays *r, size_t i)
{
    size_t last = --r->size;
    fmb_vec gone = r->v[i];
    r->v[i] = r->v[last];
    r->v[last] = gone;
    fmb_vec_clear(&r->v[last], r->width, r->mem);
    if (i != last)
        memcpy(fmb_rays_support(r, i), fmb_rays_support(r, last), r->words * sizeof *r->support);
}

fmb_status fmb_rays_reserve_bits(fmb_rays *r, size_t bits)
{
    size_t old = r->words, words = old;
    if (bits <= 64 * old)
        return FMB_OK;
    while (64 * words < bits)
        words *= 2;
    FMB_TRY(FMB_RESERVE(r->mem, &r->support, &r->capacity_words, r->size * words));
    for (size_t i = r->size; i-- > 0;) {
        uint64_t *to = r->support + i * words;
        memmove(to, r->support + i * old, old * sizeof *to);
        memset(to + old, 0, (words - old) * sizeof *to);
    }
    r->words = words;
    return FMB_OK;
}

fmb_status fmb_rays_drop_entry(fmb_rays *r, size_t c)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < r->size; i++) {
        fmb_vec *v = &r->v[i];
        if (!v->z) {
            v->s[c] = v->s[r->width - 1];
            continue;
        }
        fmb_status dropped = fmb_vec_drop_entry(v, r->width, c, r->mem);
        st = st == FMB_OK ? dropped : st;
    }
    r->width--;
    return st;
}

size_t fmb_rays_bytes_of(const fmb_rays *r, size_t from, size_t to)
{
    size_t bytes = 0;
    for (size_t i = from; i < to; i++)
        if (r->v[i].z)
            bytes += r->width * sizeof *r->v[i].z + r->v[i].limbs * sizeof(mp_limb_t);
    return bytes;
}
