/* fmb/rule.h: pruning rules, built in or your own, and who chooses the next variable.
 *
 * A rule is a const table. It may refuse pairs of rows before they are combined (drop_pairs),
 * refuse a row just made (drop_row), or drop rows at the end of a round (end_round). It sees the
 * rows through a window and changes nothing itself; a rule of yours is treated as the built-in ones
 * are. docs/adding-a-rule.md writes one from scratch.
 *
 * Soundness. A rule *of histories* argues with the set of base rows that a row was combined from;
 * its argument needs that every combination not refused by such a rule is present. A rule that
 * drops rows for another reason breaks that, so after it the engine re-bases: each live row becomes
 * its own history, and counting starts anew; multipliers over the rows of the system survive. The
 * flags say which kind a rule is; obeying them is the engine's duty, never the caller's. What a
 * rule says is believed until the evidence is checked: one that drops too much makes answers too
 * large, and then fmb_check rejects the point that goes with them.
 */
#ifndef FMB_RULE_H
#define FMB_RULE_H

#include <fmb/base.h>
#include <fmb/solve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A round in progress: the live rows over columns 0 <= col < fmb_view_dim. A row has a name, a
 * number that stays the same for the whole elimination; its entries are integers, a.x REL b. What a
 * view gives is good until the callback returns. Of NULL all of it is 0, NULL, -1 for a variable or
 * column, and true for fmb_view_stop and fmb_view_minimal; the text is "0". */
typedef struct fmb_view fmb_view;

/* What kind of a rule it is. */
typedef enum fmb_rule_flag {
    FMB_RULE_NEEDS_HISTORY = 1,  /* reads histories */
    FMB_RULE_BREAKS_HISTORY = 2, /* drops rows for reasons other than histories: re-base after it */
    FMB_RULE_VERDICT_ONLY = 4,   /* keeps feasibility but not the projection: fmb_solve alone */
    FMB_RULE_ONE_BASE = 8        /* no re-base may happen beside it: refused beside such rules */
} fmb_rule_flag;

/* Any callback may be NULL. state is fresh scratch of state_bytes zero bytes for each elimination
 * (NULL if 0); clear, unless NULL, releases what it points to. */
typedef struct fmb_rule {
    const char *name;   /* the word users type: no commas or blanks */
    const char *source; /* where it is from; built-in rules: key in docs/references.bib */
    unsigned flags;     /* of fmb_rule_flag */
    size_t state_bytes;
    /* May the combinations of lower row number i (fmb_view_lower) with the upper rows be left out?
     * Set bit j for upper row number j; bits set before are pairs already refused. */
    void (*drop_pairs)(void *state, const fmb_view *w, size_t i, uint64_t *drop);
    /* May the row just made be left out? Rules that do not need histories are asked about the base
     * rows, too, when histories start. */
    bool (*drop_row)(void *state, const fmb_view *w, size_t row);
    /* Mark live rows that may go: drop[i] is for fmb_view_row(w, i), and false at first; entries
     * have no common divisor then. Beside rules of histories and with FMB_REBASE_AUTO, a rule that
     * breaks them is not asked about few rows, and few marks are ignored. Errors: any. */
    fmb_status (*end_round)(void *state, const fmb_view *w, bool *drop);
    void (*clear)(void *state);
} fmb_rule;

/* What a shared object exports to be given to the commands as --rule-library: its rules, NULL ends
 * them. Their names are none of the built-in ones. This library does not define it. */
extern FMB_API const fmb_rule *const fmb_rule_library[];

/* The built-in rule of that name, static, or NULL; and the i-th one, NULL past the end. */
FMB_API const fmb_rule *fmb_rule_find(const char *name);
FMB_API const fmb_rule *fmb_rule_at(size_t i);

/* Use one more rule in the queries of this solver, after those in options.rules. The table is
 * borrowed for the solver's life. Errors: ARG (no name), RULE (a rule of that name is in use, or
 * too many are): fmb_solver_trouble says which. Whether rules agree with each other and with a
 * query is found out by the query: it returns FMB_ERR_RULE then, and fmb_solver_trouble names them.
 */
FMB_API FMB_CHECKED fmb_status fmb_solver_add_rule(fmb_solver *v, const fmb_rule *rule);

/* Choose the variable to eliminate next: one of col[0..n), n > 0. Anything else ends the query with
 * FMB_ERR_ARG. Beside a rule that wants one base only columns of equalities are offered while there
 * are any: substituting one later would be a re-base. */
