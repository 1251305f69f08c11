/* ranks.h: a program as several processes that share one piece of work: the ranks of MPI. A process
 * that mpirun did not start is rank 0 of 1, with or without MPI, and does not even load it.
 *
 * Only rank 0 reads and writes files and standard output. Work is distributed by counters: a rank
 * takes the next chunk when it has done its last one, so that a slow machine does less. If a rank
 * is lost, by a signal or an error, MPI ends all of them, and nothing is written: an output gets
 * its name only when it is complete (file.h).
 */
#ifndef APP_RANKS_H
#define APP_RANKS_H

#include <stddef.h>
#include <stdint.h>

/* Join the other ranks: APP_YES, or an exit code after a message (several processes without MPI).
 * Each counter is 0. */
int app_ranks_begin(size_t counters);
/* End the work; called by all ranks. */
void app_ranks_end(void);
/* The exit code of rank 0, on all ranks, before work that one of them cannot begin: each returns it
 * in good order. Called by all ranks. */
int app_ranks_agree(int code);
/* An error of this rank alone, of which the others cannot know: ends every rank at once, as does
 * MPI_Abort. Returns the code if there is only one rank. */
int app_ranks_fail(int code);

int app_rank(void);
int app_ranks(void);

/* Add n to a counter; returns its former value. Only one thread of a rank at a time. */
uint64_t app_ranks_take(size_t counter, uint64_t n);

/* x[i] becomes the sum over the ranks, on rank 0; elsewhere it is undefined. */
void app_ranks_sum(uint64_t *x, size_t n);
/* x[i] becomes the largest over the ranks, likewise. */
void app_ranks_most(double *x, size_t n);
/* Copy n bytes of rank 0 to all ranks. */
void app_ranks_share(void *x, size_t n);
/* [give, free()] Gather the bytes of all ranks, n of this one, in order of ranks on rank 0; NULL
 * elsewhere. *all: their number. */
void *app_ranks_gather(const void *x, size_t n, size_t *all);

#endif
