/* validate.h: random pairs asked in every way, and what was found.
 *
 * What is said of pair k depends on the plan, the seed and k alone: counts of shares of a study add
 * up to those of the whole, however it was shared.
 */
#ifndef FMB_STUDY_VALIDATE_H
#define FMB_STUDY_VALIDATE_H

#include "study/draw/pairs.h"
#include "study/reference/verdicts.h"

enum { STUDY_VALIDATE_MOST = 512 }; /* pairs at once */

typedef struct study_validation {
    study_pair_plan plan;
    uint64_t seed;
    double sample; /* share of the article's pairs whose verdicts are proved, chosen by number; all
                      of the other families are */
    double textbook; /* share of those that are asked of the exact way and of the textbook, too */
    bool boxes;      /* of those that meet, too */
    bool contacts;   /* depths and distances of all, in two and three dimensions */
    fmb_simd simd;
} study_validation;

/* [pairs], but for unknown */
typedef struct study_tally {
    uint64_t tested, meeting, touching; /* touching: they meet, but not if they are open */
    uint64_t exact;                     /* held against proofs */
    uint64_t solved;                    /* of those: proved by the solver */
    uint64_t textbook, left;            /* of those: held against the textbook truth; too large */
    uint64_t unknown[2];                /* [queries, two a pair] what doubles left open: FMB, SAT */
    uint64_t boxes;                     /* compared with exact ones */
    uint64_t boxes_solved;              /* [boxes, two a pair] found by the exact way */
    uint64_t doubtful;                  /* [boxes, two a pair] that doubles left open */
    uint64_t contacts;                  /* compared with exact ones */
    uint64_t contacts_open;             /* [contacts, two a pair] that doubles left open */
    uint64_t disagreeing;               /* with some fault */
    uint64_t fault[STUDY_FAULTS];
    double excess; /* the largest of a box (ends.h) */
} study_tally;

void study_tally_add(study_tally *to, const study_tally *more);

typedef struct study_finding {
    uint64_t k;
    unsigned faults;
    study_verdicts verdicts;
} study_finding;

/* Zero-initialise; free(item). */
typedef struct study_findings {
    study_finding *item;
    size_t n, capacity;
} study_findings;

/* A copy of *f at the end. Errors: MEMORY. */
fmb_status study_findings_add(study_findings *to, const study_finding *f);

/* Workspace of one thread. */
typedef struct study_validator study_validator;

/* [give] Errors: ARG (instructions that the processor lacks), MEMORY. */
fmb_status study_validator_open(const study_validation *v, study_validator **out);
void study_validator_close(study_validator *s);

/* Ask pairs first ... first + n - 1, n <= STUDY_VALIDATE_MOST. Adds to tally and findings, which
 * come in the order of k. Errors: MEMORY. */
fmb_status study_validator_run(study_validator *s, uint64_t first, size_t n, study_tally *tally,
                               study_findings *out);
/* Let the run end soon; what it says then is worth nothing. From any thread or signal handler. */
void study_validator_cancel(study_validator *s);

#endif
