/* frame_private.h: checks of frames and systems from frames, for other rooms. */
#ifndef FMB_FRAME_FRAME_PRIVATE_H
#define FMB_FRAME_FRAME_PRIVATE_H

#include <fmb/gmp.h>

#include "trace/run.h"

/* Is f a frame in R^dim with finite numbers only? */
bool fmb_frame_is_good(const fmb_frame *f, int dim);

/* Like the function above, for rationals: no denominator is 0. */
bool fmb_frame_q_is_good(const fmb_frame_q *f, int dim);

static inline bool fmb_frame_is_by_corners(fmb_shape shape)
{
    return shape == FMB_CUBOID_BY_CORNERS || shape == FMB_SIMPLEX_BY_CORNERS;
}

/* Has the frame more corners than a simplex? Then coordinates in it are not unique. */
static inline bool fmb_frame_is_hull(const fmb_frame *f)
{
    return f->naxes > f->dim;
}

/* Say why f is not a frame in R^dim: "axes[2][0] is not finite". False: it is one. */
enum { FMB_FRAME_FAULT_SIZE = 64 };
bool fmb_frame_describe_fault(const fmb_frame *f, int dim, char *text, size_t size);

/* fmb_system_from_frames, or _q (one of f and q is NULL), within a query: cancel, deadline and
 * memory limit of run apply to making the system, too; run may be NULL. Errors: also LIMIT. */
fmb_status fmb_frames_within_limits(const fmb_frame *f, const fmb_frame_q *q, size_t n,
                                    fmb_coordinates in, fmb_contact contact, const fmb_alloc *mem,
                                    fmb_run *run, fmb_system **out);

#endif
