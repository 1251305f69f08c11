/* names.c: variable names in a hash table; see names.h. */
#include "system/names.h"

#include <string.h>

/* FNV-1a. */
static size_t hash(const char *s)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (; *s; s++)
        h = (h ^ (unsigned char)*s) * 0x100000001b3u;
    return (size_t)(h ^ h >> 29);
}

/* The slot of name, or the free slot for it. */
static size_t slot_of(const fmb_names *t, const char *name)
{
    size_t i = hash(name) & (t->slots - 1);
    while (t->slot[i] >= 0 && strcmp(t->name[t->slot[i]], name) != 0)
        i = (i + 1) & (t->slots - 1);
    return i;
}

static void refill(fmb_names *t)
{
    for (size_t i = 0; i < t->slots; i++)
        t->slot[i] = -1;
    for (size_t j = 0; j < t->size; j++)
        t->slot[slot_of(t, t->name[j])] = (int)j;
}

static fmb_status reserve_slots(fmb_names *t, fmb_mem *mem)
{
    size_t slots = t->slots ? t->slots : 16;
    while (slots <= 2 * (t->size + 1))
        slots *= 2;
    if (slots == t->slots)
        return FMB_OK;
    int *slot;
    FMB_TRY(FMB_GET(mem, slot, slots));
    fmb_mem_put(mem, t->slot, t->slots, sizeof *slot);
    t->slot = slot;
    t->slots = slots;
    refill(t);
    return FMB_OK;
}

fmb_status fmb_names_add(fmb_names *t, const char *name, fmb_mem *mem)
{
    FMB_TRY(reserve_slots(t, mem));
    FMB_TRY(FMB_RESERVE(mem, &t->name, &t->capacity, t->size + 1));
    char *copy = fmb_mem_text(mem, name);
    if (!copy)
        return fmb_mem_status(mem);
    t->slot[slot_of(t, name)] = (int)t->size;
    t->name[t->size++] = copy;
    return FMB_OK;
}

fmb_status fmb_names_change(fmb_names *t, int j, const char *name, fmb_mem *mem)
{
    char *copy = fmb_mem_text(mem, name);
    if (!copy)
        return fmb_mem_status(mem);
    fmb_mem_put_text(mem, t->name[j]);
    t->name[j] = copy;
    refill(t);
    return FMB_OK;
}

void fmb_names_drop_last(fmb_names *t, fmb_mem *mem)
{
    fmb_mem_put_text(mem, t->name[--t->size]);
    refill(t);
}

int fmb_names_find(const fmb_names *t, const char *name)
{
    return t->slots ? t->slot[slot_of(t, name)] : -1;
}

void fmb_names_clear(fmb_names *t, fmb_mem *mem)
{
    for (size_t j = 0; j < t->size; j++)
        fmb_mem_put_text(mem, t->name[j]);
    fmb_mem_put(mem, t->name, t->capacity, sizeof *t->name);
    fmb_mem_put(mem, t->slot, t->slots, sizeof *t->slot);
    *t = (fmb_names){0};
}
