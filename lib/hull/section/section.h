/* section.h: the rays of a cone that has many rows and few rays, by support queries.
 *
 * Let {x : row_i.x >= 0} contain no line (columns that the others tell are left out), and let the
 * form w be nowhere negative on it. Then the section w.x = 1 is a polyhedron whose vertices and
 * rays are the rays of the cone, one each. It is the hull of what support queries find (support.h),
 * where a facet of the hull that is a row of the cone stands without a query: there are about as
 * many queries as rays. Double description (dd/cone.h) may have very many rays in between; this
 * never has more facets than hulls of its rays have.
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
    size_t *pivot;  /* [rank] base[i] is not 0 here, those after it are */
    size_t *chosen; /* [rank] the independent rows that they come from */
    fmb_integers w; /* [d] 0 but in pivots */
    size_t gone;    /* the column that w.x = 1 tells, */
    int *column;    /* [rank - 1] and those of the program */
    int *kept;      /* [rank - 1] all of these */
    fmb_program program;
    fmb_oracle *oracle;
    bool empty; /* the cone is {0}, or its lines */
    bool begun;
    fmb_support support;
} fmb_section;

/* row[m] outlives it. In any case fmb_section_close it. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_section_open(fmb_section *c, fmb_run *run, const fmb_vec *row, size_t m, size_t d);
void fmb_section_close(fmb_section *c);

/* Go on until all rays are found: *done; or more than `most` are, 0: any number; or hulls have
 * looked at so many pairs of facets, 0: any number. */
fmb_status fmb_section_ask(fmb_section *c, size_t most, uint64_t pairs, bool *done);
/* How many have been found. */
size_t fmb_section_found(const fmb_section *c);

/* The rays that were found, each of them extreme, and all lines: *image, new. In any case
 * fmb_image_clear it. */
fmb_status fmb_section_take_rays(fmb_section *c, fmb_image *image);

/* ---- section_form.c -------------------------------------------------------------------------- */

/* w, of short numbers if that can be, and c->gone. The independent rows are known. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_section_choose_form(fmb_section *c);

#endif
