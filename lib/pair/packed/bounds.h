/* bounds.h: axis-aligned boxes around the frames of a set, eight frames per box: they show, before
 * any kernel runs, that a frame meets none of the eight. One comparison for eight pairs costs next
 * to nothing where boxes meet, and saves most of the work where they do not, as in a mesh.
 */
#ifndef FMB_PAIR_BOUNDS_H
#define FMB_PAIR_BOUNDS_H

#include "pair/packed/set.h"

/* The most dimensions of a record. */
enum { FMB_BOUNDS_MOST_DIM = 8 };

/* A box that contains a frame at all times, rounded outward; an end may be infinite. */
typedef struct fmb_bounds {
    double lower[FMB_BOUNDS_MOST_DIM], upper[FMB_BOUNDS_MOST_DIM];
} fmb_bounds;

/* The box of frame i, which has a record of a kind other than NONE. */
void fmb_bounds_of_frame(const fmb_frames *s, size_t i, fmb_bounds *out);

/* Fill s->bounds and s->ends, once s->order is set. */
void fmb_bounds_of_eights(fmb_frames *s);

/* The most groups of eight in one call below. */
enum { FMB_BOUNDS_MOST = 64 };

/* Bit g < eights: the box may meet the one around the eight frames order[from + 8 g ...] of s, all
 * of one kind. from is the first of that kind plus a multiple of eight. */
uint64_t fmb_bounds_open_eights(const fmb_frames *s, size_t from, size_t eights,
                                const fmb_bounds *box);

/* Are the frames order[from ... from + 7] of s, from as above, in more than three dimensions, all
 * beyond this box? */
bool fmb_bounds_are_beyond(const fmb_frames *s, size_t from, const fmb_bounds *box);

#endif
