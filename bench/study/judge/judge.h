/* judge.h: the right answers, from the oracle (which shares nothing with elimination), each with
 * evidence that the checker accepted. */
#ifndef FMB_STUDY_JUDGE_H
#define FMB_STUDY_JUDGE_H

#include <fmb/solve.h>

typedef struct study_judge {
    fmb_solver *oracle, *shadow;
    size_t rejected; /* answers whose evidence was not accepted */
} study_judge;

/* max_seconds bounds each question [s]; what it cannot answer in time stays unknown. */
fmb_status study_judge_open(study_judge *j, double max_seconds);
void study_judge_close(study_judge *j);

fmb_status study_judge_verdict(study_judge *j, const fmb_system *s, fmb_verdict *out);

/* [give, free()] What the projection of s on keep[0..n) is, in words that equal projections share
 * and others do not; NULL if that is not known. */
fmb_status study_judge_shadow(study_judge *j, const fmb_system *s, const int *keep, int n,
                              char **out);
/* [give, free()] The same words for p, a projection that somebody else found. */
fmb_status study_judge_words(study_judge *j, const fmb_system *p, char **out);

#endif
