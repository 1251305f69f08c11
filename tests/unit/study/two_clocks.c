/* two_clocks.c: preloaded into a program, clocks that count their readings. At each reading the
 * clock of the program's processor time advances by one second, the monotonic clock by WALL_STEP
 * seconds, an environment variable. */
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
