/* crew.c: see crew.h. */
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "crew.h"

static void progress(uint64_t done, uint64_t count, time_t *last)
{
    time_t now = time(NULL);
    if (now == *last || !isatty(STDERR_FILENO))
        return;
    *last = now;
    fprintf(stderr, "\r%llu/%llu ", (unsigned long long)done, (unsigned long long)count);
}

/* One process's share. */
static crew_sum work(crew_job *job, void *self, uint64_t first, uint64_t count, int processes,
                     int mine, size_t max_rows)
{
    crew_sum sum = {0};
    agree g = {.max_rows = max_rows};
    time_t last = 0;
    for (uint64_t i = (uint64_t)mine; i < count; i += (uint64_t)processes) {
        bool more = job(self, first + i, &g, &sum.failures);
        sum.jobs++;
        if (mine == 0)
            progress(i, count, &last);
        if (!more)
            break;
    }
    sum.questions = g.questions;
    sum.unjudged = g.unjudged;
    sum.by_proof = g.by_proof;
    sum.undecided = g.undecided;
    return sum;
}

static void start(int out, crew_job *job, void *self, uint64_t first, uint64_t count, int processes,
                  int mine, size_t max_rows)
{
    crew_sum sum = work(job, self, first, count, processes, mine, max_rows);
    bool written = write(out, &sum, sizeof sum) == (ssize_t)sizeof sum;
    _exit(written ? 0 : 1);
}

static void add(crew_sum *to, const crew_sum *more)
{
    to->jobs += more->jobs;
    to->failures += more->failures;
    to->questions += more->questions;
    to->unjudged += more->unjudged;
    to->by_proof += more->by_proof;
    to->undecided += more->undecided;
}

bool crew_run(crew_job *job, void *self, uint64_t first, uint64_t count, int processes,
              size_t max_rows, crew_sum *sum)
{
    int ends[2];
    bool good = pipe(ends) == 0;
    *sum = (crew_sum){0};
    for (int k = 0; good && k < processes; k++) {
        pid_t pid = fork();
        good = pid >= 0;
        if (pid == 0)
            start(ends[1], job, self, first, count, processes, k, max_rows);
    }
    for (int status; wait(&status) > 0;) {
        if (WIFSIGNALED(status))
            fprintf(stderr, "a process was killed by signal %d\n", WTERMSIG(status));
        good = good && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
    crew_sum part;
    for (int k = 0; good && k < processes; k++) {
        good = read(ends[0], &part, sizeof part) == (ssize_t)sizeof part;
        if (good)
            add(sum, &part);
    }
    return good;
}

bool crew_number(const char *arg, const char *name, uint64_t *out)
{
    size_t n = strlen(name);
    if (strncmp(arg, name, n) != 0)
        return false;
    *out = strtoull(arg + n, NULL, 10);
    return true;
}
