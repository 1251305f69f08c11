/* poll.h: somebody to ask from time to time whether to go on. */
#ifndef FMB_BASE_POLL_H
#define FMB_BASE_POLL_H

#include <fmb/base.h>

typedef struct fmb_poll {
    fmb_status (*ask)(void *with); /* anything but FMB_OK ends it; NULL: for ever */
    void *with;
} fmb_poll;

/* p NULL: for ever, too. */
static inline fmb_status fmb_poll_ask(const fmb_poll *p)
{
    return p && p->ask ? p->ask(p->with) : FMB_OK;
}

#endif
