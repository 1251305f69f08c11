/* no_nameless.c: loaded before a program, a system on which no file system has files without names:
 * open() refuses O_TMPFILE as ext2 and NFS do. */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/syscall.h>
#include <unistd.h>

#pragma GCC diagnostic ignored "-Wmissing-prototypes"

/* Both names of open() in the C library: with offsets of 64 bits said so, and without. */
#define OPEN(NAME, SYMBOL)                                                                         \
    int NAME(const char *path, int flags, ...) __asm__(SYMBOL);                                    \
    int NAME(const char *path, int flags, ...)                                                     \
    {                                                                                              \
        va_list list;                                                                              \
        va_start(list, flags);                                                                     \
        mode_t mode = flags & O_CREAT ? va_arg(list, mode_t) : 0;                                  \
        va_end(list);                                                                              \
        if ((flags & O_TMPFILE) == O_TMPFILE) {                                                    \
            errno = EOPNOTSUPP;                                                                    \
            return -1;                                                                             \
        }                                                                                          \
        return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);                              \
    }

OPEN(open_named, "open")
OPEN(open_named_64, "open64")
