/* part.h: a connected component of a system, as dense primitive integer rows over its own
 * variables.
 *
 * Two variables are connected when a row names both; the rows of different parts say nothing of one
 * another, so each question is answered part by part. A row that names no variable belongs to no
 * part: it is true or false by itself.
 */
#ifndef FMB_SOLVE_PART_H
#define FMB_SOLVE_PART_H

#include "base/arena.h"
#include "num/vec.h"
#include "trace/run.h"

typedef struct fmb_part {
    int n;
    int *var; /* [n] variables of the system, increasing */
    size_t m;
    fmb_vec *row;   /* [m], n + 1 entries: coefficients, right side */
    fmb_rel *rel;   /* [m] */
    size_t *source; /* [m] rows of the system, increasing */
} fmb_part;

typedef struct fmb_parts {
    fmb_part *part;
    int count;
    int *of_var;      /* [dim] the part of each variable, -1 if no row names it */
    int *place;       /* [dim] its column there */
    size_t false_row; /* a row 0 REL b that is false, or SIZE_MAX */
} fmb_parts;

/* Split s. Everything is in the arena but wide entries, which fmb_parts_clear releases. */
fmb_status fmb_parts_split(fmb_parts *p, const fmb_system *s, fmb_run *run, fmb_arena *arena,
                           bool wide_only, bool components);
void fmb_parts_clear(fmb_parts *p, fmb_mem *mem);

/* The factor that turns a multiplier of the part's primitive row into one of row `source` as
 * written. */
void fmb_part_scale(const fmb_system *s, size_t source, mpq_t factor);

#endif
