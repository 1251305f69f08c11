/* ends.h: ends of variables found by an oracle. Finding an end and claiming it are separate steps,
 * so that several threads may find ends, each with an oracle of its own.
 */
#ifndef FMB_SOLVE_BOUND_ENDS_H
#define FMB_SOLVE_BOUND_ENDS_H

#include "lp/oracle/oracle.h"
#include "solve/bound/job.h"

/* The supremum of sign * x over a part, where x is the variable of one column. */
typedef struct fmb_found_end {
    bool known, attained;
    fmb_oracle_end end;
    mpq_t value;   /* OPTIMUM: of x */
    fmb_weights w; /* its proof; with claims only */
    mpq_t *x;      /* [n] a point there, or the ray; with claims only, else NULL */
} fmb_found_end;

/* with_claims: of a part of n columns. Errors: MEMORY, LIMIT. */
fmb_status fmb_found_end_init(fmb_found_end *f, size_t n, bool with_claims, fmb_mem *mem);
void fmb_found_end_clear(fmb_found_end *f, size_t n, fmb_mem *mem);

/* Ask o, whose workspace is mem. Errors: MEMORY, LIMIT. */
fmb_status fmb_find_end(fmb_oracle *o, int column, int sign, fmb_mem *mem, fmb_found_end *f);
/* Write f into the job's end, with a claim if claims are wanted; f->w is used up. */
fmb_status fmb_note_end(fmb_bound_job *j, fmb_found_end *f);

/* Find both ends of the variables of box at place[0..count), all of one part, by several threads,
 * each with a workspace and a share of the limit. Ends found before a limit are noted. */
fmb_status fmb_find_ends_together(fmb_query *q, int part, fmb_box *box, const int *place,
                                  int count);

#endif
