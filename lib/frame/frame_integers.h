/* frame_integers.h: frames in integers.
 *
 * On each axis of the world there is a unit, the least common denominator of all the numbers that
 * belong to that axis (a power of two, if they come from doubles). Numbers are counted in those
 * units: a row about world axis j is only multiplied by the unit. Numbers are converted on demand,
 * as frames in a large space may have millions of them. Frames given by corners look like others
 * from here on.
 */
#ifndef FMB_FRAME_FRAME_INTEGERS_H
#define FMB_FRAME_FRAME_INTEGERS_H

#include <fmb/gmp.h>

#include "trace/run.h"

/* The layout of a frame. Its numbers are [rows][dim]: the origin, the edges, the speed if it
 * moves. */
typedef struct fmb_integer_frame {
    fmb_shape shape; /* cuboid or simplex */
    int naxes, rows;
    bool moves;
    bool by_corners;    /* the source has corners in place of edges */
    const void *source; /* the fmb_frame or fmb_frame_q */
} fmb_integer_frame;

/* How numbers are read from a source. */
typedef struct fmb_number_source fmb_number_source;

/* All frames of one question. */
typedef struct fmb_scene {
    fmb_mem *mem;
    int dim;
    size_t frames;
    fmb_integer_frame *frame; /* [frames] */
    mpz_t *unit;              /* [dim], positive integers: the number of units in 1 */
    const fmb_number_source *from;
} fmb_scene;

/* n frames f or, if that is NULL, q, which were checked before and are borrowed. run: its limits
 * apply; or NULL. fmb_scene_clear the scene even after an error. Errors: MEMORY, LIMIT. */
fmb_status fmb_scene_open(fmb_scene *w, const fmb_frame *f, const fmb_frame_q *q, size_t n,
                          fmb_mem *mem, fmb_run *run);
void fmb_scene_clear(fmb_scene *w);

/* out = number j of row i of a frame, in units of world axis j. */
void fmb_scene_number(const fmb_scene *w, const fmb_integer_frame *f, int i, int j, mpz_t out);

#endif
