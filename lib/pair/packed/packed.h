/* packed.h: functions shared by the queries over sets. */
#ifndef FMB_PAIR_PACKED_H
#define FMB_PAIR_PACKED_H

#include "pair/kernels/minors_kernels.h"
#include "pair/packed/set.h"
#include "pair/pair_private.h"

/* How kernels decide pairs of two kinds. */
typedef struct fmb_packed_plan {
    bool moves, swapped; /* swapped: blocks hold (b, a) */
    fmb_packed_shapes shapes;
    fmb_flat_kind flat;   /* for any shapes */
    fmb_minors_what what; /* in four and more dimensions */
} fmb_packed_plan;

/* False: no kernel decides pairs of these kinds. */
bool fmb_packed_plan_of(const fmb_pair *k, int kind_a, int kind_b, fmb_packed_plan *out);

/* n pairs of the plan's kinds, for kernels; refers to plan and pair. */
fmb_packed_pairs fmb_packed_pairs_of(const fmb_pair *k, const fmb_frames *a, const fmb_frames *b,
                                     const fmb_packed_plan *plan, size_t n,
                                     const fmb_frames_pair *pair);

/* Frames that are passed on at once. */
enum { FMB_PACKED_AT_ONCE = 64 };

/* Answer n pairs by fmb_pair_answer_all; out is for these pairs. Errors: MEMORY. */
fmb_status fmb_packed_answer(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                             const fmb_frames_pair *pair, const fmb_pair_answers *out);
/* Verdicts of n pairs of one kind by fmb_pair_answer_all; if there is a plan for that kind, its
 * kernels left them open before. Errors: MEMORY. */
fmb_status fmb_packed_decide(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                             const fmb_frames_pair *pair, fmb_verdict *out);

/* Answers of n pairs with depths; out is for these pairs. Errors: MEMORY. */
fmb_status fmb_packed_contacts(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                               const fmb_frames_pair *pair, const fmb_pair_answers *out);

/* Begin a query. Are the arguments sets of the dimension of k? If not, k->error says so. */
bool fmb_packed_begin(fmb_pair *k, const fmb_frames *a, const fmb_frames *b);

/* Run jobs by the threads of k, in rounds. Errors: MEMORY. */
fmb_status fmb_packed_do(fmb_pair *k, size_t jobs, fmb_thread_job job, void *self);
/* The fmb_pair that works for k in this thread. */
fmb_pair *fmb_packed_worker(fmb_pair *k, size_t thread);

#endif
