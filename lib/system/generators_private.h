/* generators_private.h: inside of fmb_generators: vectors over (x, t), with t > 0 for vertices. */
#ifndef FMB_SYSTEM_GENERATORS_PRIVATE_H
#define FMB_SYSTEM_GENERATORS_PRIVATE_H

#include <fmb/gmp.h>

#include "num/vec.h"

struct fmb_generators {
    fmb_mem mem;
    int dim;
    size_t size, vec_capacity, kind_capacity;
    fmb_vec *vec; /* [size], dim + 1 entries each: the point x / t, or t = 0 */
    fmb_generator_kind *kind;
    char error[160]; /* why the last one to be added was refused */
};

/* Append a vector over (x, t), copied. Errors: MEMORY, LIMIT. */
fmb_status fmb_generators_append(fmb_generators *g, fmb_generator_kind kind, const fmb_vec *v);

#endif
