/* exact_box.h: boxes of pairs in up to eight dimensions, exactly: doubles walk from vertex to
 * vertex, and each vertex where an end of the box is found is proved (certify.h); where it is none,
 * integers walk on (exact_walk.h).
 */
#ifndef FMB_PAIR_EXACT_BOX_H
#define FMB_PAIR_EXACT_BOX_H

#include <fmb/gmp.h>

#include "base/mem.h"
#include "base/poll.h"
#include "pair/exact_box/wide.h"

/* Room for what is calculated, a caller's: it is too large for the stack of a small thread. Those
 * who are given NULL, for want of memory, prove nothing; nor once who is polled ends it. */
typedef struct fmb_exact_boxer fmb_exact_boxer;

/* [give] NULL without memory. */
fmb_exact_boxer *fmb_exact_boxer_new(fmb_mem *mem, const fmb_poll *poll);
void fmb_exact_boxer_free(fmb_exact_boxer *b, fmb_mem *mem);

/* Do these frames, which are good, meet? UNKNOWN if that was not proved. Nothing is allocated. */
fmb_verdict fmb_exact_box_decide(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                                 fmb_contact contact);

/* Do these frames, which are good and closed, meet at the vertex that doubles guess? False: that is
 * not known. */
bool fmb_exact_box_meet(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q);

/* Of good frames that meet: all that out asks for, but the verdict; every end is the exact one,
 * rounded outward. False, and nothing written, if that was not proved. */
bool fmb_exact_box_answer(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                          const fmb_pair_answers *out);

/* Do these closed frames meet, and all that out asks for, but the verdict. UNKNOWN if that was not
 * proved; out is then in part written. The time of what is still is not written. It takes room of
 * mem as long as it lasts. */
fmb_verdict fmb_exact_box_answer_q(const fmb_frame_q *p, const fmb_frame_q *q,
                                   const fmb_pair_answers_q *out, fmb_mem *mem);

/* The same where numbers of a row are too far apart for that. The room is a few megabytes. */
fmb_exact_boxer *fmb_long_boxer_new(fmb_mem *mem, const fmb_poll *poll);
void fmb_long_boxer_free(fmb_exact_boxer *b, fmb_mem *mem);
fmb_verdict fmb_long_box_decide(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                                fmb_contact contact);
bool fmb_long_box_answer(fmb_exact_boxer *b, const fmb_frame *p, const fmb_frame *q,
                         const fmb_pair_answers *out);
fmb_verdict fmb_long_box_answer_q(const fmb_frame_q *p, const fmb_frame_q *q,
                                  const fmb_pair_answers_q *out, fmb_mem *mem);

#endif
