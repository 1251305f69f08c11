/* sized.h: structures of callers, whose programs may be older or newer than the library.
 *
 * Each begins with its size, `size_t size`, as the caller's headers have it (<fmb/base.h>). What an
 * older one lacks is as if it were 0; what a newer one has beyond ours must be 0.
 */
#ifndef FMB_BASE_SIZED_H
#define FMB_BASE_SIZED_H

#include <fmb/base.h>

/* Larger than this is no size, but memory that nobody set. */
enum { FMB_SIZED_MOST = 1024 };

/* What is wrong with the size of a caller's structure, which goes by that name and of which we know
 * `known` bytes, in words; "" and true: nothing is. why may be NULL. */
bool fmb_sized_is_good(const void *given, size_t known, const char *name, char *why, size_t room);
/* Ours becomes what is given, with all that we know, and our size; all 0 if NULL is given. False,
 * and ours as it was: the size is wrong, as above. given may be ours. */
bool fmb_sized_take(void *ours, size_t known, const void *given, const char *name, char *why,
                    size_t room);
/* What we found goes to the caller, as much as there is room for; its size stays. */
void fmb_sized_give(void *given, const void *ours, size_t known);

/* A text goes to a caller, if there is room for it and its NUL in `size` bytes: its length. */
size_t fmb_text_give(const char *from, char *text, size_t size);

#endif
