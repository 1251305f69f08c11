/* peer.h: a driver of one library, as a const table.
 *
 * Only the questions are timed. A driver runs in a child process of its own: it may abort, leak at
 * exit, and leave its library's globals in any state.
 */
#ifndef FMB_PEERS_PEER_H
#define FMB_PEERS_PEER_H

#include "problem.h"

/* The questions. */
typedef enum peer_question {
    PEER_PROJECT = 0,
    PEER_VERTICES, /* vertices, rays and lines from rows */
    PEER_HULL,     /* rows from vertices, rays and lines */
    PEER_DECIDE,
    PEER_BOX,      /* both ends of every variable */
    PEER_REDUCE,   /* irredundant rows */
    PEER_OPTIMIZE, /* the optimum of the objective */
    PEER_QUESTIONS
} peer_question;

/* The arguments of a driver's open. */
typedef struct peer_setup {
    const fmb_options *options;
    peer_question question;
    double seconds; /* limit of CPU time of a run */
} peer_setup;

/* An answer in doubles: the 2n ends of a box; the number of irredundant rows; the optimum of the
 * objective. Owned by the driver. */
typedef struct peer_numbers {
    double *value;
    size_t n;
} peer_numbers;

typedef struct peer {
    const char *name;    /* "cdd-block" */
    const char *library; /* "cddlib": the best of its drivers counts */
    bool inexact;        /* computes with doubles: a wrong verdict is counted, not an error */
    bool ours;           /* fmb itself, not a peer */
    /* The library's own system of the problem; NULL if it cannot express it (strict rows). */
    void *(*open)(const problem *p, const peer_setup *setup);
    /* Before each run: free the last result, and make afresh whatever a run consumes. */
    void (*ready)(void *self);
    /* The projection on the first keep variables, irredundant; NULL if the library has none.
     * False if it gave up. */
    bool (*project)(void *self);
    /* Irredundant vertices, rays and lines of the rows; irredundant rows of given generators. */
    bool (*vertices)(void *self);
    bool (*hull)(void *self);
    /* The last projection, vertices or hull, as a system of keep variables; a vertex x / t or a ray
     * (t = 0) is the row x <= t, a line x = 0. */
    fmb_system *(*fetch)(void *self);
    /* CPU time of the last run in other processes [s]; NULL: it starts none. */
    double (*elsewhere)(void *self);
    /* Is the system feasible? The next three return this, too. NULL: not measured. */
    fmb_verdict (*decide)(void *self);
    fmb_verdict (*box)(void *self);
    fmb_verdict (*reduce)(void *self);
    fmb_verdict (*optimize)(void *self);
    /* Of the last box, reduction or optimum; NULL: the driver has none. */
    const peer_numbers *(*numbers)(void *self);
    /* Does fmb_check accept the evidence of the last answer, and is this evidence complete for the
     * question? Not timed; NULL: there is no evidence. */
    bool (*prove)(void *self, peer_question question);
    void (*close)(void *self);
    bool single; /* fmb with one fixed method: runs only with --methods */
} peer;

/* The driver's function for a question of verdicts; NULL for other questions, or if it has none. */
typedef fmb_verdict peer_ask(void *self);
peer_ask *peer_way(const peer *p, peer_question question);
/* Likewise for questions whose answers are lists of rows or generators. */
typedef bool peer_make(void *self);
peer_make *peer_maker(const peer *p, peer_question question);
static inline bool peer_is_list(peer_question question)
{
    return question <= PEER_HULL;
}

/* Is p in a comma list of drivers and libraries? A library stands for all its drivers. */
bool peer_is_listed(const char *list, const peer *p);
/* Does each word of the list name a driver of this build? */
bool peers_know_all(const char *list);

/* All drivers of this build; NULL ends the list. fmb is the first. */
extern const peer *const peers[];

#endif
