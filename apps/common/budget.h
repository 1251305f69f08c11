/* budget.h: what a command reads, counted against its limit of memory. */
#ifndef APP_BUDGET_H
#define APP_BUDGET_H

#include <stdbool.h>

#include <fmb/base.h>

/* From here on what comes from this allocator may not hold more than so many bytes, 0: any number.
 * What it refuses fails with FMB_ERR_MEMORY, and app_status_error says that the limit was reached.
 */
void app_budget_begin(size_t bytes);
const fmb_alloc *app_budget_alloc(void);
bool app_budget_is_spent(void);
/* All is read, and nothing is refused any more: how much is left for others, at least 1; 0: any
 * number. */
size_t app_budget_end(void);

#endif
