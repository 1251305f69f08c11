/* boxes.h: what the study of boxes measures; boxes.c reports it. */
#ifndef QUALIFY_BOXES_H
#define QUALIFY_BOXES_H

#include "fmb-qualify/study.h"
#include "study/clock/clock.h"
#include "study/draw/pairs.h"

/* Boxes in world coordinates come first. */
typedef enum boxes_kind {
    BOXES_OURS = 0,
    BOXES_ARTICLE,
    BOXES_CLIPPED,
    BOXES_MENDED,
    BOXES_AABBS,
    BOXES_OURS_INSIDE,
    BOXES_ARTICLE_INSIDE,
    BOXES_MENDED_INSIDE
} boxes_kind;
enum { BOXES_WORLD = BOXES_OURS_INSIDE, BOXES_KINDS = BOXES_MENDED_INSIDE + 1 };

typedef struct boxes_sizes {
    size_t n;                   /* pairs with a tight box that has a volume */
    double *ratio[BOXES_KINDS]; /* [n] volume over that of the tight box */
    size_t holds[BOXES_KINDS];  /* boxes that hold the tight one */
    size_t wrong;               /* our boxes that do not hold it, or are too large */
    bool interrupted;
} boxes_sizes;

/* [give, study_pairs_free] n meeting pairs of the article's generator. Errors: MEMORY. */
fmb_status boxes_draw(int dim, bool moves, uint64_t seed, size_t n, study_pairs *out);

/* [give, boxes_sizes_clear] For the first pairs only: exact boxes take long. Errors: MEMORY. */
fmb_status boxes_measure(const study_pairs *pairs, fmb_simd simd, boxes_sizes *out);
void boxes_sizes_clear(boxes_sizes *s);

/* [give, study_clock_clear] Way 0: verdicts alone; way 1: all answers of fmb_pair_test. Errors:
 * MEMORY. */
fmb_status boxes_time(const study_pairs *pairs, const qualify_setup *o, study_clock *out);

#endif
