/* sort.c: sorting in blocks, against qsort, and interrupted by a cancel. */
#include <criterion/criterion.h>

#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "trace/sort.h"

enum { MOST = 40000, BLOCK = 4096 };

static uint32_t item[MOST], same[MOST];
static atomic_int cancel;
static size_t compares, last; /* so far; a cancel comes at the last, if it is not 0 */

static int compare_items(const void *x, const void *y)
{
    uint32_t a = *(const uint32_t *)x, b = *(const uint32_t *)y;
    if (++compares == last)
        cancel = 1;
    return a < b ? -1 : a > b;
}

static void draw(support_rng *g, size_t n, uint32_t most)
{
    for (size_t i = 0; i < n; i++)
        item[i] = same[i] = (uint32_t)support_between(g, 0, (int)most);
}

/* Sort n numbers, with a cancel at that many comparisons. */
static fmb_status sort_until(size_t n, size_t comparisons)
{
    fmb_mem mem;
    fmb_run run;
    fmb_options o = {.size = sizeof o};
    cancel = 0;
    compares = 0;
    last = comparisons;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    return fmb_run_sort(&run, item, n, sizeof *item, compare_items);
}

Test(sort, as_qsort_does)
{
    support_rng g = {5};
    const size_t size[] = {0,         1,         2,         BLOCK - 1,     BLOCK,
                           BLOCK + 1, 2 * BLOCK, 3 * BLOCK, 5 * BLOCK + 7, MOST};
    for (size_t k = 0; k < sizeof size / sizeof *size; k++) {
        draw(&g, size[k], k % 2 ? 100 : 1000000000);
        cr_assert_eq(sort_until(size[k], 0), FMB_OK);
        qsort(same, size[k], sizeof *same, compare_items);
        cr_assert_arr_eq(item, same, size[k] * sizeof *item);
    }
}

/* All numbers are there whenever the cancel comes, and it is heard soon. */
Test(sort, cut_short)
{
    support_rng g = {6};
    draw(&g, MOST, 1000);
    cr_assert_eq(sort_until(MOST, 0), FMB_OK);
    size_t all = compares;
    for (size_t k = 1; k < 20; k++) {
        draw(&g, MOST, 1000);
        cr_assert_eq(sort_until(MOST, k * all / 20), FMB_LIMIT);
        cr_assert_lt(compares, k * all / 20 + 16 * BLOCK);
        last = 0;
        qsort(item, MOST, sizeof *item, compare_items);
        qsort(same, MOST, sizeof *same, compare_items);
        cr_assert_arr_eq(item, same, sizeof item);
    }
}
