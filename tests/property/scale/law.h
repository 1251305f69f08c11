/* law.h: one law: a question whose numbers are multiplied by powers of two, as a whole, row by row
 * or coordinate by coordinate, has the same answer, up to the ends of doubles.
 *
 * Problems are small and of whole numbers, so that no scaled number is rounded. They are drawn from
 * bytes, and from a seed once these are used up: a property test has seeds alone, a fuzzer bytes.
 */
#ifndef FMB_TEST_LAW_H
#define FMB_TEST_LAW_H

#include <stddef.h>
#include <stdint.h>

#include <fmb/gmp.h>

#include "support/must.h"

typedef struct law_source {
    const uint8_t *byte; /* [left] */
    size_t left;
    uint64_t state; /* of what comes after them */
} law_source;

/* From lo to hi, both included; hi - lo < 2^16. */
int law_draw(law_source *s, int lo, int hi);

enum { LAW_WHY = 200 };

/* Draw a problem, ask it and its scaled twin. False, with a line in why, if they differ. */
typedef bool law(law_source *s, char why[LAW_WHY]);

law law_of_systems; /* solve, project, bound, optimize, reduce, vertices */
law law_of_hulls;   /* hull, image, sum, hull of a union */
law law_of_pairs;   /* verdicts and boxes in every mode */
law law_of_nears;   /* distance, depth, common points, separating rows */
law law_of_meshes;  /* that stand still, or move */
law law_of_sets;    /* of frames: pairs, one against many, all against all */

typedef struct law_entry {
    const char *name;
    law *holds;
} law_entry;

enum { LAWS = 6 };
extern const law_entry law_list[LAWS];

/* Write why; false. */
bool law_broken(char why[LAW_WHY], const char *what, int a, int b);
/* q *= 2^power */
void law_shift(mpq_t q, int power);
/* Like the rows of b: row i of a with x_j = 2^power[j] y_j in place of its variables (power NULL:
 * as they are). Compares rows as sets, each up to a positive factor, and what equalities add. */
bool law_same_rows(const fmb_system *a, const fmb_system *b, const int *power);

#endif
