/* facets_copy.c: copies of facets, for threads that look at them while the hull grows; see
 * facets.h.
 */
#include <string.h>

#include "hull/facets/facets_private.h"

fmb_status fmb_facets_reserve(fmb_facets *f, size_t more)
{
    return FMB_RESERVE(f->num.mem, &f->generator, &f->generator_capacity, f->generators + more);
}

static fmb_status make_room_in_copy(const fmb_facets *f, fmb_facet *to, fmb_mem *mem)
{
    if (!to->normal.s)
        to->normal.s = fmb_mem_zero(mem, f->d + 1, sizeof *to->normal.s);
    if (!to->roughly)
        to->roughly = fmb_mem_get(mem, 2 * f->d, sizeof *to->roughly);
    if (!to->normal.s || !to->roughly)
        return fmb_mem_status(mem);
    if (to->words == f->words)
        return FMB_OK;
    uint64_t *on = fmb_mem_grow(mem, to->on, to->words, f->words, sizeof *on);
    if (!on)
        return fmb_mem_status(mem);
    to->on = on;
    to->words = f->words;
    return FMB_OK;
}

fmb_status fmb_facets_copy(const fmb_facets *f, size_t at, fmb_facet *to, fmb_mem *mem)
{
    const fmb_facet *a = &f->facet[at];
    fmb_status st = make_room_in_copy(f, to, mem);
    to->known = to->fresh = false;
    if (st != FMB_OK)
        return st;
    fmb_vec_clear(&to->normal, f->d + 1, mem);
    memcpy(to->on, a->on, f->words * sizeof *to->on);
    to->ons = a->ons;
    if (!a->known)
        return FMB_OK;
    st = fmb_vec_copy(&to->normal, &a->normal, f->d + 1, mem);
    to->known = st == FMB_OK;
    return st;
}

void fmb_facets_clear_copy(const fmb_facets *f, fmb_facet *copy, fmb_mem *mem)
{
    fmb_vec_clear(&copy->normal, f->d + 1, mem);
    fmb_mem_put(mem, copy->normal.s, f->d + 1, sizeof *copy->normal.s);
    fmb_mem_put(mem, copy->roughly, 2 * f->d, sizeof *copy->roughly);
    fmb_mem_put(mem, copy->on, copy->words, sizeof *copy->on);
    *copy = (fmb_facet){0};
}

fmb_status fmb_facets_copy_need_normal(const fmb_facets *view, fmb_facet *copy, fmb_num *num)
{
    fmb_normal_tools tools = {.num = num};
    if (copy->known)
        return FMB_OK;
    fmb_status st = fmb_facets_find_normal(view, copy, &tools);
    fmb_normal_tools_clear(view, &tools);
    return st;
}

fmb_status fmb_facets_take_normal(fmb_facets *f, size_t at, const fmb_facet *copy)
{
    fmb_facet *a = &f->facet[at];
    if (a->known || !copy->known)
        return FMB_OK;
    FMB_TRY(fmb_vec_copy(&a->normal, &copy->normal, f->d + 1, f->num.mem));
    a->known = true;
    fmb_facets_round_normal(f, a);
    return FMB_OK;
}
