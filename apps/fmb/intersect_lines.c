/* intersect_lines.c: the lines of a stream of pairs, read and answered by one thread, with progress
 * on a terminal. */
#include <errno.h>
#include <unistd.h>

#include "base/clock.h"
#include "fmb/intersect.h"
#include "fmb/stop.h"

/* ---- progress -------------------------------------------------------------------------------- */

static const double interval_seconds = 0.2; /* between two updates */

/* Progress is not shown if the report itself goes to the terminal. */
progress progress_begin(const intersect_ask *ask)
{
    bool wanted = !ask->quiet && isatty(STDERR_FILENO) && !isatty(STDOUT_FILENO);
    return (progress){.wanted = wanted, .last = wanted ? fmb_monotonic_seconds() : 0};
}

void progress_show(progress *p, const intersect *x)
{
    double t = p->wanted ? fmb_monotonic_seconds() : 0;
    if (!p->wanted || t - p->last < interval_seconds)
        return;
    fprintf(stderr, "\rfmb: %zu pairs, %zu meet", x->tested, x->meeting);
    fflush(stderr);
    p->shown = true;
    p->last = t;
}

void progress_end(const progress *p)
{
    if (p->shown)
        fprintf(stderr, "\r%60s\r", "");
}

/* ---- lines ----------------------------------------------------------------------------------- */

fmb_status answer_lines(answering *w, intersect *x, fmb_where *where)
{
    const fmb_frame_line *line = NULL;
    fmb_status st;
    int cause;
    do {
        errno = 0;
        st = fmb_frame_reader_next(w->lines, &line, where);
        if (st == FMB_OK && line && batch_wants_rationals(w->b, line))
            st = fmb_frame_reader_rationals(w->lines);
        cause = errno;
        if (st == FMB_OK && line && w->asked == FMB_OK)
            w->asked = batch_put(w->b, line);
        if (w->progress)
            progress_show(w->progress, x);
    } while (st == FMB_OK && line && w->asked == FMB_OK && !app_stop_asked());
    if (w->asked == FMB_OK)
        w->asked = batch_flush(w->b);
    errno = cause;
    return st;
}

fmb_status intersect_solver(const intersect_ask *ask, fmb_solver **out)
{
    fmb_options how = {.size = sizeof how};
    how.max_seconds = ask->max_seconds;
    how.max_bytes = ask->max_bytes;
    how.evidence = ask->boxes != BOXES_NONE ? FMB_EVIDENCE_ALL : FMB_EVIDENCE_NONE;
    return fmb_solver_new(&how, NULL, out);
}

fmb_reader intersect_reader(const intersect_ask *ask)
{
    return (fmb_reader){
        .size = sizeof(fmb_reader), .nearest = ask->nearest, .max_bytes = ask->max_input};
}
