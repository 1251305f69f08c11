/* hook.c: an allocator that counts, and fails on demand. See hook.h. */
#include <stdlib.h>

#include "hook.h"

static void *resize(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    hook *h = self;
    if (new_bytes == 0) {
        free(p);
        h->live -= old_bytes;
        return NULL;
    }
    h->calls++;
    if (h->fail_at && (h->forever ? h->calls >= h->fail_at : h->calls == h->fail_at))
        return NULL;
    void *q = realloc(p, new_bytes);
    if (q)
        h->live += new_bytes - old_bytes;
    return q;
}

fmb_alloc hook_alloc(hook *h)
{
    return (fmb_alloc){resize, h};
}

void hook_arm(hook *h, size_t fail_at, bool forever)
{
    h->calls = 0;
    h->fail_at = fail_at;
    h->forever = forever;
}

void hook_calm(hook *h)
{
    hook_arm(h, 0, false);
}
