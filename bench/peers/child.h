/* child.h: one driver on one problem, in a child process with limits on time and memory. */
#ifndef FMB_PEERS_CHILD_H
#define FMB_PEERS_CHILD_H

#include "peer.h"

typedef struct child_limits {
    double seconds; /* CPU time of one run [s] */
    size_t bytes;   /* address space of the child; 0: no limit [bytes] */
    peer_question question;
    double later; /* CPU time of the runs after the first [s] */
    int variants; /* given variants of the problem, 1 ... CHILD_VARIANTS */
    const fmb_options *options;
} child_limits;

typedef enum child_end {
    CHILD_DONE = 0, /* first and typical are valid */
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
    fmb_verdict verdict; /* except for projections */
    size_t peak;         /* memory that the first run added to the child [bytes] */
    double *number;      /* [numbers] of the answer; owned */
    size_t numbers;
    bool has_proof, proved; /* the first answer has evidence; fmb_check accepts it */
    double proving;         /* time of that check [s] */
} child_outcome;

enum { CHILD_VARIANTS = 16 };

void child_outcome_clear(child_outcome *o);
child_outcome child_run(const peer *driver, const problem *variants, const child_limits *limits);

#endif
