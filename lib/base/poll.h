/* poll.h: a callback that decides from time to time whether a computation goes on. */
#ifndef FMB_BASE_POLL_H
#define FMB_BASE_POLL_H

#include <fmb/base.h>

typedef struct fmb_poll {
    fmb_status (*ask)(void *with); /* any status but FMB_OK ends it; NULL: never */
    void *with;
} fmb_poll;

/* p may be NULL, which always answers FMB_OK. */
static inline fmb_status fmb_poll_ask(const fmb_poll *p)
{
    return p && p->ask ? p->ask(p->with) : FMB_OK;
}

#endif
