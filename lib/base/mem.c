/* mem.c: allocation with a count and a limit; see mem.h. */
#include "base/mem.h"

#include <stdlib.h>
#include <string.h>

static void *resize_by_realloc(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    (void)self;
    (void)old_bytes;
    if (new_bytes == 0) {
        free(p);
        return NULL;
    }
    return p ? realloc(p, new_bytes) : malloc(new_bytes); /* which is quicker */
}

void fmb_mem_init(fmb_mem *m, const fmb_alloc *hook, size_t limit)
{
    *m = (fmb_mem){.limit = limit};
    m->alloc = hook ? *hook : (fmb_alloc){resize_by_realloc, NULL};
}

static void count(fmb_mem *m, size_t bytes)
{
    m->used += bytes;
    if (m->used > m->peak)
        m->peak = m->used;
}

bool fmb_mem_charge(fmb_mem *m, size_t bytes)
{
    bool over = m->limit > 0 && (bytes > m->limit || m->used > m->limit - bytes);
    if (over || (m->within && !fmb_mem_charge(m->within, bytes))) {
        m->over = true;
        return false;
    }
    count(m, bytes);
    return true;
}

void fmb_mem_refund(fmb_mem *m, size_t bytes)
{
    m->used -= bytes;
    if (m->within)
        m->within->used -= bytes;
}

void fmb_mem_take(fmb_mem *m, size_t bytes)
{
    count(m, bytes);
    if (m->within)
        count(m->within, bytes);
}

void fmb_mem_enter(fmb_mem *m, fmb_mem *outer)
{
    m->within = outer;
    count(outer, m->used);
}

void fmb_mem_leave(fmb_mem *m)
{
    if (m->within)
        m->within->used -= m->used;
    m->within = NULL;
}

/* count * size, at least 1, or false on overflow. */
static bool multiply_sizes(size_t count, size_t size, size_t *bytes)
{
    if (__builtin_mul_overflow(count, size, bytes) || *bytes > PTRDIFF_MAX)
        return false;
    if (*bytes == 0)
        *bytes = 1;
    return true;
}

void *fmb_mem_grow(fmb_mem *m, void *p, size_t old, size_t count, size_t size)
{
    size_t before = 0, bytes;
    if (p)
        (void)multiply_sizes(old, size, &before);
    if (!multiply_sizes(count, size, &bytes)) {
        m->over = false;
        return NULL;
    }
    if (bytes > before && !fmb_mem_charge(m, bytes - before))
        return NULL;
    void *q = m->alloc.resize(m->alloc.self, p, before, bytes);
    m->over = m->over && q;
    if (!q && bytes > before)
        fmb_mem_refund(m, bytes - before);
    else if (q && bytes < before)
        fmb_mem_refund(m, before - bytes);
    return q;
}

void *fmb_mem_get(fmb_mem *m, size_t count, size_t size)
{
    return fmb_mem_grow(m, NULL, 0, count, size);
}

void *fmb_mem_zero(fmb_mem *m, size_t count, size_t size)
{
    void *p = fmb_mem_get(m, count, size);
    if (p)
        memset(p, 0, count * size);
    return p;
}

void fmb_mem_put(fmb_mem *m, void *p, size_t count, size_t size)
{
    if (!p)
        return;
    size_t bytes = 0;
    (void)multiply_sizes(count, size, &bytes);
    m->alloc.resize(m->alloc.self, p, bytes, 0);
    fmb_mem_refund(m, bytes);
}

fmb_status fmb_mem_reserve(fmb_mem *m, void **p, size_t *capacity, size_t need, size_t size)
{
    if (need <= *capacity)
        return FMB_OK;
    size_t count = *capacity + *capacity / 2 + 8;
    if (count < need)
        count = need;
    void *q = fmb_mem_grow(m, *p, *capacity, count, size);
    if (!q)
        return fmb_mem_status(m);
    *p = q;
    *capacity = count;
    return FMB_OK;
}

fmb_status fmb_mem_status(const fmb_mem *m)
{
    return m->over ? FMB_LIMIT : FMB_ERR_MEMORY;
}

char *fmb_mem_text(fmb_mem *m, const char *s)
{
    size_t n = strlen(s) + 1;
    char *p = fmb_mem_get(m, n, 1);
    if (p)
        memcpy(p, s, n);
    return p;
}

void fmb_mem_put_text(fmb_mem *m, char *s)
{
    if (s)
        fmb_mem_put(m, s, strlen(s) + 1, 1);
}
