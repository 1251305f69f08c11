/* support_private.h: what the files of the support queries share; see support.h. */
#ifndef FMB_HULL_SUPPORT_PRIVATE_H
#define FMB_HULL_SUPPORT_PRIVATE_H

#include "hull/support/support.h"

/* What is noted of a facet of the hull. */
enum {
    FMB_FACET_OPEN = 0, /* it may be that the projection goes further */
    FMB_FACET_STANDS,
    FMB_FACET_MISSING /* the same, but the projection only comes near */
};

/* What a question about a facet came to. */
typedef enum fmb_support_answer {
    FMB_SUPPORT_BEYOND = 0, /* the worker saw a point or ray beyond */
    FMB_SUPPORT_ROW,        /* it stands, and its row is written down */
    FMB_SUPPORT_NO_ROW      /* it stands, and has no row, or one that is known */
} fmb_support_answer;

/* ---- support_query.c ------------------------------------------------------------------------- */

fmb_status fmb_support_point_init(fmb_support_point *x, size_t n, fmb_mem *mem);
void fmb_support_point_clear(fmb_support_point *x, fmb_mem *mem);
/* The oracle must outlive the worker. In any case fmb_support_worker_clear it. Errors: MEMORY,
 * LIMIT. */
fmb_status fmb_support_worker_init(fmb_support_worker *c, fmb_run *run, fmb_oracle *oracle,
                                   size_t n);
void fmb_support_worker_clear(fmb_support_worker *c, const fmb_support *s);
/* Does the projection satisfy sign (h0 + h1 x1 + ...) >= 0, h[k + 1], which all generators do?
 * *stands: if so, and the row is written down, proof included (of an equality, with sign -1 the
 * reverse), in the worker's memory. Else the worker sees a point or ray beyond. */
fmb_status fmb_support_worker_look(fmb_support_worker *c, const fmb_support *s, const fmb_vec *h,
                                   int sign, fmb_support_row *row, bool *stands);
/* The same of a facet whose normal is known, by whatever tells soonest. */
fmb_status fmb_support_worker_settle(fmb_support_worker *c, const fmb_support *s,
                                     const fmb_facet *a, fmb_support_row *row,
                                     fmb_support_answer *answer);
/* The hull takes in what a worker saw, perhaps beyond facet `at`; the worker stands there now. */
fmb_status fmb_support_take(fmb_support *s, fmb_support_worker *c, const fmb_support_point *seen,
                            size_t at);
/* Look alone, and take in what was seen. */
fmb_status fmb_support_query(fmb_support *s, const fmb_vec *h, int sign, fmb_support_row *row,
                             bool *stands);

/* ---- support_next.c -------------------------------------------------------------------------- */

/* Are rows wanted that are no facets? Then facets asked about are from all around, so that these
 * are, too. */
bool fmb_support_is_hull_coarse(const fmb_support *s);
/* An open facet, SIZE_MAX if there is none. It is one near that generator, where the worker's
 * oracle stands, so that its way to the optimum is short; or else the youngest, roughly. */
size_t fmb_support_find_open_facet(fmb_support *s, const fmb_support_near *near);

/* ---- support_symmetry.c ---------------------------------------------------------------------- */

/* Errors: MEMORY, LIMIT, here and below. */
bool fmb_support_is_symmetric(const fmb_support *s);
void fmb_support_forget_symmetry(fmb_support *s);
/* The hull has grown by its last generator: take in its images. */
fmb_status fmb_support_take_images(fmb_support *s);
/* The row kept last is that of a facet: note its images. */
fmb_status fmb_support_note_images(fmb_support *s, const fmb_vec *normal);
/* Is that facet an image of one that stands? Then it stands, too. */
fmb_status fmb_support_recall(fmb_support *s, size_t facet, bool *known);

/* ---- support_row.c: a row is proved, or of no use -------------------------------------------- */

fmb_status fmb_support_write_row(const fmb_support *s, const fmb_vec *h, fmb_support_row *row,
                                 fmb_mem *mem);
/* Takes over the row, whatever the status. */
fmb_status fmb_support_keep(fmb_support *s, fmb_support_row *row);
/* That facet stands, its row having the relation. */
static inline void fmb_support_note_facet(fmb_support *s, size_t facet, fmb_rel rel)
{
    s->hull.facet[facet].note = rel == FMB_LT ? FMB_FACET_MISSING : FMB_FACET_STANDS;
}
/* The same, and keep the row. */
fmb_status fmb_support_keep_facet(fmb_support *s, size_t facet, fmb_support_row *row);
void fmb_support_drop(fmb_support_row *row, fmb_mem *mem);

/* ---- support_outer.c ------------------------------------------------------------------------- */

/* The next of 2 k ends of coordinates; s->begun. Errors: MEMORY, LIMIT. */
fmb_status fmb_support_ask_about_end(fmb_support *s);
/* How far does the projection go along -(h1, ... hk), from the point of s->g, if that is one?
 * Errors: MEMORY, LIMIT. */
fmb_status fmb_support_look_along(fmb_support *s, const fmb_vec *h);
void fmb_support_forget_outer_rows(fmb_support *s);

/* ---- support_known.c ------------------------------------------------------------------------- */

/* Is the facet of that normal a row of the program, and those are known? */
bool fmb_support_is_known(const fmb_support *s, const fmb_vec *normal);
void fmb_support_forget_rows(fmb_support *s);

/* support_strict.c: all facets stand. Rows for the other faces that the projection lacks. */
fmb_status fmb_support_find_missing_faces(fmb_support *s);

#endif
