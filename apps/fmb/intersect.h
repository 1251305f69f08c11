/* intersect.h: inside of `fmb intersect`: pairs, what is found of them, and how it is reported. */
#ifndef FMB_INTERSECT_H
#define FMB_INTERSECT_H

/* gmp.h declares what prints only behind these two. */
#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>
#include <fmb/pair.h>

#include "common/decimal.h"
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
    int digits;  /* of decimals, or 0: fractions */
    int threads; /* 1 to APP_MOST_THREADS */
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

/* Pairs are answered, and reported. */
typedef struct intersect {
    const intersect_ask *ask;
    FILE *out, *err; /* where the report goes, and where messages about pairs */
    fmb_solver *solver;
    long before; /* lines in front of those that are read */
    size_t tested, meeting, undecided, within, contradicted;
    fmb_stop stop; /* DONE, or a limit that left something open of some pair */
} intersect;

/* ---- intersect_report.c: [give, free()] numbers of intervals as they will be printed ----------
 */

char *report_rational(const intersect_ask *ask, mpq_srcptr q, app_rounding way);
char *report_double(const intersect_ask *ask, double d, app_rounding way);

/* ---- intersect_quick.c ----------------------------------------------------------------------- */

/* Room for the rationals of one answer, kept from pair to pair. */
typedef struct numbers numbers;

/* [give] */
numbers *numbers_new(void);
void numbers_free(numbers *room);

/* The same where it is quickly proved; if not, the verdict stays UNKNOWN. */
fmb_status intersect_quickly(const intersect *x, const fmb_frame_line *line, numbers *room,
                             meeting *out);

/* ---- intersect_exact.c ----------------------------------------------------------------------- */

/* All about one line, exactly; out->line and id are left alone. */
fmb_status intersect_exactly(const intersect *x, const fmb_frame_line *line, numbers *room,
                             meeting *out);

/* ---- intersect_batch.c: lines in doubles, many at once ----------------------------------------
 */

typedef struct batch batch;

/* [give] */
batch *batch_new(intersect *x);
void batch_free(batch *b);
/* Is this line one to be answered in rationals? */
bool batch_wants_rationals(const batch *b, const fmb_frame_line *line);
/* Take one line; what is found of it is reported later, in order. */
fmb_status batch_put(batch *b, const fmb_frame_line *line);
/* Report all that was taken. */
fmb_status batch_flush(batch *b);
/* From now on it is this thread that a signal stops (stop.h). */
void batch_join(const batch *b);

/* ---- intersect_lines.c ------------------------------------------------------------------------
 */

/* What is shown on a terminal while it is waited for. */
typedef struct progress {
    bool shown, wanted;
    double last; /* [s] */
} progress;

progress progress_begin(const intersect_ask *ask);
void progress_show(progress *p, const intersect *x);
void progress_end(const progress *p);

/* Lines on their way to answers. */
typedef struct answering {
    batch *b;
    fmb_frame_reader *lines;
    progress *progress; /* or NULL */
    fmb_status asked;   /* FMB_OK, or what the batch failed with */
} answering;

/* Answer and report every line, up to the end, a mistake (then *where and errno tell it), or a
 * signal, which may cut the last line. What the reader returned last. */
fmb_status answer_lines(answering *w, intersect *x, fmb_where *where);

/* [give] A solver as x->ask wants it. */
fmb_status intersect_solver(const intersect_ask *ask, fmb_solver **out);
fmb_reader intersect_reader(const intersect_ask *ask);

/* ---- intersect_crew.c: several threads --------------------------------------------------------
 */

/* The same as answer_lines for all of a stream by x->ask->threads threads; *asked is what failed
 * beside reading. */
typedef struct crew crew;

/* [give] */
crew *crew_new(intersect *x);
void crew_free(crew *c);
/* Report all that was read; for a listener of the stream. */
void crew_flush(crew *c);
fmb_status crew_answer(crew *c, FILE *in, fmb_where *where, fmb_status *asked);

/* ---- intersect_report.c ---------------------------------------------------------------------- */

void report_begin(const intersect *x);
/* Count and print one pair, and free what m holds. */
void report_pair(intersect *x, meeting *m);
void report_end(const intersect *x);

/* ---- intersect_stream.c ---------------------------------------------------------------------- */

/* The whole command: an exit code. */
int intersect_stream(const intersect_ask *ask, FILE *in);

#endif
