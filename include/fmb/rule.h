/* fmb/rule.h: pruning rules, built in or your own, and choosers of the next variable.
 *
 * A rule is a const table. It may refuse pairs of rows before they are combined (drop_pairs),
 * refuse a row just made (drop_row), or drop rows at the end of a round (end_round). It reads the
 * rows through a view and changes nothing itself; your rules are treated like the built-in ones.
 * docs/adding-a-rule.md writes one from scratch.
 *
 * Soundness. A rule *of histories* argues with the set of base rows that a row was combined from;
 * its argument needs that every combination not refused by such a rule is present. A rule that
 * drops rows for another reason breaks that, so after it the engine re-bases: each live row becomes
 * its own history, and counting starts anew; multipliers over the rows of the system survive. The
 * flags say which kind a rule is; obeying them is the engine's duty, never the caller's. Rules are
 * trusted until the evidence is checked: a rule that drops too much makes answers too large, and
 * then fmb_check rejects the point in their evidence.
 */
#ifndef FMB_RULE_H
#define FMB_RULE_H

#include <fmb/base.h>
#include <fmb/solve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A round in progress: the live rows over columns 0 <= col < fmb_view_dim. A row has a name, a
 * number that stays the same for the whole elimination; its entries are integers, a.x REL b. The
 * results of a view are valid until the callback returns. For NULL they are 0, NULL, -1 for a
 * variable or column, and true for fmb_view_stop and fmb_view_minimal; the text is "0". */
typedef struct fmb_view fmb_view;

/* Properties of a rule. */
typedef enum fmb_rule_flag {
    FMB_RULE_NEEDS_HISTORY = 1,  /* reads histories */
    FMB_RULE_BREAKS_HISTORY = 2, /* drops rows for reasons other than histories: re-base after it */
    FMB_RULE_VERDICT_ONLY = 4,   /* keeps feasibility but not the projection: for fmb_solve only */
    FMB_RULE_ONE_BASE = 8        /* allows no re-base: refused beside rules that need one */
} fmb_rule_flag;

/* Any callback may be NULL. state is fresh scratch of state_bytes zero bytes for each elimination
 * (NULL if 0); clear, unless NULL, releases what it points to. */
typedef struct fmb_rule {
    const char *name;   /* the word users type: no commas or blanks */
    const char *source; /* its reference; for built-in rules: a key in docs/references.bib */
    unsigned flags;     /* of fmb_rule_flag */
    size_t state_bytes;
    /* Which combinations of lower row number i (fmb_view_lower) with upper rows may be left out?
     * Set bit j for upper row number j; bits already set are pairs refused before. */
    void (*drop_pairs)(void *state, const fmb_view *w, size_t i, uint64_t *drop);
    /* May the row just made be left out? Rules that do not need histories are called for the base
     * rows, too, when histories start. */
    bool (*drop_row)(void *state, const fmb_view *w, size_t row);
    /* Mark live rows that may be dropped: drop[i] is for fmb_view_row(w, i), initially false; rows
     * are then without common divisors. Beside rules of histories and with FMB_REBASE_AUTO, a rule
     * that breaks them is not called for few rows, and few marks are ignored. Errors: any. */
    fmb_status (*end_round)(void *state, const fmb_view *w, bool *drop);
    void (*clear)(void *state);
} fmb_rule;

/* A shared object that is given to the commands as --rule-library exports this: its rules, ended by
 * NULL. Their names must differ from built-in ones. This library does not define it. */
extern FMB_API const fmb_rule *const fmb_rule_library[];

/* The built-in rule of that name, static, or NULL; and the i-th one, NULL past the end. */
FMB_API const fmb_rule *fmb_rule_find(const char *name);
FMB_API const fmb_rule *fmb_rule_at(size_t i);

/* Use one more rule in the queries of this solver, after those in options.rules. The table is
 * borrowed for the solver's life. Errors: ARG (no name), RULE (a rule of that name is in use, or
 * too many are): fmb_solver_trouble says which. Each query checks whether rules are compatible with
 * each other and with the query: if not, it returns FMB_ERR_RULE, and fmb_solver_trouble names
 * them. */
FMB_API FMB_CHECKED fmb_status fmb_solver_add_rule(fmb_solver *v, const fmb_rule *rule);

/* Choose the column to eliminate next: one of col[0..n), n > 0. Anything else ends the query with
 * FMB_ERR_ARG. Beside a rule with FMB_RULE_ONE_BASE only columns of equalities are offered while
 * there are any: substituting one later would be a re-base. */
typedef struct fmb_chooser {
    int (*choose)(void *self, const fmb_view *w, const int *col, size_t n);
    void *self;
} fmb_chooser;

/* Use a chooser instead of options.order; {NULL, NULL}: options.order again. */
FMB_API void fmb_solver_set_chooser(fmb_solver *v, fmb_chooser chooser);

