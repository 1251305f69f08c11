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
    FMB_EVENT_ENGINE     /* an engine has done what it could for a part: attempt is set */
} fmb_event_kind;

/* A row just made, and what its history says about it. Rows are numbered from 0 within one
 * elimination, those of the system first; a row that is dropped leaves its number to the next one.
 * fmb_bound goes back to an earlier round to go on another way (its number comes again): the rows
 * made since leave their numbers, too. fmb_optimize adds a row behind those of the system, and a
 * column behind those of the variables, which says what the form is: its variable is -1. Bit sets
 * are words of 64 bits, least first; what pointers show is the library's and good until the
 * callback returns. */
typedef struct fmb_row_event {
    uint64_t row;              /* its number */
    uint64_t parent[2];        /* the rows combined */
    const int *variable;       /* the system's variable of each column, NULL: the same */
    const uint32_t *base;      /* the row of each bit of a history */
    const char *dropped_by;    /* the rule that dropped it, or NULL: it lives */
    const uint64_t *history;   /* [history_words] base rows combined, or NULL: none are kept */
    const uint64_t *effective; /* [column_words] columns effectively eliminated */
    const uint64_t *implicit;  /* [column_words] columns implicitly eliminated */
    size_t history_words, column_words;
    int minimal; /* rank of the history: 1 minimal, 0 not, -1 not known */
} fmb_row_event;

/* How an engine fared. A query may ask several, one after the other, or one several times with more
 * patience, until the last one answers or a limit is reached. */
typedef struct fmb_attempt {
    const char *engine; /* static texts here: "elimination", "oracle", ... */
    const char *task;   /* what was asked: "verdict", "projection", "ends", "optimum", "rows",
                           "rays", "facets" */
    int part;           /* connected component of the system, from 0; -1: all of it */
    size_t columns, rows;
    uint64_t budget;   /* how far it was allowed to go, 0: to its end */
    const char *unit;  /* of the budget: "rows", "rays", "pairs" or "steps"; or NULL */
    const char *ended; /* "answered"; "gave up" at its budget; "paused" at its budget, where it goes
                          on when it is asked again; "unsuitable": it saw that it is none for this;
                          "limit" of the query */
    uint64_t spent;    /* steps that it has taken so far, where it is one that pauses; else 0 */
    uint64_t left;     /* steps that it is expected to take yet; 0: no idea */
} fmb_attempt;

/* Something that happened in a query; members that its kind says nothing of are 0 or NULL. */
typedef struct fmb_event {
    fmb_event_kind kind;
    int round, var; /* var: just eliminated, -1 if none */
    uint64_t rows_in, rows_out;
    uint64_t pairs;   /* pairs of rows looked at */
    uint64_t made;    /* rows combined */
    uint64_t dropped; /* pairs and rows dropped by rules */
    uint64_t widened; /* rows widened to GMP */
    const fmb_row_event *row;
    const fmb_attempt *attempt; /* the library's and good until the callback returns */
    const char *name;           /* static text, or NULL */
    double seconds;             /* since the query began [s] */
} fmb_event;

/* Who watches a query: put is told of every event, by the thread of the query. */
typedef struct fmb_sink {
    void (*put)(void *self, const fmb_event *e); /* NULL: silent */
    void *self;
} fmb_sink;

/* What a sink that writes JSON says of an event, to memory (<fmb/base.h>): one object and its line
 * end. Errors: ARG (NULL, no such kind, a ROW without its row, an
 * ENGINE without its attempt), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_event_print(const fmb_event *e, char *text, size_t size,
                                               size_t *length);
/* A sink that writes one JSON object a line to out (borrowed). Errors of the stream stay in it. */
FMB_API fmb_sink fmb_sink_jsonl(FILE *out);

#ifdef __cplusplus
}
#endif
#endif
