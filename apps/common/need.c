/* need.c: see need.h. */
#include "common/need.h"

#include <errno.h>
#include <fmb/base.h>
#include <gmp.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/message.h"

/* Without asking for more of it. */
static void say_out_of_memory(void)
{
    const char *text = fmb_status_text(FMB_ERR_MEMORY);
    app_errors_drop();
    if (app_errors_are_json())
        fprintf(stderr,
                "{\"error\": {\"file\": null, \"line\": null, \"column\": null, \"text\": \"%s\", "
                "\"exit\": %d}}\n",
                text, APP_INTERNAL);
    else
        fprintf(stderr, "%s: %s\n", program_invocation_short_name, text);
}

void *app_need(void *p)
{
    if (!p) {
        say_out_of_memory();
        exit(APP_INTERNAL);
    }
    return p;
}

/* ---- limbs ----------------------------------------------------------------------------------- */

static void *need_new_limbs(size_t bytes)
{
    return app_need(malloc(bytes));
}

static void *need_grown_limbs(void *p, size_t old_bytes, size_t new_bytes)
{
    (void)old_bytes;
    return app_need(realloc(p, new_bytes));
}

static void free_limbs(void *p, size_t bytes)
{
    (void)bytes;
    free(p);
}

void app_need_limbs(void)
{
    mp_set_memory_functions(need_new_limbs, need_grown_limbs, free_limbs);
}
