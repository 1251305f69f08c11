/* fmb/pair.h: do two frames meet, where, and when?
 *
 * Doubles with an error bound come first; where the bound leaves the answer open, an exact query
 * decides. So every verdict is exact, and fast unless the frames nearly touch, are nearly flat, or
 * have fewer axes than the space has dimensions.
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
    FMB_PAIR_EXACT    /* exact queries only */
} fmb_pair_method;

/* Options of pair queries. All zeros but the size are the defaults. */
typedef struct fmb_pair_options {
    size_t size; /* sizeof(fmb_pair_options) */
    fmb_contact contact;
    fmb_pair_method method;
    bool tightest; /* ends of boxes are the exact ones, each rounded outward to a double; if not,
                      they may lie farther out by 1e-12 of the largest coordinate of the frames */
    bool doubles_only; /* no exact queries: the verdict may be UNKNOWN, also if a requested box is
                          not known accurately enough */
    fmb_simd simd;
    size_t threads; /* for queries over sets (<fmb/frames.h>), at most 64; 0 or 1: only the
                       caller's. With more, the allocator must be safe for threads */
    /* Limits of one exact query: beyond them the verdict is UNKNOWN. */
    double max_seconds; /* [s]; 0 = no limit */
    size_t max_bytes;   /* of its system and workspace, and once more for the proof of a witness
                           [bytes]; 0 = 1 GiB; SIZE_MAX = no limit */
} fmb_pair_options;

/* Why fmb_pair_new refuses these options, like fmb_options_trouble. */
FMB_API size_t fmb_pair_options_trouble(const fmb_pair_options *o, char *text, size_t size);

/* The caller's arrays for the answers about n pairs. All but verdict may be NULL. For a pair that
 * does not meet (or is UNKNOWN) only the verdict is written. The common points are those in both
 * frames (closed, whatever the contact) at one time t; a witness is one of them, up to rounding.
 * Ends come as lower, upper. [world length units; c and t have none] */
typedef struct fmb_pair_answers {
    size_t size;          /* sizeof(fmb_pair_answers) */
    fmb_verdict *verdict; /* [n] FEASIBLE: they meet */
    double *world;        /* [n][dim][2] tight box of the common points */
    double *inside;  /* [n][dim][2] tight box of their coordinates c in the second frame; rows from
                        its naxes on are not written, and no row if naxes > dim */
    double *time;    /* [n][2] when they meet; 0, 1 if nothing moves */
    double *witness; /* [n][dim] a common point */
    /* In two and three dimensions, for frames with at most dim axes, or 64 corners; a moving frame
     * counts as the union of all its places. */
    double *depth;  /* [n] the length of the shortest translation of the second after which they at
                       most touch; with an error of at most 1e-12 of the sum of the sizes (largest
                       coordinates) of all edges, speeds and the vector between the origins; for a
                       frame with more axes than dim its longest edge counts twice */
    double *normal; /* [n][dim] its direction, of length 1, away from the first; the depth along it
                       has no larger error */
    /* The contact after that translation, up to the error of the depth (for faces that cross at an
     * acute angle, divided by its sine); for moving frames 0 and nothing. */
    uint8_t *faces; /* [n][2] the vertices of the face of each, as bits: bit b is vertex b, of a
                       cuboid the one where c_i is bit i of b, of a simplex the origin (0) or the
                       end of edge b (from 1); so one bit is a vertex, two are an edge; 0 if there
                       are more than 8 vertices */
    double *points; /* [n][FMB_PAIR_MOST_POINTS][dim] vertices of the intersection of the faces, on
                       the first frame, in order around it; if there are more, four far apart */
    uint8_t *npoints; /* [n] their number */
    /* For pairs that do not meet, under the same conditions; if any of these is requested, the
     * normal is written for them, too: from the nearest point of the first to that of the second (0
     * if they touch with open contact). */
    double *distance; /* [n] with the error bound of a depth; 0 for pairs that meet */
    double *nearest;  /* [n][2][dim] a point of each, up to rounding, at that distance */
    double *offset;   /* [n] a row between them: normal.x <= offset holds for the first, and
                         normal.x >= offset for the second, exactly and for the normal as
                         written; NAN if no such double is found, and if they move */
} fmb_pair_answers;

/* The most points of a contact. */
enum { FMB_PAIR_MOST_POINTS = 4 };

/* Counts of pairs, and of those decided exactly. */
typedef struct fmb_pair_counts {
    size_t size;             /* sizeof(fmb_pair_counts) */
    uint64_t pairs;          /* all so far */
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
 * Verdicts and tightest ends are the same on every processor, and for pairs given together or one
 * by one; other ends and witnesses may differ by rounding. Only exact queries allocate. On an
 * error, answers of some pairs may have been written. Errors: ARG (another dimension, an invalid
 * frame, a number that is not finite; fmb_pair_trouble says more), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_pair_test(fmb_pair *k, size_t n, const fmb_frame *p,
                                             const fmb_frame *q, const fmb_pair_answers *out);

/* Why the last fmb_pair_test returned FMB_ERR_ARG, one line: "q[17]: axes[0][2] is not finite" is
 * about that number of frame q[17]; "" otherwise, and for NULL. Valid until the next call. */
FMB_API const char *fmb_pair_trouble(const fmb_pair *k);

/* The counts of k so far. Errors: ARG (NULL, an invalid size). */
FMB_API FMB_CHECKED fmb_status fmb_pair_count(const fmb_pair *k, fmb_pair_counts *out);

/* Ask a running fmb_pair_test to stop soon: undecided pairs are UNKNOWN. The one call allowed from
 * another thread or a signal handler. NULL is fine. */
FMB_API void fmb_pair_cancel(fmb_pair *k);

#ifdef __cplusplus
}
#endif
#endif
