/* nucleus.h: LU factors modulo p of a sparse matrix that has no order to begin with.
 *
 * Rows and columns are numbered 0 ... size - 1 here. While there are zeros enough, the next pivot
 * is the one that can make the fewest new entries (Markowitz 1957), looked for in a few of the
 * shortest rows and columns (Suhl and Suhl 1990); no entry is too small modulo p. Once the rest is
 * dense, it is factored as such (dense_lu.h).
 *
 * Invariants: rows that are active have their entries in active columns only, and each active
 * column lists exactly the active rows that have an entry there.
 */
#ifndef FMB_LP_NUCLEUS_H
#define FMB_LP_NUCLEUS_H

#include "lp/linalg/modular/dense_lu.h"

/* Lists of numbers in one pool: list i has size[i] of room[i] from start[i] on. */
typedef struct fmb_nucleus_lists {
    size_t *start;
    int *size, *room;
    int *entry;
    uint64_t *value; /* beside entry, or NULL: no values */
    size_t used, entry_room, value_room;
} fmb_nucleus_lists;

/* Rows or columns by the number of their entries: doubly linked, -1 ends. */
typedef struct fmb_buckets {
    int *head, *next, *prev;
} fmb_buckets;

typedef struct fmb_multiplier {
    int before; /* another one of that row, or -1 */
    int pivot;
    uint64_t value;
} fmb_multiplier;

typedef struct fmb_nucleus {
    fmb_run *run;
    fmb_arena *arena;
    const fmb_prime *q;
    int size;
    fmb_nucleus_lists row, column;
    fmb_buckets by_row, by_column;
    int *row_at, *column_at; /* [pivots] */
    int pivots;              /* before those of the dense rest */
    uint64_t *inverse;       /* [pivots] of the pivot, which is the first entry of its row */
    fmb_multiplier *multiplier;
    size_t multipliers, multiplier_room;
    int *last;          /* [size] the last multiplier of each row, or -1 */
    int *mark;          /* [size] a column's place in the pivot row, or -1 */
    bool *met;          /* [size] places of the pivot row that the other row has, too */
    size_t entries;     /* of active rows */
    int active;         /* rows that are not pivots yet, empty ones included */
    fmb_dense_lu dense; /* the rest */
} fmb_nucleus;

/* No rows yet. Errors: MEMORY, LIMIT. */
fmb_status fmb_nucleus_open(fmb_nucleus *u, fmb_run *run, fmb_arena *arena, const fmb_prime *q,
                            size_t size, size_t entries);
/* Append an entry to the row that is being filled, i; rows are filled one after the other. */
static inline void fmb_nucleus_put(fmb_nucleus *u, int i, int column, uint64_t value)
{
    u->row.entry[u->row.used] = column;
    u->row.value[u->row.used++] = value;
    u->row.size[i]++;
}
/* Factor. Errors: MEMORY, LIMIT. */
fmb_status fmb_nucleus_factor(fmb_nucleus *u);

#endif
