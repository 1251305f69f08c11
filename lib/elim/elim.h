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
 */
#ifndef FMB_ELIM_ELIM_H
#define FMB_ELIM_ELIM_H

#include "base/arena.h"
#include "rule/rule.h"
#include "trace/run.h"

#define FMB_NO_ROW    UINT32_MAX
#define FMB_MAX_RULES 8

typedef struct fmb_derived {
    fmb_vec v;
    uint64_t *history; /* [words] of the base in force when it was made */
    uint32_t p, q;     /* parents; FMB_NO_ROW for a base row */
    int32_t col;       /* the column they cancelled */
    bool strict, equality;
} fmb_derived;

/* What a round removed: the rows in which var stood, in the order found. */
typedef struct fmb_round {
    uint32_t *row;
    size_t rows;
    int var;
    bool equality; /* row[0] is an equality, solved for var; the others are its results' parents */
} fmb_round;

typedef struct fmb_elim {
    fmb_run *run;
    fmb_arena *arena;
    fmb_num num;
    int n;
    fmb_order order;
    const fmb_rule *rule[FMB_MAX_RULES];
    int rules;
    bool histories; /* some rule needs them */

    fmb_derived *row;
    size_t rows, row_capacity;
    int64_t *spare;        /* words of a row that said nothing, or NULL */
    uint32_t *live, *next; /* rows alive; rows alive after the round being made */
    size_t lives, live_capacity, nexts, next_capacity;
    fmb_round *round; /* [n], in the order made */
    int rounds;

    size_t budget;    /* rows that the store may hold, 0 = any number: set it after init */
    bool over_budget; /* it held more: the elimination ended with FMB_LIMIT */

    bool based;     /* the live rows' histories are valid */
    size_t words;   /* of a history */
    int since;      /* variables eliminated by pairing since the last re-base */
    uint32_t clash; /* a row that no point satisfies (0 <= -1, 0 < 0, 0 = 1), or FMB_NO_ROW */
} fmb_elim;

/* An empty store over n variables. rule[0..rules) are copied pointers. Errors: MEMORY, LIMIT. */
fmb_status fmb_elim_init(fmb_elim *e, fmb_run *run, fmb_arena *arena, int n, const fmb_options *o,
                         const fmb_rule *const *rule, int rules);
void fmb_elim_clear(fmb_elim *e);

/* Add a base row (copied, [n + 1], primitive): its number is the count of rows before it. */
fmb_status fmb_elim_add(fmb_elim *e, const fmb_vec *v, fmb_rel rel);

/* Drop live rows as the rules say; var has just been eliminated, -1: none yet. */
fmb_status fmb_elim_prune(fmb_elim *e, int var);

/* Eliminate all variables with drop[var], in the engine's order, until done or a row clashes. */
fmb_status fmb_elim_eliminate(fmb_elim *e, const bool *drop);

/* ---- for the other files of this room -------------------------------------------------------- */

/* The variable to eliminate next among those with drop[var] and not yet done, or -1. */
int fmb_elim_choose(const fmb_elim *e, const bool *drop);
/* Eliminate the last variable: every row of the round names no other. Only the tightest bounds are
 * combined. */
fmb_status fmb_elim_squeeze(fmb_elim *e, const fmb_round *round, size_t lowers);
/* Append a row derived from p and q by cancelling col; rows that say nothing are not kept. */
fmb_status fmb_elim_combine(fmb_elim *e, uint32_t p, uint32_t q, int col);

#endif
