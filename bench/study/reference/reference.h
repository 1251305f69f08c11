/* reference.h: the right answers, from the oracle (which shares nothing with elimination), each
 * with evidence that the checker accepted. */
#ifndef FMB_STUDY_REFERENCE_H
#define FMB_STUDY_REFERENCE_H

#include <fmb/solve.h>

typedef struct study_reference {
    fmb_solver *oracle, *projection;
    size_t rejected; /* answers whose evidence was not accepted */
} study_reference;

/* max_seconds bounds each question [s]; what it cannot answer in time stays unknown. */
fmb_status study_reference_open(study_reference *j, double max_seconds);
void study_reference_close(study_reference *j);

fmb_status study_reference_verdict(study_reference *j, const fmb_system *s, fmb_verdict *out);

/* [give, free()] What the projection of s on keep[0..n) is, in words that equal projections share
 * and others do not; NULL if that is not known. */
fmb_status study_reference_projection(study_reference *j, const fmb_system *s, const int *keep,
                                      int n, char **out);
/* [give, free()] The same words for p, a projection that somebody else found. */
fmb_status study_reference_words(study_reference *j, const fmb_system *p, char **out);

#endif
