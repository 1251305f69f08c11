/* group.h: symmetries of a linear program: permutations of its columns and rows that do not change
 * the program, given by generators.
 *
 * Generator g maps column j to image[g][j], and row i to row image[g][n + i]: the coefficients of
 * row i, permuted, are those of its image, with the same right side and relation. Kept columns are
 * mapped to kept ones. So the image of a point satisfies the image of a row if the point satisfies
 * the row; and the image of the multipliers of a row proves the image of that row.
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

/* Add image[n + m] as a generator if it is a symmetry of p that maps columns with keeps[column] to
 * such columns, and moves one of them: *fits. Errors: MEMORY, LIMIT. */
fmb_status fmb_group_add(fmb_group *g, const fmb_program *p, const bool *keeps,
                         const uint32_t *image, bool *fits);

/* find.c: generators of the symmetries of a program, from the automorphisms of a coloured graph
 * (nauty). None if the program is large or has long numbers, or if nauty is not installed. Source:
 * McKay and Piperno 2014, Practical graph isomorphism, II. Errors: MEMORY, LIMIT. The caller must
 * call fmb_group_clear even then. */
fmb_status fmb_symmetry_find(fmb_run *run, const fmb_program *p, const bool *keeps, fmb_group *out);

/* The permutations of the API (permutations.c). */
struct fmb_permutations {
    fmb_mem mem;
    int dim;
    int **image; /* [size][dim] */
    size_t size, capacity;
    char error[160]; /* why the last one to be added was refused */
};

/* Complete image[n], where -1 means undefined: close chains to cycles and fix all other elements.
 * False if two elements have the same image. met[n] is scratch. */
bool fmb_permutation_complete(int *image, int n, bool *met);

#endif
