/* two.h: random pairs of frames of many kinds, in any dimension. */
#ifndef FMB_TEST_TWO_H
#define FMB_TEST_TWO_H

#include <fmb/frame.h>

#include "support/support.h"

enum { TWO_MOST_DIM = 16 };

typedef enum family {
    ARTICLE,  /* evenly in -100 ... 100 */
    LATTICE,  /* whole numbers -2 ... 2: touching, degenerate, dependent axes */
    NEAR,     /* those, one origin a little aside */
    FLAT,     /* article, one axis of 1e-8 */
    TINY,     /* article, one frame by 1e-9 */
    FAR,      /* article, both 1e9 away */
    DENORMAL, /* lattice in multiples of the least double */
    HUGE,     /* lattice in multiples of 2^1021: differences may overflow */
    MIXED,    /* lattice, each world coordinate in a unit of its own */
    GRAZING,  /* lattice, touching but for rounding */
    FAMILIES
} family;

typedef struct two {
    fmb_frame f[2];
    double number[2][TWO_MOST_DIM * (TWO_MOST_DIM + 2)];
} two;

/* closer: of the distance between the origins. The struct must not move. */
void two_draw(support_rng *g, family of, int dim, bool moves, bool faces, double closer, two *out);

#endif
