/* intersect_stream.c: a stream of pairs from its first line to its last, by one thread or by a
 * crew. */
#include <errno.h>
#include <stdlib.h>

#include "common/message.h"
#include "common/source.h"
#include "fmb/intersect.h"
#include "fmb/listen.h"
#include "fmb/stop.h"

/* Answers come from one of the two. */
typedef struct stream {
    answering alone;
    crew *crew;
} stream;

/* Answer the collected lines: the sender may wait for answers before the next line. */
static void answer_what_waits(void *self)
{
    stream *s = self;
    if (s->crew)
        crew_flush(s->crew);
    else if (s->alone.asked == FMB_OK)
        s->alone.asked = batch_flush(s->alone.b);
    fflush(stdout);
}

static fmb_status answer_alone(stream *s, intersect *x, FILE *in, fmb_where *where)
{
    fmb_reader reading = intersect_reader(x->ask);
    progress p = progress_begin(x->ask);
    s->alone.progress = &p;
    fmb_status st = fmb_frame_reader_new(in, &reading, &s->alone.lines);
    if (st != FMB_OK)
        return st;
    s->alone.b = batch_new(x);
    app_stop_reader(s->alone.lines);
    st = answer_lines(&s->alone, x, where);
    progress_end(&p);
    return st;
}

static int answer_stream(stream *s, intersect *x, FILE *in)
{
    fmb_where where = {0};
    fmb_status st, asked = FMB_OK;
    if (x->ask->threads > 1) {
        s->crew = crew_new(x);
        st = crew_answer(s->crew, in, &where, &asked);
    } else {
        st = answer_alone(s, x, in, &where);
        asked = s->alone.asked;
    }
    if (asked != FMB_OK)
        return app_status_error(asked);
    if (st == FMB_OK && x->tested == 0 && !app_stop_asked())
        st = app_source_without_pairs(&where);
    return app_source_outcome_of(APP_KIND_FRAMES, st, x->ask->file, &where);
}

static int exit_code(const intersect *x)
{
    if (x->contradicted > 0)
        return APP_INTERNAL;
    fmb_stop stop = app_stop_asked() ? FMB_STOP_CANCELLED : x->stop;
    if (stop == FMB_STOP_DONE)
        return x->meeting + x->within > 0 ? APP_YES : APP_NO;
    if (!x->ask->quiet)
        fprintf(stderr, "fmb: undecided (%s): %zu pairs tested, not all to the end\n",
                fmb_stop_text(stop), x->tested);
    return APP_UNDECIDED;
}

int intersect_stream(const intersect_ask *ask, FILE *in)
{
    intersect x = {.ask = ask, .out = stdout, .err = stderr};
    stream s = {{0}, NULL};
    app_listener listener = {.in = in, .idle = answer_what_waits, .self = &s};
    FILE *heard = app_need(app_listen(&listener));
    fmb_status st = intersect_solver(ask, &x.solver);
    int code = st == FMB_OK ? APP_YES : app_status_error(st);
    if (code == APP_YES) {
        report_begin(&x);
        app_stop_begin(x.solver);
        code = answer_stream(&s, &x, heard);
        app_stop_end();
        report_end(&x);
    }
    if (app_stop_asked()) /* freeing a million numbers one by one would take too long */
        exit(code == APP_YES ? exit_code(&x) : code);
    crew_free(s.crew);
    batch_free(s.alone.b);
    fmb_frame_reader_free(s.alone.lines);
    fmb_solver_free(x.solver);
    fclose(heard);
    return code == APP_YES ? exit_code(&x) : code;
}
