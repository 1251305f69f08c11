/* intersect.h: the parts of `fmb intersect`: pairs, their answers, and the report. */
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
    BOXES_NONE       /* verdicts only */
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

/* One variable of a box: lower end, upper end, and its value in the witness; texts from malloc.
 * outer: because of a limit an end may not be the tightest. */
typedef struct interval {
    char *lower, *upper, *at;
    bool outer;
} interval;

/* The answers about one pair. */
typedef struct meeting {
    long line;
    char *id; /* as JSON, or NULL; from malloc */
    fmb_verdict verdict;
    fmb_stop stop;
    int dim, inside;    /* intervals of the world, of the second frame */
    bool moves;         /* there is an interval of time, too */
    interval *interval; /* [dim + inside + moves], or NULL if there is no box; from malloc */
    near_found near;
} meeting;

/* The state of answering and reporting pairs. */
typedef struct intersect {
    const intersect_ask *ask;
    FILE *out, *err; /* for the report, and for messages about pairs */
    fmb_solver *solver;
    long before; /* number of lines before those that are read */
    size_t tested, meeting, undecided, within, contradicted;
    fmb_stop stop; /* DONE, or a limit that left answers of some pair open */
} intersect;

/* ---- intersect_report.c: [give, free()] numbers of intervals as they will be printed ----------
 */

char *report_rational(const intersect_ask *ask, mpq_srcptr q, app_rounding way);
char *report_double(const intersect_ask *ask, double d, app_rounding way);

/* ---- intersect_quick.c ----------------------------------------------------------------------- */

/* Scratch for the rationals of one answer, reused for all pairs. */
typedef struct numbers numbers;

/* [give] */
numbers *numbers_new(void);
void numbers_free(numbers *room);

/* Answer a pair if that is quickly proved; if not, the verdict stays UNKNOWN. */
fmb_status intersect_quickly(const intersect *x, const fmb_frame_line *line, numbers *room,
                             meeting *out);

/* ---- intersect_exact.c ----------------------------------------------------------------------- */

/* Answer one line exactly; out->line and id are left alone. */
fmb_status intersect_exactly(const intersect *x, const fmb_frame_line *line, numbers *room,
                             meeting *out);

/* ---- intersect_batch.c: lines in doubles, many at once ----------------------------------------
 */

typedef struct batch batch;

/* [give] */
batch *batch_new(intersect *x);
void batch_free(batch *b);
/* Must this line be answered in rationals? */
bool batch_wants_rationals(const batch *b, const fmb_frame_line *line);
/* Take one line; its answers are reported later, in order. */
fmb_status batch_put(batch *b, const fmb_frame_line *line);
/* Report all lines taken. */
fmb_status batch_flush(batch *b);
/* From now on signals stop the work of this thread (stop.h). */
void batch_join(const batch *b);

/* ---- intersect_lines.c ------------------------------------------------------------------------
 */

/* The progress shown on a terminal. */
typedef struct progress {
    bool shown, wanted;
    double last; /* [s] */
} progress;

progress progress_begin(const intersect_ask *ask);
void progress_show(progress *p, const intersect *x);
void progress_end(const progress *p);

/* The state of answering lines. */
typedef struct answering {
    batch *b;
    fmb_frame_reader *lines;
    progress *progress; /* or NULL */
    fmb_status asked;   /* FMB_OK, or the error of the batch */
} answering;

/* Answer and report every line, up to the end, an error (described by *where and errno), or a
 * signal, which may cut off the last line. Returns the last status of the reader. */
fmb_status answer_lines(answering *w, intersect *x, fmb_where *where);

/* [give] A solver with the options in ask. */
fmb_status intersect_solver(const intersect_ask *ask, fmb_solver **out);
fmb_reader intersect_reader(const intersect_ask *ask);

/* ---- intersect_crew.c: several threads --------------------------------------------------------
 */

/* answer_lines for a whole stream by x->ask->threads threads; *asked: an error other than of
 * reading. */
typedef struct crew crew;

/* [give] */
crew *crew_new(intersect *x);
void crew_free(crew *c);
/* Report all lines read; for a listener of the stream. */
void crew_flush(crew *c);
fmb_status crew_answer(crew *c, FILE *in, fmb_where *where, fmb_status *asked);

/* ---- intersect_report.c ---------------------------------------------------------------------- */

void report_begin(const intersect *x);
/* Count and print one pair, and free the contents of m. */
void report_pair(intersect *x, meeting *m);
void report_end(const intersect *x);

/* ---- intersect_stream.c ---------------------------------------------------------------------- */

/* The whole command: an exit code. */
int intersect_stream(const intersect_ask *ask, FILE *in);

#endif
