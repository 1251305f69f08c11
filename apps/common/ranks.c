/* ranks.c: see ranks.h. A single process has its counters here; the module joins several. */
#include "common/ranks.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/module.h"
#include "common/ranks_module.h"

static struct {
    const app_ranks_module *by; /* NULL: alone */
    uint64_t *counter;          /* then */
    int rank, ranks;
} team = {.rank = 0, .ranks = 1};

/* ---- the module ------------------------------------------------------------------------------ */

/* Has a launcher started several processes? Their number as it says, or "some"; else NULL. */
static const char *count_launched(void)
{
    static const char *const of[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        if (getenv(of[i]))
            return getenv(of[i]);
    return getenv("PMIX_RANK") ? "some" : NULL;
}

#ifdef APP_RANKS_MODULE
/* MPI loads plug-ins, which must find its symbols. */
static int join_by_module(const char *processes, size_t counters)
{
    team.by = app_module_symbol("ranks-mpi", "app_ranks_mpi");
    if (!team.by)
        return app_error(APP_USAGE, "one of %s processes, but no module for MPI: %s", processes,
                         dlerror());
    if (!team.by->begin(counters, &team.rank, &team.ranks))
        return app_error(APP_INTERNAL, "this MPI does not bear threads");
    return APP_YES;
}
#else
static int join_by_module(const char *processes, size_t counters)
{
    (void)counters;
    return app_error(APP_USAGE, "one of %s processes, but built without MPI", processes);
}
#endif

int app_ranks_begin(size_t counters)
{
    const char *processes = count_launched();
    if (processes && strcmp(processes, "1") != 0)
        return join_by_module(processes, counters);
    team.counter = app_need(calloc(counters + 1, sizeof *team.counter));
    return APP_YES;
}

void app_ranks_end(void)
{
    free(team.counter);
    if (team.by)
        team.by->end();
}

int app_ranks_agree(int code)
{
    app_ranks_share(&code, sizeof code);
    return code;
}

int app_ranks_fail(int code)
{
    if (team.by)
        team.by->abort(code);
    return code;
}

int app_rank(void)
{
    return team.rank;
}

int app_ranks(void)
{
    return team.ranks;
}

/* ---- work and its results -------------------------------------------------------------------- */

uint64_t app_ranks_take(size_t counter, uint64_t n)
{
    if (team.by)
        return team.by->take(counter, n);
    uint64_t was = team.counter[counter];
    team.counter[counter] += n;
    return was;
}

void app_ranks_sum(uint64_t *x, size_t n)
{
    if (team.by)
        team.by->sum(x, n);
}

void app_ranks_most(double *x, size_t n)
{
    if (team.by)
        team.by->most(x, n);
}

void app_ranks_share(void *x, size_t n)
{
    if (team.by)
        team.by->share(x, n);
}

void *app_ranks_gather(const void *x, size_t n, size_t *all)
{
    uint64_t *size = app_need(calloc((size_t)team.ranks, sizeof *size));
    char *out = NULL;
    *all = 0;
    size[0] = n;
    if (team.by)
        team.by->list(n, size);
    for (int i = 0; team.rank == 0 && i < team.ranks; i++)
        *all += (size_t)size[i];
    if (team.rank > 0)
        team.by->send(x, n);
    else
        out = app_need(malloc(*all + 1));
    if (out && n > 0)
        memcpy(out, x, n);
    char *next = out;
    for (int i = 1; out && i < team.ranks; i++) {
        next += size[i - 1];
        team.by->receive(i, next, (size_t)size[i]);
    }
    free(size);
    return out;
}
