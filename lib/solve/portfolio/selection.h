/* selection.h: which ways of a projection are tried, and for how long, by what a part is like.
 *
 * Nothing is measured but numbers of rows, variables and coefficients, so that the same system
 * takes the same way everywhere. Trees of questions about features, which are fitted to times on
 * families of systems (bench/study/selection, `ninja fit-selection`), add up to the logarithm of
 * the time of each pipeline over that of the best; the least one is taken.
 */
#ifndef FMB_SOLVE_SELECTION_H
#define FMB_SOLVE_SELECTION_H

#include "solve/prepare/features.h"

/* A few rows are eliminated faster than anything else is done. */
#define FMB_TRIAL_BUDGET(m) (128 + 4 * (m))

/* What a step of a pipeline does, and what its budget counts: work (trace/run.h) of engines that go
 * on where they stopped, whether with a later step or in turns (slices.h). */
typedef enum fmb_step_kind {
    FMB_STEP_NONE,
    FMB_STEP_RECESSION, /* looks for a direction that leaves all rows behind */
    FMB_STEP_BOUNDED,   /* eliminates what makes few more rows than go: trials */
    FMB_STEP_PRUNED,    /* eliminates and asks the oracle which rows are redundant: work */
    FMB_STEP_RAYS,      /* double description: work */
    FMB_STEP_QUERIES,   /* support queries: work */
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

/* Pipelines that the table knows by name. NULL: there are not so many. */
const char *fmb_selection_name(int pipeline);
/* What speaks against each of them, in parts of 1 / FMB_SELECTION_PARTS: the one that the least
 * speaks against is taken. */
#define FMB_MOST_PIPELINES  8
#define FMB_SELECTION_PARTS 32
void fmb_selection_score(const fmb_features *f, int *score);
int fmb_selection_best(const fmb_features *f);

#ifdef FMB_ABLATE
/* Who studies the choice takes this pipeline instead; negative: as the table tells. */
extern int fmb_selection_forced;
#endif
/* Are the rows that an elimination left few enough to go on with? There were so many before. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept);

#endif
