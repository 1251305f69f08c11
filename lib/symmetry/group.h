/* group.h: symmetries of a linear program: permutations of its columns and rows under which the
 * program stays what it is, by generators.
 *
 * Generator g takes column j to column image[g][j], and row i to row image[g][n + i]: the
 * coefficients of row i, moved so, are those of the other, right side and relation being the same.
 * Columns that are kept go to such. So a point, moved, satisfies row image[g][n + i] if it
 * satisfied row i; and multipliers of a row, moved, are multipliers of that row, moved.
 */
#ifndef FMB_SYMMETRY_GROUP_H
#define FMB_SYMMETRY_GROUP_H

#include "base/mem.h"
#include "lp/model/program.h"
#include "trace/run.h"
#include <fmb/symmetry.h>

typedef struct fmb_group {
    fmb_mem *mem;
    size_t n, m;      /* columns; rows */
    uint32_t **image; /* [size][n + m] */
    size_t size, capacity;
} fmb_group;

/* No generators: the identity alone. */
void fmb_group_init(fmb_group *g, fmb_mem *mem, size_t n, size_t m);
void fmb_group_clear(fmb_group *g);

/* image[n + m] becomes a generator, if it is a symmetry of p that moves some column with
 * keeps[column], and takes those to such: *fits. Errors: MEMORY, LIMIT. */
fmb_status fmb_group_add(fmb_group *g, const fmb_program *p, const bool *keeps,
                         const uint32_t *image, bool *fits);

/* find.c: generators of the symmetries of a program, found as those of a coloured graph (nauty).
 * None where the program is large or has long numbers, or where nauty is not installed.
 * Source: McKay and Piperno 2014, Practical graph isomorphism, II. Errors: MEMORY, LIMIT. In any
 * case fmb_group_clear it. */
fmb_status fmb_symmetry_find(fmb_run *run, const fmb_program *p, const bool *keeps, fmb_group *out);

/* What one or several permutations are to the API (permutations.c). */
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
