/* ranks_mpi.c: see ranks.h. Started by mpirun: MPI's own errors end all ranks. Counters stand in a
 * window of rank 0 and are read and raised at once (MPI-3, one-sided). */
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <mpi.h>

#include "common/message.h"
#include "common/ranks.h"

static struct {
    bool launched; /* else MPI is not asked anything */
    int rank, ranks;
    MPI_Win window; /* of the counters */
    uint64_t *counter;
} team = {.rank = 0, .ranks = 1};

/* Does a launcher say so? Without one MPI need not start, which takes a while. */
static bool was_launched(void)
{
    return getenv("OMPI_COMM_WORLD_SIZE") || getenv("PMI_SIZE") || getenv("PMIX_RANK");
}

int app_ranks_begin(size_t counters)
{
    int level;
    team.launched = was_launched();
    if (!team.launched) {
        team.counter = app_need(calloc(counters + 1, sizeof *team.counter));
        return APP_YES;
    }
    MPI_Init_thread(NULL, NULL, MPI_THREAD_SERIALIZED, &level);
    if (level < MPI_THREAD_SERIALIZED)
        return app_error(APP_INTERNAL, "this MPI does not bear threads");
    MPI_Comm_rank(MPI_COMM_WORLD, &team.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &team.ranks);
    MPI_Aint size = team.rank == 0 ? (MPI_Aint)((counters + 1) * sizeof *team.counter) : 0;
    MPI_Win_allocate(size, sizeof *team.counter, MPI_INFO_NULL, MPI_COMM_WORLD, &team.counter,
                     &team.window);
    MPI_Win_lock_all(0, team.window);
    if (team.rank == 0)
        memset(team.counter, 0, (size_t)size);
    MPI_Win_sync(team.window);
    MPI_Barrier(MPI_COMM_WORLD);
    return APP_YES;
}

void app_ranks_end(void)
{
    if (!team.launched) {
        free(team.counter);
        return;
    }
    MPI_Win_unlock_all(team.window);
    MPI_Win_free(&team.window);
    MPI_Finalize();
}

int app_ranks_fail(int code)
{
    if (team.ranks > 1)
        MPI_Abort(MPI_COMM_WORLD, code);
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

uint64_t app_ranks_take(size_t counter, uint64_t n)
{
    uint64_t was;
    if (!team.launched) {
        was = team.counter[counter];
        team.counter[counter] += n;
        return was;
    }
    MPI_Fetch_and_op(&n, &was, MPI_UINT64_T, 0, (MPI_Aint)counter, MPI_SUM, team.window);
    MPI_Win_flush(0, team.window);
    return was;
}

void app_ranks_sum(uint64_t *x, size_t n)
{
    if (team.ranks > 1)
        MPI_Reduce(team.rank == 0 ? MPI_IN_PLACE : x, x, (int)n, MPI_UINT64_T, MPI_SUM, 0,
                   MPI_COMM_WORLD);
}

void app_ranks_most(double *x, size_t n)
{
    if (team.ranks > 1)
        MPI_Reduce(team.rank == 0 ? MPI_IN_PLACE : x, x, (int)n, MPI_DOUBLE, MPI_MAX, 0,
                   MPI_COMM_WORLD);
}

/* The bytes of one rank after the other: any number, where MPI counts with an int. */
static void receive_bytes(int from, char *to, size_t n)
{
    for (size_t done = 0; done < n; done += INT_MAX) {
        int part = (int)(n - done < INT_MAX ? n - done : INT_MAX);
        MPI_Recv(to + done, part, MPI_BYTE, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
}

static void send_bytes(const char *x, size_t n)
{
    for (size_t done = 0; done < n; done += INT_MAX) {
        int part = (int)(n - done < INT_MAX ? n - done : INT_MAX);
        MPI_Send(x + done, part, MPI_BYTE, 0, 0, MPI_COMM_WORLD);
    }
}

void *app_ranks_gather(const void *x, size_t n, size_t *all)
{
    uint64_t mine = n, *size = app_need(calloc((size_t)team.ranks, sizeof *size));
    size[0] = n;
    if (team.ranks > 1)
        MPI_Gather(&mine, 1, MPI_UINT64_T, size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    char *out = NULL;
    *all = 0;
    if (team.rank > 0)
        send_bytes(x, n);
    for (int i = 0; team.rank == 0 && i < team.ranks; i++)
        *all += size[i];
    if (team.rank == 0)
        out = app_need(malloc(*all + 1));
    if (out && n > 0)
        memcpy(out, x, n);
    char *next = out;
    for (int i = 1; out && i < team.ranks; i++) {
        next += size[i - 1];
        receive_bytes(i, next, size[i]);
    }
    free(size);
    return out;
}
