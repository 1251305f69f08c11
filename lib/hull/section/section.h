/* section.h: the rays of a cone with many rows and few rays, by support queries.
 *
 * Let {x : row_i.x >= 0} contain no line (dependent columns are dropped), and let w.x >= 0 on it.
 * Then the section w.x = 1 is a polyhedron whose vertices and rays correspond to the rays of the
 * cone. It is computed as the hull of the answers of support queries (support.h); a facet of the
 * hull that is a row of the cone needs no query, so there are about as many queries as rays. Double
 * description (dd/cone.h) may have very many intermediate rays; this method never has more facets
 * than the hulls of subsets of the rays.
 *
 * Source: Bremner, Fukuda, Marzetta 1998, Primal-dual methods for vertex and facet enumeration.
 */
#ifndef FMB_HULL_SECTION_H
#define FMB_HULL_SECTION_H

#include "hull/image/image.h"
#include "hull/support/support.h"

typedef struct fmb_section {
    fmb_run *run;
    fmb_num num;
    fmb_arena arena;
    size_t d, m;
    const fmb_vec *row; /* [m], d entries each */
    size_t rank;
    fmb_vec *base;  /* [rank] rows in echelon form: */
    size_t *pivot;  /* [rank] base[i] is not 0 here, later rows are */
    size_t *chosen; /* [rank] the independent rows, by number */
    fmb_integers w; /* [d] 0 except at pivots */
    size_t gone;    /* the column eliminated by w.x = 1, */
    int *column;    /* [rank - 1] and the columns of the program */
    int *kept;      /* [rank - 1] all columns of the program */
    fmb_program program;
    fmb_oracle *oracle;
    bool empty; /* the cone is {0}, or its lines */
    bool begun;
    fmb_support support;
} fmb_section;

/* row[m] outlives it; call fmb_section_close even after errors: MEMORY, LIMIT, as below. */
fmb_status fmb_section_open(fmb_section *c, fmb_run *run, const fmb_vec *row, size_t m, size_t d);
void fmb_section_close(fmb_section *c);

/* Continue until all rays are found, *done; or more than `most` are (0: any number); or the hull
 * has tested so many pairs of facets (0: any number). */
fmb_status fmb_section_ask(fmb_section *c, size_t most, uint64_t pairs, bool *done);
/* The number of rays found so far. */
size_t fmb_section_found(const fmb_section *c);

/* *image, new, gets the extreme rays found and all lines. The caller must call fmb_image_clear even
 * after an error. */
fmb_status fmb_section_take_rays(fmb_section *c, fmb_image *image);

/* ---- section_form.c -------------------------------------------------------------------------- */

/* Choose w, with short numbers if possible, and c->gone, once the independent rows are known.
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_section_choose_form(fmb_section *c);

#endif
