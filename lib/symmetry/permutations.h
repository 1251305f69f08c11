/* permutations.h: inside of fmb_permutations, and what makes one of what is said of some. */
#ifndef FMB_SYMMETRY_PERMUTATIONS_H
#define FMB_SYMMETRY_PERMUTATIONS_H

#include <fmb/symmetry.h>

#include "base/mem.h"

struct fmb_permutations {
    fmb_mem mem;
    int dim;
    int **image; /* [size][dim] */
    size_t size, capacity;
    char error[160]; /* what was wrong with the last that was to be added */
};

/* image[n] is -1 where nothing is said: chains become cycles, everything else stays. False if two
 * go to one place. met[n] is scratch. */
bool fmb_permutation_complete(int *image, int n, bool *met);

#endif
