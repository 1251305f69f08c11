/* line.h: one question about one system, asked of all drivers, round by round. */
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
    child_outcome outcome[LINE_DRIVERS]; /* typical: the median over the rounds; texts, numbers gone
                                          */
    bool differs[LINE_DRIVERS];          /* from fmb's answer */
    fmb_verdict verdict;                 /* fmb's */
    line_fault fault;
    size_t peak; /* of fmb with evidence [bytes] */
} line;

void line_measure(line *l, const subject *s, subject_dress dress, const line_plan *plan);
/* How many times the time of driver d fmb took; 0 if one of them has none. */
double line_ratio(const line *l, int d);
/* May it take that much memory? 50 times its system and 50 MB. */
bool line_is_lean(const line *l);

#endif
