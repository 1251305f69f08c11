/* intersect.h: inside of `fmb intersect`: pairs, what is found of them, and how it is reported. */
#ifndef FMB_INTERSECT_H
#define FMB_INTERSECT_H

/* gmp.h declares what prints only behind these two. */
#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>
#include <fmb/pair.h>

#include "fmb/intersect_near.h"

typedef enum boxes {
    BOXES_EXACT = 0, /* in rationals */
    BOXES_OUTWARD,   /* in doubles, rounded outward */
    BOXES_NONE       /* verdicts alone */
} boxes;

typedef struct intersect_ask {
    const char *file;
    fmb_contact contact;
    boxes boxes;
    near_ask near;
    bool json, quiet, nearest;
    double max_seconds;
    size_t max_bytes; /* 0: no limit */
    size_t max_input; /* longest line [bytes]; 0: FMB_READER_MAX_BYTES */
} intersect_ask;

/* One variable of a box: lower end, upper end, and where the witness is; texts from malloc. An end
 * that no limit kept from being the tightest is not outer. */
typedef struct interval {
    char *lower, *upper, *at;
    bool outer;
} interval;

/* What was found of one pair. */
typedef struct meeting {
    long line;
    char *id; /* as JSON, or NULL; from malloc */
    fmb_verdict verdict;
    fmb_stop stop;
    int dim, inside;    /* intervals of the world, of the second frame */
    bool moves;         /* then one of time */
    interval *interval; /* [dim + inside + moves], or NULL if there is no box; from malloc */
    near_found near;
} meeting;

typedef struct intersect {
    const intersect_ask *ask;
    fmb_solver *solver;
    size_t tested, meeting, undecided, within;
} intersect;

/* ---- intersect_exact.c ----------------------------------------------------------------------- */

/* [give, free()] A double in as few digits as tell it from all others. */
char *intersect_double(double d);

/* All about one line, exactly; out->line and id are left alone. */
fmb_status intersect_exactly(const intersect *x, const fmb_frames_line *line, meeting *out);

/* ---- intersect_quick.c ----------------------------------------------------------------------- */

/* The same where it is quickly proved; if not, the verdict stays UNKNOWN. */
fmb_status intersect_quickly(const intersect *x, const fmb_frames_line *line, meeting *out);

/* ---- intersect_batch.c: lines in doubles, many at once ----------------------------------------
 */

typedef struct batch batch;

/* [give] */
batch *batch_new(intersect *x);
void batch_free(batch *b);
/* Is this line one to be answered in rationals? */
bool batch_wants_rationals(const batch *b, const fmb_frames_line *line);
/* Take one line; what is found of it is reported later, in order. */
fmb_status batch_put(batch *b, const fmb_frames_line *line);
/* Report all that was taken. */
fmb_status batch_flush(batch *b);

/* ---- intersect_report.c ---------------------------------------------------------------------- */

void report_begin(const intersect *x);
/* Count and print one pair, and free what m holds. */
void report_pair(intersect *x, meeting *m);
void report_end(const intersect *x);

#endif
