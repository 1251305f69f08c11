/* meet.h: verdicts for the tests of frames. */
#ifndef FMB_TEST_MEET_H
#define FMB_TEST_MEET_H

#include <fmb/frame.h>
#include <fmb/gmp.h>

/* The system of closed frames. */
fmb_system *meeting(const fmb_frame *f, size_t n, fmb_coordinates in);
/* The verdict on a system, whose evidence has to be accepted. */
bool is_feasible(const fmb_system *s);
/* The same of frames. */
bool meet(const fmb_frame *f, size_t n, fmb_coordinates in);
bool meet_open(const fmb_frame *f, size_t n, fmb_coordinates in);

/* A frame in rationals, with numbers of its own. */
fmb_frame_q rational_new(fmb_shape shape, int dim, int naxes, bool moves);
/* The same numbers as those of a frame of doubles. */
fmb_frame_q rational_of(const fmb_frame *f);
void rational_free(fmb_frame_q *f);

#endif
