/* bodies.h: random pairs of frames, and their Minkowski difference corner by corner. */
#ifndef FMB_TEST_BODIES_H
#define FMB_TEST_BODIES_H

#include <fmb/gmp.h>

#include "support/support.h"

enum { BODIES_MOST_DIM = 4, BODIES_MOST_CORNERS = 2 * 16 * 16 };

/* Two frames and their numbers. */
typedef struct bodies {
    double origin[2][BODIES_MOST_DIM], axes[2][BODIES_MOST_DIM * BODIES_MOST_DIM];
    double speed[2][BODIES_MOST_DIM];
    fmb_frame f[2];
} bodies;

/* Any shapes, numbers of axes and, now and then, speeds; coarse ones touch often. Their origins
 * differ by so much at most. The struct must not move. */
void bodies_draw(support_rng *g, int dim, bool coarse, int spread, bodies *b);

/* p - q + t (speed - speed) for corners p, q and t = 0, 1: all vertices of the difference, and
 * more. */
typedef struct difference {
    int dim, corners;
    mpq_t corner[BODIES_MOST_CORNERS][BODIES_MOST_DIM];
} difference;

difference *difference_new(const fmb_frame *f);
void difference_free(difference *m);
/* out = the least u.m over the corners m. */
void difference_least(const difference *m, mpq_t *u, mpq_t out);

/* A frame in rationals, moved by shift (NULL: not). */
fmb_frame_q bodies_moved(const fmb_frame *f, mpq_t *shift);

#endif
