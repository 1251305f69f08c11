/* line.h: the answers of all drivers to one question about one system, round by round. */
#ifndef FMB_BENCH_LINE_H
#define FMB_BENCH_LINE_H

#include "subject.h"

enum { LINE_DRIVERS = 8 };

typedef struct line_plan {
    const peer *driver[LINE_DRIVERS]; /* fmb, fmb with proof, then the peers */
    int drivers;
    child_limits limits;
    int rounds;
} line_plan;

typedef enum line_fault {
    LINE_RIGHT = 0,
    LINE_UNDECIDED, /* by fmb */
    LINE_UNPROVED,
    LINE_WRONG
} line_fault;

typedef struct line {
    char name[64];
    int n;
    size_t m, terms, bytes;
    peer_question question;
    subject_dress dress;
    child_outcome outcome[LINE_DRIVERS]; /* typical: median over the rounds; no text, no number */
    bool differs[LINE_DRIVERS];          /* from fmb's answer */
    fmb_verdict verdict;                 /* fmb's */
    line_fault fault;
    size_t peak; /* of fmb with evidence [bytes] */
} line;

void line_measure(line *l, const subject *s, subject_dress dress, const line_plan *plan);
/* The time of fmb over that of driver d; 0 if one of the times is missing. */
double line_ratio(const line *l, int d);
/* Is the peak memory of fmb at most 50 times that of the system plus 50 MB? */
bool line_is_lean(const line *l);

#endif
