/* selection.h: which ways of a projection are tried, and for how long, by what a part is like.
 *
 * Nothing is measured but numbers of rows, variables and coefficients, so that the same system
 * takes the same way everywhere. A table that is fitted to times on families of systems
 * (bench/study/selection, `ninja fit-selection`) tells which pipeline is taken, or that rules do,
 * for shapes of systems: where numbers are short, these choose better than any fit did on families
 * that it had not seen.
 */
#ifndef FMB_SOLVE_SELECTION_H
#define FMB_SOLVE_SELECTION_H

#include "solve/prepare/features.h"

/* A few rows are eliminated faster than anything else is done. */
#define FMB_TRIAL_BUDGET(m) (128 + 4 * (m))
/* In so many, queries are few, and rays soon turned into facets. */
#define FMB_SHORT_QUERIES 4

/* What a step of a pipeline does, and what its budget counts: work (trace/run.h) of engines that go
 * on where they stopped, whether with a later step or in turns (slices.h). */
typedef enum fmb_step_kind {
    FMB_STEP_NONE,
    FMB_STEP_RECESSION,   /* looks for a direction that leaves all rows behind */
    FMB_STEP_BOUNDED,     /* eliminates what makes few more rows than go: trials */
    FMB_STEP_PRUNED,      /* eliminates and asks the oracle which rows are redundant: work */
    FMB_STEP_FIRST_RAYS,  /* double description: work */
    FMB_STEP_SECOND_RAYS, /* goes on with it: work */
    FMB_STEP_QUERIES,     /* support queries: work */
    FMB_STEPS
} fmb_step_kind;

typedef struct fmb_pipeline_step {
    fmb_step_kind kind;
    uint64_t budget;
} fmb_pipeline_step;

enum { FMB_MOST_STEPS = 8 };

/* Ways of a projection, one after the other until one of them answers. */
typedef struct fmb_pipeline {
    fmb_pipeline_step step[FMB_MOST_STEPS]; /* up to the first FMB_STEP_NONE */
} fmb_pipeline;

/* The pipeline for a part like that. */
fmb_pipeline fmb_selection_pipeline(const fmb_features *f);

/* Pipelines that the table knows by name. The first one is what rules for shapes of systems put
 * together. NULL: there are not so many. */
const char *fmb_selection_name(int pipeline);

/* A line of the table: a question, is the feature at most that? If so, the next line tells; else
 * the line `otherwise`. Or an answer, where asks is FMB_FEATURE_COUNT. */
typedef struct fmb_selection_line {
    fmb_feature_id asks;
    double most;
    int otherwise;
    int pipeline;
} fmb_selection_line;

/* It begins with line 0. */
const fmb_selection_line *fmb_selection_line_at(int index);

#ifdef FMB_ABLATE
/* Who studies the choice takes this pipeline instead; negative: as the table tells. */
extern int fmb_selection_forced;
#endif
/* Are the rows that an elimination left few enough to go on with? There were so many before. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept);

#endif
