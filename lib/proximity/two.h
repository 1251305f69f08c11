/* two.h: the two frames of a question, in doubles or in rationals. */
#ifndef FMB_PROXIMITY_TWO_H
#define FMB_PROXIMITY_TWO_H

#include "frame/frame_integers.h"
#include "frame/frame_private.h"
#include "solve/query/solver.h"

/* One of f and q is not NULL: [2], of one dimension. */
typedef struct fmb_two {
    const fmb_frame *f;
    const fmb_frame_q *q;
} fmb_two;

/* Are there two frames, and a place for the answer? Errors: ARG. */
fmb_status fmb_two_expect(fmb_solver *v, const fmb_two *two, bool out, const fmb_result *res);
int fmb_two_dim(const fmb_two *two);
bool fmb_two_moves(const fmb_two *two);

/* [give] Where they meet. Errors: ARG (dependent axes, where c is no variable), MEMORY. */
fmb_status fmb_two_system(const fmb_two *two, fmb_coordinates in, fmb_contact contact,
                          const fmb_alloc *mem, fmb_system **out);
/* fmb_scene_clear it, whatever is returned. Errors: MEMORY. */
fmb_status fmb_two_scene(const fmb_two *two, fmb_mem *mem, fmb_scene *out);

#endif
