/* selection.h: which ways of a projection are tried, and for how long, by what a part is like.
 *
 * Nothing is measured but numbers of rows, variables and coefficients, so that the same system
 * takes the same way everywhere. The limits below were found on families of systems
 * (study/program), and hold on seeds that they were not found on.
 */
#ifndef FMB_SOLVE_SELECTION_H
#define FMB_SOLVE_SELECTION_H

#include "solve/portfolio/features.h"

/* A few rows are eliminated faster than anything else is done. */
#define FMB_TRIAL_BUDGET(m) (128 + 4 * (m))
/* In so many, queries are few, and rays soon turned into facets. */
#define FMB_SHORT_QUERIES 4

/* In more dimensions than a few, so many pairs of facets of a hull take as long as a few queries.
 */
#define FMB_FIRST_PAIRS ((uint64_t)1 << 17)

/* What a step of a pipeline does, and what its budget counts. */
typedef enum fmb_step_kind {
    FMB_STEP_NONE,
    FMB_STEP_SOLUTION,    /* asks the oracle whether there is a solution */
    FMB_STEP_RECESSION,   /* looks for a direction that leaves all rows behind */
    FMB_STEP_BOUNDED,     /* eliminates what makes few more rows than go: trials */
    FMB_STEP_GROWING,     /* eliminates what makes more of them: trials */
    FMB_STEP_PRUNED,      /* eliminates and asks the oracle which rows are redundant: rows */
    FMB_STEP_FIRST_RAYS,  /* double description: rays */
    FMB_STEP_SECOND_RAYS, /* goes on with it: rays */
    FMB_STEP_QUERIES,     /* support queries: pairs of facets, if many variables stay */
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
/* Are the rows that an elimination left few enough to go on with? There were so many before. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept);

#endif
