/* ranks.h: a program as several processes that share one piece of work: the ranks of MPI. A process
 * that mpirun did not start is rank 0 of 1, with or without MPI, and does not even load it.
 *
 * Rank 0 alone reads and writes files and standard output. Work is handed out by counters: a rank
 * takes the next chunk when it has done its last one, so that a slow machine does less. A rank that
 * is lost ends them all, by a signal or with an error (MPI's own behaviour), and nothing is
 * written: an output gets its name only when it is whole (file.h).
 */
#ifndef APP_RANKS_H
#define APP_RANKS_H

#include <stddef.h>
#include <stdint.h>

/* Join the others: APP_YES, or an exit code after a message (several processes, but without MPI).
 * Each counter is 0. */
int app_ranks_begin(size_t counters);
/* The end of the work; all ranks come here. */
void app_ranks_end(void);
/* An error that the others cannot know of: ends every rank. The code, if there is but one. */
int app_ranks_fail(int code);

int app_rank(void);
int app_ranks(void);

/* What the counter was; it is n more then. Only one thread of a rank at a time. */
uint64_t app_ranks_take(size_t counter, uint64_t n);

/* x[i] becomes the sum over the ranks, on rank 0; elsewhere it is undefined. */
void app_ranks_sum(uint64_t *x, size_t n);
/* The same for the largest. */
void app_ranks_most(double *x, size_t n);
/* n bytes of rank 0 become those of all. */
void app_ranks_share(void *x, size_t n);
/* [give, free()] What all ranks have, n bytes here, one after the other by rank, on rank 0; NULL
 * elsewhere. *all is how many. */
void *app_ranks_gather(const void *x, size_t n, size_t *all);

#endif
