/* frame.h: what other rooms ask about a frame. */
#ifndef FMB_FRAME_FRAME_H
#define FMB_FRAME_FRAME_H

#include <fmb/frame.h>

/* A frame in R^dim, all of its numbers finite. */
bool fmb_frame_is_good(const fmb_frame *f, int dim);

#endif
