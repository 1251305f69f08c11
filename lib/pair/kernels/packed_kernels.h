/* packed_kernels.h: the kernels over records of sets (pair/packed/set.h), once for each width.
 *
 * A record is 8 (in the plane) or 16 (in space) numbers: origin, D axes, speed. Records of the
 * frames of a block are transposed into its rows, and a kernel of pair_kernels.h answers it.
 *
 * Records of floats are as long. Three rows follow in their blocks: bounds of the numbers whose
 * differences are the shift and the drift, and what rounding to floats is off by, times sizes.
 */
#ifndef FMB_PAIR_KERNELS_PACKED_KERNELS_H
#define FMB_PAIR_KERNELS_PACKED_KERNELS_H

#include "frame/flat.h"
#include "pair/contact/bodies.h"
#include "pair/kernels/pair_kernels.h"

/* The verdict kernel of frames with any number of axes; rows of missing axes are not read. */
typedef fmb_pair_bits fmb_flat_kernel(const fmb_flat_kind *kind, const double *block);

/* The depths of a block, in a good lane that meets as accurate as <fmb/pair.h> promises; the normal
 * points from A to B. If all lanes are apart, only bits are written. */
typedef struct fmb_contact_lanes {
    fmb_pair_bits bits;
    unsigned good;
    double depth[FMB_BLOCK_MOST_LANES], normal[3][FMB_BLOCK_MOST_LANES];
} fmb_contact_lanes;
/* For a block as the kernel above takes it. */
typedef void fmb_contact_kernel(const fmb_flat_kind *kind, const double *block,
                                fmb_contact_lanes *out);

/* The distances of a block: a good lane is apart, and as accurate as <fmb/pair.h> promises. The
 * normal is from A to B. Points (at t = 0) and ends are relative to A's origin. */
typedef struct fmb_distance_lanes {
    unsigned good;
    double distance[FMB_BLOCK_MOST_LANES], normal[3][FMB_BLOCK_MOST_LANES];
    double point[2][3][FMB_BLOCK_MOST_LANES], time[FMB_BLOCK_MOST_LANES]; /* where, and when */
    /* if nothing moves: the upper end of A and the lower end of B along the normal */
    double low[FMB_BLOCK_MOST_LANES], high[FMB_BLOCK_MOST_LANES];
    double reach[FMB_BLOCK_MOST_LANES];
} fmb_distance_lanes;
typedef void fmb_distance_kernel(const fmb_flat_kind *kind, const double *block,
                                 fmb_distance_lanes *out);

/* The shapes of the pairs in a block. */
typedef enum fmb_packed_shapes {
    FMB_PACKED_CUBOIDS = 0,
    FMB_PACKED_ONE_OF_EACH, /* A is the cuboid */
    FMB_PACKED_SIMPLICES,
    FMB_PACKED_ANY /* any number of axes */
} fmb_packed_shapes;

/* The rows that are tested for a block: those of A's and B's faces alone, which show for most pairs
 * that they are apart, and never that they meet; or all rows (or axes). */
typedef enum fmb_asked { FMB_ASK_FACES, FMB_ASK_ALL } fmb_asked;

/* What rounding to a float is off by, times the size, and a hundredth for what is of second order.
 */
#define FMB_SINGLE_ERROR (1.01 * 0x1p-24)

/* n > 0 pairs of one kind: record index[2 i] of each side. */
typedef struct fmb_packed_pairs {
    const double *record[2];
    const float *single[2]; /* the same rounded to floats, for kernels that say so */
    /* of those: bounds of the numbers of both origins, and of both speeds; FMB_SINGLE_ERROR, or 0
     * if no number was rounded */
    double far, fast, rounding;
    const uint32_t *index[2];
    size_t n;
    bool moves;
    bool closed; /* touching is meeting; used in four and more dimensions only */
    fmb_packed_shapes shapes;
    const fmb_flat_kind *kind; /* of any shapes */
} fmb_packed_pairs;

/* One frame against many of one kind, in tiles. */
typedef struct fmb_packed_row {
    const double *one;   /* its record */
    const double *tiles; /* of records index[0] ... index[n - 1] */
    const double *record;
    const uint32_t *index;
    size_t n;
    uint64_t open; /* in more than three dimensions: which eights are tested */
    bool moves;
    bool closed;  /* as above */
    bool swapped; /* `one` is B of the blocks */
    fmb_packed_shapes shapes;
    const fmb_flat_kind *kind; /* of any shapes */
} fmb_packed_row;

/* Verdict bits of eight frames. */
typedef struct fmb_packed_bits {
    uint8_t apart, meet;
} fmb_packed_bits;

/* The kernels of one width, in the plane and in space; `kind` knows in which. */
typedef struct fmb_packed {
    fmb_flat_kernel *flat;
    fmb_contact_kernel *contact;
    fmb_distance_kernel *distance;
    /* One answer per block, of either kind; the other is NULL. */
    void (*lengths)(const fmb_packed_pairs *x, fmb_contact_lanes *contacts,
                    fmb_distance_lanes *distances);
    /* Are all verdicts known? */
    bool (*pairs[2])(const fmb_packed_pairs *x, fmb_verdict *out); /* [D - 2] */
    /* The same in space, of frames with all axes, where it pays by floats; may be NULL. */
    bool (*single)(const fmb_packed_pairs *x, fmb_verdict *out);
    /* The rows of a block of as many pairs as there are lanes, which stand still and have all axes.
     */
    void (*load)(int dim, const fmb_frame *a, const fmb_frame *b, double *block);
    /* Records index[0] ... index[n - 1], n > 0, as tiles: n rounded up to eights records. */
    void (*tiles)(int dim, const double *record, const uint32_t *index, size_t n, double *tiles);
    void (*row[2])(const fmb_packed_row *x, fmb_packed_bits *out); /* [D - 2] */
    /* The largest of n numbers in the even and in the odd places; n is even. */
    void (*largest)(const uint32_t *index, size_t n, uint32_t out[2]);
    fmb_hull_kernels hulls;
} fmb_packed;

extern const fmb_packed fmb_packed_narrow, fmb_packed_avx2, fmb_packed_avx512;

#endif
