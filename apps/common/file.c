/* file.c: see file.h. */
#include "common/file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
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

/* ---- inputs ---------------------------------------------------------------------------------- */

/* Which regular files have been read: the first few, and no command reads more than two by name. */
static struct {
    dev_t device;
    ino_t number;
} inputs[16];
static size_t inputs_known;

static void remember_input(const struct stat *info)
{
    if (!S_ISREG(info->st_mode) || inputs_known == sizeof inputs / sizeof *inputs)
        return;
    inputs[inputs_known].device = info->st_dev;
    inputs[inputs_known++].number = info->st_ino;
}

static bool was_read(const struct stat *info)
{
    for (size_t i = 0; i < inputs_known; i++)
        if (inputs[i].device == info->st_dev && inputs[i].number == info->st_ino)
            return true;
    return false;
}

/* FILE > FILE: the shell has emptied it already, or what is appended would be read again. (Where
 * standard output was closed, the input itself has got its number, but only for reading.) */
static bool feeds_itself(void)
{
    struct stat out;
    return (fcntl(STDOUT_FILENO, F_GETFL) & O_ACCMODE) != O_RDONLY &&
           fstat(STDOUT_FILENO, &out) == 0 && S_ISREG(out.st_mode) && was_read(&out);
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
    remember_input(&info);
    if (feeds_itself()) {
        app_file_close_input(f);
        return app_error(APP_USAGE, "%s: standard output goes to this very file",
                         app_file_shown(path));
    }
    *out = f;
    return APP_YES;
}

void app_file_close_input(FILE *f)
{
    if (f != stdin)
        fclose(f);
}

/* ---- outputs --------------------------------------------------------------------------------- */

/* An output that has not got its name yet. */
typedef struct output {
    FILE *file;
    char *target, *temporary; /* where it goes, links resolved; where it is */
    struct output *next;
} output;

static output *outputs;

/* [give] Take the output out of the list; NULL if f is none: a device, or a standard stream. */
static output *take_output(const FILE *f)
{
    for (output **o = &outputs; *o; o = &(*o)->next)
        if ((*o)->file == f) {
            output *found = *o;
            *o = found->next;
            return found;
        }
    return NULL;
}

static void free_output(output *o)
{
    if (!o)
        return;
    free(o->target);
    free(o->temporary);
    free(o);
}

static void remove_unfinished(void)
{
    for (; outputs; app_file_discard(outputs->file))
        ;
}

/* A file of the mode that open() would give it, at a name of its own beside the target. */
static FILE *open_temporary(char *temporary)
{
    int descriptor = mkstemp(temporary);
    mode_t mask = umask(0);
    umask(mask);
    FILE *f = NULL;
    if (descriptor >= 0 && fchmod(descriptor, 0666 & ~mask) == 0)
        f = fdopen(descriptor, "wb");
    if (!f && descriptor >= 0) {
        close(descriptor);
        unlink(temporary);
    }
    return f;
}

static int create_named(const char *path, FILE **out)
{
    char *resolved = realpath(path, NULL);
    output *o = app_need(calloc(1, sizeof *o));
    o->target = app_need(resolved ? resolved : strdup(path));
    o->temporary = app_need(malloc(strlen(o->target) + sizeof ".XXXXXX"));
    sprintf(o->temporary, "%s.XXXXXX", o->target);
    o->file = open_temporary(o->temporary);
    if (!o->file) {
        int code = app_error(APP_CANNOT_WRITE, "%s: %s", path, strerror(errno));
        free_output(o);
        return code;
    }
    static bool guarded;
    if (!guarded && atexit(remove_unfinished) != 0)
        exit(app_status_error(FMB_ERR_MEMORY));
    guarded = true;
    o->next = outputs;
    outputs = o;
    *out = o->file;
    return APP_YES;
}

static bool is_written_already(const char *path)
{
    char *resolved = realpath(path, NULL);
    bool found = false;
    for (const output *o = outputs; o; o = o->next)
        found |= strcmp(o->target, resolved ? resolved : path) == 0;
    free(resolved);
    return found;
}

int app_file_create(const char *path, FILE **out)
{
    struct stat info;
    bool there = !is_standard(path) && stat(path, &info) == 0;
    if (is_standard(path)) {
        *out = stdout;
        return APP_YES;
    }
    if (there && was_read(&info))
        return app_error(APP_USAGE, "%s: an input cannot be an output as well", path);
    if (is_written_already(path))
        return app_error(APP_USAGE, "%s: two outputs want this file", path);
    if (there && S_ISREG(info.st_mode) && access(path, W_OK) != 0)
        return app_error(APP_CANNOT_WRITE, "%s: %s", path, strerror(errno));
    if (!there || S_ISREG(info.st_mode))
        return create_named(path, out);
    FILE *f = fopen(path, "wb");
    if (!f)
        return app_error(APP_CANNOT_WRITE, "%s: %s", path, strerror(errno));
    *out = f;
    return APP_YES;
}

int app_file_close(FILE *f, const char *path)
{
    if (!f || f == stdin || f == stdout)
        return APP_YES;
    output *o = take_output(f);
    errno = 0;
    bool failed = ferror(f);
    failed |= fclose(f) != 0;
    if (o && !failed)
        failed = rename(o->temporary, o->target) != 0;
    int why = errno;
    if (o && failed)
        unlink(o->temporary);
    free_output(o);
    return failed
               ? app_error(APP_CANNOT_WRITE, "%s: %s", path, why ? strerror(why) : "writing failed")
               : APP_YES;
}

void app_file_discard(FILE *f)
{
    if (!f || f == stdin || f == stdout)
        return;
    output *o = take_output(f);
    fclose(f);
    if (o)
        unlink(o->temporary);
    free_output(o);
}

void app_file_abandon(int signal_number)
{
    for (const output *o = outputs; o; o = o->next)
        unlink(o->temporary);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
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