typedef struct fmb_chooser {
    int (*choose)(void *self, const fmb_view *w, const int *col, size_t n);
    void *self;
} fmb_chooser;

/* In place of options.order; {NULL, NULL}: options.order again. */
FMB_API void fmb_solver_set_chooser(fmb_solver *v, fmb_chooser chooser);

/* An order that users type as a word: letters, digits, - and _, at most 31 of them. */
typedef struct fmb_named_chooser {
    const char *name;
    const char *source; /* where it is from */
    fmb_chooser chooser;
} fmb_named_chooser;

/* What a shared object exports beside its rules, or instead: its orders, NULL ends them. Their
 * names are none of those of options.order. This library does not define it. */
extern FMB_API const fmb_named_chooser *const fmb_chooser_library[];

/* ---- the window ------------------------------------------------------------------------------ */

FMB_API int fmb_view_dim(const fmb_view *w); /* columns */
/* The rule that is being asked, the very table that was added: it may be the first member of a
 * structure that holds what the rule has to know. NULL: a chooser is. */
FMB_API const fmb_rule *fmb_view_rule(const fmb_view *w);
/* The system's variable of a column; -1: the form of fmb_optimize, which is never eliminated. */
FMB_API int fmb_view_variable(const fmb_view *w, int col);
FMB_API int fmb_view_column(const fmb_view *w);           /* of this round; -1: between rounds */
FMB_API size_t fmb_view_rows(const fmb_view *w);          /* live rows */
FMB_API size_t fmb_view_row(const fmb_view *w, size_t i); /* the name of the i-th */
/* Variables eliminated by pairing since the last re-base, that of this round included. */
FMB_API int fmb_view_eliminated(const fmb_view *w);

/* The rows to be paired: in lower ones the coefficient of the round's column is negative, in upper
 * ones positive. None outside drop_pairs. */
FMB_API size_t fmb_view_lowers(const fmb_view *w);
FMB_API size_t fmb_view_uppers(const fmb_view *w);
FMB_API size_t fmb_view_lower(const fmb_view *w, size_t i);
FMB_API size_t fmb_view_upper(const fmb_view *w, size_t j);

/* Relation of a row; the sign of its entry in a column. */
FMB_API fmb_rel fmb_view_rel(const fmb_view *w, size_t row);
FMB_API int fmb_view_sign(const fmb_view *w, size_t row, int col); /* -1, 0, 1; col = dim: of b */
/* The dim coefficients and the right side, or NULL if they do not fit. Any size: fmb_view_get in
 * <fmb/gmp.h>; and one of them as exact text (<fmb/base.h>), col = dim being the right side. */
FMB_API const int64_t *fmb_view_int64(const fmb_view *w, size_t row);
FMB_API size_t fmb_view_text(const fmb_view *w, size_t row, int col, char *text, size_t size);

/* Base rows combined into a row, as a bit set of *words words; NULL while no histories are kept: no
 * rule in use needs them, or they start anew before the next pairs. All that is said of histories
 * below is then empty, and every row minimal. */
FMB_API const uint64_t *fmb_view_history(const fmb_view *w, size_t row, size_t *words);
/* Columns effectively eliminated on the way to a row: those that some combination cancelled. */
FMB_API const uint64_t *fmb_view_effective(const fmb_view *w, size_t row, size_t *words);
/* Columns that stand in a base row of the history but in the row no longer, and are not effectively
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
/* Set bit j where some other row's history lies inside that union. The rows that said nothing (0 <=
 * 3) and went are looked at, too. */
FMB_API void fmb_view_drop_covered(const fmb_view *w, size_t i, uint64_t *drop);

/* Over the box that the rows with one variable made when histories last started, perhaps with one
 * more that bounds a sum (a simplex): the sign of the least of b - a.x. Positive: the row is
 * strictly slack over the box, and holds in all of it. -1 also if the box is open where it matters,
 * and for rows of the box or made of nothing but these. */
FMB_API int fmb_view_slack(const fmb_view *w, size_t row);

/* Scratch memory until the callback returns, counted against the limits; NULL: return
 * FMB_ERR_MEMORY. */
FMB_API void *fmb_view_scratch(const fmb_view *w, size_t bytes);

/* Has the query to end, by a limit or a cancel? To be asked in long loops; if so, return anything:
 * what the callback said is not used. */
FMB_API bool fmb_view_stop(const fmb_view *w);

#ifdef __cplusplus
}
#endif
#endif
