/* tiny_private.h: shared by the files of the tiny elimination; see tiny.c.
 *
 * A row is an array of words: the right side at 0, the coefficients at 1..n. Every |word| < 2^62,
 * and the row's `bits` is a closer bound. A round that removes variable c gives its number to the
 * last one, n, so rows stay compact and loops short.
 */
#ifndef FMB_ELIM_TINY_TINY_PRIVATE_H
#define FMB_ELIM_TINY_TINY_PRIVATE_H

#include <fmb/solve.h>

#include "num/vec.h"

#define FMB_TINY_VARIABLES 9
#define FMB_TINY_BASE      64   /* base rows: a history is one word */
#define FMB_TINY_ROWS      128  /* of a table */
#define FMB_TINY_PAIRS     2048 /* visited before giving up */
#define FMB_TINY_FEW_PAIRS 640  /* for seven variables and more: the oracle is faster */
#define FMB_TINY_WORDS     16   /* of a row */
#define FMB_TINY_END_BITS  60   /* of an end of the box */

typedef struct fmb_tiny_table {
    int64_t a[FMB_TINY_ROWS][FMB_TINY_WORDS];
    uint64_t history[FMB_TINY_ROWS]; /* base rows combined */
    uint8_t bits[FMB_TINY_ROWS];
    bool strict[FMB_TINY_ROWS];
    int rows;
} fmb_tiny_table;

/* The best bound on the last variable on each side, c > 0 and b / c least: x <= b / c for the upper
 * side, -x <= b / c for the lower one. */
typedef struct fmb_tiny_end {
    fmb_i128 b, c;
    uint64_t history;
    bool strict, known;
} fmb_tiny_end;

typedef struct fmb_tiny {
    int n;                                   /* remaining variables */
    int since;                               /* variables eliminated by pairing */
    uint64_t most_pairs;                     /* visited before giving up */
    int64_t end[2][FMB_TINY_WORDS];          /* the box, rounded outward, */
    uint64_t end_history[2][FMB_TINY_WORDS]; /* and the base rows of its ends */
    unsigned open[2];                        /* bit k: variable k has no such end */
    fmb_tiny_table *now, *next;
    fmb_tiny_end last[2];
    uint64_t clash; /* base rows found to be infeasible together */
    fmb_stats *stats;
    fmb_tiny_table table[2];
} fmb_tiny;

typedef enum fmb_tiny_step {
    FMB_TINY_GO,
    FMB_TINY_CLASH, /* no point satisfies the rows */
    FMB_TINY_FULL   /* no room for a row, or it does not fit */
} fmb_tiny_step;

static inline void fmb_tiny_copy(fmb_tiny_table *to, int i, const fmb_tiny_table *from, int k)
{
    for (int word = 0; word < FMB_TINY_WORDS; word++)
        to->a[i][word] = from->a[k][word];
    to->history[i] = from->history[k];
    to->bits[i] = from->bits[k];
    to->strict[i] = from->strict[k];
}

/* tiny_load.c: take m rows as the base, and those with one variable also as the box: all rows of s;
 * or, if s is NULL, row[m], small rows over all t->n variables, taken as strict. */
fmb_tiny_step fmb_tiny_load(fmb_tiny *t, const fmb_system *s, size_t m, const fmb_vec *row);

/* tiny_row.c: put the combination of rows p and q of t->now that cancels variable c, whose
 * coefficient is negative in p and positive in q, behind the counted rows of t->next; false if it
 * does not fit. */
bool fmb_tiny_combine(fmb_tiny *t, int p, int q, int c);

/* tiny_box.c: drop the rows from number `first` on that hold strictly in the whole box. A row that
 * fails in the whole box is a clash. */
fmb_tiny_step fmb_tiny_prune(fmb_tiny *t, fmb_tiny_table *rows, int first);

/* tiny_last.c: note the bound c x <= b (< b), of these base rows. c = 0: the row may be false. */
fmb_tiny_step fmb_tiny_note(fmb_tiny *t, fmb_i128 c, fmb_i128 b, bool strict, uint64_t history);
/* Is there a value between the noted bounds? If not, they clash. */
fmb_tiny_step fmb_tiny_compare_ends(fmb_tiny *t);

#endif
