/* intersect_near.h: answers of `fmb intersect` beyond verdicts and boxes: distance, depth, common
 * points, and separating rows. */
#ifndef FMB_INTERSECT_NEAR_H
#define FMB_INTERSECT_NEAR_H

#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>

typedef struct near_ask {
    bool distance, depth, common, separate;
    fmb_norm norm; /* of distance, depth and within */
    bool within;   /* is the distance at most margin? */
    mpq_t margin;  /* initialised if within is set */
    int digits;    /* of decimals, or 0: fractions */
} near_ask;

/* These answers about one pair: NULL if not requested, or if there is none. */
typedef struct near_found {
    fmb_proximity *distance, *depth;
    fmb_generators *common;
    fmb_system *row;
    bool is_within;
    fmb_stop stop;             /* DONE; else a limit was reached, and answers are missing */
    const char *contradiction; /* to the verdict, in words: a bug; else NULL */
} near_found;

/* Set within and margin from text, a rational or decimal: an exit code. */
int near_read_margin(near_ask *ask, const char *text);
void near_ask_clear(near_ask *ask);
/* Is any of these answers requested? */
bool near_is_asked(const near_ask *ask);
/* Find the answers about a pair with a known verdict, with the limits of v. A polytope given by
 * rows is converted to its vertices; for an unbounded one there are no answers. */
fmb_status near_find(const near_ask *ask, fmb_solver *v, const fmb_frame_line *line,
                     fmb_contact contact, fmb_verdict verdict, near_found *out);
void near_clear(near_found *f);
/* Which of the answers found contradicts the verdict, in words; NULL if none does. */
const char *near_contradiction(const near_ask *ask, fmb_contact contact, fmb_verdict verdict,
                               const near_found *found);

/* Print the lines below a pair; and the members of its JSON object, with ", " first. */
void near_print(const near_ask *ask, const near_found *f, FILE *out);
void near_print_json(const near_ask *ask, const near_found *f, FILE *out);

#endif
