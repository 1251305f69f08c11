/* bodies.h: frames of small whole numbers, and the same with coordinate j times 2^power[j]. */
#ifndef FMB_TEST_BODIES_H
#define FMB_TEST_BODIES_H

#include "property/scale/law.h"

enum { BODIES_MOST_DIM = 4, BODIES_NUMBERS = BODIES_MOST_DIM * (BODIES_MOST_DIM + 2) };

/* A frame, plain and scaled, into its numbers: not to be copied. */
typedef struct body {
    fmb_frame frame[2];
    double number[2][BODIES_NUMBERS];
} body;

typedef struct bodies {
    int dim, power[BODIES_MOST_DIM];
    fmb_frame plain[2], scaled[2];
    body body[2]; /* those again */
} bodies;

/* uniform: one power for all coordinates; else often. */
void bodies_draw_powers(law_source *g, int dim, bool uniform, int *power);
/* Of whole numbers up to `most`; moves: it may move. */
void bodies_draw_body(law_source *g, int dim, int most, bool moves, const int *power, body *out);
/* Two of them; moves: something may move. */
void bodies_draw(law_source *g, bool uniform, bool moves, bodies *out);

#endif
