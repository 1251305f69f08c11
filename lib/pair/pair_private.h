/* pair_private.h: the layout of an fmb_pair, and what may be known of the frames of a query. */
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
#include "pair/kernels/minors_kernels.h"

/* Blocks by number: [stage][kind], where a kind is [moves][shape of A][shape of B]. Pairs that a
 * block leaves open go to a block of a later stage, or are decided without a block. The last block
 * is for verdicts of frames with any number of axes, of the kind pair.flat. */
enum { STAGE_VERDICT, STAGE_BOX, STAGES = STAGE_BOX + FMB_BOX_LEVELS };
enum { KINDS = 2 * 2 * 2, FLAT_BLOCK = STAGES * KINDS, BLOCKS };

/* Pairs of one kind in four to eight dimensions that wait for a kernel over records, which is asked
 * about so many at once: it brings those together that need more than tests of faces. */
enum { FMB_MINOR_PAIRS = 32 };
typedef struct fmb_minor_block {
    size_t pair[FMB_MINOR_PAIRS];
    int n;
} fmb_minor_block;

struct fmb_pair {
    fmb_mem mem;
    fmb_pair_options options;
    int dim;
    const fmb_pair_kernels *one, *wide; /* for a single pair, for many */
    fmb_general *general;
    fmb_exact_boxer *boxer; /* made for the first pair that needs it; or NULL */
    fmb_pair_oracle oracle;
    fmb_pair_counts counts; /* without its size */
    fmb_pair **workers;  /* [threads - 1] one for each other thread, for sets of frames; or NULL */
    int threads;         /* at least 1 */
    fmb_threads running; /* opened by the first query that needs them */
    double *room;        /* workspace of kernels in 4 to 8 dimensions, within minors; or NULL */
    double *record;      /* behind it: records of FMB_MINOR_PAIRS pairs */
    double *minors;
    char error[FMB_FRAME_FAULT_SIZE + 40]; /* why the last call returned FMB_ERR_ARG */
    uint64_t waiting;                      /* bits of blocks that are not empty */
    fmb_flat_kind flat;                    /* kind of the pairs in the last block */
    fmb_block block[BLOCKS];
    fmb_minor_block minor[FMB_MINORS_WHATS];
};

/* Has fmb_pair_cancel been called? */
static inline bool fmb_pair_is_cancelled(const fmb_pair *k)
{
    return atomic_load_explicit(&k->oracle.cancel, memory_order_relaxed) != 0;
}

/* Copy the caller's structure of answers to one of this version. Errors: ARG, with k->error set. */
fmb_status fmb_pair_read_answers(fmb_pair *k, const fmb_pair_answers *out, fmb_pair_answers *ours);

/* What is known of the frames of pairs: nothing; that they are good; also that kernels left their
 * verdicts open. */
typedef enum fmb_pair_known { FMB_PAIR_NEW, FMB_PAIR_GOOD, FMB_PAIR_OPEN } fmb_pair_known;

#endif
