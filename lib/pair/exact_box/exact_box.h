/* exact_box.h: exact boxes of pairs in up to eight dimensions: a simplex walk in doubles goes from
 * vertex to vertex, and each vertex where it finds an end of the box is proved optimal (certify.h);
 * if it is not, the walk continues in integers (exact_walk.h).
 */
#ifndef FMB_PAIR_EXACT_BOX_H
#define FMB_PAIR_EXACT_BOX_H

#include <fmb/gmp.h>

#include "base/mem.h"
#include "base/poll.h"
#include "pair/exact_box/wide.h"

/* Workspace of a caller: it is too large for the stack of a small thread. Functions that get NULL,
 * for want of memory, prove nothing, and neither after the poll has ended the query. */
typedef struct fmb_exact_boxer fmb_exact_boxer;

/* [give] NULL without memory. */
fmb_exact_boxer *fmb_exact_boxer_new(fmb_mem *mem, const fmb_poll *poll);
void fmb_exact_boxer_free(fmb_exact_boxer *b, fmb_mem *mem);

/* Do these good frames meet? UNKNOWN if that was not proved. Nothing is allocated. */
fmb_verdict fmb_exact_box_decide(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                                 fmb_contact contact);

/* Do these good frames, as closed sets, meet at the vertex that doubles guess? False: unknown. */
bool fmb_exact_box_meet(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q);

/* For good frames that meet: fill in all that out requests, except the verdict; every end is exact,
 * rounded outward. False, and nothing written, if that was not proved. */
bool fmb_exact_box_answer(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                          const fmb_pair_answers *out);

/* Do these closed frames meet? Fills in all that out requests, except the verdict. UNKNOWN if that
 * was not proved; out is then partly written. If nothing moves, the time is not written. Workspace
 * comes from mem during the call. */
fmb_verdict fmb_exact_box_answer_q(const fmb_frame_q *p, const fmb_frame_q *q,
                                   const fmb_pair_answers_q *out, fmb_mem *mem);

/* The same functions with longer integers, for numbers of a row that are too far apart for those
 * above. The workspace has a few megabytes. */
fmb_exact_boxer *fmb_long_boxer_new(fmb_mem *mem, const fmb_poll *poll);
void fmb_long_boxer_free(fmb_exact_boxer *b, fmb_mem *mem);
fmb_verdict fmb_long_box_decide(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                                fmb_contact contact);
bool fmb_long_box_answer(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                         const fmb_pair_answers *out);
fmb_verdict fmb_long_box_answer_q(const fmb_frame_q *p, const fmb_frame_q *q,
                                  const fmb_pair_answers_q *out, fmb_mem *mem);

#endif
