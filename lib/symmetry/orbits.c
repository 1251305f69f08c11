/* orbits.c: see orbits.h. */
#include "symmetry/orbits.h"

#include <string.h>

/* Most images of one vector: more are not worth their memory. */
#define MOST_IMAGES 4096

/* ---- life ------------------------------------------------------------------------------------ */

/* The place of a column in kept[]. */
static uint32_t place_of_column(const int *kept, size_t k, uint32_t column)
{
    size_t j = 0;
    while (j + 1 < k && kept[j] != (int)column)
        j++;
    return (uint32_t)j;
}

fmb_status fmb_orbits_init(fmb_orbits *o, fmb_run *run, const fmb_group *group, const int *kept,
                           size_t k)
{
    *o = (fmb_orbits){.run = run, .group = group, .k = k};
    FMB_TRY(FMB_GET(run->mem, o->place, group->size * k));
    for (size_t g = 0; g < group->size; g++)
        for (size_t j = 0; j < k; j++)
            o->place[g * k + j] = place_of_column(kept, k, group->image[g][kept[j]]);
    return FMB_OK;
}

void fmb_orbits_clear(fmb_orbits *o)
{
    if (!o->run)
        return;
    fmb_mem *mem = o->run->mem;
    for (size_t i = 0; i < o->size; i++) {
        fmb_vec_clear(&o->item[i].v, o->k + 1, mem);
        fmb_mem_put(mem, o->item[i].v.s, o->k + 1, sizeof *o->item[i].v.s);
    }
    fmb_mem_put(mem, o->item, o->capacity, sizeof *o->item);
    fmb_mem_put(mem, o->slot, o->slots, sizeof *o->slot);
    fmb_mem_put(mem, o->place, o->group->size * o->k, sizeof *o->place);
    *o = (fmb_orbits){0};
}

/* ---- the hash table -------------------------------------------------------------------------- */

/* The slot of v, or the free slot for it; at least one slot is free. */
static size_t find_slot(const fmb_orbits *o, const fmb_vec *v)
{
    size_t at = (size_t)fmb_vec_hash(v, o->k + 1) & (o->slots - 1);
    while (o->slot[at] != UINT32_MAX && !fmb_vec_equal(&o->item[o->slot[at]].v, v, o->k + 1))
        at = (at + 1) & (o->slots - 1);
    return at;
}

static fmb_status double_slots(fmb_orbits *o)
{
    size_t slots = o->slots > 0 ? 2 * o->slots : 64;
    uint32_t *slot;
    FMB_TRY(FMB_GET(o->run->mem, slot, slots));
    memset(slot, 0xff, slots * sizeof *slot);
    fmb_mem_put(o->run->mem, o->slot, o->slots, sizeof *o->slot);
    o->slot = slot;
    o->slots = slots;
    for (size_t i = 0; i < o->size; i++)
        slot[find_slot(o, &o->item[i].v)] = (uint32_t)i;
    return FMB_OK;
}

size_t fmb_orbits_find(const fmb_orbits *o, const fmb_vec *v)
{
    uint32_t at = o->slots > 0 ? o->slot[find_slot(o, v)] : UINT32_MAX;
    return at == UINT32_MAX ? SIZE_MAX : at;
}

/* ---- orbits ---------------------------------------------------------------------------------- */

/* to = the image of v under generator g. `to` has memory for k + 1 small entries. */
static fmb_status move_vector(const fmb_orbits *o, const fmb_vec *v, size_t g, fmb_vec *to)
{
    FMB_TRY(fmb_vec_copy(to, v, o->k + 1, o->run->mem));
    for (size_t j = 0; j < o->k; j++) {
        size_t at = o->place[g * o->k + j] + 1;
        if (v->z)
            mpz_set(to->z[at], v->z[j + 1]);
        else
            to->s[at] = v->s[j + 1];
    }
    return v->z ? fmb_vec_settle(to, o->k + 1, o->run->mem) : FMB_OK;
}

/* Make one more item, undefined except for its origin; keep_item_if_new counts it. */
static fmb_status make_item(fmb_orbits *o, uint32_t from, uint32_t by, size_t tag)
{
    fmb_mem *mem = o->run->mem;
    FMB_TRY(FMB_RESERVE(mem, &o->item, &o->capacity, o->size + 1));
    if (2 * (o->size + 1) > o->slots)
        FMB_TRY(double_slots(o));
    fmb_orbit_vector *t = &o->item[o->size];
    *t = (fmb_orbit_vector){.from = from, .by = by, .tag = tag};
    t->v.s = fmb_mem_zero(mem, o->k + 1, sizeof *t->v.s);
    return t->v.s ? FMB_OK : fmb_mem_status(mem);
}

static void drop_item(fmb_orbits *o)
{
    fmb_vec *v = &o->item[o->size].v;
    fmb_vec_clear(v, o->k + 1, o->run->mem);
    fmb_mem_put(o->run->mem, v->s, o->k + 1, sizeof *v->s);
}

/* Count the vector at the end of the items unless an equal one exists. */
static void keep_item_if_new(fmb_orbits *o)
{
    size_t at = find_slot(o, &o->item[o->size].v);
    if (o->slot[at] == UINT32_MAX)
        o->slot[at] = (uint32_t)o->size++;
    else
        drop_item(o);
}

static fmb_status add_image(fmb_orbits *o, size_t item, size_t g)
{
    FMB_TRY(make_item(o, (uint32_t)item, (uint32_t)g, SIZE_MAX));
    fmb_status st = move_vector(o, &o->item[item].v, g, &o->item[o->size].v);
    if (st == FMB_OK)
        keep_item_if_new(o);
    else
        drop_item(o);
    return st;
}

fmb_status fmb_orbits_add(fmb_orbits *o, const fmb_vec *v, size_t tag)
{
    size_t first = o->size;
    FMB_TRY(make_item(o, FMB_ORBIT_ROOT, 0, tag));
    fmb_status st = fmb_vec_copy(&o->item[first].v, v, o->k + 1, o->run->mem);
    if (st == FMB_OK)
        keep_item_if_new(o);
    else
        drop_item(o);
    for (size_t i = first; st == FMB_OK && i < o->size && o->size - first < MOST_IMAGES; i++) {
        for (size_t g = 0; st == FMB_OK && g < o->group->size; g++)
            st = add_image(o, i, g);
        FMB_THEN(st, fmb_run_poll(o->run));
    }
    return st;
}

size_t fmb_orbits_root(const fmb_orbits *o, size_t item)
{
    while (o->item[item].from != FMB_ORBIT_ROOT)
        item = o->item[item].from;
    return item;
}

/* The image of the row under the generators that lead to the item. */
static uint32_t move_row(const fmb_orbits *o, size_t item, uint32_t row)
{
    const fmb_orbit_vector *t = &o->item[item];
    return t->from == FMB_ORBIT_ROOT
               ? row
               : o->group->image[t->by][o->group->n + move_row(o, t->from, row)];
}

fmb_status fmb_orbits_move_weights(const fmb_orbits *o, size_t item, const fmb_weights *from,
                                   fmb_weights *to)
{
    for (size_t i = 0; i < from->size; i++)
        FMB_TRY(
            fmb_weights_add(to, move_row(o, item, from->index[i]), from->value[i], o->run->mem));
    return FMB_OK;
}
