/* row_images.h: the rows of a system in a hash table, to find those that a permutation of variables
 * takes them to.
 *
 * Inequalities are the same if one is a positive multiple of the other but for multiples of
 * equalities of the system: the table has them in lowest terms, without the variables that these
 * give (reduced echelon form, one variable an equality). Equalities are the same if one is a
 * multiple of the other.
 */
#ifndef FMB_SYMMETRY_ROW_IMAGES_H
#define FMB_SYMMETRY_ROW_IMAGES_H

#include "num/vec.h"
#include "system/system_private.h"

/* A row as the table has it: coefficients by increasing variable, right side. */
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
    int *pivot;       /* [equalities] the variable that it gives, with coefficient 1 */
    size_t equalities, room;
    fmb_row_image moved; /* the last one, with room for dim variables */
    mpz_t *z;            /* [dim + 1] scratch */
    mpq_t *x, q;         /* [dim + 1] scratch, or NULL: there are no equalities */
} fmb_row_images;

/* In any case fmb_row_images_clear it. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_row_images_init(fmb_row_images *t, const fmb_system *s, fmb_mem *mem);
void fmb_row_images_clear(fmb_row_images *t);

/* The first row that row i becomes when variable j becomes image[j]; SIZE_MAX if there is none. An
 * equality that follows from the others without being one is found to be itself. */
fmb_status fmb_row_images_find(fmb_row_images *t, size_t i, const int *image, size_t *found);
/* The first row that has no image; SIZE_MAX if all have: then image is a symmetry of s. */
fmb_status fmb_row_images_check(fmb_row_images *t, const int *image, size_t *without);
/* Rows that image takes to one another get into one class: class_of[rows] is the first row of the
 * class of each, at the beginning perhaps each its own. */
fmb_status fmb_row_images_classes(fmb_row_images *t, const int *image, size_t *class_of);

#endif
