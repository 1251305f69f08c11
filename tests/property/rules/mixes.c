/* mixes.c: see mixes.h. */
#include <stdio.h>
#include <string.h>

#include "mixes.h"

static const char *const NAME[] = {"duplicate", "dominated", "kohler", "chernikov",
                                   "imbert",    "box",       "lp"};

enum { NAMES = sizeof NAME / sizeof *NAME, TEXT = 64 };

unsigned mix_at(int i)
{
    unsigned mix = 1;
    for (;; mix++) {
        unsigned rules = 0;
        for (int k = 0; k < NAMES; k++)
            rules += mix >> k & 1;
        if (rules <= 3 && i-- == 0)
            return mix;
    }
}

static void write_mix(unsigned mix, unsigned turn, char out[TEXT])
{
    for (unsigned k = 0; k < NAMES; k++) {
        unsigned rule = (k + turn * NAMES / MIX_TURNS) % NAMES;
        if (!(mix >> rule & 1))
            continue;
        if (out[0])
            strcat(out, ",");
        strcat(out, NAME[rule]);
    }
    if (!out[0])
        strcpy(out, "none");
}

const char *mix_text(unsigned mix, unsigned turn)
{
    static char text[2 * MIX_SUBSETS][MIX_TURNS][TEXT];
    char *out = text[mix][turn % MIX_TURNS];
    if (!out[0])
        write_mix(mix, turn % MIX_TURNS, out);
    return out;
}

bool mix_needs_rebase(unsigned mix)
{
    bool histories = (mix & (MIX_KOHLER | MIX_CHERNIKOV | MIX_IMBERT)) != 0;
    return histories && (mix & (MIX_DUPLICATE | MIX_DOMINATED | MIX_LP)) != 0;
}
