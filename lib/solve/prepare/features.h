/* features.h: features of a part after its cheap eliminations. They alone decide which engines
 * project it (selection.h); they depend on no clock, so the same system is solved the same way
 * everywhere.
 */
#ifndef FMB_SOLVE_FEATURES_H
#define FMB_SOLVE_FEATURES_H

#include "solve/prepare/reduced_part.h"

typedef struct fmb_features {
    /* The part before any elimination. */
    int kept;      /* kept variables */
    int variables; /* all of them */
    bool is_wide;  /* some numbers are longer than a word */
    /* The part after the cheap eliminations. */
    size_t columns, rows; /* variables and rows */
    size_t entries;       /* coefficients */
    size_t equalities;    /* rows */
    size_t bounds;        /* rows with one coefficient */
    size_t kept_rows;     /* rows over kept variables only */
    size_t dropped_rows;  /* rows over variables to eliminate only */
    size_t homogeneous;   /* rows with right side 0 */
    size_t most_pairs;    /* pairs of opposite signs in a variable to eliminate, the maximum */
    size_t least_growth;  /* pairs formed less rows removed, the minimum over these variables */
    size_t minor_bits;    /* estimated length of a minor of all columns (fmb_elim_minor_bits) */
    bool has_origin;      /* all variables at 0 are a solution */
} fmb_features;

/* part / whole, 0 where whole is 0. */
static inline double fmb_features_share(size_t part, size_t whole)
{
    return whole > 0 ? (double)part / (double)whole : 0;
}

static inline size_t fmb_features_least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* The features that the choice uses: identifier, name in data and reports, value. */
#define FMB_FEATURE_VALUES(F)                                                                      \
    F(KEPT, "variables that stay", f->kept)                                                        \
    F(VARIABLES, "variables given", f->variables)                                                  \
    F(COLUMNS, "variables", f->columns)                                                            \
    F(ROWS, "rows", f->rows)                                                                       \
    F(ROWS_BY_COLUMN, "rows a variable", fmb_features_share(f->rows, f->columns))                  \
    F(ENTRIES_BY_ROW, "coefficients a row", fmb_features_share(f->entries, f->rows))               \
    F(DENSITY, "density", fmb_features_share(f->entries, f->rows * f->columns))                    \
    F(KEPT_ROWS, "share of rows that only stay", fmb_features_share(f->kept_rows, f->rows))        \
    F(DROPPED_ROWS, "share of rows that only go", fmb_features_share(f->dropped_rows, f->rows))    \
    F(EQUALITIES, "share of equalities", fmb_features_share(f->equalities, f->rows))               \
    F(BOUNDS, "share of bounds", fmb_features_share(f->bounds, f->rows))                           \
    F(HOMOGENEOUS, "share of rows through 0", fmb_features_share(f->homogeneous, f->rows))         \
    F(MOST_PAIRS, "pairs of a variable", f->most_pairs)                                            \
    F(LEAST_GROWTH, "rows more by a variable", f->least_growth)                                    \
    F(MINOR_BITS, "bits of a minor", f->minor_bits)                                                \
    F(DROPPED, "variables that go", f->columns - fmb_features_least((size_t)f->kept, f->columns))  \
    F(SPARE_ROWS, "rows beyond variables", f->rows - fmb_features_least(f->rows, f->columns))      \
    F(EQUALITY_COUNT, "equalities", f->equalities)                                                 \
    F(ENTRY_BITS, "bits of an entry", fmb_features_share(f->minor_bits, f->columns))               \
    F(OPEN_ROWS, "rows that do not only stay", f->rows - f->kept_rows)                             \
    F(WIDE, "wide numbers", f->is_wide)                                                            \
    F(ORIGIN, "0 is a solution", f->has_origin)

#define FMB_FEATURE_IDENTIFIER(id, name, value) FMB_FEATURE_##id,
typedef enum fmb_feature_id {
    FMB_FEATURE_VALUES(FMB_FEATURE_IDENTIFIER) FMB_FEATURE_COUNT
} fmb_feature_id;
#undef FMB_FEATURE_IDENTIFIER

/* Reads each coefficient twice. The result is valid while the reduced part does not change. */
fmb_features fmb_features_of(const fmb_reduced_part *reduced);
double fmb_features_value(const fmb_features *f, fmb_feature_id which);
const char *fmb_features_name(fmb_feature_id which);

#ifdef FMB_ABLATE
/* Studies of the choice (bench/study/selection) are notified of each part before the choice. */
typedef struct fmb_features_watcher {
    void (*hear)(void *self, const fmb_features *, const fmb_reduced_part *);
    void *self;
} fmb_features_watcher;

extern fmb_features_watcher fmb_features_watch;
#endif

#endif
