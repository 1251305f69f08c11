/* draw.h: random pairs of frames, as systems.
 *
 * A class holds the properties that all pairs of one line of a table share. Random numbers are
 * GSL's mt19937, seeded from the seed of the study and the class alone, so that a class is the same
 * whatever else is studied. Source of the setting: Baillehache 2020.
 */
#ifndef FMB_STUDY_DRAW_H
#define FMB_STUDY_DRAW_H

#include <gsl/gsl_rng.h>

#include <fmb/frame.h>

typedef enum study_family {
    STUDY_SMALL = 0, /* axes and origins -3 ... 3, speeds -1, 0, 1: whole numbers */
    STUDY_FLOAT      /* doubles, each evenly from -10 to 10, as in the article */
} study_family;

typedef struct study_class {
    study_family family;
    int dim;
    bool moves;
    fmb_shape shape[2];
    bool meets; /* by the exact answer */
} study_class;

/* "small", "float"; false if the word is unknown. */
const char *study_family_text(study_family family);
bool study_family_parse(const char *word, study_family *out);

/* [give, gsl_rng_free] NULL without memory. */
gsl_rng *study_draw_begin(const study_class *c, unsigned long seed);

/* [give] The system of one pair, A's rows in B's coordinates first (FMB_COORDINATES_LAST). The axes
 * of both are independent; c->meets is ignored. Errors: MEMORY. */
fmb_status study_draw_pair(gsl_rng *g, const study_class *c, fmb_system **out);

#endif
