/* budget.c: see budget.h. What is read may be given back by any thread. */
#include "common/budget.h"

#include <gmp.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "common/need.h"

static size_t limit;
static atomic_size_t held;
static bool is_spent;

/* What a block really takes: its room, and the word in front of it. */
static size_t size_of_block(void *p)
{
    return p ? malloc_usable_size(p) + sizeof(size_t) : 0;
}

static void *resize(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    (void)self;
    (void)old_bytes;
    size_t before = size_of_block(p), after = new_bytes + sizeof(size_t);
    if (new_bytes == 0) {
        free(p);
        atomic_fetch_sub(&held, before);
        return NULL;
    }
    if (limit > 0 && after > before && atomic_load(&held) - before + after > limit) {
        is_spent = true;
        return NULL;
    }
    void *q = realloc(p, new_bytes);
    if (q)
        atomic_fetch_add(&held, size_of_block(q) - before); /* modulo a power of two */
    return q;
}

/* ---- limbs of GMP: counted while all is read, but never refused, as GMP would end the process ---
 */

static void *count_new_limbs(size_t bytes)
{
    void *p = app_need(malloc(bytes));
    atomic_fetch_add(&held, size_of_block(p));
    return p;
}

static void *count_grown_limbs(void *p, size_t old_bytes, size_t new_bytes)
{
    (void)old_bytes;
    atomic_fetch_sub(&held, size_of_block(p));
    void *q = app_need(realloc(p, new_bytes));
    atomic_fetch_add(&held, size_of_block(q));
    return q;
}

static void count_freed_limbs(void *p, size_t bytes)
{
    (void)bytes;
    atomic_fetch_sub(&held, size_of_block(p));
    free(p);
}

/* ---- the budget ------------------------------------------------------------------------------ */

void app_budget_begin(size_t bytes)
{
    limit = bytes;
    if (bytes > 0)
        mp_set_memory_functions(count_new_limbs, count_grown_limbs, count_freed_limbs);
}

const fmb_alloc *app_budget_alloc(void)
{
    static const fmb_alloc counting = {.resize = resize};
    return &counting;
}

bool app_budget_is_spent(void)
{
    return is_spent;
}

size_t app_budget_end(void)
{
    size_t all = limit, used = atomic_load(&held);
    limit = 0;
    app_need_limbs();
    if (all == 0)
        return 0;
    return used < all ? all - used : 1;
}
