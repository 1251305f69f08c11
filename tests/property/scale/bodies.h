/* bodies.h: two frames of small whole numbers, and the same with coordinate j times 2^power[j]. */
#ifndef FMB_TEST_BODIES_H
#define FMB_TEST_BODIES_H

#include "property/scale/law.h"

enum { BODIES_MOST_DIM = 4, BODIES_NUMBERS = BODIES_MOST_DIM * (BODIES_MOST_DIM + 2) };

typedef struct bodies {
    int dim, power[BODIES_MOST_DIM];
    fmb_frame plain[2], scaled[2]; /* into number: not to be copied */
    double number[2][2][BODIES_NUMBERS];
} bodies;

/* uniform: one power for all coordinates; else often. moves: something may move. */
void bodies_draw(law_source *g, bool uniform, bool moves, bodies *out);

#endif
