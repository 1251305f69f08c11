/* store.h: rows with their derivations, and the state of an elimination.
 *
 * Rows are in one store and never move; a row is referred to by its number. A *base* row was added
 * from outside; any other row is a combination of two earlier rows that cancels one variable, so
 * the store is a derivation from which multipliers over the base rows can be read (derive.h), and
 * the rows that each round removed suffice for back-substitution (witness.h). Rows are primitive
 * integer vectors: n coefficients and the right side, a.x <= b, < b or = b.
 *
 * Variables are numbered 0 <= var < n here; the run maps them to those of the system (var_of).
 *
 * Histories (history.h) are kept from a *base* on: the rows live when the first pairs were made
 * after the start, after a substitution, or after a rule dropped rows without regard to histories.
 */
#ifndef FMB_ELIM_STORE_H
#define FMB_ELIM_STORE_H

#include <fmb/rule.h>

#include "base/arena.h"
#include "num/bitset.h"
#include "num/vec.h"
#include "trace/run.h"

#define FMB_NO_ROW    UINT32_MAX
#define FMB_MAX_RULES 16

typedef struct fmb_derived {
    fmb_vec v;
    uint64_t *history; /* [words] of the base at that time, then [var_words] variables effectively
                          eliminated */
    uint64_t *names;   /* [var_words] the variables in the row */
    uint32_t p, q;     /* parents; FMB_NO_ROW for a base row; q alone: the reverse of p */
    int32_t var;       /* the variable that p and q cancelled */
    bool strict, equality;
    bool lowest; /* known to be primitive */
} fmb_derived;

static inline fmb_rel fmb_derived_rel(const fmb_derived *r)
{
    return r->equality ? FMB_EQ : r->strict ? FMB_LT : FMB_LE;
}

/* What a round removed: the rows that contain var, in the order found. */
typedef struct fmb_round {
    uint32_t *row;
    size_t rows;
    int var;
    bool equality; /* row[0] is an equality, solved for var and substituted */
} fmb_round;

/* Counters before a round; events report the differences. */
typedef struct fmb_tally {
    size_t live, rows;
    uint64_t pairs, made, dropped, widened;
} fmb_tally;

/* A round whose lower rows before `next` have been paired; at its end a rule may pause, too. */
typedef struct fmb_pairing {
    bool running, pruning;          /* among its pairs; within a rule that tests all rows, */
    int pruner;                     /* that of this worker, */
    void *look;                     /* with its results so far, */
    void (*close_look)(void *look); /* which fmb_elim_clear closes so */
    size_t lowers, next;
    fmb_tally before;
} fmb_pairing;

/* A growing list of rows. */
typedef struct fmb_list {
    uint32_t *row;
    size_t size, capacity;
} fmb_list;

/* A rule with its state. */
typedef struct fmb_worker {
    const fmb_rule *rule;
    void *state;      /* [rule->state_bytes] */
    uint64_t dropped; /* pairs and rows, in this round */
} fmb_worker;

/* Steps that can be switched off for studies. */
typedef enum fmb_step {
    FMB_STEP_EQUALITIES = 1, /* substitute equalities */
    FMB_STEP_COMPONENTS = 2, /* connected components one by one */
    FMB_STEP_ONESIDED = 4,   /* variables of one sign first */
    FMB_STEP_BOUNDS = 8,     /* the tightest row with one variable of each side makes a box */
    FMB_STEP_REFUTE = 16     /* a row that the box refutes ends the elimination */
} fmb_step;

/* The box of the rows with one variable (exact_intervals.h). Ends are multiples of 1 / unit, so
 * that rows are compared with it in integers. */
typedef struct fmb_box_rows {
    uint32_t *row[2]; /* [side][n]: the row of the end, or FMB_NO_ROW */
    int64_t *end[2];  /* [side][n]: unit times the end */
    uint64_t *ended;  /* [var_words] variables with an end */
    int64_t unit;
    int bits;        /* bound on those of every end, unit and room */
    bool any;        /* is there an end? */
    uint32_t budget; /* base row sum s_j x_j <= c over variables with an end where s_j x_j is
                        least, some without the other end; FMB_NO_ROW: none */
    int64_t room;    /* unit times (c - the least of sum s_j x_j) >= 0 */
    uint64_t *hard;  /* [words] base rows that make the ends and the budget */
} fmb_box_rows;

