/* names.h: variable names, with a hash table from name to index.
 *
 * Invariants: names are distinct and not empty; slots is a power of two above twice size.
 */
#ifndef FMB_SYSTEM_NAMES_H
#define FMB_SYSTEM_NAMES_H

#include "base/mem.h"

typedef struct fmb_names {
    char **name; /* [size] */
    size_t size, capacity;
    int *slot; /* [slots] open addressing by linear probing; -1 = free */
    size_t slots;
} fmb_names;

/* Append a name; the caller has checked that it is not taken. Errors: MEMORY. */
fmb_status fmb_names_add(fmb_names *t, const char *name, fmb_mem *mem);
fmb_status fmb_names_change(fmb_names *t, int j, const char *name, fmb_mem *mem);
/* Remove the last name. */
void fmb_names_drop_last(fmb_names *t, fmb_mem *mem);
int fmb_names_find(const fmb_names *t, const char *name);
void fmb_names_clear(fmb_names *t, fmb_mem *mem);

#endif
