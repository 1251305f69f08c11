/* farther.h: normals along which M (difference.h) surely reaches farther than it is said to, told
 * by doubles.
 */
#ifndef VALIDATE_FARTHER_H
#define VALIDATE_FARTHER_H

#include "fmb-validate/difference.h"

/* Columns: the axes of both sides, the drift, `away`, and the coordinates of the space. */
enum {
    VALIDATE_DRIFT = 2 * VALIDATE_MOST_DIM,
    VALIDATE_AWAY,
    VALIDATE_COORDINATES,
    VALIDATE_COLUMNS = VALIDATE_COORDINATES + VALIDATE_MOST_DIM
};

/* What is left of all columns at right angles to the edges chosen: of each row bounds for its
 * numbers, and for what these are off by. */
typedef struct validate_rest {
    double x[VALIDATE_MOST_DIM][VALIDATE_COLUMNS], most[VALIDATE_MOST_DIM], off[VALIDATE_MOST_DIM];
} validate_rest;

typedef struct validate_farther {
    const validate_difference *m;
    double length[VALIDATE_AWAY + 1];      /* of a column */
    double share[VALIDATE_MOST_DIM];       /* of a coordinate of a normal; of the largest one 1 */
    double claim;                          /* how far */
    validate_rest rest[VALIDATE_MOST_DIM]; /* with so many edges chosen */
} validate_farther;

void validate_farther_load(validate_farther *f, const validate_difference *m, const mpq_t square);
/* One edge more, after that many; false if doubles do not tell that it is independent of them. */
bool validate_farther_choose(validate_farther *f, int chosen, const validate_edge *e);
/* All but one dimension are chosen: does M surely reach farther along their normal, and back? */
bool validate_is_farther(const validate_farther *f);

#endif
