/* two.h: the two frames of a question, in doubles or in rationals. */
#ifndef FMB_PROXIMITY_TWO_H
#define FMB_PROXIMITY_TWO_H

#include "frame/frame_integers.h"
#include "frame/frame_private.h"
#include "solve/query/solver.h"

/* Either f or q is not NULL: [2] frames of one dimension. */
typedef struct fmb_two {
    const fmb_frame *f;
    const fmb_frame_q *q;
} fmb_two;

/* Are there two frames, and a place for the answer? Errors: ARG. */
fmb_status fmb_two_expect(fmb_solver *v, const fmb_two *two, bool out, const fmb_result *res);
int fmb_two_dim(const fmb_two *two);
bool fmb_two_moves(const fmb_two *two);

/* [give] The system of common points. Errors: ARG (dependent axes, c no variables), MEMORY. */
fmb_status fmb_two_system(const fmb_two *two, fmb_coordinates in, fmb_contact contact,
                          const fmb_alloc *mem, fmb_system **out);

#endif
