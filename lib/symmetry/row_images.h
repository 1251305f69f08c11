/* row_images.h: a hash table of the rows of a system, to find the image of a row under a
 * permutation of variables.
 *
 * Inequalities count as equal if one is a positive multiple of the other up to multiples of
 * equalities of the system: they are stored in lowest terms, without the pivot variables of the
 * equalities (reduced echelon form). Equalities are equal if one is a multiple of the other.
 */
#ifndef FMB_SYMMETRY_ROW_IMAGES_H
#define FMB_SYMMETRY_ROW_IMAGES_H

#include "num/vec.h"
#include "system/system_private.h"

/* A row as stored in the table: coefficients by increasing variable, then the right side. */
typedef struct fmb_row_image {
    int *var;  /* [size] */
    fmb_vec v; /* [size + 1] */
    size_t size;
    uint64_t hash;
} fmb_row_image;

typedef struct fmb_row_images {
    const fmb_system *s;
    fmb_mem *mem;
    fmb_num num;
    size_t dim;
    fmb_row_image *row; /* [rows] */
    size_t *slot;       /* [slots] of rows, SIZE_MAX: free; slots a power of two */
    size_t slots;
    mpq_t **equality; /* [equalities][dim + 1] in reduced echelon form; room for all of s */
    int *pivot;       /* [equalities] its pivot variable, with coefficient 1 */
    size_t equalities, room;
    fmb_row_image moved; /* the last row permuted, with memory for dim variables */
    mpz_t *z;            /* [dim + 1] scratch */
    mpq_t *x, q;         /* [dim + 1] scratch, or NULL: there are no equalities */
} fmb_row_images;

/* Errors: MEMORY, LIMIT, here and below; call fmb_row_images_clear even then. */
fmb_status fmb_row_images_init(fmb_row_images *t, const fmb_system *s, fmb_mem *mem);
void fmb_row_images_clear(fmb_row_images *t);

/* *found = the first row equal to row i with each variable j replaced by image[j]; SIZE_MAX: none.
 * For an equality that is implied by the others but equal to none it is i. */
fmb_status fmb_row_images_find(fmb_row_images *t, size_t i, const int *image, size_t *found);
/* *without = the first row without an image; SIZE_MAX: none, so that image is a symmetry of s. */
fmb_status fmb_row_images_check(fmb_row_images *t, const int *image, size_t *without);
/* Merge the classes of rows that image maps to one another: class_of[rows] is the first row of each
 * row's class; initially perhaps every row is in a class of its own. */
fmb_status fmb_row_images_classes(fmb_row_images *t, const int *image, size_t *class_of);

#endif
