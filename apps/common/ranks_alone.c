/* ranks_alone.c: see ranks.h. Without MPI there is one process. */
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/ranks.h"

static uint64_t *counter;

int app_ranks_begin(size_t counters)
{
    const char *size = getenv("OMPI_COMM_WORLD_SIZE");
    size = size ? size : getenv("PMI_SIZE");
    if (size && strcmp(size, "1") != 0)
        return app_error(APP_USAGE, "one of %s processes, but built without MPI", size);
    counter = app_need(calloc(counters + 1, sizeof *counter));
    return APP_YES;
}

void app_ranks_end(void)
{
    free(counter);
    counter = NULL;
}

int app_ranks_fail(int code)
{
    return code;
}

int app_rank(void)
{
    return 0;
}

int app_ranks(void)
{
    return 1;
}

uint64_t app_ranks_take(size_t which, uint64_t n)
{
    uint64_t was = counter[which];
    counter[which] += n;
    return was;
}

void app_ranks_sum(uint64_t *x, size_t n)
{
    (void)x;
    (void)n;
}

void app_ranks_most(double *x, size_t n)
{
    (void)x;
    (void)n;
}

void *app_ranks_gather(const void *x, size_t n, size_t *all)
{
    void *out = app_need(malloc(n + 1));
    if (n > 0)
        memcpy(out, x, n);
    *all = n;
    return out;
}
