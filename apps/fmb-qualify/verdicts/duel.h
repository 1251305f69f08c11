/* duel.h: verdicts on the pairs of one class, by FMB and by SAT, timed against each other. */
#ifndef QUALIFY_DUEL_H
#define QUALIFY_DUEL_H

#include "fmb-qualify/study.h"
#include "fmb-qualify/verdicts/pool.h"
#include "study/clock/clock.h"

/* The rivals: the library with elimination and with separating axes. */
typedef struct verdict_rivals {
    fmb_pair *fmb, *sat;
} verdict_rivals;

/* Errors: ARG (instructions that the processor lacks), MEMORY. verdict_rivals_close is due in any
 * case. */
fmb_status verdict_rivals_open(verdict_rivals *r, int dim, fmb_simd simd);
void verdict_rivals_close(verdict_rivals *r);

/* Times are of one query [ns], over the passes; warm ones over the pairs. */
typedef struct verdict_duel {
    verdict_class class;
    size_t queries;               /* distinct pairs, each asked once a pass */
    uint64_t drawn;               /* pairs tested to find them */
    bool complete;                /* nothing was interrupted */
    study_spread fmb, sat, plain; /* all pairs in one call */
    study_ratio fmb_sat, plain_sat;
    study_spread one_fmb, one_sat; /* a call for each pair */
    study_ratio one_fmb_sat;
    size_t warm_pairs; /* each of them asked many times in a row */
    study_spread warm_fmb, warm_sat;
    study_ratio warm_fmb_sat;
    double exact_share; /* of FMB's queries, decided exactly */
    size_t wrong;       /* verdicts of FMB or SAT that differ from the class */
    size_t plain_wrong;
} verdict_duel;

fmb_status verdict_duel_run(const verdict_source *from, const verdict_class *c,
                            const qualify_setup *o, verdict_rivals *r, verdict_duel *out);

/* FMB over SAT on shuffled pairs of which a share meets; groups of consecutive pairs are timed
 * separately. */
enum { VERDICT_SHARES = 11 }; /* 0, 10, ... 100 % */
typedef struct verdict_mix {
    int dim;
    bool moves, complete;
    size_t queries, groups;
    double total[VERDICT_SHARES];      /* of all pairs */
    study_ratio group[VERDICT_SHARES]; /* over the groups */
} verdict_mix;

fmb_status verdict_mix_run(const verdict_source *from, const qualify_setup *o, verdict_rivals *r,
                           verdict_mix *mix);

/* ---- for the files of this folder ------------------------------------------------------------ */

/* One method on some pairs: the self of a study_timed. */
typedef struct verdict_way {
    fmb_pair *k;
    const fmb_frame *p, *q;
    fmb_verdict *verdict; /* [n] */
} verdict_way;

/* All pairs in one call. */
fmb_status verdict_way_all(void *self, size_t first, size_t n);

#endif
