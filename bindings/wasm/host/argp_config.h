/* argp_config.h: gnulib's configuration macros for its argp, set for musl, the C library of
 * Emscripten. Its own getopt is renamed, as argp needs more than musl's. */
#define _GNU_SOURCE     1
#define __GETOPT_PREFIX for_argp_

#include <stdalign.h>
#include <stdbool.h>

#define HAVE_DECL_CLEARERR_UNLOCKED             1
#define HAVE_DECL_PROGRAM_INVOCATION_NAME       1
#define HAVE_DECL_PROGRAM_INVOCATION_SHORT_NAME 1
#define HAVE_DECL_PUTC_UNLOCKED                 1
#define HAVE_MEMPCPY                            1
#define HAVE_STRCHRNUL                          1
#define HAVE_STRNDUP                            1
#define FALLTHROUGH
#define MAYBE_UNUSED
#define _GL_ARG_NONNULL(positions)
#define _GL_ATTRIBUTE_DEALLOC(how, position)
#define _GL_ATTRIBUTE_FORMAT(form) __attribute__((__format__ form))
#define _GL_ATTRIBUTE_MAYBE_UNUSED
#define _GL_ATTRIBUTE_SPEC_PRINTF_STANDARD __printf__
#define _GL_ATTRIBUTE_SPEC_PRINTF_SYSTEM   __printf__
#define _GL_EXTERN_INLINE                  extern inline
#define _GL_INLINE                         inline
#define _GL_INLINE_HEADER_BEGIN
#define _GL_INLINE_HEADER_END
#define _GL_UNUSED           __attribute__((__unused__))
#define last_component(path) ((char *)(strrchr(path, '/') ? strrchr(path, '/') + 1 : (path)))
