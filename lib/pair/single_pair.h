/* single_pair.h: one pair by itself, not beside others in a block for kernels: in doubles, at
 * vertices that are proved, by the exact query.
 */
#ifndef FMB_PAIR_SINGLE_PAIR_H
#define FMB_PAIR_SINGLE_PAIR_H

#include "pair/contact/bodies.h"
#include "pair/corner_edges.h"
#include "pair/pair_private.h"

/* One call of fmb_pair_answer_all. */
typedef struct fmb_pair_call {
    fmb_pair *k;
    const fmb_frame *p, *q;
    const fmb_pair_answers *out;
    bool boxes, alone; /* more than the verdict is wanted; this is the only pair */
    fmb_pair_known known;
    const fmb_pair_kernels *kernels;
} fmb_pair_call;

/* The places of answers from pair i on. */
fmb_pair_answers fmb_pair_answers_from(const fmb_pair_answers *o, size_t dim, size_t i);

/* Are both frames of pair i good? */
static inline bool fmb_single_pair_is_good(const fmb_pair_call *a, size_t i)
{
    return a->known != FMB_PAIR_NEW ||
           (fmb_frame_is_good(&a->p[i], a->k->dim) && fmb_frame_is_good(&a->q[i], a->k->dim));
}

/* As frames by edges, as doubles want them. False: an edge is no double. */
static inline bool fmb_single_pair_edges(const fmb_pair_call *a, size_t i, fmb_corner_edges *p,
                                         fmb_corner_edges *q)
{
    return fmb_edges_of_frame(&a->p[i], p) && fmb_edges_of_frame(&a->q[i], q);
}

static inline bool fmb_single_pair_is_of_hulls(const fmb_frame *p, const fmb_frame *q)
{
    return (fmb_frame_is_hull(p) || fmb_frame_is_hull(q)) && fmb_bodies_are(p, q);
}

/* Say what is wrong with pair i. Returns FMB_ERR_ARG. */
fmb_status fmb_single_pair_refuse(const fmb_pair_call *a, size_t i);

/* Verdict on good frames, by signs of determinants, in doubles where no kernel did that, and at
 * vertices. *out stays as it is, UNKNOWN, where that tells nothing. */
void fmb_single_pair_decide(const fmb_pair_call *a, size_t i, fmb_verdict *out);

/* Verdict by long numbers at vertices or the exact query, and the rest of the answer. Errors:
 * MEMORY. */
fmb_status fmb_single_pair_decide_exactly(const fmb_pair_call *a, size_t i);

/* More than the verdict, which is FEASIBLE: in doubles if they are good enough, or at vertices that
 * are proved, or by the exact query. Errors: MEMORY. */
fmb_status fmb_single_pair_answer(const fmb_pair_call *a, size_t i);

#endif
