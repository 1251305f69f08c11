/* message.c: see message.h. */
#include "common/message.h"

#include "common/budget.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "common/json.h"
#include "common/text.h"

static bool as_json;

/* ---- what others write ----------------------------------------------------------------------- */

static struct {
    int own;  /* the real standard error, by another number; -1: nothing is captured */
    int file; /* a file in memory that replaces it */
    const char *name;
} captured = {.own = -1};

void app_errors_drop(void)
{
    if (captured.own < 0)
        return;
    fflush(stderr);
    dup2(captured.own, STDERR_FILENO);
    close(captured.own);
    captured.own = -1;
}

void app_errors_release(void)
{
    char *line = NULL;
    size_t room = 0, name;
    if (captured.own < 0)
        return;
    app_errors_drop();
    FILE *in = app_need(fdopen(captured.file, "r"));
    rewind(in);
    if (getline(&line, &room, in) > 0) {
        char *text = line;
        name = strlen(captured.name);
        if (strncmp(text, captured.name, name) == 0 && strncmp(text + name, ": ", 2) == 0)
            text += name + 2;
        text[strcspn(text, "\n")] = '\0';
        if (*text)
            app_error(APP_USAGE, "%s", text);
    }
    fclose(in);
    free(line);
}

/* Where there is no standard error, or no such file, what others write stays as it is. */
void app_errors_capture(const char *name)
{
    static bool guarded;
    if (!guarded && atexit(app_errors_release) != 0)
        exit(app_status_error(FMB_ERR_MEMORY));
    guarded = true;
    captured.name = name;
    captured.own = dup(STDERR_FILENO);
    captured.file = captured.own < 0 ? -1 : memfd_create("errors", MFD_CLOEXEC);
    if (captured.file >= 0 && dup2(captured.file, STDERR_FILENO) >= 0)
        return;
    if (captured.own >= 0)
        close(captured.own);
    captured.own = -1;
}

/* ---- errors ---------------------------------------------------------------------------------- */

void app_errors_as_json(void)
{
    as_json = true;
}

bool app_errors_are_json(void)
{
    return as_json;
}

static json_t *number_or_null(long number)
{
    return number > 0 ? json_integer(number) : json_null();
}

static void say_as_json(app_place at, const char *text, int code)
{
    json_t *whole =
        json_pack("{s:{s:o,s:o,s:o,s:o,s:i}}", "error", "file",
                  at.file ? app_json_text(at.file) : json_null(), "line", number_or_null(at.line),
                  "column", number_or_null(at.column), "text", app_json_text(text), "exit", code);
    char *line = app_need(whole ? json_dumps(whole, 0) : NULL);
    fprintf(stderr, "%s\n", line);
    free(line);
    json_decref(whole);
}

static void say_as_text(app_place at, const char *raw)
{
    char *text = app_text(raw, APP_TEXT_TERMINAL);
    fprintf(stderr, "%s:", program_invocation_short_name);
    if (at.file) {
        char *file = app_text(at.file, APP_TEXT_TERMINAL);
        fprintf(stderr, " %s:", file);
        free(file);
    }
    if (at.file && at.line > 0)
        fprintf(stderr, "%ld:", at.line);
    if (at.file && at.line > 0 && at.column > 0)
        fprintf(stderr, "%ld:", at.column);
    fprintf(stderr, " %s\n", text);
    free(text);
}

void app_warn_at(app_place at, const char *text)
{
    say_as_text(at, text);
}

static int say_error(app_place at, int code, const char *format, va_list args)
{
    char *raw = NULL;
    int length = vasprintf(&raw, format, args);
    app_need(length < 0 ? NULL : raw);
    app_errors_release();
    if (as_json && code >= APP_USAGE)
        say_as_json(at, raw, code);
    else
        say_as_text(at, raw);
    free(raw);
    return code;
}

int app_error(int code, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    say_error((app_place){0}, code, format, args);
    va_end(args);
    return code;
}

int app_error_at(app_place at, int code, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    say_error(at, code, format, args);
    va_end(args);
    return code;
}

int app_status_error(fmb_status st)
{
    if (st == FMB_ERR_MEMORY && app_budget_is_spent())
        return app_error(APP_UNDECIDED, "undecided (%s): the input alone takes more",
                         fmb_stop_text(FMB_STOP_BYTES));
    int code = st == FMB_ERR_RULE ? APP_USAGE : st == FMB_ERR_IO ? APP_CANNOT_WRITE : APP_INTERNAL;
    return app_error(code, "%s", fmb_status_text(st));
}
