/* lp.h: a small exact linear-programming oracle: simplex on dictionaries of integers.
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
#ifndef FMB_LP_LP_H
#define FMB_LP_LP_H

#include "num/vec.h"
#include "num/weights.h"
#include "trace/run.h"

typedef struct fmb_lp_row {
    const fmb_vec *v; /* [n + 1] coefficients and right side */
    fmb_rel rel;
} fmb_lp_row;

/* What a slack is to the oracle now. */
typedef enum fmb_slack {
    FMB_SLACK_ACTIVE = 0,
    FMB_SLACK_LOCKED,
    FMB_SLACK_TESTED, /* relaxed while fmb_lp_test looks how far it falls */
    FMB_SLACK_ASLEEP, /* basic, and neither counted nor kept up to date until its row is woken */
    FMB_SLACK_RELAXED /* its row is gone: basic for ever, and not kept up to date */
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

typedef enum fmb_lp_end {
    FMB_LP_OPTIMUM = 0,
    FMB_LP_UNBOUNDED,
    FMB_LP_VIOLATED /* fmb_lp_test: a point satisfies all other rows and not this one */
} fmb_lp_end;

/* rows[m] must outlive lp. Errors: MEMORY, LIMIT. After an error only fmb_lp_clear may follow. */
fmb_status fmb_lp_init(fmb_lp *lp, fmb_run *run, int n, size_t m, const fmb_lp_row *rows,
                       bool wide_only);
void fmb_lp_clear(fmb_lp *lp);

/* Reach a feasible dictionary; *feasible false: none exists, fmb_lp_conflict says why. */
fmb_status fmb_lp_feasible(fmb_lp *lp, bool *feasible);

/* From a feasible dictionary: push x_j up (sign 1) or down (-1) as far as the rows allow. */
fmb_status fmb_lp_extreme(fmb_lp *lp, int j, int sign, fmb_lp_end *end);
/* From a feasible dictionary: is the inequality i implied by the other rows that count? OPTIMUM:
 * yes, and the row is relaxed; VIOLATED: no. Never UNBOUNDED. The dictionary is feasible again
 * afterwards (call fmb_lp_restore once the answer has been read). */
fmb_status fmb_lp_test(fmb_lp *lp, size_t i, fmb_lp_end *end);
fmb_status fmb_lp_restore(fmb_lp *lp);
/* The same, where many rows may be asleep: x[n] gets the point of a violation, which satisfies them
 * too. center[n] is roughly a point inside: rows are woken where the way from it to a violation
 * first meets one. */
fmb_status fmb_lp_test_lazily(fmb_lp *lp, size_t i, const double *center, mpq_t *x,
                              fmb_lp_end *end);
/* Put every basic slack of an inequality that counts to sleep: pivots then cost nothing for it. */
void fmb_lp_sleep(fmb_lp *lp);
/* Add the current point to sum[n], roughly. */
void fmb_lp_add_point(const fmb_lp *lp, double *sum);
/* From a feasible dictionary: make slack i as large as possible, stopping early once it is positive
 * in the limit delta = 0. OPTIMUM: it is 0 everywhere; UNBOUNDED: it can be positive. */
fmb_status fmb_lp_widen_slack(fmb_lp *lp, size_t i, fmb_lp_end *end);

/* Hold slack i at 0 from now on (it is 0 everywhere): its row counts as an equality. *depends: it
 * is a combination of rows locked before (fmb_lp_dependence reads it) and was relaxed instead. */
fmb_status fmb_lp_lock(fmb_lp *lp, size_t i, bool *depends);

/* Is slack i positive at the current point, in the limit delta = 0? */
bool fmb_lp_is_slack(const fmb_lp *lp, size_t i);

/* ---- reading the dictionary (read.c) --------------------------------------------------------- */

/* Multipliers over the rows whose combination reads 0 <= negative or 0 < 0. */
fmb_status fmb_lp_conflict(const fmb_lp *lp, fmb_weights *w);
/* Multipliers y with sum_i y_i (b_i - a_i.x) = constant - sign * B, B the variable last pushed (an
 * x_j, or the slack of a test): they prove the optimum. */
fmb_status fmb_lp_optimum(const fmb_lp *lp, int sign, fmb_weights *w);
/* B = K/d + D/d delta: the optimum itself; *step gets the sign of D. */
void fmb_lp_value(const fmb_lp *lp, mpq_t value, int *step);
/* A point that satisfies every row that counts; with `closure`, the limit delta = 0. x[n]. */
fmb_status fmb_lp_point(const fmb_lp *lp, bool closure, mpq_t *x);
/* The point that a test found: satisfies the other rows, violates the one tested. */
fmb_status fmb_lp_violation(const fmb_lp *lp, mpq_t *x);
/* The direction of an UNBOUNDED push. */
void fmb_lp_ray(const fmb_lp *lp, mpq_t *x);

/* ---- for the other files of this room -------------------------------------------------------- */

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
/* fmb_lp_feasible, as a part of another program. */
fmb_status fmb_lp_make_feasible(fmb_lp *lp, bool *feasible);
/* The row that first reaches 0 when the variable of column j moves in the direction sign, SIZE_MAX
 * if none does; of equals the one of least variable. */
size_t fmb_lp_find_block(const fmb_lp *lp, size_t j, int sign);
/* Exchange the variables of row r and column j. Errors: MEMORY, LIMIT. */
fmb_status fmb_lp_pivot(fmb_lp *lp, size_t r, size_t j);

#endif
