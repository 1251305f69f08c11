/* fmb/pair.h: do two frames meet, where, and when?
 *
 * Doubles are asked first. They answer with an error bound, and say nothing where the truth lies
 * within it; then an exact query decides. So every verdict is exact, and fast unless the frames
 * nearly touch, are nearly flat, or have fewer axes than the space has dimensions.
 *
 * Source: Baillehache 2020 (FMB); docs/theory.md, "Pairs".
 */
#ifndef FMB_PAIR_H
#define FMB_PAIR_H

#include <fmb/frame.h>
#include <fmb/options.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How verdicts on pairs are found. */
typedef enum fmb_pair_method {
    FMB_PAIR_FMB = 0, /* Fourier-Motzkin elimination in doubles, then exact */
    FMB_PAIR_EXACT    /* nothing but exact */
} fmb_pair_method;

/* How pairs are asked. All zeros but the size are the defaults. */
typedef struct fmb_pair_options {
    size_t size; /* sizeof(fmb_pair_options) */
    fmb_contact contact;
    fmb_pair_method method;
    bool tightest; /* ends of boxes are the exact ones, each rounded outward to a double; if not,
                      they may lie farther out by 1e-12 of the largest coordinate of the frames */
    bool doubles_only; /* do not ask exactly: the verdict may be UNKNOWN, which also stands where a
                          box that was asked for is not known well enough */
    fmb_simd simd;
    size_t threads; /* of queries over sets (<fmb/frames.h>), at most 64; 0 or 1: the caller's
                       alone. The allocator must then be safe for threads */
    /* Limits of one exact query: beyond them the verdict is UNKNOWN. */
    double max_seconds; /* [s]; 0 = no limit */
    size_t max_bytes;   /* its system and workspace, and as much again for the proof of a witness
                           [bytes]; 0 = 1 GiB; SIZE_MAX = no limit */
} fmb_pair_options;

/* Why fmb_pair_new refuses these options, as fmb_options_trouble tells of others. */
FMB_API size_t fmb_pair_options_trouble(const fmb_pair_options *o, char *text, size_t size);

/* Where answers go: arrays of the caller's, for n pairs. Every one but verdict may be NULL. Of a
 * pair that does not meet (or is UNKNOWN) only the verdict is written. The common points are those
 * that both frames (closed, whatever the contact) hold at one time t; a witness is one of them, up
 * to rounding. Ends come as lower, upper. [world length units; c and t have none] */
typedef struct fmb_pair_answers {
    size_t size;          /* sizeof(fmb_pair_answers) */
    fmb_verdict *verdict; /* [n] FEASIBLE: they meet */
    double *world;        /* [n][dim][2] the common points, tightly */
    double *inside;  /* [n][dim][2] their coordinates c in the second frame; rows from its naxes
                        on are not written, and none is where naxes > dim */
    double *time;    /* [n][2] when they meet; 0, 1 if nothing moves */
    double *witness; /* [n][dim] a common point */
    /* In two and three dimensions, of frames with at most dim axes, or 64 corners; what moves
     * counts as all its places. */
    double *depth;  /* [n] of the shortest translation of the second after which they do no more
                       than touch; off by at most 1e-12 of the sum of the sizes (largest
                       coordinates) of all edges, speeds and the way between the origins; of a frame
                       with more axes than dim its longest edge counts twice */
    double *normal; /* [n][dim] its direction, of length 1, away from the first; the depth along it
                       is off by no more than that either */
    /* Where they touch after that translation, up to what the depth may be off by (along faces that
     * cross at an acute angle, that over its sine); of frames that move 0 and nothing. */
    uint8_t *faces; /* [n][2] the vertices of the face of each, a bit each: bit b is vertex b, of a
                       cuboid the one where c_i is bit i of b, of a simplex the origin (0) or the
                       end of edge b (from 1); so one bit is a vertex, two are an edge; 0 of more
                       than 8 vertices */
    double *points; /* [n][FMB_PAIR_MOST_POINTS][dim] vertices of what the faces have in common, on
                       the first frame, around it; of more, four that are far apart */
    uint8_t *npoints; /* [n] how many */
    /* The same of pairs that do not meet, if any of these is asked for; the normal, then, too: from
     * the nearest point of the first to that of the second (0 where they touch with open contact).
     */
    double *distance; /* [n] off by no more than a depth; 0 of pairs that meet */
    double *nearest;  /* [n][2][dim] a point of each, up to rounding, that far from each other */
    double *offset;   /* [n] a row between them: normal.x <= offset holds for the first, and
                         normal.x >= offset for the second, exactly and for the normal as it is
                         written; NAN where no doubles are known to, and if they move */
} fmb_pair_answers;

/* Points of a contact. */
enum { FMB_PAIR_MOST_POINTS = 4 };

/* How many pairs were asked, and how many of them exactly. */
typedef struct fmb_pair_counts {
    size_t size;             /* sizeof(fmb_pair_counts) */
    uint64_t pairs;          /* asked so far */
    uint64_t exact_verdicts; /* of those, decided exactly */
    uint64_t exact_boxes;    /* of those, answered with more than a verdict by an exact query */
} fmb_pair_counts;

/* Workspace for pairs of frames of one dimension; it belongs to one thread at a time. */
typedef struct fmb_pair fmb_pair;

/* [give] Options are copied; NULL means the default. Errors: ARG (dim not 1 to FMB_FRAME_MOST_DIM,
 * an option out of range, or instructions that the processor lacks), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_pair_new(int dim, const fmb_pair_options *o,
                                            const fmb_alloc *mem, fmb_pair **out);
FMB_API void fmb_pair_free(fmb_pair *k);

/* Answer pairs (p[i], q[i]), 0 <= i < n. A frame with a speed moves; t is the time of both.
 * Verdicts and tightest ends are the same on every processor, and whether pairs are asked together
 * or one by one; other ends and witnesses may differ by rounding. Only exact queries allocate. On
 * an error, answers of some pairs may have been written. Errors: ARG (another dimension, a frame
 * that is none, a number that is not finite; fmb_pair_trouble says more), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_pair_test(fmb_pair *k, size_t n, const fmb_frame *p,
                                             const fmb_frame *q, const fmb_pair_answers *out);

/* Why the last fmb_pair_test returned FMB_ERR_ARG, one line: "q[17]: axes[0][2] is not finite" is
 * about that number of frame q[17]; "" otherwise, and for NULL. Good until the next call. */
FMB_API const char *fmb_pair_trouble(const fmb_pair *k);

/* What k was asked so far. Errors: ARG (NULL, a size that is none). */
FMB_API FMB_CHECKED fmb_status fmb_pair_count(const fmb_pair *k, fmb_pair_counts *out);

/* Ask a running fmb_pair_test to stop soon: what is not decided is UNKNOWN. The one call allowed
 * from another thread or a signal handler. NULL is fine. */
FMB_API void fmb_pair_cancel(fmb_pair *k);

#ifdef __cplusplus
}
#endif
#endif
