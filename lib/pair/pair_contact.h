/* pair_contact.h: depths and distances of many pairs: by kernels in two and three dimensions, and
 * exactly where these are not certain.
 */
#ifndef FMB_PAIR_PAIR_CONTACT_H
#define FMB_PAIR_PAIR_CONTACT_H

#include "pair/contact/contact_near.h"
#include "pair/kernels/packed_kernels.h"
#include "pair/single_pair.h"

/* Does out request depths of pairs that meet, beyond fmb_pair_answer_all? Below: distances of pairs
 * that do not? */
static inline bool fmb_contact_asks_depth(const fmb_pair_answers *out)
{
    return out->depth || out->normal || out->faces || out->points || out->npoints;
}

static inline bool fmb_contact_asks_distance(const fmb_pair_answers *out)
{
    return out->distance || out->nearest || out->offset;
}

/* Does it request data about common points? */
static inline bool fmb_pair_answers_more(const fmb_pair_answers *out)
{
    return out->world || out->inside || out->time || out->witness;
}

/* Write a depth, its normal, and all else that out requests for this pair, except the verdict. */
void fmb_contact_write(const fmb_frame *p, const fmb_frame *q, double depth, const double *normal,
                       const fmb_pair_answers *out);

/* Read the distance of a pair that is apart from a good lane; the row only if it is wanted. */
void fmb_contact_read_distance(const fmb_frame *p, const fmb_frame *q,
                               const fmb_distance_lanes *from, int lane, bool row,
                               fmb_pair_near *out);

/* Answer the distance of one pair that is apart: from near, or if that is NULL by doubles or
 * exactly; the verdict becomes UNKNOWN if it is not found. Errors: MEMORY. */
fmb_status fmb_contact_answer_apart(fmb_pair *k, const fmb_frame *p, const fmb_frame *q,
                                    fmb_pair_near *near, const fmb_pair_answers *out);

/* Fill in all that out requests. Errors: ARG, with k->error set, MEMORY. */
fmb_status fmb_contact_answer_all(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                                  const fmb_pair_answers *out);

#endif
