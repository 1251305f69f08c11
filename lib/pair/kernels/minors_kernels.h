/* minors_kernels.h: the kernels over records of sets (pair/packed/set.h) in four to eight
 * dimensions, once for each width; see minors/minors_kernel.h.
 *
 * A record of a cuboid or simplex with all its axes holds, from these places on,
 *
 *     0            origin, D           D (D + 1)    speed, D, of a still frame 0
 *     D            axes, D D           D (D + 2)    inverse, D D, row by row
 *     2 D (D + 1)  reach, D            D (2 D + 3)  size, whole, grain, units
 *
 * and zeros up to a multiple of eight numbers. The determinant of the axes is positive: where that
 * of the frame's is not, two of them are exchanged. inverse times (point - origin) gives the
 * coordinates of a point along the axes; reach bounds the sum of the absolute values of each row of
 * it, size the numbers of the axes. Exact definitions, and which frames have records:
 * kernels/inverse.h.
 */
#ifndef FMB_PAIR_KERNELS_MINORS_KERNELS_H
#define FMB_PAIR_KERNELS_MINORS_KERNELS_H

#include <math.h>

#include "pair/kernels/packed_kernels.h"

enum { FMB_MINORS_LEAST_DIM = 4, FMB_MINORS_MOST_DIM = 8, FMB_MINORS_DIMS = 5 };

static inline bool fmb_minors_is_dim(int dim)
{
    return dim >= FMB_MINORS_LEAST_DIM && dim <= FMB_MINORS_MOST_DIM;
}

/* Numbers of a record. */
static inline int fmb_minors_record(int dim)
{
    return (2 * dim * dim + 3 * dim + 4 + 7) / 8 * 8;
}

enum { FMB_MINORS_MOST_RECORD = 2 * 8 * 8 + 3 * 8 + 8 };

/* Pack two exponents of powers of two into one number: of the unit of all axes and the speed, and
 * of the unit of the origin. */
static inline double fmb_minors_join_units(int axes, int origin)
{
    return 8192.0 * axes + origin;
}
static inline void fmb_minors_split_units(double both, int *axes, int *origin)
{
    *axes = (int)floor(both / 8192 + 0.5);
    *origin = (int)(both - 8192.0 * *axes);
}

/* Numbers in the memory for the minors, of two views, that a next level needs. With n columns and
 * levels up to K (minors_kernel.h) a view has the sum over 1 < k <= K of choose(rows, k) choose(n,
 * k); simplices also have words for their signs and one lane more for each set of rows. Of a cuboid
 * and a simplex only one view needs memory. */
static inline size_t fmb_minors_room(int dim)
{
    static const size_t lanes[FMB_MINORS_DIMS] = {170, 1120, 2828, 2548, 3920};
    return 2 * FMB_BLOCK_MOST_LANES * lanes[dim - FMB_MINORS_LEAST_DIM];
}

/* The kind of pairs in records: 2 for simplices, 4 for a cuboid and a simplex, the cuboid first;
 * plus 1 if anything moves. */
typedef enum fmb_minors_what {
    FMB_MINORS_STILL,
    FMB_MINORS_MOVING,
    FMB_MINORS_SIMPLICES,
    FMB_MINORS_MOVING_SIMPLICES,
    FMB_MINORS_MIXED,
    FMB_MINORS_MOVING_MIXED,
    FMB_MINORS_WHATS
} fmb_minors_what;

static inline fmb_minors_what fmb_minors_what_of(bool simplex_a, bool simplex_b, bool moves)
{
    const int shapes = simplex_a != simplex_b ? FMB_MINORS_MIXED
                       : simplex_a            ? FMB_MINORS_SIMPLICES
                                              : FMB_MINORS_STILL;
    return (fmb_minors_what)(shapes + moves);
}

/* Is there a kernel for this dimension and kind? */
static inline bool fmb_minors_decide(int dim, fmb_minors_what what)
{
    const int moves = (int)what % 2;
    const int most = what < FMB_MINORS_SIMPLICES ? 8 - moves
                     : what < FMB_MINORS_MIXED   ? 6
                                                 : 6 - moves;
    return fmb_minors_is_dim(dim) && dim <= most;
}

/* In packed pairs and rows, shapes and kinds are ignored. room: fmb_minors_room(dim) numbers,
 * aligned to 64 bytes. */
typedef struct fmb_minor_kernels {
    /* Fill in inverse, reach and size of n records, at most as many as there are lanes, from
     * origin, axes (whose order may change) and speed, and in place of `whole` the approximate
     * determinant of the axes over the least greater power of two of the size. Returns bits of the
     * good records: a frame that is flat, or so slender or large that no inverse is certain, has
     * none, or one whose numbers are not finite. */
    unsigned (*invert)(int dim, double *const *record, unsigned n);
    bool (*pairs)(int dim, fmb_minors_what what, const fmb_packed_pairs *x, double *room,
                  fmb_verdict *out);
    void (*tiles)(int dim, const double *record, const uint32_t *index, size_t n, double *tiles);
    void (*row)(int dim, fmb_minors_what what, const fmb_packed_row *x, double *room,
                fmb_packed_bits *out);
} fmb_minor_kernels;

extern const fmb_minor_kernels fmb_minors_narrow, fmb_minors_avx2, fmb_minors_avx512;

#endif