/* An order that users type as a word: letters, digits, - and _, at most 31 of them. */
typedef struct fmb_named_chooser {
    const char *name;
    const char *source; /* its reference */
    fmb_chooser chooser;
} fmb_named_chooser;

/* A shared object may export this beside its rules, or instead: its orders, ended by NULL. Their
 * names must differ from those of options.order. This library does not define it. */
extern FMB_API const fmb_named_chooser *const fmb_chooser_library[];

/* ---- the window ------------------------------------------------------------------------------ */

FMB_API int fmb_view_dim(const fmb_view *w); /* columns */
/* The rule being called, the very table that was added: it may be the first member of a structure
 * with data of the rule. NULL: a chooser is being called. */
FMB_API const fmb_rule *fmb_view_rule(const fmb_view *w);
/* The system's variable of a column; -1: the form of fmb_optimize, which is never eliminated. */
FMB_API int fmb_view_variable(const fmb_view *w, int col);
FMB_API int fmb_view_column(const fmb_view *w);           /* of this round; -1: between rounds */
FMB_API size_t fmb_view_rows(const fmb_view *w);          /* live rows */
FMB_API size_t fmb_view_row(const fmb_view *w, size_t i); /* the name of the i-th */
/* Variables eliminated by pairing since the last re-base, that of this round included. */
FMB_API int fmb_view_eliminated(const fmb_view *w);

/* The rows to be paired: lower ones have a negative coefficient in the round's column, upper ones a
 * positive one. None outside drop_pairs. */
FMB_API size_t fmb_view_lowers(const fmb_view *w);
FMB_API size_t fmb_view_uppers(const fmb_view *w);
FMB_API size_t fmb_view_lower(const fmb_view *w, size_t i);
FMB_API size_t fmb_view_upper(const fmb_view *w, size_t j);

/* Relation of a row; the sign of its entry in a column. */
FMB_API fmb_rel fmb_view_rel(const fmb_view *w, size_t row);
FMB_API int fmb_view_sign(const fmb_view *w, size_t row, int col); /* -1, 0, 1; col = dim: of b */
/* The dim coefficients and the right side, or NULL if they do not fit (any size: fmb_view_get in
 * <fmb/gmp.h>); and one of them as exact text (<fmb/base.h>), col = dim being the right side. */
FMB_API const int64_t *fmb_view_int64(const fmb_view *w, size_t row);
FMB_API size_t fmb_view_text(const fmb_view *w, size_t row, int col, char *text, size_t size);

/* Base rows combined into a row, as a bit set of *words words; NULL while no histories are kept: no
 * rule in use needs them, or they start anew before the next pairs. All sets about histories below
 * are then empty, and every row counts as minimal. */
FMB_API const uint64_t *fmb_view_history(const fmb_view *w, size_t row, size_t *words);
/* Columns effectively eliminated in the derivation of a row: those that a combination cancelled. */
FMB_API const uint64_t *fmb_view_effective(const fmb_view *w, size_t row, size_t *words);
/* Columns that occur in a base row of the history but not in the row, and are not effectively
 * eliminated: they vanished by chance. out[words], words as above. */
FMB_API void fmb_view_implicit(const fmb_view *w, size_t row, uint64_t *out);
/* Columns eliminated by pairing since histories started, words as above. */
FMB_API const uint64_t *fmb_view_gone(const fmb_view *w);
/* The base rows: those alive when histories last started. */
FMB_API size_t fmb_view_bases(const fmb_view *w);
FMB_API int fmb_view_base_sign(const fmb_view *w, size_t base, int col);
/* Is the rank of the row's base rows, in the columns eliminated, one less than their number? Then
 * no other combination uses fewer of them. Exact. */
FMB_API bool fmb_view_minimal(const fmb_view *w, size_t row);

/* For drop_pairs. Set bit j where the union of the histories of lower row i and upper row j has
 * more than `most` base rows. */
FMB_API void fmb_view_drop_larger(const fmb_view *w, size_t i, int most, uint64_t *drop);
/* Set bit j where some other row's history lies inside that union. Dropped trivial rows (0 <= 3)
 * count, too. */
FMB_API void fmb_view_drop_covered(const fmb_view *w, size_t i, uint64_t *drop);

/* Over the box that the rows with one variable made when histories last started, perhaps with one
 * more that bounds a sum (a simplex): the sign of the least of b - a.x. Positive: the row is
 * strictly slack over the box, and holds in all of it. -1 also if the box is open where it matters,
 * and for rows of the box or made of nothing but these. */
FMB_API int fmb_view_slack(const fmb_view *w, size_t row);

/* Scratch memory until the callback returns, counted against the limits; NULL: return
 * FMB_ERR_MEMORY. */
FMB_API void *fmb_view_scratch(const fmb_view *w, size_t bytes);

/* Must the query end, by a limit or a cancel? Call this in long loops; if so, return anything: the
 * result of the callback is not used. */
FMB_API bool fmb_view_stop(const fmb_view *w);

#ifdef __cplusplus
}
#endif
#endif
