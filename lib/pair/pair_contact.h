/* pair_contact.h: how deep two frames are in each other, for many pairs: by kernels in two and
 * three dimensions, and where these are not sure of a depth exactly.
 */
#ifndef FMB_PAIR_PAIR_CONTACT_H
#define FMB_PAIR_PAIR_CONTACT_H

#include "pair/pair_portfolio.h"

/* Does out ask for more than fmb_pair_answer_all answers? */
static inline bool fmb_contact_is_asked(const fmb_pair_answers *out)
{
    return out->depth || out->normal;
}

/* All of out. Errors: ARG, with k->error set, MEMORY. */
fmb_status fmb_contact_answer_all(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                                  const fmb_pair_answers *out);

#endif
