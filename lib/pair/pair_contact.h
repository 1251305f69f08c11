/* pair_contact.h: how deep two frames are in each other, for many pairs: by kernels in two and
 * three dimensions, and where these are not sure of a depth exactly.
 */
#ifndef FMB_PAIR_PAIR_CONTACT_H
#define FMB_PAIR_PAIR_CONTACT_H

#include "pair/contact/contact_near.h"
#include "pair/kernels/packed_kernels.h"
#include "pair/single_pair.h"

/* Of pairs that meet: does out ask for more than fmb_pair_answer_all answers? Of those that do not?
 */
static inline bool fmb_contact_asks_depth(const fmb_pair_answers *out)
{
    return out->depth || out->normal || out->faces || out->points || out->npoints;
}

static inline bool fmb_contact_asks_distance(const fmb_pair_answers *out)
{
    return out->distance || out->nearest || out->offset;
}

/* Does it ask for common points? */
static inline bool fmb_pair_answers_more(const fmb_pair_answers *out)
{
    return out->world || out->inside || out->time || out->witness;
}

/* What goes with a depth and its normal: all of out, of this one pair, but its verdict. */
void fmb_contact_write(const fmb_frame *p, const fmb_frame *q, double depth, const double *normal,
                       const fmb_pair_answers *out);

/* What a lane that is good says of a pair that is apart; its row only if that is wanted. */
void fmb_contact_read_distance(const fmb_frame *p, const fmb_frame *q,
                               const fmb_distance_lanes *from, int lane, bool row,
                               fmb_pair_near *out);

/* Of one pair that is apart: how far, as in near, or if that is NULL by doubles or exactly; the
 * verdict becomes UNKNOWN where that is not told. Errors: MEMORY. */
fmb_status fmb_contact_answer_apart(fmb_pair *k, const fmb_frame *p, const fmb_frame *q,
                                    fmb_pair_near *near, const fmb_pair_answers *out);

/* All of out. Errors: ARG, with k->error set, MEMORY. */
fmb_status fmb_contact_answer_all(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                                  const fmb_pair_answers *out);

#endif
