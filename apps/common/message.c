/* message.c: see message.h. */
#include "common/message.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/text.h"

int app_error(int code, const char *format, ...)
{
    va_list args;
    char *raw = NULL;
    va_start(args, format);
    int length = vasprintf(&raw, format, args);
    va_end(args);
    char *text = app_text(app_need(length < 0 ? NULL : raw), APP_TEXT_TERMINAL);
    fprintf(stderr, "%s: %s\n", program_invocation_short_name, text);
    free(text);
    free(raw);
    return code;
}

int app_status_error(fmb_status st)
{
    int code = st == FMB_ERR_RULE ? APP_USAGE : st == FMB_ERR_IO ? APP_CANNOT_WRITE : APP_INTERNAL;
    return app_error(code, "%s", fmb_status_text(st));
}
