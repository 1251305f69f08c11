/* pair_kernels.h: the inner loops over blocks of pairs, one table per width, chosen at run time.
 *
 * A block holds the numbers of `width` pairs (A, B) of one kind in rows: row r has number r of each
 * pair, lane by lane. In D dimensions the rows are
 *
 *     shift   D     origin of B - origin of A
 *     a       D D   axes of A, axis by axis
 *     b       D D   axes of B
 *     drift   D     speed of B - speed of A, if moving
 *     place   2 D   origin of A, of B   (boxes only)
 *     speed   2 D   speed of A, of B    (boxes only, if moving)
 *
 * In a block a cuboid comes before a simplex: pairs (simplex, cuboid) are swapped, so A and B here
 * are the pair's second and first frame. Boxes are in coordinates of the pair's second frame
 * nevertheless.
 *
 * Differences are rounded once, so shift and drift have a relative error of at most 2^-53; all
 * other rows are exact. Every number is finite.
 */
#ifndef FMB_PAIR_KERNELS_PAIR_KERNELS_H
#define FMB_PAIR_KERNELS_PAIR_KERNELS_H

#include <fmb/pair.h>

enum {
    FMB_BLOCK_MOST_LANES = 8,
    FMB_BLOCK_MOST_ROWS = 36, /* moving in 3D, with place and speed */
    FMB_BOX_MOST_ROWS = 17,
    FMB_BOX_LEVELS = 3
};

/* Bits of the lanes where the closed frames certainly have no common point; where their interiors
 * certainly have one. A lane in neither is unknown. */
typedef struct fmb_pair_bits {
    unsigned apart, meet;
} fmb_pair_bits;

typedef fmb_pair_bits fmb_verdict_kernel(const double *block);

/* For pairs that meet, of shapes a and b: rows of answers, D each: lower and upper ends in the
 * world, lower and upper ends in coordinates of B; then first and last time; then D for a witness.
 * The bits of the lanes where the ends contain the exact ones and exceed them by at most 1e-12
 * (coordinates of B, times), or 1e-12 of the largest coordinate of a corner of A or B at t = 0 or 1
 * (world); other lanes mean nothing. Static: the times are 0 and 1. */
typedef unsigned fmb_box_kernel(bool moves, int a, int b, const double *block, double *answer);

struct fmb_packed;        /* packed_kernels.h */
struct fmb_minor_kernels; /* minors_kernels.h */

typedef struct fmb_pair_kernels {
    int width;
    const struct fmb_packed *packed;         /* for records of sets, of that width */
    const struct fmb_minor_kernels *minors;  /* the same in four to eight dimensions, or NULL */
    fmb_verdict_kernel *verdict[2][2][2][2]; /* [D - 2][moving][shape of A][shape of B] */
    /* [level][D - 2][moving]: each level is slower, for lanes that the one before left open. NULL:
     * there is no further level. */
    fmb_box_kernel *box[FMB_BOX_LEVELS][2][2];
} fmb_pair_kernels;

/* The kernels of that level, NULL if this processor (or compiler) lacks it. */
const fmb_pair_kernels *fmb_pair_kernels_choose(fmb_simd level);

/* For every processor; a single pair needs no others. */
extern const fmb_pair_kernels fmb_pair_kernels_narrow;

/* Let k use these kernels, for a single pair and for many, instead of its own; for studies that
 * measure other kernels behind the same portfolio. */
void fmb_pair_use_kernels(fmb_pair *k, const fmb_pair_kernels *one, const fmb_pair_kernels *wide);

/* ---- for the other files of this room -------------------------------------------------------- */

/* They exist where FMB_PAIR_AVX2 and FMB_PAIR_AVX512 are defined. */
extern const fmb_pair_kernels fmb_pair_kernels_avx2, fmb_pair_kernels_avx512;

#endif
