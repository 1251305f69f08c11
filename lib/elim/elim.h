/* elim.h: Fourier-Motzkin elimination on integer rows that know where they come from.
 *
 * Rows live in one store and never move; a row is named by its number. A *base* row was put in; any
 * other is a combination of two earlier rows that cancels one column, so the store is a derivation
 * from which multipliers over the base rows can be read (derive.h), and the rows that each round
 * removed are all that back-substitution needs (witness.h). Rows are primitive integer vectors: n
 * coefficients and the right side, a.x <= b, < b or = b.
 *
 * A round eliminates one variable: by substitution if an equality contains it, else by pairing rows
 * of opposite sign. Source: Fourier 1827; Motzkin 1936; Schrijver 1986, section 12.2.
 *
 * Histories (history.c) are kept from a *base* on: the rows alive when the first pairs were made
 * after the start, after a substitution, or after a rule dropped rows for reasons of its own.
 */
#ifndef FMB_ELIM_ELIM_H
#define FMB_ELIM_ELIM_H

#include <fmb/rule.h>

#include "base/arena.h"
#include "elim/box.h"
#include "num/vec.h"
#include "trace/run.h"

#define FMB_NO_ROW    UINT32_MAX
#define FMB_MAX_RULES 16

typedef struct fmb_derived {
    fmb_vec v;
    uint64_t
        *history;  /* [words] of the base in force when it was made, then [columns] eliminated */
    uint32_t p, q; /* parents; FMB_NO_ROW for a base row; q alone: the reverse of p */
    int32_t col;   /* the column they cancelled */
    bool strict, equality;
} fmb_derived;

/* What a round removed: the rows in which var stood, in the order found. */
typedef struct fmb_round {
    uint32_t *row;
    size_t rows;
    int var;
    bool equality; /* row[0] is an equality, solved for var; the others are its results' parents */
} fmb_round;

/* A growing list of rows. */
typedef struct fmb_list {
    uint32_t *row;
    size_t size, capacity;
} fmb_list;

/* A rule at work. */
typedef struct fmb_worker {
    const fmb_rule *rule;
    void *state;      /* [rule->state_bytes] */
    uint64_t dropped; /* pairs and rows, in this round */
} fmb_worker;

/* Steps that may be left out for study. */
typedef enum fmb_step {
    FMB_STEP_EQUALITIES = 1, /* substitute equalities */
    FMB_STEP_COMPONENTS = 2, /* part by part */
    FMB_STEP_ONESIDED = 4,   /* columns of one sign first */
    FMB_STEP_BOUNDS = 8,     /* the tightest row with one variable of each side makes a box */
    FMB_STEP_REFUTE = 16     /* a row that the box refutes ends the elimination */
} fmb_step;

/* What a caller decides; borrowed. */
typedef struct fmb_elim_options {
    fmb_order order;
    fmb_rebase rebase;
    unsigned steps; /* of fmb_step */
    bool wide_only;
    fmb_chooser chooser;
    const fmb_rule *const *rule;
    int rules;
} fmb_elim_options;

typedef struct fmb_elim {
    fmb_run *run;
    fmb_arena *arena;
    fmb_num num;
    int n;
    fmb_order order;
    fmb_rebase rebase;
    unsigned steps;
    fmb_chooser chooser;
    fmb_worker worker[FMB_MAX_RULES];
    int workers;
    bool histories;     /* some rule needs them */
    uint64_t constants; /* rows of this round that said nothing */

    fmb_derived *row;
    size_t rows, row_capacity;
    int64_t *spare; /* words of a row that was given up, or NULL */
    uint64_t *spare_history;
    fmb_list live, next; /* rows alive; rows alive after the round being made */
    fmb_round *round;    /* [n], in the order made */
    int rounds;
    int *candidate; /* [n] scratch of the choice */

    size_t budget;    /* rows that the store may hold, 0 = any number: set it after init */
    bool over_budget; /* it held more: the elimination ended with FMB_LIMIT */

    bool based;                /* the live rows' histories are valid */
    bool broken;               /* in this round a rule refused pairs or rows that they count on */
    uint32_t *base;            /* [bases] */
    size_t bases, words;       /* words of a history */
    size_t columns;            /* words of a set of columns */
    uint64_t *gone;            /* [columns] columns eliminated by pairing since the last re-base */
    int since;                 /* their number */
    fmb_box_rows box;          /* of the base */
    struct fmb_filter *filter; /* histories in planes; see filter.h */
    uint32_t clash; /* a row that no point satisfies (0 <= -1, 0 < 0, 0 = 1), or FMB_NO_ROW */
} fmb_elim;

