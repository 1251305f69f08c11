/* markowitz.h: Gaussian elimination of a sparse matrix with little fill-in, over any numbers.
 *
 * Rows and columns are numbered 0 ... size - 1. The next pivot has the least bound on new entries,
 * the product of the numbers of other entries in its row and in its column, among a few of the
 * shortest rows and columns. A table of functions gives the arithmetic: residues modulo a prime,
 * where every nonzero may be a pivot, or doubles, where a pivot must not be small in its row.
 *
 * Invariants: active rows have their entries in active columns only, and each active column lists
 * exactly the active rows that have an entry there.
 *
 * Source: Markowitz 1957, The elimination form of the inverse and its application to linear
 * programming; Suhl and Suhl 1990, Computing sparse LU factorizations for large-scale linear
 * programming bases.
 */
#ifndef FMB_LP_MARKOWITZ_H
#define FMB_LP_MARKOWITZ_H

#include "base/arena.h"
#include "trace/run.h"

/* All bits of zero are 0. */
typedef union fmb_number {
    uint64_t residue;
    double real;
} fmb_number;

typedef struct fmb_markowitz_numbers {
    /* The pivot in the form that `divide` takes. */
    fmb_number (*make_divisor)(const void *self, fmb_number pivot);
    fmb_number (*divide)(const void *self, fmb_number a, fmb_number divisor);
    /* v[at[k]] -= factor pivot[k], k < size; returns how many become 0. */
    int (*subtract)(const void *self, fmb_number *v, const int *at, const fmb_number *pivot,
                    int size, fmb_number factor);
    /* Numbers of a row below this are no pivots; HUGE_VAL: none is, the row vanishes. NULL: every
     * nonzero may be a pivot. */
    double (*least_pivot)(const fmb_number *v, int size);
    double least_alone; /* likewise if the column has no other entry */
} fmb_markowitz_numbers;

/* Lists in one pool: list i has size[i] entries and memory for room[i], from start[i] on. */
typedef struct fmb_strips {
    size_t *start;
    int *size, *room;
    int *entry;
    fmb_number *value; /* of each entry; NULL: no values */
    size_t used, entry_room, value_room;
} fmb_strips;

/* Rows or columns by their number of entries, in doubly linked lists that end with -1. */
typedef struct fmb_buckets {
    int *head, *next, *prev;
} fmb_buckets;

typedef struct fmb_multiplier {
    int before; /* the previous one of the row, or -1 */
    int pivot, row;
    fmb_number value;
} fmb_multiplier;

typedef struct fmb_markowitz {
    fmb_run *run;
    fmb_arena *arena;
    const fmb_markowitz_numbers *kind;
    const void *self; /* argument of the functions */
    int size;
    fmb_strips row, column;
    fmb_buckets by_row, by_column;
    int *row_at, *column_at;    /* [pivots] */
    int pivots;                 /* so far */
    fmb_number *divisor;        /* [pivots] of the pivot, which is the first entry of its row */
    fmb_multiplier *multiplier; /* [multipliers] pivot by pivot */
    size_t multipliers, multiplier_room;
    int *last;      /* [size] the last multiplier of each row, or -1 */
    int *mark;      /* [size] a column's place in the pivot row, or -1 */
    int *met;       /* [size] scratch: where another row has the same column */
    size_t entries; /* of active rows */
    int active;     /* rows that are not pivots yet, empty ones included */
} fmb_markowitz;

/* No rows yet; about `entries` entries will be added. Errors: MEMORY, LIMIT. */
fmb_status fmb_markowitz_open(fmb_markowitz *u, fmb_run *run, fmb_arena *arena,
                              const fmb_markowitz_numbers *kind, const void *self, size_t size,
                              size_t entries);
/* Append an entry to row i; rows are filled one after the other. */
static inline void fmb_markowitz_put(fmb_markowitz *u, int i, int column, fmb_number value)
{
    u->row.entry[u->row.used] = column;
    u->row.value[u->row.used++] = value;
    u->row.size[i]++;
}
/* To be called when all rows are filled. */
void fmb_markowitz_begin(fmb_markowitz *u);
/* Eliminate one pivot; *done: there was none. Errors: MEMORY, LIMIT. */
fmb_status fmb_markowitz_step(fmb_markowitz *u, bool *done);

#endif
