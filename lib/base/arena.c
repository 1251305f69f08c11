/* arena.c: chunks in a list, each at least twice as large as needed at first; see arena.h. */
#include "base/arena.h"

#include <string.h>

#define FIRST_CHUNK   ((size_t)16384)
#define LARGEST_CHUNK ((size_t)1 << 22)

struct fmb_chunk {
    fmb_chunk *next;
    size_t size; /* [bytes] of data */
    _Alignas(16) unsigned char data[];
};

void fmb_arena_init(fmb_arena *a, fmb_mem *mem)
{
    *a = (fmb_arena){.mem = mem};
}

/* From the next chunk if it is large enough, else a new one. Apart, as most calls need neither. */
static __attribute__((noinline)) void *get_from_roomy_chunk(fmb_arena *a, size_t bytes)
{
    fmb_chunk *next = a->current ? a->current->next : a->first;
    if (!next || next->size < bytes) {
        size_t size = a->current ? 2 * a->current->size : FIRST_CHUNK;
        size = size > LARGEST_CHUNK ? LARGEST_CHUNK : size;
        size = size < bytes ? bytes : size;
        fmb_chunk *fresh = fmb_mem_get(a->mem, sizeof *fresh + size, 1);
        if (!fresh)
            return NULL;
        *fresh = (fmb_chunk){.next = next, .size = size};
        *(a->current ? &a->current->next : &a->first) = fresh;
        next = fresh;
    }
    a->current = next;
    a->at = bytes;
    return next->data;
}

void *fmb_arena_get(fmb_arena *a, size_t count, size_t size)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes) || bytes > PTRDIFF_MAX / 2) {
        a->mem->over = false;
        return NULL;
    }
    bytes = (bytes + 15) & ~(size_t)15;
    if (!a->current || a->current->size - a->at < bytes)
        return get_from_roomy_chunk(a, bytes);
    a->at += bytes;
    return a->current->data + a->at - bytes;
}

fmb_status fmb_arena_reserve(fmb_arena *a, void **p, size_t *capacity, size_t need, size_t size)
{
    if (need <= *capacity)
        return FMB_OK;
    size_t count = 2 * *capacity > need ? 2 * *capacity : need < 32 ? 32 : need;
    void *q = fmb_arena_get(a, count, size);
    if (!q)
        return fmb_mem_status(a->mem);
    if (*capacity > 0)
        memcpy(q, *p, *capacity * size);
    *p = q;
    *capacity = count;
    return FMB_OK;
}

void fmb_arena_reset(fmb_arena *a)
{
    a->current = NULL;
    a->at = 0;
}

fmb_arena_place fmb_arena_tell(const fmb_arena *a)
{
    return (fmb_arena_place){a->current, a->at};
}

void fmb_arena_rewind(fmb_arena *a, fmb_arena_place to)
{
    a->current = to.current;
    a->at = to.at;
}

void fmb_arena_trim(fmb_arena *a)
{
    fmb_chunk **rest = a->current ? &a->current->next : &a->first;
    for (fmb_chunk *c = *rest; c;) {
        fmb_chunk *next = c->next;
        fmb_mem_put(a->mem, c, sizeof *c + c->size, 1);
        c = next;
    }
    *rest = NULL;
}

void fmb_arena_clear(fmb_arena *a)
{
    fmb_arena_reset(a);
    fmb_arena_trim(a);
}
