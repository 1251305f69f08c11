/* claims.h: each claim about a row (irredundant.h) is at once recomputed from the rows. */
#ifndef FMB_TEST_CLAIMS_H
#define FMB_TEST_CLAIMS_H

#include "lp/redundancy/irredundant.h"
#include "scene.h"

typedef struct scene_listener {
    const scene *c;
    bool *gone; /* [m] */
    size_t claims;
} scene_listener;

/* The combination is the row, or stronger, over rows that are still there. */
fmb_status scene_hear_redundant(void *self, size_t i, const fmb_weights *w);
/* The combination is the reverse of the row, which is an equality from now on. */
fmb_status scene_hear_equality(void *self, size_t i, const fmb_weights *w);
/* The point breaks this row alone of those still there. */
fmb_status scene_hear_irredundant(void *self, size_t i, mpq_t *x);

#endif
