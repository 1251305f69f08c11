/* scaling.h: what the study of dimensions measures; scaling.c reports it. */
#ifndef QUALIFY_SCALING_H
#define QUALIFY_SCALING_H

#include "fmb-qualify/study.h"
#include "study/clock/clock.h"
#include "study/draw/pairs.h"

enum { SCALING_LEAST_DIM = 2, SCALING_MOST_DIM = 8 };

typedef struct scaling_class {
    int dim;
    bool moves;
    fmb_shape shape[2];
} scaling_class;

/* The results of one class. NaN: not measured. */
typedef struct scaling_cell {
    scaling_class class;
    bool complete;           /* nothing was interrupted */
    size_t pairs, meeting;   /* asked; FEASIBLE */
    size_t checked, wrong;   /* verdicts against the oracle */
    size_t boxes, bad_boxes; /* boxes against the exact ones */
    double exact_share;      /* of the verdicts, decided exactly */
    double rows;             /* made by exact elimination, mean over some of the pairs */
    study_spread ns;         /* of a verdict, over the passes */
    /* The linear program on some of the pairs, and our verdicts on the same pairs. */
    study_spread lp_ns, beside_lp_ns;
    study_ratio over_lp;
    size_t lp_pairs, lp_wrong;
} scaling_cell;

/* An exit code, after a message unless it is APP_YES. */
int scaling_measure(const scaling_class *c, const qualify_setup *o, size_t pairs,
                    scaling_cell *out);

/* ---- a linear program in doubles ------------------------------------------------------------- */

typedef struct scaling_lp scaling_lp;

/* "GLPK 5.0", or NULL if there is none in this program. */
const char *scaling_lp_name(void);
/* [give, scaling_lp_close] The programs of n pairs, with verdict[n] to be written; NULL if there is
 * none. */
scaling_lp *scaling_lp_open(size_t n, const fmb_frame *p, const fmb_frame *q, fmb_verdict *verdict);
void scaling_lp_close(scaling_lp *lp);
/* Solve programs first ... first + n - 1 from the start; fits study_timed. */
fmb_status scaling_lp_run(void *self, size_t first, size_t n);

#endif
