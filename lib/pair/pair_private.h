/* pair_private.h: what an fmb_pair consists of, and what is known of the frames that it is asked
 * about. */
#ifndef FMB_PAIR_PAIR_PRIVATE_H
#define FMB_PAIR_PAIR_PRIVATE_H

#include "base/mem.h"
#include "base/threads.h"
#include "frame/flat.h"
#include "frame/frame_private.h"
#include "pair/block.h"
#include "pair/exact.h"
#include "pair/exact_box/exact_box.h"
#include "pair/general/general.h"

/* Blocks by number: [stage][kind], where a kind is [moves][shape of A][shape of B]. What a block
 * leaves open goes to one of a later stage, or is settled without a block. The last one is for
 * verdicts of frames with any number of axes, those of pair.flat. */
enum { STAGE_VERDICT, STAGE_BOX, STAGES = STAGE_BOX + FMB_BOX_LEVELS };
enum { KINDS = 2 * 2 * 2, FLAT_BLOCK = STAGES * KINDS, BLOCKS };

struct fmb_pair {
    fmb_mem mem;
    fmb_pair_options options;
    int dim;
    const fmb_pair_kernels *one, *wide; /* for a single pair, for many */
    fmb_general *general;
    fmb_exact_boxer *boxer; /* since the first pair that it is asked about; or NULL */
    fmb_pair_oracle oracle;
    fmb_pair_counts counts; /* without its size */
    fmb_pair **workers;  /* [threads - 1] one for each other thread, of sets of frames; or NULL */
    int threads;         /* at least 1 */
    fmb_threads running; /* since the first query for them */
    double *room;        /* of kernels in four to eight dimensions, within minors; or NULL */
    double *minors;
    char error[FMB_FRAME_FAULT_SIZE + 40]; /* why the last call returned FMB_ERR_ARG */
    uint64_t waiting;                      /* the blocks that are not empty */
    fmb_flat_kind flat;                    /* what waits in the last block */
    fmb_block block[BLOCKS];
};

/* Has fmb_pair_cancel been called? */
static inline bool fmb_pair_is_cancelled(const fmb_pair *k)
{
    return atomic_load_explicit(&k->oracle.cancel, memory_order_relaxed) != 0;
}

/* The caller's places for answers, as we know them. Errors: ARG, with k->error set. */
fmb_status fmb_pair_read_answers(fmb_pair *k, const fmb_pair_answers *out, fmb_pair_answers *ours);

/* What is known of frames: nothing; that they are good; that kernels left open, too, whether they
 * meet. */
typedef enum fmb_pair_known { FMB_PAIR_NEW, FMB_PAIR_GOOD, FMB_PAIR_OPEN } fmb_pair_known;

#endif
