/* packed.h: what the queries over sets share. */
#ifndef FMB_PAIR_PACKED_H
#define FMB_PAIR_PACKED_H

#include "pair/kernels/minors_kernels.h"
#include "pair/packed/set.h"
#include "pair/pair_private.h"

/* How kernels decide pairs of two kinds. */
typedef struct fmb_packed_plan {
    bool moves, swapped; /* swapped: blocks hold (b, a) */
    fmb_packed_shapes shapes;
    fmb_flat_kind flat;   /* of any shapes */
    fmb_minors_what what; /* in four and more dimensions */
} fmb_packed_plan;

/* False: no kernel does. */
bool fmb_packed_plan_of(const fmb_pair *k, int kind_a, int kind_b, fmb_packed_plan *out);

/* Frames that are handed on at once. */
enum { FMB_PACKED_AT_ONCE = 64 };

/* What is asked of n pairs, by fmb_pair_answer_all; out is of these pairs. Errors: MEMORY. */
fmb_status fmb_packed_answer(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                             const fmb_frames_pair *pair, const fmb_pair_answers *out);
/* Verdicts of n pairs of one kind by fmb_pair_answer_all, which kernels left open if they have a
 * plan for that kind. Errors: MEMORY. */
fmb_status fmb_packed_decide(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                             const fmb_frames_pair *pair, fmb_verdict *out);

/* The same with depths; out is of these pairs. Errors: MEMORY. */
fmb_status fmb_packed_contacts(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                               const fmb_frames_pair *pair, const fmb_pair_answers *out);

/* Are the arguments sets of the dimension of k? If not, k->error says so. A query begins. */
bool fmb_packed_begin(fmb_pair *k, const fmb_frames *a, const fmb_frames *b);

/* Jobs by the threads of k, in rounds. Errors: MEMORY. */
fmb_status fmb_packed_do(fmb_pair *k, size_t jobs, fmb_thread_job job, void *self);
/* Who works for k in this thread of them. */
fmb_pair *fmb_packed_worker(fmb_pair *k, size_t thread);

#endif
