/* hook.h: an allocator that counts, and fails on demand. */
#ifndef FMB_TEST_HOOK_H
#define FMB_TEST_HOOK_H

#include <fmb/base.h>

typedef struct hook {
    size_t live;    /* [bytes] */
    size_t calls;   /* requests for memory since hook_arm */
    size_t fail_at; /* the request that fails, from 1; 0: none */
    bool forever;   /* and all later ones */
} hook;

/* An allocator that lives in h. */
fmb_alloc hook_alloc(hook *h);
/* Count from 0 again, and fail request fail_at. */
void hook_arm(hook *h, size_t fail_at, bool forever);
/* Fail no more. */
void hook_calm(hook *h);

#endif
