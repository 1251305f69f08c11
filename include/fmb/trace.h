/* fmb/trace.h: one callback, one event type: watch a query from inside. */
#ifndef FMB_TRACE_H
#define FMB_TRACE_H

#include <fmb/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum fmb_event_kind {
    FMB_EVENT_BEGIN = 0, /* name: the query */
    FMB_EVENT_ROUND,     /* a variable was eliminated */
    FMB_EVENT_RULE,      /* name: the rule; rows_in - rows_out rows were dropped by it */
    FMB_EVENT_LP,        /* an exact linear program begins, over rows_in rows */
    FMB_EVENT_END        /* name: the verdict */
} fmb_event_kind;

typedef struct fmb_event {
    fmb_event_kind kind;
    int round, var; /* var: just eliminated, -1 if none */
    uint64_t rows_in, rows_out;
    uint64_t pairs;   /* pairs of rows looked at */
    const char *name; /* static text, or NULL */
    double seconds;   /* since the query began [s] */
} fmb_event;

typedef struct fmb_sink {
    void (*put)(void *self, const fmb_event *e); /* NULL: silent */
    void *self;
} fmb_sink;

/* A sink that writes one JSON object a line to out (borrowed). Errors of the stream stay in it. */
FMB_API fmb_sink fmb_sink_jsonl(FILE *out);

#ifdef __cplusplus
}
#endif
#endif
