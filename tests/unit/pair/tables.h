/* tables.h: the kernels over records that this processor has, and a record by one of them. */
#ifndef FMB_TESTS_PAIR_TABLES_H
#define FMB_TESTS_PAIR_TABLES_H

#include "pair/kernels/inverse.h"
#include "pair/kernels/pair_kernels.h"

extern const fmb_minor_kernels minors_plain;

/* The kernels of one width. */
typedef struct kernel_table {
    const fmb_minor_kernels *kernels;
    unsigned width;
} kernel_table;

/* Tables of this processor. */
static inline size_t find_tables(kernel_table out[4])
{
    const fmb_simd level[3] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};
    size_t n = 0;
#ifdef HAVE_PLAIN
    out[n++] = (kernel_table){&minors_plain, 1};
#endif
    for (int i = 0; i < 3; i++) {
        const fmb_pair_kernels *k = fmb_pair_kernels_choose(level[i]);
        if (k)
            out[n++] = (kernel_table){k->minors, (unsigned)k->width};
    }
    return n;
}

/* The record of f alone, by these kernels; does it have one? */
static inline bool make_record(const fmb_minor_kernels *kernels, const fmb_frame *f, double *record)
{
    fmb_inverse_write_frame(f, record);
    if (kernels->invert(f->dim, &record, 1) != 1)
        return false;
    fmb_inverse_write_integers(f->dim, record);
    return true;
}

#endif
