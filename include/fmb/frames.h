/* fmb/frames.h: sets of frames, stored once and queried often.
 *
 * A set keeps each frame as one record of aligned numbers, edges included, checked once. Queries
 * name frames by their numbers: records of a block of pairs are transposed into vector registers,
 * without following pointers and with no second copy; where one frame is tested against many, or
 * all against all, its own lanes and those of a chunk of the others are made once. Verdicts are
 * those of fmb_pair_test (<fmb/pair.h>), which decides the pairs that doubles leave open.
 *
 * There are kernels for all frames with edges that are doubles in two and three dimensions, and, by
 * edges with all their axes, for two cuboids in four to eight (moving: to seven), for two simplices
 * in four to six, still or moving, and for a cuboid and a simplex in four to six (moving: to five),
 * if they are neither so flat that one of their corners is less than about 1e-9 of their size away
 * from the plane of the others, nor larger than 1e90 or smaller than 1e-90. Pairs with other frames
 * are decided one at a time.
 *
 *   fmb_frames_new(3, n, frames, NULL, &set);
 *   fmb_pair_new(3, NULL, NULL, &k);
 *   fmb_frames_meet(k, set, NULL, told, self);      which pairs of the set meet, in order
 *
 * Source: Baillehache 2020 (FMB), whose frames are prepared "once for all".
 */
#ifndef FMB_FRAMES_H
#define FMB_FRAMES_H

#include <fmb/pair.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- sets ------------------------------------------------------------------------------------ */

/* A set of frames of one dimension. It never changes once it is made, so threads may share it. */
typedef struct fmb_frames fmb_frames;

/* The most frames of a set. */
#define FMB_FRAMES_MOST ((size_t)UINT32_MAX - 1)

/* [give] A set of n frames of that dimension; everything is copied. Frames may be of different
 * shapes, with any number of axes, by edges or by corners, still or moving. Errors: ARG (dim not 1
 * to FMB_FRAME_MOST_DIM, too many frames, an invalid frame, a number that is not finite), MEMORY.
 */
FMB_API FMB_CHECKED fmb_status fmb_frames_new(int dim, size_t n, const fmb_frame *f,
                                              const fmb_alloc *mem, fmb_frames **out);

/* Frames of one shape in arrays, of double or of float. */
typedef struct fmb_frame_arrays {
    size_t size; /* sizeof(fmb_frame_arrays) */
    fmb_shape shape;
    int naxes;
    bool single;        /* numbers are float, not double */
    const void *origin; /* [n][dim] */
    const void *axes;   /* [n][naxes][dim] */
    const void *speed;  /* [n][dim], or NULL: nothing moves */
} fmb_frame_arrays;

/* [give] A set from arrays. Errors: as above, also ARG (an array that must not be NULL). */
FMB_API FMB_CHECKED fmb_status fmb_frames_from_arrays(int dim, size_t n, const fmb_frame_arrays *a,
                                                      const fmb_alloc *mem, fmb_frames **out);
FMB_API void fmb_frames_free(fmb_frames *s);

/* 0 for NULL. */
FMB_API int fmb_frames_dim(const fmb_frames *s);
FMB_API size_t fmb_frames_count(const fmb_frames *s);
/* Frame i; its arrays are valid as long as the set. If there is none, or s is NULL: all zeros. */
FMB_API fmb_frame fmb_frames_at(const fmb_frames *s, size_t i);

/* ---- queries --------------------------------------------------------------------------------- */

/* Frame a of the first set and frame b of the second. */
typedef struct fmb_frames_pair {
    uint32_t a, b;
} fmb_frames_pair;

/* Answers to pairs pair[i], 0 <= i < n, in the arrays of out, [n] each, as fmb_pair_test gives
 * them. With options.threads, pairs are shared among so many threads; answers are the same for any
 * number. fmb_pair_cancel stops this, too. Errors: ARG (NULL, sets of another dimension than k, no
 * such frame: fmb_pair_trouble names the pair), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_frames_test(fmb_pair *k, const fmb_frames *a,
                                               const fmb_frames *b, size_t n,
                                               const fmb_frames_pair *pair,
                                               const fmb_pair_answers *out);

/* One against many: verdict[j] on frame i of a and frame j of b, for all of b. Errors: as above. */
FMB_API FMB_CHECKED fmb_status fmb_frames_test_row(fmb_pair *k, const fmb_frames *a, size_t i,
                                                   const fmb_frames *b, fmb_verdict *verdict);

/* A callback that gets n > 0 pairs with this verdict, FEASIBLE or UNKNOWN; false: stop. */
typedef bool fmb_frames_told(void *self, fmb_verdict verdict, size_t n,
                             const fmb_frames_pair *pair);

/* All against all: told gets, in several calls, every pair of a frame of a and one of b that meet,
 * ordered by a, then b; if b is NULL or a: the pairs (i, j), i < j, of a. UNKNOWN pairs follow the
 * meeting pairs of the same portion. Calls come one at a time and are the same for any number of
 * threads, though perhaps made by other threads than the caller's. Errors: as above; OK after told
 * returned false, or a cancel. */
FMB_API FMB_CHECKED fmb_status fmb_frames_meet(fmb_pair *k, const fmb_frames *a,
                                               const fmb_frames *b, fmb_frames_told *told,
                                               void *self);

#ifdef __cplusplus
}
#endif
#endif
