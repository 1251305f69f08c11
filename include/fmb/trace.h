/* fmb/trace.h: one callback, one event type: watch a query from inside. */
#ifndef FMB_TRACE_H
#define FMB_TRACE_H

#include <fmb/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What happened. */
typedef enum fmb_event_kind {
    FMB_EVENT_BEGIN = 0, /* name: the query */
    FMB_EVENT_ROUND,     /* a variable was eliminated: after the events of its rules and rows */
    FMB_EVENT_RULE,      /* name: the rule, or "constant"; dropped: the pairs and rows it dropped */
    FMB_EVENT_LP,        /* an exact linear program begins, over rows_in rows */
    FMB_EVENT_END,       /* name: the verdict */
    FMB_EVENT_ROW,       /* a row was made (options.trace_rows); row is set */
    FMB_EVENT_REBASE,    /* histories start anew from rows_in rows */
    FMB_EVENT_ENGINE     /* an engine has finished an attempt at a part: attempt is set */
} fmb_event_kind;

/* A row just made, and its history. Rows are numbered from 0 within one elimination, those of the
 * system first; the number of a dropped row is reused for the next one. fmb_bound returns to an
 * earlier round to continue differently (the number of the round comes again): numbers of rows made
 * since are reused, too. fmb_optimize adds a row after those of the system, which defines the form,
 * and a column for it after those of the variables: its variable is -1. Bit sets are words of 64
 * bits, least first; data behind pointers belong to the library and are valid until the callback
 * returns. */
typedef struct fmb_row_event {
    uint64_t row;              /* its number */
    uint64_t parent[2];        /* the rows combined */
    const int *variable;       /* the system's variable of each column, NULL: the same */
    const uint32_t *base;      /* the row of each bit of a history */
    const char *dropped_by;    /* the rule that dropped it, or NULL: it is live */
    const uint64_t *history;   /* [history_words] base rows combined, or NULL: none are kept */
    const uint64_t *effective; /* [column_words] columns effectively eliminated */
    const uint64_t *implicit;  /* [column_words] columns implicitly eliminated */
    size_t history_words, column_words;
    int minimal; /* rank of the history: 1 minimal, 0 not, -1 not known */
} fmb_row_event;

/* The result of an engine's attempt. A query may try several engines, one after the other, or one
 * engine several times with larger budgets, until one answers or a limit is reached. */
typedef struct fmb_attempt {
    const char *engine; /* static texts here: "elimination", "oracle", ... */
    const char *task;   /* what it computes: "verdict", "projection", "ends", "optimum", "rows",
                           "rays", "facets" */
    int part;           /* connected component of the system, from 0; -1: all of it */
    size_t columns, rows;
    uint64_t budget;   /* its limit in this attempt, 0: none */
    const char *unit;  /* of the budget: "rows", "rays", "pairs" or "steps"; or NULL */
    const char *ended; /* "answered"; "gave up" at its budget; "paused" at its budget, to continue
                          in a later attempt; "unsuitable": it cannot handle this part; "limit" of
                          the query */
    uint64_t spent;    /* steps taken so far, if it is an engine that pauses; else 0 */
    uint64_t left;     /* steps that it is expected to take yet; 0: unknown */
} fmb_attempt;

/* Something that happened in a query; members that its kind does not use are 0 or NULL. */
typedef struct fmb_event {
    fmb_event_kind kind;
    int round, var; /* var: just eliminated, -1 if none */
    uint64_t rows_in, rows_out;
    uint64_t pairs;   /* pairs of rows considered */
    uint64_t made;    /* rows combined */
    uint64_t dropped; /* pairs and rows dropped by rules */
    uint64_t widened; /* rows widened to GMP */
    const fmb_row_event *row;
    const fmb_attempt *attempt; /* valid until the callback returns, like row */
    const char *name;           /* static text, or NULL */
    double seconds;             /* since the query began [s] */
} fmb_event;

/* A watcher of queries: put is called for every event, by the thread of the query. */
typedef struct fmb_sink {
    void (*put)(void *self, const fmb_event *e); /* NULL: silent */
    void *self;
} fmb_sink;

/* An event as JSON to memory (<fmb/base.h>), as fmb_sink_jsonl writes it: one object and its line
 * end. Errors: ARG (NULL, no such kind, a ROW without its row, an ENGINE without its attempt),
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_event_print(const fmb_event *e, char *text, size_t size,
                                               size_t *length);
/* A sink that writes one JSON object a line to out (borrowed). Errors of the stream stay in it. */
FMB_API fmb_sink fmb_sink_jsonl(FILE *out);

#ifdef __cplusplus
}
#endif
#endif
