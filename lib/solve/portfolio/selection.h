/* selection.h: which ways of a projection are tried, and for how long, by what a part is like.
 *
 * Nothing is measured but numbers of rows, variables and coefficients, so that the same system
 * takes the same way everywhere. Weights of features and trees of questions about them, which are
 * fitted to times on families of systems (bench/study/selection, `ninja fit-selection`), tell how
 * much work each engine takes, and whether bounded elimination pays.
 */
#ifndef FMB_SOLVE_SELECTION_H
#define FMB_SOLVE_SELECTION_H

#include "solve/prepare/features.h"

/* Engines that go on where they stopped, and take turns (slices.h). */
enum { FMB_ENGINE_RAYS, FMB_ENGINE_ELIMINATION, FMB_ENGINE_QUERIES, FMB_ENGINES };

typedef struct fmb_choice {
    bool recession;           /* first a direction is looked for that leaves all rows behind; */
    uint64_t bounded;         /* then what makes few more rows than go is eliminated, for so much
                                 work (trace/run.h); 0: it is not */
    double work[FMB_ENGINES]; /* that each engine is expected to take; INFINITY: it is not asked */
} fmb_choice;

/* For a part like that. */
fmb_choice fmb_selection_of(const fmb_features *f);

#ifdef FMB_ABLATE
/* Who studies the choice takes this one instead; NULL: as the trees tell. */
extern const fmb_choice *fmb_selection_forced;
#endif
/* Are the rows that an elimination left few enough to go on with? There were so many before. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept);

#endif
