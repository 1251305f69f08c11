/* article.h: FMB as published, for measurements and comparisons only. It has the faults of its
 * original: one absolute epsilon, frames without an inverse refused, another answer for (q, p) than
 * for (p, q) where they touch, boxes far too large, and a corner forgotten where they move
 * (docs/theory.md, "What the article's boxes are").
 *
 * Source: Baillehache 2020, and its program: variables are eliminated in order, c first and t last;
 * each new row is tested against the unit box. No row is ever dropped. In two and three dimensions
 * it costs what the program costs, within 15 % in each cell of Table 1: bench/article/beside shows
 * it for this and for its SAT, study_sat_program. Studies call these two the article's.
 */
#ifndef FMB_STUDY_ARTICLE_H
#define FMB_STUDY_ARTICLE_H

#include "study/rivals/rows.h"

/* How back substitution computes the intervals. */
typedef enum study_article_box_kind {
    STUDY_ARTICLE_PUBLISHED = 0, /* all but the last variable: rows may only widen 0 ... 1 */
    STUDY_ARTICLE_MENDED         /* each row bounds its variable, and no corner is forgotten */
} study_article_box_kind;

typedef struct study_article_box {
    double inside[STUDY_ROWS_MOST_DIM + 1][2]; /* c of q, then t if anything moves */
    double world[STUDY_ROWS_MOST_DIM][2];
} study_article_box;

/* Workspace, for any pairs. */
typedef struct study_article study_article;

/* [give, study_article_free] Errors: MEMORY. */
fmb_status study_article_new(study_article **out);
void study_article_free(study_article *w);

/* The verdict on two frames with all axes, by p's inverse, which each call computes anew, as the
 * article's program does; UNKNOWN if |det p| is too small for that program, or too many rows arise.
 * box, unless NULL, is written if they meet. Errors: MEMORY. */
fmb_status study_article_test(study_article *w, const fmb_frame *p, const fmb_frame *q,
                              study_article_box_kind kind, study_article_box *box,
                              fmb_verdict *out);

#endif