typedef struct fmb_elim {
    fmb_run *run;
    fmb_arena *arena;
    fmb_num num;
    int n;
    fmb_order order;
    fmb_rebase rebase;
    unsigned steps; /* of fmb_step */
    fmb_chooser chooser;
    fmb_worker worker[FMB_MAX_RULES];
    int workers;
    bool histories;     /* does some rule need them? */
    uint64_t constants; /* trivial rows of this round */

    fmb_derived *row;
    size_t rows, row_capacity;
    int64_t *spare; /* words of a forgotten row, or NULL */
    uint64_t *spare_history;
    fmb_list live, next; /* live rows; live rows after this round */
    fmb_round *round;    /* [n], in the order made */
    int rounds;
    int *candidate;       /* [n] scratch of order.c */
    uint64_t *candidates; /* [var_words] variables still to eliminate, at the last choice */

    bool cheap_only; /* stop before rows would become more: set it after init */
    double growth;   /* > 0: over_budget before a variable without both box ends that makes more
                       rows than so many times the live ones (elim.c), or if more than twice
                       `flat` rows are live: set both after init */
    size_t flat;
    size_t judged;    /* rows before it were seen by rules at the end of a round */
    size_t budget;    /* most rows of the store, 0 = any number: set it after init */
    bool over_budget; /* budget exceeded: the elimination ended with FMB_LIMIT */
    bool pauses;      /* at the end of a slice it returns FMB_LIMIT, */
    bool paused;      /* and the next call continues: set `pauses` after init */
    fmb_pairing at;   /* the round in progress */

    bool based;                /* the live rows' histories are valid */
    bool broken;               /* in this round a rule refused pairs or rows that they need */
    uint32_t *base;            /* [bases] */
    size_t bases, words;       /* words of a history */
    size_t var_words;          /* words of a set of variables */
    uint64_t *gone;            /* [var_words] eliminated by pairing since the last re-base */
    int since;                 /* their number */
    fmb_box_rows box;          /* of the base */
    struct fmb_filter *filter; /* histories in planes; see filter.h */
    uint32_t clash; /* a row that no point satisfies (0 <= -1, 0 < 0, 0 = 1), or FMB_NO_ROW */
} fmb_elim;

/* Add a base row (copied, [n + 1], primitive); its number is the number of rows before it. */
fmb_status fmb_elim_add(fmb_elim *e, const fmb_vec *v, fmb_rel rel);

/* Treat equality i, a base row, as two inequalities: itself and its reverse, a new row. */
fmb_status fmb_elim_split(fmb_elim *e, uint32_t i);

/* The first variable of the row from number `from` on, or -1. All of them: for (int j =
 * fmb_elim_next_variable(e, r, 0); j >= 0; j = fmb_elim_next_variable(e, r, j + 1)). */
static inline int fmb_elim_next_variable(const fmb_elim *e, const fmb_derived *r, int from)
{
    size_t w = (size_t)from / 64;
    if (w >= e->var_words)
        return -1;
    uint64_t left = r->names[w] >> (from % 64) << (from % 64);
    while (left == 0 && ++w < e->var_words)
        left = r->names[w];
    return left != 0 ? (int)(64 * w) + __builtin_ctzll(left) : -1;
}

static inline int fmb_elim_count_variables(const fmb_elim *e, const fmb_derived *r)
{
    int n = 0;
    for (size_t w = 0; w < e->var_words; w++)
        n += (int)fmb_ones64(r->names[w]);
    return n;
}

/* The only variable of the row, or -1. */
static inline int fmb_elim_single_variable(const fmb_elim *e, const fmb_derived *r)
{
    int j = fmb_elim_next_variable(e, r, 0);
    return j < 0 || fmb_elim_next_variable(e, r, j + 1) >= 0 ? -1 : j;
}

/* Estimated bits of a minor of all remaining columns and right sides: the sum of their mean bits in
 * the live rows. */
size_t fmb_elim_minor_bits(const fmb_elim *e);
/* With minors of this many bits, exact linear programs become slow. */
#define FMB_LONG_MINOR 120

/* Combine p and q to cancel var, whatever the rules say: *out is the new row, which is not live. */
fmb_status fmb_elim_derive_row(fmb_elim *e, uint32_t p, uint32_t q, int var, uint32_t *out);

/* ---- for the other files of this room -------------------------------------------------------- */

/* The same at the end of the store, but not counted yet; e->rows++ keeps the row. */
fmb_status fmb_elim_form_row(fmb_elim *e, uint32_t p, uint32_t q, int var);
/* Forget the row at the end of the store; the next one reuses its memory. */
void fmb_elim_forget_row(fmb_elim *e, bool keep_history);

/* Does the row contain no variable? */
static inline bool fmb_elim_is_constant(const fmb_elim *e, const fmb_derived *r)
{
    return fmb_elim_next_variable(e, r, 0) < 0;
}

/* Is the constant row false? */
static inline bool fmb_elim_is_false(const fmb_elim *e, const fmb_derived *r)
{
    int b = fmb_vec_sgn(&r->v, (size_t)e->n);
    return r->equality ? b != 0 : r->strict ? b <= 0 : b < 0;
}

fmb_status fmb_list_push(fmb_elim *e, fmb_list *list, uint32_t row);

static inline bool fmb_elim_keeps(const fmb_elim *e, fmb_step step)
{
    return (e->steps & (unsigned)step) != 0;
}

#endif
