/* message.c: see message.h. */
#include "common/message.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>

#include "common/text.h"

int app_error(int code, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fprintf(stderr, "%s: ", program_invocation_short_name);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    return code;
}

static void say_at(const char *file, const fmb_where *where, const char *kind)
{
    char *text = app_text(where->text, APP_TEXT_TERMINAL);
    fprintf(stderr, "%s: %s:", program_invocation_short_name, file);
    if (where->line > 0)
        fprintf(stderr, "%ld:", where->line);
    if (where->line > 0 && where->column > 0)
        fprintf(stderr, "%ld:", where->column);
    fprintf(stderr, " %s%s\n", kind, text);
    free(text);
}

int app_error_at(int code, const char *file, const fmb_where *where)
{
    say_at(file, where, "");
    return code;
}

void app_warning_at(const char *file, const fmb_where *where)
{
    say_at(file, where, "warning: ");
}

int app_status_error(fmb_status st)
{
    int code = st == FMB_ERR_RULE ? APP_USAGE : st == FMB_ERR_IO ? APP_CANNOT_WRITE : APP_INTERNAL;
    return app_error(code, "%s", fmb_status_text(st));
}

void *app_need(void *p)
{
    if (!p)
        exit(app_status_error(FMB_ERR_MEMORY));
    return p;
}
