/* set.h: a set of frames as records.
 *
 * In the plane and in space a record has 8 or 16 numbers and begins where a cache line does:
 *
 *     origin  D      axes  D D, row i is edge i, missing ones 0      speed  D, of a still frame 0
 *
 * In space it stands there as floats, too (single.h). In four to eight dimensions frames by edges
 * with all their axes have longer records (pair/kernels/minors_kernels.h).
 *
 * A kind describes the contents of a record. Frames that no record can hold (other frames and
 * dimensions; corners whose differences are no doubles) have kind NONE. These, and every frame by
 * corners, are also stored as given: exact queries need that.
 */
#ifndef FMB_PAIR_SET_H
#define FMB_PAIR_SET_H

#include <stdbool.h>

#include <fmb/frames.h>

#include "base/mem.h"

/* 2 naxes + shape, plus MOVES if it moves; in four and more dimensions without naxes. */
enum { FMB_KIND_MOVES = 8, FMB_KIND_NONE = 16, FMB_KINDS };

/* Numbers of a record in the plane; twice as many in space. */
enum { FMB_RECORD_LINE = 8 };

struct fmb_frames {
    fmb_mem mem;
    int dim;
    size_t n;
    size_t stride;               /* numbers of a record; 0: there are none */
    double *record;              /* [n][stride], aligned, within room */
    float *single;               /* [n][stride], the same as floats, in space */
    bool rounded;                /* are there other numbers than floats? */
    double far, fast;            /* the largest number of an origin, of a speed, in `single` */
    uint8_t *kind;               /* [n] */
    int only;                    /* the kind of all, or -1 */
    uint32_t *order;             /* [n] frames by kind, then number */
    size_t first[FMB_KINDS + 1]; /* index in order of the first frame of each kind */
    double *bounds; /* [dim][lower, upper][eights] around eight frames of a kind (bounds.h) */
    double
        *ends; /* [eights][dim][lower, upper][8] of these frames, in more than three dimensions */
    size_t first_eight[FMB_KINDS + 1], eights; /* of each kind; total of kinds other than NONE */
    fmb_frame *given;              /* [n], or NULL: none is needed; dim 0: the record is complete */
    double *beside;                /* the numbers of given */
    double *room;                  /* memory of the records */
    size_t room_size, beside_size; /* [doubles] */
};

static inline const double *fmb_frames_record(const fmb_frames *s, size_t i)
{
    return s->record + s->stride * i;
}

/* Shape and number of axes of a kind other than NONE. */
static inline fmb_shape fmb_kind_shape(int kind)
{
    return (fmb_shape)(kind & 1);
}
static inline int fmb_kind_naxes(int dim, int kind)
{
    return dim > 3 ? dim : kind % FMB_KIND_MOVES / 2;
}

#endif
