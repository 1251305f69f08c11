/* pairs.h: blocks of pairs of frames as problems of their own, and the driver that asks them.
 *
 * A problem has no rows then: the driver goes by problem.own, which is a block.
 */
#ifndef FMB_ABLATE_PAIRS_H
#define FMB_ABLATE_PAIRS_H

#include "../peers/peer.h"
#include "study/draw/pairs.h"

typedef struct pair_block {
    study_pair_plan plan;
    uint64_t seed;
    bool by_corners; /* simplices are told by them */
    fmb_contact contact;
    size_t pairs;
} pair_block;

/* Blocks of all families, in a few dimensions, still and moving, closed and open: how many there
 * are. */
size_t pair_blocks(void);
/* A problem that owns nothing but its name; *block must outlive it. */
void pair_block_draw(size_t number, uint64_t seed, pair_block *block, problem *p);

/* Decides, or finds the tightest boxes of those that meet: how many meet, and the sums of lower and
 * of upper ends. */
extern const peer peer_pairs;

#endif
