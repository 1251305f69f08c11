/* ranks_mpi.c: see ranks_module.h. MPI's own errors end all ranks. Counters stand in a window of
 * rank 0 and are read and raised at once (MPI-3, one-sided). */
#include <limits.h>
#include <string.h>

#include <mpi.h>

#include "common/ranks_module.h"

static MPI_Win window; /* of the counters */

static bool begin_mpi(size_t counters, int *rank, int *ranks)
{
    int level;
    uint64_t *counter;
    MPI_Init_thread(NULL, NULL, MPI_THREAD_SERIALIZED, &level);
    if (level < MPI_THREAD_SERIALIZED)
        return false;
    MPI_Comm_rank(MPI_COMM_WORLD, rank);
    MPI_Comm_size(MPI_COMM_WORLD, ranks);
    MPI_Aint size = *rank == 0 ? (MPI_Aint)((counters + 1) * sizeof *counter) : 0;
    MPI_Win_allocate(size, sizeof *counter, MPI_INFO_NULL, MPI_COMM_WORLD, &counter, &window);
    MPI_Win_lock_all(0, window);
    if (*rank == 0)
        memset(counter, 0, (size_t)size);
    MPI_Win_sync(window);
    MPI_Barrier(MPI_COMM_WORLD);
    return true;
}

static void end_mpi(void)
{
    MPI_Win_unlock_all(window);
    MPI_Win_free(&window);
    MPI_Finalize();
}

static void abort_all_ranks(int code)
{
    MPI_Abort(MPI_COMM_WORLD, code);
}

static uint64_t raise_counter_of_rank_0(size_t counter, uint64_t n)
{
    uint64_t was;
    MPI_Fetch_and_op(&n, &was, MPI_UINT64_T, 0, (MPI_Aint)counter, MPI_SUM, window);
    MPI_Win_flush(0, window);
    return was;
}

static void reduce_to_rank_0(void *x, size_t n, MPI_Datatype type, MPI_Op op)
{
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Reduce(rank == 0 ? MPI_IN_PLACE : x, x, (int)n, type, op, 0, MPI_COMM_WORLD);
}

static void sum_over_ranks(uint64_t *x, size_t n)
{
    reduce_to_rank_0(x, n, MPI_UINT64_T, MPI_SUM);
}

static void largest_of_ranks(double *x, size_t n)
{
    reduce_to_rank_0(x, n, MPI_DOUBLE, MPI_MAX);
}

static void list_by_rank(uint64_t mine, uint64_t *all)
{
    MPI_Gather(&mine, 1, MPI_UINT64_T, all, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
}

/* ---- bytes: any number, where MPI counts with an int ------------------------------------------
 */

static int piece_of(size_t n, size_t done)
{
    return (int)(n - done < INT_MAX ? n - done : INT_MAX);
}

static void share_bytes(void *x, size_t n)
{
    for (size_t done = 0; done < n; done += INT_MAX)
        MPI_Bcast((char *)x + done, piece_of(n, done), MPI_BYTE, 0, MPI_COMM_WORLD);
}

static void receive_bytes(int from, void *x, size_t n)
{
    for (size_t done = 0; done < n; done += INT_MAX)
        MPI_Recv((char *)x + done, piece_of(n, done), MPI_BYTE, from, 0, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
}

static void send_bytes(const void *x, size_t n)
{
    for (size_t done = 0; done < n; done += INT_MAX)
        MPI_Send((const char *)x + done, piece_of(n, done), MPI_BYTE, 0, 0, MPI_COMM_WORLD);
}

const app_ranks_module app_ranks_mpi = {.begin = begin_mpi,
                                        .end = end_mpi,
                                        .abort = abort_all_ranks,
                                        .take = raise_counter_of_rank_0,
                                        .sum = sum_over_ranks,
                                        .most = largest_of_ranks,
                                        .share = share_bytes,
                                        .list = list_by_rank,
                                        .send = send_bytes,
                                        .receive = receive_bytes};
