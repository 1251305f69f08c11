/* single_pair.h: one pair alone, without a block for kernels: by doubles, by vertices that are
 * proved, or by the exact query.
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
    bool boxes, alone; /* more than the verdict is requested; there is only one pair */
    fmb_pair_known known;
    const fmb_pair_kernels *kernels;
} fmb_pair_call;

/* The answers from pair i on. */
fmb_pair_answers fmb_pair_answers_from(const fmb_pair_answers *o, size_t dim, size_t i);

/* Are both frames of pair i good? */
static inline bool fmb_single_pair_is_good(const fmb_pair_call *a, size_t i)
{
    return a->known != FMB_PAIR_NEW ||
           (fmb_frame_is_good(&a->p[i], a->k->dim) && fmb_frame_is_good(&a->q[i], a->k->dim));
}

/* Convert both frames to edges, for methods in doubles. False: an edge is no double. */
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

/* The verdict on good frames: by signs of determinants, in doubles unless a kernel tried that, and
 * by vertices. *out stays UNKNOWN if these cannot decide. */
void fmb_single_pair_decide(const fmb_pair_call *a, size_t i, fmb_verdict *out);

/* The verdict by vertices with long numbers or by the exact query, then the other answers. Errors:
 * MEMORY. */
fmb_status fmb_single_pair_decide_exactly(const fmb_pair_call *a, size_t i);

/* The other answers of a pair with the verdict FEASIBLE: in doubles if these are good enough, or by
 * vertices that are proved, or by the exact query. Errors: MEMORY. */
fmb_status fmb_single_pair_answer(const fmb_pair_call *a, size_t i);

#endif
