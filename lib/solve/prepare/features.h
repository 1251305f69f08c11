/* features.h: what a part looks like once what is cheap has been eliminated: by that, and nothing
 * else, the ways of a projection are chosen (selection.h). No clock is asked, so that the same
 * system takes the same way everywhere.
 */
#ifndef FMB_SOLVE_FEATURES_H
#define FMB_SOLVE_FEATURES_H

#include "solve/prepare/reduced_part.h"

typedef struct fmb_features {
    /* The part as it came. */
    int kept;       /* variables that stay */
    int variables;  /* all of them */
    size_t given;   /* rows */
    bool is_strict; /* some rows are strict */
    bool is_wide;   /* some numbers are longer than a word */
    /* What is left of it. */
    size_t columns, rows; /* variables and rows */
    size_t entries;       /* coefficients */
    size_t bounds;        /* rows with one coefficient */
    size_t freedom;    /* the least of dimensions and of rows beyond as many, of the cone: up to 10
                          or so it has few rays */
    size_t minor_bits; /* about as long is a minor of all columns, if rows are like the mean of
                          them [bits] */
    bool is_long;      /* some numbers are longer than a word, or so long in all rows that those of
                          combinations will be */
    bool has_origin;   /* all variables at 0 are a solution */
} fmb_features;

/* What the choice asks about: identifier, name in data and reports, and the number as a double. */
#define FMB_FEATURE_VALUES(F)                                                                      \
    F(KEPT, "variables that stay", f->kept)                                                        \
    F(TO_GO, "variables to go", (double)f->columns - f->kept)                                      \
    F(COLUMNS, "variables", f->columns)                                                            \
    F(ROWS, "rows", f->rows)                                                                       \
    F(ENTRIES, "coefficients", f->entries)                                                         \
    F(ROWS_BY_COLUMN, "rows a variable", (double)f->rows / (double)f->columns)                     \
    F(ENTRIES_BY_ROW, "coefficients a row", (double)f->entries / (double)f->rows)                  \
    F(DENSITY, "density", (double)f->entries / ((double)f->rows * (double)f->columns))             \
    F(BOUNDS, "share of bounds", (double)f->bounds / (double)f->rows)                              \
    F(FREEDOM, "freedom of the cone", f->freedom)                                                  \
    F(MINOR_BITS, "bits of a minor", f->minor_bits)                                                \
    F(LONG, "long numbers", f->is_long)                                                            \
    F(STRICT, "strict rows", f->is_strict)                                                         \
    F(ORIGIN, "0 is a solution", f->has_origin)

#define FMB_FEATURE_IDENTIFIER(id, name, value) FMB_FEATURE_##id,
typedef enum fmb_feature_id {
    FMB_FEATURE_VALUES(FMB_FEATURE_IDENTIFIER) FMB_FEATURE_COUNT
} fmb_feature_id;
#undef FMB_FEATURE_IDENTIFIER

/* Looks at each coefficient once. What follows holds while the reduced part stays as it is. */
fmb_features fmb_features_of(const fmb_reduced_part *reduced);
double fmb_features_value(const fmb_features *f, fmb_feature_id which);
const char *fmb_features_name(fmb_feature_id which);

#ifdef FMB_ABLATE
/* Who studies the choice (bench/study/selection) hears of each part before a way is chosen. */
typedef struct fmb_features_watcher {
    void (*hear)(void *self, const fmb_features *, const fmb_reduced_part *);
    void *self;
} fmb_features_watcher;

extern fmb_features_watcher fmb_features_watch;
#endif

#endif
