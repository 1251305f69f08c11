/* dictionary.h: dictionaries of integers, on which a small exact simplex works (exact_simplex.h):
 * the oracle.
 *
 * The rows a_i.x REL b_i define slacks s_i = b_i - a_i.x - delta [row i strict] >= 0, with delta a
 * positive infinitesimal; x is free. A dictionary writes m *basic* variables in the n *nonbasic*
 * ones; dictionary row r reads
 *
 *     0 = sum_j c_rj N_j + e_r B_r + K_r + D_r delta,      e_r < 0,
 *
 * stored as a primitive integer vector (c_r0 .. c_r,n-1, e_r, K_r, D_r, scratch), so that a pivot
 * is one fmb_vec_cancel a row. Nonbasic variables have the value 0; a dictionary is feasible when
 * every basic slack that counts has (K_r, D_r) >= 0 lexicographically. Slacks of equalities are
 * *locked* at 0 and stay nonbasic; slacks of rows that were taken out are *relaxed* and stay basic.
 * After the start every x is basic, or no row names it.
 *
 * Sources: Fukuda and Avis on dictionaries; Bland 1977 for termination; Dutertre and de Moura 2006
 * for delta.
 */
#ifndef FMB_LP_DICTIONARY_H
#define FMB_LP_DICTIONARY_H

#include "lp/model/row.h"
#include "trace/run.h"

/* What a slack is to the oracle now. */
typedef enum fmb_slack {
    FMB_SLACK_ACTIVE = 0,
    FMB_SLACK_LOCKED,
    FMB_SLACK_TESTED,   /* relaxed while fmb_lp_test looks how far it falls */
    FMB_SLACK_INACTIVE, /* basic, and neither counted nor kept up to date until its row is activated
                         */
    FMB_SLACK_RELAXED   /* its row is gone: basic for ever, and not kept up to date */
} fmb_slack;

/* Variables are numbered: x_j is j, slack s_i is n + i. */
typedef struct fmb_lp {
    fmb_run *run;
    fmb_num num;
    int n;
    size_t m;
    const fmb_lp_row *source; /* [m] the rows given: borrowed */
    fmb_vec *row;             /* [m] dictionary rows */
    int64_t *words;           /* [m][n + 4] their small entries */
    fmb_vec temp;             /* the pivot row, prepared */
    size_t *basic;            /* [m] variable of each row */
    size_t *column;           /* [n] variable of each column */
    size_t *where;            /* [n + m] row of a basic variable, m + column of a nonbasic one */
    fmb_slack *slack;         /* [m] */
    bool *strict;             /* [m] */
    bool any_strict;
    size_t stalled; /* pivots since the last step that moved: Bland's rule from some count on */
    /* Where the last call stopped. */
    size_t at_row;    /* dictionary row: the contradiction, or the optimum's */
    size_t at_column; /* entering column: of a ray, or of the step to a violation; SIZE_MAX: none */
    int at_sign;      /* direction in which it enters */
    size_t tested;    /* the row of the last test */
    size_t block;     /* the row that stops the step, SIZE_MAX: none does */
} fmb_lp;

/* rows[m] must outlive lp. Errors: MEMORY, LIMIT. After an error only fmb_lp_clear may follow. */
fmb_status fmb_lp_init(fmb_lp *lp, fmb_run *run, int n, size_t m, const fmb_lp_row *rows,
                       bool wide_only);
void fmb_lp_clear(fmb_lp *lp);

static inline size_t fmb_lp_width(const fmb_lp *lp)
{
    return (size_t)lp->n + 4;
}
enum {
    FMB_LP_OWN = 0,
    FMB_LP_K = 1,
    FMB_LP_D = 2,
    FMB_LP_SCRATCH = 3
}; /* places after column n - 1 */
static inline size_t fmb_lp_place(const fmb_lp *lp, int which)
{
    return (size_t)lp->n + (size_t)which;
}
static inline bool fmb_lp_is_x(const fmb_lp *lp, size_t variable)
{
    return variable < (size_t)lp->n;
}
/* May the variable of column j enter? */
static inline bool fmb_lp_may_enter(const fmb_lp *lp, size_t j)
{
    size_t v = lp->column[j];
    return !fmb_lp_is_x(lp, v) && lp->slack[v - (size_t)lp->n] == FMB_SLACK_ACTIVE;
}
/* Must the basic variable of row r stay nonnegative? */
static inline bool fmb_lp_counts(const fmb_lp *lp, size_t r)
{
    size_t v = lp->basic[r];
    return !fmb_lp_is_x(lp, v) && lp->slack[v - (size_t)lp->n] == FMB_SLACK_ACTIVE;
}
/* Is the variable free to move both ways? */
static inline bool fmb_lp_is_free(const fmb_lp *lp, size_t variable)
{
    return fmb_lp_is_x(lp, variable) || lp->slack[variable - (size_t)lp->n] == FMB_SLACK_TESTED;
}
/* Entry j of row r over that of its own variable, roughly, and positive where both signs agree. */
double fmb_lp_ratio(const fmb_lp *lp, size_t r, size_t j);
/* Sign of K + D delta in row r. */
int fmb_lp_sign(const fmb_lp *lp, size_t r);
/* Exchange the variables of row r and column j. Errors: MEMORY, LIMIT. */
fmb_status fmb_lp_pivot(fmb_lp *lp, size_t r, size_t j);

#endif
