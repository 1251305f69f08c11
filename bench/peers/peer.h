/* peer.h: a driver of one library, as a const table.
 *
 * Inside the clock: project and decide, nothing else. A driver runs in a child process of its own:
 * it may abort, leak at its end, and leave its library's globals as it likes.
 */
#ifndef FMB_PEERS_PEER_H
#define FMB_PEERS_PEER_H

#include "problem.h"

/* How fmb is driven, for its driver. */
typedef struct peer_setup {
    const fmb_options *options;
} peer_setup;

typedef struct peer {
    const char *name;    /* "cdd-block" */
    const char *library; /* "cddlib": the best of its drivers counts */
    bool inexact;        /* computes with doubles: a wrong verdict is counted, not an error */
    bool ours;           /* not a peer, but fmb itself */
    /* The library's own system of the problem; NULL if it cannot express it (strict rows). */
    void *(*open)(const problem *p, const peer_setup *setup);
    /* Before each run: forget the last run's result, and make whatever a run uses up. */
    void (*ready)(void *self);
    /* The projection on the first keep variables, irredundant; NULL if the library has none.
     * False if it gave up. */
    bool (*project)(void *self);
    /* The last projection, as a system of keep variables. */
    fmb_system *(*fetch)(void *self);
    /* Has the system a solution? NULL if the library is not asked. */
    fmb_verdict (*decide)(void *self);
    void (*close)(void *self);
} peer;

/* All drivers of this build; NULL ends the list. fmb is the first. */
extern const peer *const peers[];

#endif
