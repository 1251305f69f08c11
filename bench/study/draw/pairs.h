/* pairs.h: random pairs of frames as numbers. Pair k depends on the plan, the seed and k alone, so
 * each share of a study can run on its own machine.
 *
 * Source of the setting: Baillehache 2020 (family article).
 */
#ifndef FMB_STUDY_PAIRS_H
#define FMB_STUDY_PAIRS_H

#include <fmb/pair.h>

enum { STUDY_PAIR_MOST_DIM = 16 };

typedef enum study_pair_family {
    STUDY_PAIR_ARTICLE = 0, /* origin, axes, speed evenly in -100 ... 100, |det| > 0.1 */
    STUDY_PAIR_LATTICE,     /* whole numbers -2 ... 2, singular ones too */
    STUDY_PAIR_TOUCHING,    /* made to touch in exactly one face, edge or corner */
    STUDY_PAIR_NEAR,        /* made to touch, then 1e-6 ... 1e-15 off, either way */
    STUDY_PAIR_FLAT,        /* one axis 1e-6 or 1e-8 long */
    STUDY_PAIR_DEGENERATE,  /* dependent or zero axes; both in one plane */
    STUDY_PAIR_TINY_A,      /* A scaled by 1e-9 (or 1e9: B is the tiny one) around a point of B */
    STUDY_PAIR_TINY_B,
    STUDY_PAIR_FAR,      /* both 1e9 from the origin */
    STUDY_PAIR_DENORMAL, /* numbers around the least double */
    STUDY_PAIR_SWEPT,    /* fast: they meet, if at all, for a short time in between */
    STUDY_PAIR_INTEGER,  /* whole numbers -100 ... 100 */
    STUDY_PAIR_SCALED,   /* article, touching or near, all times one power of 2: any double */
    STUDY_PAIR_SPREAD,   /* the same, each coordinate times its own power of 2: 2^-900 ... 2^900 */
    STUDY_PAIR_RAGGED,   /* the same, every other number times its own power of 2: 1 ... 2^-1080 */
    STUDY_PAIR_UNEVEN, /* touching or near, axes times powers of 2 of their own: needles, blades */
    STUDY_PAIR_FAMILIES
} study_pair_family;

enum { STUDY_PAIR_ANY_SHAPE = -1 };

typedef struct study_pair_plan {
    study_pair_family family;
    int dim; /* 1 ... STUDY_PAIR_MOST_DIM */
    bool moves;
    int shape[2]; /* fmb_shape of A, of B, or STUDY_PAIR_ANY_SHAPE: each as likely */
    int naxes[2]; /* of A, of B; 0 means dim */
} study_pair_plan;

/* One pair; the frames point into number. Must not be copied. */
typedef struct study_pair {
    fmb_frame p, q;
    double number[2][STUDY_PAIR_MOST_DIM * (STUDY_PAIR_MOST_DIM + 2)];
} study_pair;

/* "article", ...; false if the word is unknown. */
const char *study_pair_family_text(study_pair_family family);
bool study_pair_family_parse(const char *word, study_pair_family *out);

void study_pair_draw(const study_pair_plan *plan, uint64_t seed, uint64_t k, study_pair *out);

/* Many pairs of one plan, side by side in memory; all, or those that a filter keeps. */
typedef struct study_pairs {
    size_t n;
    fmb_frame *p, *q; /* [n] */
    double *number;
    uint64_t drawn; /* pairs tested to find n of them */
} study_pairs;

/* [give, study_pairs_free] The first n pairs for which keep(self, p, q) is true (NULL: all of
 * them). Errors: MEMORY. */
fmb_status study_pairs_make(const study_pair_plan *plan, uint64_t seed, size_t n,
                            bool (*keep)(void *self, const fmb_frame *p, const fmb_frame *q),
                            void *self, study_pairs *out);
/* [give, study_pairs_free] Room for n pairs of a plan, to be filled again and again. Errors:
 * MEMORY. */
fmb_status study_pairs_room(const study_pair_plan *plan, size_t n, study_pairs *out);
/* Overwrite *out with pairs first ... first + n - 1; n is at most that of study_pairs_room. */
void study_pairs_fill(const study_pair_plan *plan, uint64_t seed, uint64_t first, size_t n,
                      study_pairs *out);
void study_pairs_free(study_pairs *s);

#endif
