/* sized.c: see sized.h. */
#include "base/sized.h"

#include <string.h>

static size_t given_size(const void *given)
{
    size_t size;
    memcpy(&size, given, sizeof size);
    return size;
}

static size_t smaller_size(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* The first byte from `from` on that is not 0; size if there is none. */
static size_t find_nonzero_byte(const void *given, size_t from, size_t size)
{
    const unsigned char *byte = given;
    while (from < size && byte[from] == 0)
        from++;
    return from;
}

bool fmb_sized_is_good(const void *given, size_t known, const char *name, char *why, size_t room)
{
    size_t size = given_size(given), far = 0;
    bool is_size = size >= sizeof size && size <= FMB_SIZED_MOST;
    if (is_size)
        far = find_nonzero_byte(given, known, size);
    if (why)
        why[0] = '\0';
    if (is_size && far >= size)
        return true;
    if (why && !is_size)
        snprintf(why, room, "%s.size is %zu, and should be its size in bytes, %zu", name, size,
                 known);
    else if (why)
        snprintf(why, room, "%s.size is %zu, this version knows %zu bytes, and byte %zu is not 0",
                 name, size, known, far);
    return false;
}

bool fmb_sized_take(void *ours, size_t known, const void *given, const char *name, char *why,
                    size_t room)
{
    if (given && !fmb_sized_is_good(given, known, name, why, room))
        return false;
    size_t size = given ? smaller_size(given_size(given), known) : 0;
    if (given)
        memmove(ours, given, size);
    else if (why)
        why[0] = '\0';
    memset((char *)ours + size, 0, known - size);
    memcpy(ours, &known, sizeof known);
    return true;
}

void fmb_sized_give(void *given, const void *ours, size_t known)
{
    size_t size = smaller_size(given_size(given), known);
    if (size > sizeof size)
        memcpy((char *)given + sizeof size, (const char *)ours + sizeof size, size - sizeof size);
}

size_t fmb_text_give(const char *from, char *text, size_t size)
{
    size_t length = strlen(from);
    if (text && length < size)
        memcpy(text, from, length + 1);
    return length;
}
