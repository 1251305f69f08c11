/* sort.h: sorting of lists so long that a limit may be reached meanwhile. */
#ifndef FMB_TRACE_SORT_H
#define FMB_TRACE_SORT_H

#include "trace/run.h"

/* The type of qsort's comparison. */
typedef int fmb_compare(const void *, const void *);

/* Sort n items of `size` bytes each. Errors: MEMORY, LIMIT; then the items are still complete, in
 * some order. */
fmb_status fmb_run_sort(fmb_run *run, void *items, size_t n, size_t size, fmb_compare *compare);

#endif
