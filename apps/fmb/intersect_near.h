/* intersect_near.h: what `fmb intersect` is asked for beside verdicts and boxes: distance, depth,
 * common points, and rows that separate. */
#ifndef FMB_INTERSECT_NEAR_H
#define FMB_INTERSECT_NEAR_H

#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>

typedef struct near_ask {
    bool distance, depth, common, separate;
    fmb_norm norm; /* of distance, depth and within */
    bool within;   /* is the distance at most ... */
    mpq_t margin;  /* ... that? Initialised if within is set */
    int digits;    /* of decimals, or 0: fractions */
} near_ask;

/* What was found of one pair: NULL where it was not asked for, or there is none. */
typedef struct near_found {
    fmb_proximity *distance, *depth;
    fmb_generators *common;
    fmb_system *row;
    bool is_within;
    fmb_stop stop;             /* DONE; else a limit was reached, and something is missing */
    const char *contradiction; /* of the verdict, in words: a bug; else NULL */
} near_found;

/* Set within and margin from text, a rational or decimal: an exit code. */
int near_read_margin(near_ask *ask, const char *text);
void near_ask_clear(near_ask *ask);
/* Is anything wanted? */
bool near_is_asked(const near_ask *ask);
/* Ask about a pair whose verdict is known, with the limits of v. A body that is a polytope given by
 * rows counts by its vertices; of an unbounded one nothing is told. */
fmb_status near_find(const near_ask *ask, fmb_solver *v, const fmb_frame_line *line,
                     fmb_contact contact, fmb_verdict verdict, near_found *out);
void near_clear(near_found *f);
/* What of all that was asked and found contradicts the verdict, in words; NULL if nothing does. */
const char *near_contradiction(const near_ask *ask, fmb_contact contact, fmb_verdict verdict,
                               const near_found *found);

/* Lines under a pair; members of its JSON object, ", " first. */
void near_print(const near_ask *ask, const near_found *f, FILE *out);
void near_print_json(const near_ask *ask, const near_found *f, FILE *out);

#endif
