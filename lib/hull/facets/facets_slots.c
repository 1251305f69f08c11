/* facets_slots.c: management of facets: their slots, sets and neighbours; see facets.h. */
#include "hull/facets/facets_private.h"

#include <string.h>

#include "base/arrays.h"

/* ---- slots ----------------------------------------------------------------------------------- */

static fmb_status widen_set(fmb_facets *f, uint64_t **set, size_t *words, size_t wanted)
{
    uint64_t *larger = fmb_mem_grow(f->num.mem, *set, *words, wanted, sizeof *larger);
    if (!larger)
        return fmb_mem_status(f->num.mem);
    memset(larger + *words, 0, (wanted - *words) * sizeof *larger);
    *set = larger;
    *words = wanted;
    return FMB_OK;
}

fmb_status fmb_facets_widen_sets(fmb_facets *f)
{
    size_t wanted = 2 * f->words;
    fmb_status st = widen_set(f, &f->common, &f->common_words, wanted);
    for (size_t a = 0; st == FMB_OK && a < f->slots; a++)
        st = widen_set(f, &f->facet[a].on, &f->facet[a].words, wanted);
    f->words = wanted;
    return st;
}

/* Make a new slot. */
static fmb_status make_slot(fmb_facets *f, uint32_t *out)
{
    fmb_mem *mem = f->num.mem;
    FMB_TRY(FMB_RESERVE(mem, &f->facet, &f->facet_capacity, f->slots + 1));
    fmb_facet *a = &f->facet[f->slots++];
    *a = (fmb_facet){0};
    a->words = f->words;
    *out = (uint32_t)(f->slots - 1);
    return FMB_ARRAYS(mem, true, FMB_ARRAY_ZERO(a->normal.s, f->d + 1),
                      FMB_ARRAY(a->roughly, 2 * f->d), FMB_ARRAY(a->on, f->words));
}

fmb_status fmb_facets_open_slot(fmb_facets *f, uint32_t *out)
{
    fmb_status st = FMB_OK;
    if (f->unuseds > 0)
        *out = f->unused[--f->unuseds];
    else
        st = make_slot(f, out);
    if (st == FMB_OK) /* so that closing a slot cannot fail */
        st = FMB_RESERVE(f->num.mem, &f->unused, &f->unused_capacity, f->slots);
    if (st != FMB_OK)
        return st;
    fmb_facet *a = &f->facet[*out];
    memset(a->on, 0, f->words * sizeof *a->on);
    a->ons = a->nexts = 0;
    a->valued = a->known = a->fresh = false;
    a->note = 0;
    a->alive = true;
    f->alive++;
    return FMB_OK;
}

void fmb_facets_close_slot(fmb_facets *f, uint32_t a)
{
    fmb_vec_clear(&f->facet[a].normal, f->d + 1, f->num.mem);
    f->facet[a].alive = false;
    f->facet[a].nexts = 0;
    f->unused[f->unuseds++] = a;
    f->alive--;
}

fmb_status fmb_facets_list(fmb_facets *f, uint32_t **list, size_t *size, size_t *capacity,
                           uint32_t a)
{
    FMB_TRY(FMB_RESERVE(f->num.mem, list, capacity, *size + 1));
    (*list)[(*size)++] = a;
    return FMB_OK;
}

static fmb_status add_neighbour(fmb_facets *f, uint32_t a, uint32_t b)
{
    fmb_facet *t = &f->facet[a];
    return fmb_facets_list(f, &t->next, &t->nexts, &t->next_capacity, b);
}

fmb_status fmb_facets_join(fmb_facets *f, uint32_t a, uint32_t b)
{
    FMB_TRY(add_neighbour(f, a, b));
    return add_neighbour(f, b, a);
}

void fmb_facets_part(fmb_facets *f, uint32_t a, uint32_t b)
{
    fmb_facet *t = &f->facet[a];
    for (size_t k = 0; k < t->nexts; k++)
        if (t->next[k] == b) {
            t->next[k] = t->next[--t->nexts];
            return;
        }
}

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status open_vectors(fmb_facets *f)
{
    for (size_t i = 0; i < f->d; i++) {
        FMB_TRY(FMB_GET_ZERO(f->num.mem, f->equation[i].s, f->d + 1));
        f->equation[i].s[i] = f->equation[i].bits = 1;
    }
    return FMB_OK;
}

fmb_status fmb_facets_init(fmb_facets *f, fmb_run *run, size_t d)
{
    fmb_mem *mem = run->mem;
    *f = (fmb_facets){.run = run, .d = d, .words = 1, .common_words = 1};
    FMB_TRY(fmb_run_open_num(run, &f->num, d + 1, false));
    FMB_TRY(FMB_ARRAYS(mem, true, FMB_ARRAY_ZERO(f->g.s, d), FMB_ARRAY(f->near, d),
                       FMB_ARRAY(f->common, f->words), FMB_ARRAY_ZERO(f->equation, d)));
    return open_vectors(f);
}

static void clear_facet_slot(fmb_facets *f, fmb_facet *a)
{
    fmb_mem *mem = f->num.mem;
    fmb_vec_clear(&a->normal, f->d + 1, mem);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(a->normal.s, f->d + 1), FMB_ARRAY(a->roughly, 2 * f->d),
                   FMB_ARRAY(a->on, a->words), FMB_ARRAY(a->next, a->next_capacity));
}

static void clear_vectors(fmb_vec *v, size_t count, size_t capacity, size_t n, fmb_mem *mem)
{
    for (size_t i = 0; v && i < count; i++) {
        fmb_vec_clear(&v[i], n, mem);
        fmb_mem_put(mem, v[i].s, n, sizeof *v[i].s);
    }
    fmb_mem_put(mem, v, capacity, sizeof *v);
}

void fmb_facets_clear(fmb_facets *f)
{
    fmb_mem *mem = f->num.mem;
    if (!f->num.scratch) /* nothing was made */
        return;
    for (size_t a = 0; a < f->slots; a++)
        clear_facet_slot(f, &f->facet[a]);
    clear_vectors(f->equation, f->d, f->d, f->d + 1, mem);
    fmb_normal_tools_clear(f, &(fmb_normal_tools){&f->num, f->minor});
    clear_vectors(f->generator, f->generators, f->generator_capacity, f->d, mem);
    fmb_vec_clear(&f->g, f->d, mem);
    FMB_ARRAYS_PUT(mem, FMB_ARRAY(f->g.s, f->d), FMB_ARRAY(f->near, f->d),
                   FMB_ARRAY(f->rounded, f->rounded_capacity),
                   FMB_ARRAY(f->common, f->common_words), FMB_ARRAY(f->holder, f->holder_capacity),
                   FMB_ARRAY(f->facet, f->facet_capacity), FMB_ARRAY(f->seen, f->seen_capacity),
                   FMB_ARRAY(f->touched, f->touched_capacity), FMB_ARRAY(f->made, f->made_capacity),
                   FMB_ARRAY(f->unused, f->unused_capacity));
    fmb_num_clear(&f->num);
}
