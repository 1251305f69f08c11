/* peer.h: a driver of one library, as a const table.
 *
 * Inside the clock: the questions, nothing else. A driver runs in a child process of its own:
 * it may abort, leak at its end, and leave its library's globals as it likes.
 */
#ifndef FMB_PEERS_PEER_H
#define FMB_PEERS_PEER_H

#include "problem.h"

/* What is asked. */
typedef enum peer_question {
    PEER_PROJECT = 0,
    PEER_VERTICES, /* vertices, rays and lines from rows */
    PEER_HULL,     /* rows from those */
    PEER_DECIDE,
    PEER_BOX,      /* both ends of every variable */
    PEER_REDUCE,   /* which rows stay */
    PEER_OPTIMIZE, /* how far the objective goes */
    PEER_QUESTIONS
} peer_question;

/* What a driver is told before it opens. */
typedef struct peer_setup {
    const fmb_options *options;
    peer_question question;
    double seconds; /* of CPU time that a run may take */
} peer_setup;

/* What an answer came to in doubles: the ends of a box, 2n of them; how many rows stay; the best
 * value of an objective. Owned by the driver. */
typedef struct peer_numbers {
    double *value;
    size_t n;
} peer_numbers;

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
    /* Irredundant vertices, rays and lines of the rows; an irredundant system of such. */
    bool (*vertices)(void *self);
    bool (*hull)(void *self);
    /* The last of these, as a system of keep variables; a vertex x / t, a ray (t = 0) or a line is
     * the row x <= t or x = 0. */
    fmb_system *(*fetch)(void *self);
    /* CPU time of the last run in other processes [s]; NULL: there are none. */
    double (*elsewhere)(void *self);
    /* Has the system a solution? The others say so, too. NULL if the library is not asked. */
    fmb_verdict (*decide)(void *self);
    fmb_verdict (*box)(void *self);
    fmb_verdict (*reduce)(void *self);
    fmb_verdict (*optimize)(void *self);
    /* Of the last box, reduction or optimum; NULL: there are none. */
    const peer_numbers *(*numbers)(void *self);
    /* Does fmb_check accept the evidence of the last answer, and is it all that the question takes?
     * Not inside the clock; NULL: there is no evidence. */
    bool (*prove)(void *self, peer_question question);
    void (*close)(void *self);
    bool single; /* fmb, told which way to go: runs where all ways are asked for */
} peer;

/* The driver's way to a question of verdicts; NULL if there is none, or it asks to project. */
typedef fmb_verdict peer_ask(void *self);
peer_ask *peer_way(const peer *p, peer_question question);
/* The same of questions whose answers are lists of rows, or of generators. */
typedef bool peer_make(void *self);
peer_make *peer_maker(const peer *p, peer_question question);
static inline bool peer_is_list(peer_question question)
{
    return question <= PEER_HULL;
}

/* Is it in a comma list of drivers and libraries? A library stands for all its drivers. */
bool peer_is_listed(const char *list, const peer *p);
/* Does each word of the list name a driver of this build? */
bool peers_know_all(const char *list);

/* All drivers of this build; NULL ends the list. fmb is the first. */
extern const peer *const peers[];

#endif
