/* mem.c: allocation with a count and a limit; see mem.h. */
#include "base/mem.h"

#include <stdlib.h>
#include <string.h>

/* ---- the usual allocator --------------------------------------------------------------------- */

/* Blocks have one of few sizes: 16 to 64 bytes by steps of 16, then four sizes for each power of
 * two up to SMALL_BLOCK; larger ones are as large as asked for. */
enum { SMALL_BLOCK = 1 << 16, STEP_BITS = 4, LEAST_SPLIT = 2 };

/* The number of the size of a block for so many bytes, 1 to SMALL_BLOCK: with s = ceil(bytes / 16)
 * it is s - 1 up to 4; then, where 2^k < s <= 2^(k + 1), that of s in quarters of 2^k. */
static unsigned size_class(size_t bytes)
{
    size_t last = (bytes - 1) >> STEP_BITS; /* s - 1 */
    if (last < 1u << LEAST_SPLIT)
        return (unsigned)last;
    unsigned k = 63u - (unsigned)__builtin_clzll(last);
    return (unsigned)(last >> (k - LEAST_SPLIT)) + ((k - LEAST_SPLIT) << LEAST_SPLIT);
}

/* What a block for so many bytes holds. */
static size_t block_bytes(size_t bytes)
{
    size_t last = (bytes - 1) >> STEP_BITS;
    if (bytes > SMALL_BLOCK)
        return bytes;
    if (last < 1u << LEAST_SPLIT)
        return (last + 1) << STEP_BITS;
    unsigned shift = 63u - (unsigned)__builtin_clzll(last) - LEAST_SPLIT;
    return ((last >> shift) + 1) << (shift + STEP_BITS);
}

static void *resize_by_realloc(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    (void)self;
    (void)old_bytes;
    if (new_bytes == 0) {
        free(p);
        return NULL;
    }
    return realloc(p, block_bytes(new_bytes));
}

/* ---- blocks that wait ------------------------------------------------------------------------ */

/* More does not wait [bytes]. */
#define MOST_WAITING ((size_t)1 << 18)

/* Where a sanitizer is to see every block released, none waits. */
#if defined(__SANITIZE_ADDRESS__)
#define SEES_BLOCKS true
#elif defined(__has_feature)
#define SEES_BLOCKS __has_feature(address_sanitizer)
#else
#define SEES_BLOCKS false
#endif

void fmb_mem_use_pool(fmb_mem *m, fmb_pool *p)
{
    m->pool = !SEES_BLOCKS && m->alloc.resize == resize_by_realloc ? p : NULL;
}

void fmb_pool_clear(fmb_pool *p)
{
    for (int k = 0; k < FMB_POOL_CLASSES; k++) {
        while (p->first[k]) {
            void *block = p->first[k];
            memcpy(&p->first[k], block, sizeof block);
            free(block);
        }
    }
    p->bytes = 0;
}

/* A block that waited, or NULL. */
static void *take_from_pool(fmb_pool *p, size_t bytes)
{
    void **first = &p->first[size_class(bytes)], *block = *first;
    if (!block)
        return NULL;
    memcpy(first, block, sizeof block);
    p->bytes -= block_bytes(bytes);
    return block;
}

static bool leave_in_pool(fmb_pool *p, void *block, size_t bytes)
{
    void **first = &p->first[size_class(bytes)];
    if (p->bytes >= MOST_WAITING)
        return false;
    memcpy(block, first, sizeof block);
    *first = block;
    p->bytes += block_bytes(bytes);
    return true;
}

/* p, of old bytes (0: none), becomes a block of so many (0: none). */
static void *resize(fmb_mem *m, void *p, size_t old, size_t bytes)
{
    bool waits = m->pool && old <= SMALL_BLOCK && bytes <= SMALL_BLOCK;
    if (waits && old > 0 && bytes > 0 && size_class(old) == size_class(bytes))
        return p;
    void *q = waits && bytes > 0 ? take_from_pool(m->pool, bytes) : NULL;
    if (q && old > 0)
        memcpy(q, p, old < bytes ? old : bytes);
    if (!q && bytes > 0)
        return m->alloc.resize(m->alloc.self, p, old, bytes);
    if (old > 0 && !(waits && leave_in_pool(m->pool, p, old)))
        m->alloc.resize(m->alloc.self, p, old, 0);
    return q;
}

/* ---- blocks ---------------------------------------------------------------------------------- */

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
    void *q = resize(m, p, before, bytes);
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
    resize(m, p, bytes, 0);
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
