/* budget.h: the input of a command, counted against its limit of memory. */
#ifndef APP_BUDGET_H
#define APP_BUDGET_H

#include <stdbool.h>

#include <fmb/base.h>

/* From here on this allocator hands out at most so many bytes, 0: any number. Calls that it refuses
 * fail with FMB_ERR_MEMORY, and app_status_error says that the limit was reached.
 */
void app_budget_begin(size_t bytes);
const fmb_alloc *app_budget_alloc(void);
bool app_budget_is_spent(void);
/* End of reading: nothing is refused any more. The rest of the limit, at least 1; 0: no limit. */
size_t app_budget_end(void);

#endif
