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
        return app_error_at((app_place){.file = app_file_shown(path)}, APP_CANNOT_OPEN, "%s",
                            strerror(errno));
    if (S_ISDIR(info.st_mode)) {
        app_file_close_input(f);
        return app_error_at((app_place){.file = app_file_shown(path)}, APP_CANNOT_OPEN, "%s",
                            strerror(EISDIR));
    }
    remember_input(&info);
    if (feeds_itself()) {
        app_file_close_input(f);
        return app_error_at((app_place){.file = app_file_shown(path)}, APP_USAGE,
                            "standard output goes to this very file");
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
    char *target;    /* its final name, links resolved */
    char *temporary; /* its present name; "" if it has none */
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

#define SUFFIX ".XXXXXX"

/* NULL where one's own open files cannot be linked to a name: there is no /proc then. */
static const char *own_name(int descriptor, char name[static 32])
{
    snprintf(name, 32, "/proc/self/fd/%d", descriptor);
    return access(name, F_OK) == 0 ? name : NULL;
}

/* A file without a name in the folder of the target, gone with the process however that ends; -1
 * where there are none, or where a temporary name beside the target would be too long. */
static int open_nameless(const output *o)
{
    int descriptor = -1;
    (void)o;
#ifdef O_TMPFILE
    if (access(o->temporary, F_OK) != 0 && errno == ENAMETOOLONG)
        return -1;
    char own[32], *folder = app_need(strdup(o->target)), *slash = strrchr(folder, '/');
    if (slash)
        slash[slash == folder] = '\0';
    descriptor = open(slash ? folder : ".", O_TMPFILE | O_WRONLY, 0666);
    free(folder);
    if (descriptor >= 0 && !own_name(descriptor, own)) {
        close(descriptor);
        descriptor = -1;
    }
#endif
    return descriptor;
}

/* A file of the mode that open() would give it, at a name of its own beside the target. */
static int open_temporary(char *temporary)
{
    int descriptor = mkstemp(temporary);
    mode_t mask = umask(0);
    umask(mask);
    if (descriptor >= 0 && fchmod(descriptor, 0666 & ~mask) != 0) {
        close(descriptor);
        unlink(temporary);
        descriptor = -1;
    }
    return descriptor;
}

static bool open_output(output *o)
{
    sprintf(o->temporary, "%s" SUFFIX, o->target);
    int descriptor = open_nameless(o);
    if (descriptor >= 0)
        *o->temporary = '\0';
    else if ((descriptor = open_temporary(o->temporary)) < 0)
        return false;
    o->file = fdopen(descriptor, "wb");
    if (!o->file) {
        close(descriptor);
        unlink(o->temporary);
        errno = ENOMEM;
    }
    return o->file != NULL;
}

/* Give a nameless file the name of the target. A link cannot replace an existing file: then it gets
 * a temporary name beside it first, which stays behind only if the process is killed just then. */
static bool link_nameless(output *o, int descriptor)
{
    char own[32];
    const char *from = own_name(descriptor, own);
    if (from && linkat(AT_FDCWD, from, AT_FDCWD, o->target, AT_SYMLINK_FOLLOW) == 0)
        return true;
    for (unsigned long i = (unsigned long)getpid(); from && errno == EEXIST; i++) {
        sprintf(o->temporary, "%s.%06lx", o->target, i & 0xffffff);
        if (linkat(AT_FDCWD, from, AT_FDCWD, o->temporary, AT_SYMLINK_FOLLOW) == 0)
            return rename(o->temporary, o->target) == 0;
        *o->temporary = '\0';
    }
    return false;
}

static int create_named(const char *path, FILE **out)
{
    char *resolved = realpath(path, NULL);
    output *o = app_need(calloc(1, sizeof *o));
    o->target = app_need(resolved ? resolved : strdup(path));
    o->temporary = app_need(malloc(strlen(o->target) + sizeof SUFFIX));
    if (!open_output(o)) {
        int code = app_error_at((app_place){.file = path}, APP_CANNOT_WRITE, "%s", strerror(errno));
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
        return app_error_at((app_place){.file = path}, APP_USAGE,
                            "an input cannot be an output as well");
    if (is_written_already(path))
        return app_error_at((app_place){.file = path}, APP_USAGE, "two outputs want this file");
    if (there && S_ISREG(info.st_mode) && access(path, W_OK) != 0)
        return app_error_at((app_place){.file = path}, APP_CANNOT_WRITE, "%s", strerror(errno));
    if (!there || S_ISREG(info.st_mode))
        return create_named(path, out);
    FILE *f = fopen(path, "wb");
    if (!f)
        return app_error_at((app_place){.file = path}, APP_CANNOT_WRITE, "%s", strerror(errno));
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
    int nameless = o && !*o->temporary ? dup(fileno(f)) : -1;
    failed |= fclose(f) != 0;
    if (o && !failed)
        failed = *o->temporary ? rename(o->temporary, o->target) != 0 : !link_nameless(o, nameless);
    int why = errno;
    if (nameless >= 0)
        close(nameless);
    if (o && failed)
        unlink(o->temporary);
    free_output(o);
    return failed ? app_error_at((app_place){.file = path}, APP_CANNOT_WRITE, "%s",
                                 why ? strerror(why) : "writing failed")
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
    app_error_at((app_place){.file = "standard output"}, APP_CANNOT_WRITE, "%s",
                 errno ? strerror(errno) : "writing failed");
    _exit(APP_CANNOT_WRITE);
}

void app_file_guard_output(void)
{
    if (atexit(close_output) != 0)
        exit(app_status_error(FMB_ERR_MEMORY));
}