/* An empty store over n variables. Errors: MEMORY, LIMIT. In any case fmb_elim_clear it. */
fmb_status fmb_elim_init(fmb_elim *e, fmb_run *run, fmb_arena *arena, int n,
                         const fmb_elim_options *o);
void fmb_elim_clear(fmb_elim *e);

/* Add a base row (copied, [n + 1], primitive): its number is the count of rows before it. */
fmb_status fmb_elim_add(fmb_elim *e, const fmb_vec *v, fmb_rel rel);

/* Take equality i, a base row, for two inequalities: itself and its reverse, a new row. */
fmb_status fmb_elim_split(fmb_elim *e, uint32_t i);

/* Drop live rows as the rules say, between rounds. */
fmb_status fmb_elim_prune(fmb_elim *e);

/* Eliminate all variables with drop[var], in the engine's order, until done or a row clashes. */
fmb_status fmb_elim_eliminate(fmb_elim *e, const bool *drop);

/* ---- for the other files of this room -------------------------------------------------------- */

/* The variable to eliminate next among those with drop[var] and not yet done; -1: none. */
fmb_status fmb_elim_choose(fmb_elim *e, const bool *drop, int *var);

/* row.c: append a row derived from p and q by cancelling col to the next live rows. Rows that say
 * nothing, or that a rule drops, are not kept. */
fmb_status fmb_elim_combine(fmb_elim *e, uint32_t p, uint32_t q, int col);
/* The same without asking anybody, and not alive: *out is the new row. */
fmb_status fmb_elim_derive_row(fmb_elim *e, uint32_t p, uint32_t q, int col, uint32_t *out);
fmb_status fmb_list_push(fmb_elim *e, fmb_list *list, uint32_t row);

/* pairs.c: eliminate a variable by pairing: every row of the round names it, lowers come first. */
fmb_status fmb_elim_pair(fmb_elim *e, const fmb_round *round, size_t lowers);
/* squeeze.c: the same for the last variable, when every row of the round names no other: only the
 * tightest bounds are combined. */
fmb_status fmb_elim_squeeze(fmb_elim *e, const fmb_round *round, size_t lowers);

/* The rule has refused pairs or rows of this round. */
static inline void fmb_elim_note_drop(fmb_elim *e, int worker, uint64_t dropped)
{
    fmb_worker *w = &e->worker[worker];
    w->dropped += dropped;
    e->run->stats.rows_dropped += dropped;
    e->broken |= dropped > 0 && (w->rule->flags & FMB_RULE_BREAKS_HISTORY) != 0;
}

/* prune.c: what the rules say when a round of var (-1: none) has ended. */
fmb_status fmb_elim_end_round(fmb_elim *e, int var);

/* history.c: live rows become their own histories: the i-th live row is base row i. */
fmb_status fmb_elim_start_histories(fmb_elim *e);
/* Room for a history and its columns, or NULL. */
uint64_t *fmb_history_get(fmb_elim *e);
/* The history of r, just combined from p and q; nothing while no histories are kept. */
fmb_status fmb_history_join(fmb_elim *e, fmb_derived *r, const fmb_derived *p,
                            const fmb_derived *q);
/* Columns of the base rows of r that are neither in r nor effectively eliminated: out[columns]. */
void fmb_history_implicit(const fmb_elim *e, const fmb_derived *r, uint64_t *out);

/* refute.c: end the elimination by row r, whose least value over the box is more than it allows. */
fmb_status fmb_elim_refute(fmb_elim *e, uint32_t r);

static inline bool fmb_elim_keeps(const fmb_elim *e, fmb_step step)
{
    return (e->steps & (unsigned)step) != 0;
}

/* Words of 64 bits for a set of n. */
static inline size_t fmb_set_words(size_t n)
{
    return (n + 63) / 64;
}

#endif
