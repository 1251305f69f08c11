/* support_private.h: shared by the files of the support queries; see support.h. */
#ifndef FMB_HULL_SUPPORT_PRIVATE_H
#define FMB_HULL_SUPPORT_PRIVATE_H

#include "hull/support/support.h"

/* The note of a facet of the hull. */
enum {
    FMB_FACET_OPEN = 0, /* the projection may have points beyond it */
    FMB_FACET_STANDS,
    FMB_FACET_MISSING /* stands, but the projection has none of its points */
};

/* The result of a query about a facet. */
typedef enum fmb_support_answer {
    FMB_SUPPORT_BEYOND = 0, /* a point or ray beyond was seen */
    FMB_SUPPORT_ROW,        /* it stands, and its row was written */
    FMB_SUPPORT_NO_ROW      /* it stands, with no row, or a known one */
} fmb_support_answer;

/* ---- support_query.c ------------------------------------------------------------------------- */

/* Does the projection satisfy the facet, whose normal is known? By the cheapest test that decides.
 */
fmb_status fmb_support_settle(fmb_support *s, const fmb_facet *a, fmb_support_row *row,
                              fmb_support_answer *answer);
/* Add s->seen, perhaps beyond facet `at`, to the hull. */
fmb_status fmb_support_take(fmb_support *s, size_t at);
/* Does the projection satisfy sign (h0 + h1 x1 + ...) >= 0, h[k + 1], as all generators do? If so,
 * *stands, and row is written, with its proof (for an equality, the one of the reverse if sign is
 * -1). Otherwise s->seen, a point or ray beyond, is added to the hull. */
fmb_status fmb_support_query(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row,
                             bool *stands);

/* ---- support_next.c -------------------------------------------------------------------------- */

/* Are rows wanted that are no facets? Then the facets to query are taken from all directions, so
 * that these rows are, too. */
bool fmb_support_is_hull_coarse(const fmb_support *s);
/* An open facet; SIZE_MAX if there is none. Preferably one at the generator of `near`, where the
 * oracle is, so that its way to the optimum is short; otherwise roughly the youngest. */
size_t fmb_support_find_open_facet(fmb_support *s, const fmb_support_near *near);

/* ---- support_symmetry.c ---------------------------------------------------------------------- */

/* Errors: MEMORY, LIMIT, here and below. */
void fmb_support_forget_symmetry(fmb_support *s);
/* After the hull got a new generator: add the images of that. */
fmb_status fmb_support_take_images(fmb_support *s);
/* After the row of a facet was kept: note its images. */
fmb_status fmb_support_note_images(fmb_support *s, const fmb_vec *normal);
/* Is the facet an image of one that stands? Then it stands, too. */
fmb_status fmb_support_recall(fmb_support *s, size_t facet, bool *known);

/* ---- support_row.c: a row is kept or discarded ----------------------------------------------- */

fmb_status fmb_support_write_row(const fmb_support *s, const fmb_vec *h, fmb_support_row *row,
                                 fmb_mem *mem);
/* Takes over the row, whatever the status. */
fmb_status fmb_support_keep(fmb_support *s, fmb_support_row *row);
/* Note that the facet stands, with a row of this relation. */
static inline void fmb_support_note_facet(fmb_support *s, size_t facet, fmb_rel rel)
{
    s->hull.facet[facet].note = rel == FMB_LT ? FMB_FACET_MISSING : FMB_FACET_STANDS;
}
/* The same, and keep the row. */
fmb_status fmb_support_keep_facet(fmb_support *s, size_t facet, fmb_support_row *row);
void fmb_support_drop(fmb_support_row *row, fmb_mem *mem);

/* ---- support_outer.c ------------------------------------------------------------------------- */

/* Query the next of the 2 k bounds of coordinates; s->begun. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_ask_about_end(fmb_support *s);
/* Maximize over the projection in the direction -(h1, ..., hk), starting from the point of s->g if
 * that is one. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_look_along(fmb_support *s, const fmb_vec *h);
void fmb_support_forget_outer_rows(fmb_support *s);

/* ---- support_known.c ------------------------------------------------------------------------- */

/* Are the rows of the program known, and is the facet with that normal one of them? */
bool fmb_support_is_known(const fmb_support *s, const fmb_vec *normal);
void fmb_support_forget_rows(fmb_support *s);

/* support_strict.c: when all facets stand, find rows for other faces that are missing. */
fmb_status fmb_support_find_missing_faces(fmb_support *s);

#endif
