/* need.c: see need.h. */
#include "common/need.h"

#include <errno.h>
#include <fmb/base.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/exit_code.h"

void *app_need(void *p)
{
    if (!p) {
        fprintf(stderr, "%s: %s\n", program_invocation_short_name, fmb_status_text(FMB_ERR_MEMORY));
        exit(APP_INTERNAL);
    }
    return p;
}
