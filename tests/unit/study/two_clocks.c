/* two_clocks.c: loaded before a program, clocks that count how often they are asked. At each
 * reading that of the program's processor time is a second later, and the monotonic one as many
 * seconds as the environment's WALL_STEP says. */
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

int clock_gettime(clockid_t clock, struct timespec *t)
{
    static atomic_int wall, processor;
    const char *step = getenv("WALL_STEP");
    if (clock == CLOCK_MONOTONIC)
        *t = (struct timespec){.tv_sec = (time_t)(++wall) * (step ? atoi(step) : 0)};
    else if (clock == CLOCK_PROCESS_CPUTIME_ID)
        *t = (struct timespec){.tv_sec = ++processor};
    else
        return (int)syscall(SYS_clock_gettime, clock, t);
    return 0;
}
