/* whole.h: frames in whole numbers.
 *
 * On each axis of the world there is a unit, the least common denominator of all the numbers that
 * belong to that axis (a power of two, if they come from doubles). Numbers are counted in those
 * units: a row of a system that says something about world axis j is only multiplied by it.
 */
#ifndef FMB_FRAME_WHOLE_H
#define FMB_FRAME_WHOLE_H

#include <fmb/gmp.h>

#include "base/mem.h"

/* Its rows: the origin, the edges, the speed if it moves. */
typedef struct fmb_whole {
    fmb_shape shape;
    int naxes, rows;
    bool moves;
    mpz_t *number; /* [rows][dim], in the scene */
} fmb_whole;

/* All frames of one question. */
typedef struct fmb_scene {
    fmb_mem *mem;
    int dim;
    size_t frames;
    fmb_whole *frame; /* [frames] */
    mpz_t *unit;      /* [dim], whole and positive: the number of units in 1 */
    mpz_t *cell;      /* the units, then the numbers of the frames */
    size_t cells;
} fmb_scene;

/* Frames that have been checked. Errors: MEMORY. What was opened is closed by fmb_scene_clear. */
fmb_status fmb_scene_of_doubles(fmb_scene *w, const fmb_frame *f, size_t n, fmb_mem *mem);
fmb_status fmb_scene_of_rationals(fmb_scene *w, const fmb_frame_q *f, size_t n, fmb_mem *mem);
void fmb_scene_clear(fmb_scene *w);

#endif
