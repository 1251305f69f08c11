/* report.h: the table, the summary and the JSON of a comparison. */
#ifndef FMB_PEERS_REPORT_H
#define FMB_PEERS_REPORT_H

#include "child.h"

enum { REPORT_DRIVERS = 16 };

/* The results of one problem. */
typedef struct entry {
    problem problem; /* its rows are freed */
    child_outcome outcome[REPORT_DRIVERS];
    int best;                    /* driver of the fastest peer that finished, -1 if none did */
    double ratio;                /* its time over fmb's, or fmb's limit; 0: no peer */
    bool unlike[REPORT_DRIVERS]; /* answers that differ from the first exact driver's */
    bool wrong;                  /* an exact driver's answer is unlike */
    bool silent;                 /* a driver that can express the question has no answer */
} entry;

typedef struct report {
    const peer *driver[REPORT_DRIVERS];
    int drivers;
    child_limits limits;
    entry *list;
    size_t entries;
} report;

/* Fills best, ratio, unlike and wrong of e from its outcomes. */
void report_judge(const report *r, entry *e);
void report_head(const report *r);
void report_line(const report *r, const entry *e);
/* Per family and in all. */
void report_summary(const report *r);
bool report_json(const report *r, const char *path);

#endif
