/* missing.c: what the command asks for and the C library of Emscripten lacks. */
#define _GNU_SOURCE
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

/* Its own name, in messages. */
__attribute__((constructor)) static void name_program(void)
{
    static char name[] = "fmb";
    program_invocation_name = program_invocation_short_name = name;
}

/* No signal ever comes, so that none is to be held back meanwhile. */
int ppoll(struct pollfd *fds, nfds_t n, const struct timespec *patience, const sigset_t *mask)
{
    (void)mask;
    return poll(fds, n,
                patience ? (int)(patience->tv_sec * 1000 + patience->tv_nsec / 1000000) : -1);
}

/* A file that has lost its name. */
int memfd_create(const char *name, unsigned flags)
{
    char path[] = "/tmp/fmb.XXXXXX";
    int descriptor = mkstemp(path);
    (void)name;
    (void)flags;
    if (descriptor >= 0)
        unlink(path);
    return descriptor;
}
