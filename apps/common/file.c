/* file.c: see file.h. */
#include "common/file.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/message.h"

static bool is_standard(const char *path)
{
    return strcmp(path, "-") == 0;
}

const char *app_file_shown(const char *path)
{
    return is_standard(path) ? "<stdin>" : path;
}

int app_file_open(const char *path, FILE **out)
{
    FILE *f = is_standard(path) ? stdin : fopen(path, "rb");
    struct stat info;
    if (!f || fstat(fileno(f), &info) != 0)
        return app_error(APP_CANNOT_OPEN, "%s: %s", app_file_shown(path), strerror(errno));
    if (S_ISDIR(info.st_mode)) {
        app_file_close_input(f);
        return app_error(APP_CANNOT_OPEN, "%s: %s", app_file_shown(path), strerror(EISDIR));
    }
    *out = f;
    return APP_YES;
}

void app_file_close_input(FILE *f)
{
    if (f != stdin)
        fclose(f);
}

int app_file_create(const char *path, FILE **out)
{
    FILE *f = is_standard(path) ? stdout : fopen(path, "wb");
    if (!f)
        return app_error(APP_CANNOT_WRITE, "%s: %s", path, strerror(errno));
    *out = f;
    return APP_YES;
}

int app_file_close(FILE *f, const char *path)
{
    if (!f || f == stdin || f == stdout)
        return APP_YES;
    errno = 0;
    bool failed = ferror(f);
    failed |= fclose(f) != 0;
    return failed ? app_error(APP_CANNOT_WRITE, "%s: %s", path,
                              errno ? strerror(errno) : "writing failed")
                  : APP_YES;
}

static void close_output(void)
{
    errno = 0;
    bool failed = ferror(stdout);
    failed |= fclose(stdout) != 0;
    if (!failed)
        return;
    app_error(APP_CANNOT_WRITE, "standard output: %s", errno ? strerror(errno) : "writing failed");
    _exit(APP_CANNOT_WRITE);
}

void app_file_guard_output(void)
{
    if (atexit(close_output) != 0)
        exit(app_status_error(FMB_ERR_MEMORY));
}
