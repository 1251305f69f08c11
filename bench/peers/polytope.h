/* polytope.h: polytopes by name, for vertices and hulls.
 *
 * "cube:16", "sphere:5:100": a family, a size and perhaps a number of rows. Families that are
 * random take a seed.
 */
#ifndef FMB_PEERS_POLYTOPE_H
#define FMB_PEERS_POLYTOPE_H

#include "problem.h"

typedef struct polytope_plan {
    int family, size, rows;
    uint64_t seed;
} polytope_plan;

/* False if the text names no family, or no size. */
bool polytope_parse(const char *text, polytope_plan *plan);
void polytope_draw(const polytope_plan *plan, problem *p, const char *name);

#endif
