/* sized.h: structures of callers, whose programs may be older or newer than the library.
 *
 * Each begins with its size, `size_t size`, according to the caller's headers (<fmb/base.h>).
 * Fields that an older structure lacks count as 0; fields beyond ours in a newer one must be 0.
 */
#ifndef FMB_BASE_SIZED_H
#define FMB_BASE_SIZED_H

#include <fmb/base.h>

/* A size beyond this is taken for uninitialized memory. */
enum { FMB_SIZED_MOST = 1024 };

/* Is the size of a caller's structure valid, where we know `known` bytes? If not, why[room] says
 * what is wrong with the structure of that name; if so, it is "". why may be NULL. */
bool fmb_sized_is_good(const void *given, size_t known, const char *name, char *why, size_t room);
/* Copy the caller's structure (NULL: zeros) to ours, with our size. False, and ours is unchanged,
 * if the caller's size is not valid, as above. given may be ours. */
bool fmb_sized_take(void *ours, size_t known, const void *given, const char *name, char *why,
                    size_t room);
/* Copy our structure to the caller's, as much of it as fits; the caller's size is unchanged. */
void fmb_sized_give(void *given, const void *ours, size_t known);

/* Copy a text to text[size] if it fits with its NUL; returns its length. */
size_t fmb_text_give(const char *from, char *text, size_t size);

#endif
