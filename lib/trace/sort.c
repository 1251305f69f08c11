/* sort.c: sorting that can be cut off by a limit; see sort.h. */
#include "trace/sort.h"

#include <stdlib.h>
#include <string.h>

/* Number of items that qsort sorts without a poll. */
enum { BLOCK = 4096 };

/* Merge the first `left` items, which are sorted, with the items from there up to n, also sorted.
 * The former are copied to `waiting`. At a limit the waiting items not yet merged are copied back:
 * the gap has just their number, so no item is lost. */
static fmb_status merge(fmb_run *run, char *at, size_t left, size_t n, size_t size,
                        fmb_compare *compare, char *waiting)
{
    fmb_status st = FMB_OK;
    size_t taken = 0, right = left, put = 0;
    memcpy(waiting, at, left * size);
    while (taken < left && right < n && st == FMB_OK) {
        bool is_right = compare(at + right * size, waiting + taken * size) < 0;
        const char *next = is_right ? at + right++ * size : waiting + taken++ * size;
        memcpy(at + put++ * size, next, size);
        st = fmb_run_poll(run);
    }
    memcpy(at + put * size, waiting + taken * size, (left - taken) * size);
    return st;
}

fmb_status fmb_run_sort(fmb_run *run, void *items, size_t n, size_t size, fmb_compare *compare)
{
    char *at = items, *waiting = NULL;
    fmb_status st = FMB_OK;
    for (size_t i = 0; i < n && st == FMB_OK; i += BLOCK) {
        qsort(at + i * size, n - i < BLOCK ? n - i : BLOCK, size, compare);
        st = n > BLOCK ? fmb_run_poll_now(run) : FMB_OK;
    }
    if (n <= BLOCK || st != FMB_OK)
        return st;
    waiting = fmb_mem_get(run->mem, n, size);
    if (!waiting)
        return fmb_mem_status(run->mem);
    for (size_t width = BLOCK; width < n && st == FMB_OK; width *= 2)
        for (size_t i = 0; i + width < n && st == FMB_OK; i += 2 * width)
            st = merge(run, at + i * size, width, n - i < 2 * width ? n - i : 2 * width, size,
                       compare, waiting);
    fmb_mem_put(run->mem, waiting, n, size);
    return st;
}
