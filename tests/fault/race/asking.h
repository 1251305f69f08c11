/* asking.h: ask a solver one question about a scene, and judge whatever comes back. */
#ifndef FMB_TEST_ASKING_H
#define FMB_TEST_ASKING_H

#include <fmb/solve.h>

#include "scenes.h"

typedef enum asking_kind {
    ASKING_SOLVE,
    ASKING_PROJECT,
    ASKING_BOUND,
    ASKING_REDUCE,
    ASKING_OPTIMIZE,
    ASKING_VERTICES,
    ASKING_HULL, /* of a cyclic polytope's vertices, whatever the scene */
    ASKING_KINDS
} asking_kind;

/* The query's result, if all is well: the verdict is unknown or the truth, the evidence is accepted
 * and says the same, and what else was handed out fits the stop. Otherwise the program ends with a
 * message. *readings: of the counted clock, when the query came back. */
fmb_result asking(fmb_solver *v, const scene *c, asking_kind kind, size_t *readings);

/* Print and end the program. */
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2), noreturn))
#endif
void asking_fail(const char *format, ...);

#endif
