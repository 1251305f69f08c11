/* pairs.h: blocks of pairs of frames as problems, and the driver that decides them.
 *
 * Such a problem has no rows: problem.own points to its block, which the driver reads.
 */
#ifndef FMB_ABLATE_PAIRS_H
#define FMB_ABLATE_PAIRS_H

#include "../peers/peer.h"
#include "study/draw/pairs.h"

typedef struct pair_block {
    study_pair_plan plan;
    uint64_t seed;
    bool by_corners; /* simplices are given by corners */
    fmb_contact contact;
    size_t pairs;
} pair_block;

/* The number of blocks: all families, in a few dimensions, still and moving, closed and open. */
size_t pair_blocks(void);
/* A problem that owns nothing but its name; *block must outlive it. */
void pair_block_draw(size_t number, uint64_t seed, pair_block *block, problem *p);

/* Decides all pairs, or finds the tightest boxes of the meeting pairs. Its numbers: how many meet,
 * the sums of lower and of upper ends. */
extern const peer peer_pairs;

#endif
