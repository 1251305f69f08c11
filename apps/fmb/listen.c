/* listen.c: see listen.h. A signal may arrive just before a wait begins: signals are blocked until
 * ppoll, which atomically unblocks them and returns if one arrives. Writing calls are restarted
 * after a signal (signals.h), so no answer is lost. */
#include "fmb/listen.h"

#include <poll.h>
#include <signal.h>
#include <sys/types.h>
#include <unistd.h>

#include "common/signals.h"
#include "fmb/stop.h"

/* Wait until there is input, its end, or a signal. */
static void wait_for(struct pollfd *p)
{
    sigset_t held, before;
    app_signals_fill(&held);
    sigprocmask(SIG_BLOCK, &held, &before);
    if (!app_stop_asked())
        ppoll(p, 1, NULL, &before);
    sigprocmask(SIG_SETMASK, &before, NULL);
}

static ssize_t take(void *cookie, char *to, size_t size)
{
    const app_listener *l = cookie;
    struct pollfd p = {.fd = fileno(l->in), .events = POLLIN};
    if (poll(&p, 1, 0) == 0) {
        l->idle(l->self);
        wait_for(&p);
    }
    return app_stop_asked() ? 0 : read(p.fd, to, size);
}

FILE *app_listen(app_listener *l)
{
    FILE *heard = fopencookie(l, "r", (cookie_io_functions_t){.read = take});
    if (heard)
        setvbuf(heard, l->room, _IOFBF, sizeof l->room);
    return heard;
}
