/* frame_private.h: what other rooms ask about frames. */
#ifndef FMB_FRAME_FRAME_PRIVATE_H
#define FMB_FRAME_FRAME_PRIVATE_H

#include <fmb/gmp.h>

#include "trace/run.h"

/* A frame in R^dim, all of its numbers finite. */
bool fmb_frame_is_good(const fmb_frame *f, int dim);

/* The same in rationals: all denominators are there. */
bool fmb_frame_q_is_good(const fmb_frame_q *f, int dim);

static inline bool fmb_frame_is_by_corners(fmb_shape shape)
{
    return shape == FMB_CUBOID_BY_CORNERS || shape == FMB_SIMPLEX_BY_CORNERS;
}

/* Corners, more than a simplex has: coordinates in it are not unique. */
static inline bool fmb_frame_is_hull(const fmb_frame *f)
{
    return f->naxes > f->dim;
}

/* What keeps f from being one: "axes[2][0] is not finite". False: nothing does. */
enum { FMB_FRAME_FAULT_SIZE = 64 };
bool fmb_frame_describe_fault(const fmb_frame *f, int dim, char *text, size_t size);

/* fmb_system_from_frames, and _q, for a query: its cancel, its deadline, and the limit of run->mem
 * hold for the system, too. Errors: also LIMIT. */
fmb_status fmb_frames_within_limits(const fmb_frame *f, size_t n, fmb_coordinates in,
                                    fmb_contact contact, const fmb_alloc *mem, fmb_run *run,
                                    fmb_system **out);
/* run may be NULL. */
fmb_status fmb_frames_q_within_limits(const fmb_frame_q *f, size_t n, fmb_coordinates in,
                                      fmb_contact contact, const fmb_alloc *mem, fmb_run *run,
                                      fmb_system **out);

#endif
