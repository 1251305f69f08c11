/* sort.h: sorting of lists that may be so long that a limit is reached meanwhile. */
#ifndef FMB_TRACE_SORT_H
#define FMB_TRACE_SORT_H

#include "trace/run.h"

/* As qsort wants it. */
typedef int fmb_compare(const void *, const void *);

/* Sort n items of `size` bytes each. Errors: MEMORY, LIMIT; then the
 * items are all there, in some order. */
fmb_status fmb_run_sort(fmb_run *run, void *items, size_t n, size_t size, fmb_compare *compare);

#endif
