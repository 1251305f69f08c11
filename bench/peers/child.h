/* child.h: one driver on one problem, in a child process with limits on time and memory. */
#ifndef FMB_PEERS_CHILD_H
#define FMB_PEERS_CHILD_H

#include "peer.h"

typedef struct child_limits {
    double seconds; /* CPU time of one run [s] */
    size_t bytes;   /* address space of the child; 0: no limit [bytes] */
    bool decide;    /* decide instead of project */
    const fmb_options *options;
} child_limits;

typedef enum child_end {
    CHILD_DONE = 0, /* first and typical hold */
    CHILD_TIME,     /* limit of time */
    CHILD_GAVE_UP,  /* the library returned an error */
    CHILD_CANNOT,   /* the driver cannot express the question */
    CHILD_CRASHED   /* abort, signal, no memory */
} child_end;

typedef struct child_outcome {
    child_end end;
    int signal;          /* of a crash */
    double limit;        /* of one run [s] */
    double first;        /* the first run, cold [s] */
    double typical;      /* median of the later runs, or the first if there are none [s] */
    int runs;            /* later runs */
    char *text;          /* canonical result; NULL if it could not be made; owned */
    bool unlike;         /* the driver's results on two variants of the problem differ */
    fmb_verdict verdict; /* when asked to decide */
} child_outcome;

#define CHILD_VARIANTS 16

child_outcome child_run(const peer *driver, const problem *variants, const child_limits *limits);

#endif
