/* part.h: a connected component of a system; where they are wanted, its rows as dense primitive
 * integers over its own variables.
 *
 * Two variables are connected when a row names both; rows of different parts share no variable, so
 * each question is answered part by part. A row that names no variable belongs to no part: it is
 * true or false by itself.
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
    fmb_rel *rel;   /* [m] */
    size_t *source; /* [m] rows of the system, increasing */
    fmb_vec *row;   /* [m], n + 1 entries: coefficients, right side; NULL until fmb_part_load */
    int64_t *words; /* [m][n + 1] their small entries */
    bool wide;      /* some of them are wide (num/vec.h) */
} fmb_part;

typedef struct fmb_parts {
    fmb_part *part;
    int count;
    int *of_var;      /* [dim] the part of each variable, -1 if no row names it */
    int *place;       /* [dim] the column of each variable in its part */
    size_t false_row; /* a row 0 REL b that is false, or SIZE_MAX */
} fmb_parts;

typedef enum fmb_split {
    FMB_SPLIT_COMPONENTS = 0,
    FMB_SPLIT_NAMED, /* one part, of all variables that a row names */
    FMB_SPLIT_ALL    /* one part, of all variables, each in the column of its number; none, where no
                        row names any */
} fmb_split;

/* Split s. All memory comes from the arena except dense rows, which fmb_parts_clear releases. */
fmb_status fmb_parts_split(fmb_parts *p, const fmb_system *s, fmb_run *run, fmb_arena *arena,
                           fmb_split how);
void fmb_parts_clear(fmb_parts *p, fmb_mem *mem);

/* Write the dense rows of a part, unless they exist: place[dim] as in fmb_parts. A limit that was
 * reached before stops this only where numbers are long (num/gcd.h). Errors: MEMORY, LIMIT. */
fmb_status fmb_part_load(fmb_part *p, const fmb_system *s, const int *place, fmb_run *run,
                         bool wide_only);

/* The greatest common divisor of coefficients and right side, as the system holds them. Errors:
 * LIMIT. */
fmb_status fmb_part_content(const fmb_system *s, size_t source, fmb_run *run, mpz_t content);
/* The factor that converts a multiplier of the part's primitive row into one of row `source` of the
 * system. Errors: LIMIT. */
fmb_status fmb_part_scale(const fmb_system *s, size_t source, fmb_run *run, mpq_t factor);

#endif
