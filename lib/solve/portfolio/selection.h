/* selection.h: which engines project a part, and with which budgets, decided by features of it.
 *
 * The features are counts of rows, variables and coefficients, never times, so the same system is
 * solved the same way everywhere. Linear weights and decision trees over the features, fitted to
 * times on families of systems (bench/study/selection, `ninja fit-selection`), estimate how much
 * work each engine takes, and whether bounded elimination pays.
 */
#ifndef FMB_SOLVE_SELECTION_H
#define FMB_SOLVE_SELECTION_H

#include "solve/prepare/features.h"

/* Engines that can be interrupted and continued; they take turns (slices.h). */
enum { FMB_ENGINE_RAYS, FMB_ENGINE_ELIMINATION, FMB_ENGINE_QUERIES, FMB_ENGINES };

typedef struct fmb_choice {
    bool verdict;             /* ask the oracle first whether there is a solution */
    bool recession;           /* search for a recession direction first (prepare/recession.h) */
    uint64_t bounded;         /* then eliminate variables that add few rows, within this much work
                                 (trace/run.h); 0: do not */
    double work[FMB_ENGINES]; /* expected work of each engine; INFINITY: the engine is not used */
} fmb_choice;

/* The choice for a part with these features. */
fmb_choice fmb_selection_of(const fmb_features *f);

#ifdef FMB_ABLATE
/* Studies force this choice; NULL: the trees decide. */
extern const fmb_choice *fmb_selection_forced;
#endif
/* Are the live rows after a bounded elimination few enough to keep? There were `before` of them. */
bool fmb_selection_keeps_rows(const fmb_elim *e, size_t before, int kept);

#endif
