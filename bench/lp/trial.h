/* trial.h: trials: which questions are put about which systems, and the resulting lines. */
#ifndef FMB_BENCH_TRIAL_H
#define FMB_BENCH_TRIAL_H

#include "line.h"

typedef struct lines {
    line *list;
    size_t n;
} lines;

/* The arguments of a run. */
typedef struct setup {
    const char *cases; /* the folder of collected cases */
    const char *peers; /* comma list of drivers, or NULL: the trial's own */
    double seconds;    /* limit of one answer [s]; 0: the trial's own */
    size_t bytes;      /* address space of a child [bytes]; 0: no limit, for sanitizers */
    int rounds;        /* 0: the trial's own */
    bool quick;
    bool terse; /* no line for each system */
    uint64_t seed;
    const fmb_options *options;
} setup;

typedef struct question {
    peer_question kind;
    const char *peers; /* comma list of drivers */
    double seconds;    /* of one answer [s] */
    int rounds;
    double later; /* CPU time of the runs after the first one of a round [s] */
} question;

/* The plan of a question, with the drivers that this build has. */
line_plan plan_of(const question *q, const setup *how);
/* Measure one system and print its line. False if there is no such system. */
bool ask_about(lines *to, const char *what, subject_dress dress, const question *q,
               const setup *how);

/* A set of systems and a question; bars.h judges the lines. */
typedef struct trial {
    const char *name, *about;
    question question;
    bool (*run)(const struct trial *t, const setup *how, lines *to); /* false: cases not found */
} trial;

extern const trial TRIALS[];
extern const int TRIALS_COUNT;

#endif
