/* bounds.h: boxes along the axes around the frames of a set, eight at a time: what tells, before
 * any kernel is asked, that a frame meets none of the eight. A comparison for eight pairs is next
 * to nothing where boxes meet, and most of the work where they do not, as in a mesh.
 */
#ifndef FMB_PAIR_BOUNDS_H
#define FMB_PAIR_BOUNDS_H

#include "pair/packed/set.h"

/* No frame in more dimensions has a record. */
enum { FMB_BOUNDS_MOST_DIM = 8 };

/* A box that holds a frame at all times, rounded outward; an end may be infinite. */
typedef struct fmb_bounds {
    double lower[FMB_BOUNDS_MOST_DIM], upper[FMB_BOUNDS_MOST_DIM];
} fmb_bounds;

/* Of frame i, which has a record of a kind but NONE. */
void fmb_bounds_of_frame(const fmb_frames *s, size_t i, fmb_bounds *out);

/* Fill s->bounds, once s->order is there. */
void fmb_bounds_of_eights(fmb_frames *s);

/* Most eights that one question is about. */
enum { FMB_BOUNDS_MOST = 64 };

/* Bit g < eights: the box may meet that around frames order[from + 8 g ...] of s, eight of a kind.
 * from is that kind's first or a multiple of eight behind it. */
uint64_t fmb_bounds_open_eights(const fmb_frames *s, size_t from, size_t eights,
                                const fmb_bounds *box);

#endif
