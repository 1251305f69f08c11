/* mixes.h: sets of pruning rules as bit masks. */
#ifndef FMB_TEST_MIXES_H
#define FMB_TEST_MIXES_H

#include <stdbool.h>

enum {
    MIX_DUPLICATE = 1,
    MIX_DOMINATED = 2,
    MIX_KOHLER = 4,
    MIX_CHERNIKOV = 8,
    MIX_IMBERT = 16,
    MIX_BOX = 32,
    MIX_LP = 64,      /* beside the six: projections only */
    MIX_SUBSETS = 64, /* of the six */
    MIX_SMALL = 41,   /* of these, the ones with one, two or three rules */
    MIX_TURNS = 3     /* orders in which the names are written */
};

/* The i-th mix of one, two or three rules: 0 <= i < MIX_SMALL. */
unsigned mix_at(int i);
/* As options.rules; static for the life of the program. `turn` rotates the names. */
const char *mix_text(unsigned mix, unsigned turn);
/* A rule of histories beside one that drops rows for other reasons: right only because the engine
 * re-bases. */
bool mix_needs_rebase(unsigned mix);

#endif
