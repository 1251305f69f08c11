/* rule.h: the door between elimination and its pruning rules.
 *
 * A rule is a const table: it may refuse a pair of rows before they are combined (drop_pair), or
 * mark live rows to be dropped after a round (end_round). It sees the rows through a window and
 * changes nothing itself.
 *
 * Soundness. A rule *of histories* argues with the set of base rows that a row was combined from;
 * its argument needs that every combination not refused by such a rule is present. A rule that
 * drops rows for another reason breaks that, so after it the engine re-bases: each live row becomes
 * its own history, and counting starts anew. The flags say which kind a rule is; obeying them is
 * the engine's duty, never the caller's.
 */
#ifndef FMB_RULE_RULE_H
#define FMB_RULE_RULE_H

#include "num/vec.h"

enum {
    FMB_RULE_NEEDS_HISTORY = 1, /* reads histories */
    FMB_RULE_BREAKS_HISTORY = 2 /* drops rows for reasons other than histories: re-base after it */
};

/* One live row. */
typedef struct fmb_live {
    const fmb_vec *v;        /* [n + 1]: coefficients, right side; primitive integers */
    const uint64_t *history; /* [words], or NULL before the first combination */
    bool strict, equality;
} fmb_live;

/* The window. */
typedef struct fmb_view {
    int n;          /* variables */
    int eliminated; /* since the last re-base, the variable of this round included */
    size_t words;   /* of a history */
    size_t rows;    /* live rows; 0 in drop_pair */
    const fmb_live *row;
} fmb_view;

typedef struct fmb_rule {
    const char *name;   /* the word users type */
    const char *source; /* key in docs/references.bib */
    unsigned flags;
    /* May the combination of two rows with these histories be left out? */
    bool (*drop_pair)(const fmb_view *w, const uint64_t *a, const uint64_t *b);
    /* Mark rows that may go; drop[rows] comes in all false; *marked counts the marks. */
    fmb_status (*end_round)(void *state, const fmb_view *w, fmb_mem *mem, bool *drop,
                            size_t *marked);
    void *state; /* handed to end_round */
} fmb_rule;

extern const fmb_rule fmb_rule_kohler, fmb_rule_duplicate;

/* The built-in rule of that name (size bytes), or NULL; and the i-th one, NULL past the end. */
const fmb_rule *fmb_rule_find(const char *name, size_t size);
const fmb_rule *fmb_rule_at(size_t i);

#endif
