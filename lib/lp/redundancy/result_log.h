/* result_log.h: what was found about rows, noted to be told later. */
#ifndef FMB_LP_RESULT_LOG_H
#define FMB_LP_RESULT_LOG_H

#include "lp/redundancy/irredundant.h"

typedef struct fmb_logged_result {
    size_t row;
    bool kept;
    fmb_weights weights; /* the proof of a row that is redundant, */
    mpq_t *x;            /* [n] or the point of one that is not; none where nobody was told */
} fmb_logged_result;

typedef struct fmb_result_log {
    fmb_mem *mem;
    size_t n;
    fmb_logged_result *item; /* [count] */
    size_t count, room;
    fmb_verdicts listener; /* notes what it is told, with proofs */
} fmb_result_log;

/* None. f must not move. */
void fmb_result_log_begin(fmb_result_log *f, fmb_mem *mem, size_t n);
/* Note what became of a row, without a proof. Errors: MEMORY, LIMIT. */
fmb_status fmb_result_log_note(fmb_result_log *f, size_t row, fmb_fate fate);
void fmb_result_log_end(fmb_result_log *f);
/* Set fate[m] and tell of those rows that are UNKNOWN there; told may be NULL. Errors: those of
 * told. */
fmb_status fmb_result_log_tell(fmb_result_log *f, fmb_fate *fate, const fmb_verdicts *told);

#endif
