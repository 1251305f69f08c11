/* ranks_module.h: the interface to MPI, for ranks.c only: a module that is loaded if mpirun has
 * started the program. So other runs neither need MPI nor wait for it to be loaded.
 */
#ifndef APP_RANKS_MODULE_H
#define APP_RANKS_MODULE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* All but take are called by all ranks, or by rank 0 and the rank that it receives from. */
typedef struct app_ranks_module {
    /* false: this MPI does not support threads. */
    bool (*begin)(size_t counters, int *rank, int *ranks);
    void (*end)(void);
    void (*abort)(int code);
    uint64_t (*take)(size_t counter, uint64_t n);
    void (*sum)(uint64_t *x, size_t n);
    void (*most)(double *x, size_t n);
    void (*share)(void *x, size_t n);
    /* all: [ranks], on rank 0. */
    void (*list)(uint64_t mine, uint64_t *all);
    void (*send)(const void *x, size_t n);
    void (*receive)(int from, void *x, size_t n);
} app_ranks_module;

extern const app_ranks_module app_ranks_mpi;

#endif
