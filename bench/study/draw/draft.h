/* draft.h: a pair of frames under construction; for the families.
 *
 * Random numbers come through GSL's interface from splitmix64 (Steele, Lea and Flood 2014): a state
 * of one word, so that starting a stream for each pair costs nothing.
 */
#ifndef FMB_STUDY_DRAFT_H
#define FMB_STUDY_DRAFT_H

#include <gsl/gsl_rng.h>

#include "study/draw/pairs.h"

extern const gsl_rng_type study_splitmix;

typedef struct study_draft {
    gsl_rng *g;
    int dim;
    bool moves;
    int still; /* which frame has no speed; -1: none */
    fmb_shape shape[2];
    int naxes[2];
    double *origin[2], *axes[2], *speed[2]; /* [dim], [naxes][dim], [dim] */
    double factor[2][STUDY_PAIR_MOST_DIM];  /* of the length of each axis of a touching frame */
    double haste;                           /* the same for its speed */
} study_draft;

static inline bool study_coin(study_draft *d)
{
    return gsl_rng_uniform(d->g) < 0.5;
}

/* An integer 0 ... n - 1. */
static inline int study_choice(study_draft *d, int n)
{
    return (int)gsl_rng_uniform_int(d->g, (unsigned long)n);
}

/* n numbers, uniform in -most ... most: reals, or integers. */
void study_draw_even(study_draft *d, double most, double *out, int n);
void study_draw_whole(study_draft *d, int most, double *out, int n);

static inline double study_dot(const double *x, const double *y, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* c: coordinates of a random point of frame f; of a random point of its boundary. */
void study_draw_inside(study_draft *d, int f, double *c);
void study_draw_boundary(study_draft *d, int f, double *c);

/* Move B so that at time t its point with coordinates cq is A's point with coordinates cp plus
 * `off`. */
void study_place(study_draft *d, const double *cp, const double *cq, double t, const double *off);

/* Draw two frames that touch: exactly, in whole numbers of at most about 2^30 and sixteenths of
 * them; or, if not whole, up to rounding. normal: of length 1, of a plane between them, from A's
 * side to B's. Axes and speed are multiplied by factor and haste: powers of 2 keep things exact as
 * long as the numbers have room. */
void study_draw_touching(study_draft *d, bool whole, double *normal);

/* Draws all numbers of a pair of a family; its shapes are chosen already. */
typedef void study_family_draw(study_draft *d);
extern study_family_draw *const study_family_draws[STUDY_PAIR_FAMILIES];

#endif
