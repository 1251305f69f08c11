/* report.h: the results of a study of rules, in several forms. All take the plan after the run. */
#ifndef QUALIFY_REPORT_H
#define QUALIFY_REPORT_H

#include "fmb-qualify/page.h"
#include "fmb-qualify/rules/plan.h"
#include "study/grid/digest.h"

enum { ANY = -1, FILES = 0 };

/* Which systems: -1 is any; dim 0 means files. */
typedef struct qualify_select {
    int dim, moves, kind, meets; /* kind: 2 * shape of A + shape of B */
    const char *file;            /* this file alone, or NULL */
} qualify_select;

/* The digest of way number way (against `none` in the same order) over those systems. If a
 * selection has meeting and disjoint pairs, only the rows of meeting pairs are counted: on disjoint
 * pairs the elimination ends early. */
study_digest qualify_digest(const qualify_plan *p, size_t way, const qualify_select *which);
/* The selections of a report, finest first counting: every class and file on its own (detail), or
 * every dimension and motion, and all files together. Calls use for each. */
void qualify_each(const qualify_plan *p, bool detail, void *self,
                  void (*use)(void *self, const qualify_plan *p, const qualify_select *which));
/* [give, free()] "D3 static CC meeting", "D3 static", "files". */
char *qualify_select_text(const qualify_select *which);

/* Each adds its part to the page; the numbers must come first. */
void qualify_numbers(const qualify_plan *p, qualify_page *page);
void qualify_tables(const qualify_plan *p, qualify_page *page);
/* From which D on each set saves rows and time; the claims of the article. */
void qualify_claims(const qualify_plan *p, qualify_page *page);
/* The first wrong answer, if any, and a minimal system that shows it; also as wrong.fmb. */
void qualify_show_wrong(const qualify_plan *p, qualify_page *page);
/* runs.csv: a line for each run. */
void qualify_runs_csv(const qualify_plan *p, qualify_page *page);

#endif
