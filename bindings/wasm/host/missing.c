/* missing.c: functions that the command needs and the C library of Emscripten lacks, or cannot do
 * with the files of Node. */
#define _GNU_SOURCE
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <sys/mman.h>
#include <time.h>

/* Sets the program's name for messages. */
__attribute__((constructor)) static void name_program(void)
{
    static char name[] = "fmb";
    program_invocation_name = program_invocation_short_name = name;
}

/* Buffers standard output in blocks of 64 KiB, the size of a pipe in Linux: a reader that closes
 * after the first line does not end the command before it has written its files. */
__attribute__((constructor)) static void widen_output(void)
{
    static char block[1 << 16];
    setvbuf(stdout, block, _IOFBF, sizeof block);
}

/* Never waits: the reads themselves block. */
int poll(struct pollfd *fds, nfds_t n, int patience)
{
    (void)patience;
    for (nfds_t i = 0; i < n; i++)
        fds[i].revents = fds[i].events;
    return (int)n;
}

int ppoll(struct pollfd *fds, nfds_t n, const struct timespec *patience, const sigset_t *mask)
{
    (void)patience;
    (void)mask;
    return poll(fds, n, 0);
}

/* Not available; the command works without it. */
int memfd_create(const char *name, unsigned flags)
{
    (void)name;
    (void)flags;
    errno = ENOSYS;
    return -1;
}
