/* markowitz.h: Gaussian elimination of a sparse matrix that fills in little, over any numbers.
 *
 * Rows and columns are numbered 0 ... size - 1. The next pivot is the one that can make the fewest
 * new entries, the product of what else is in its row and in its column, looked for in a few of the
 * shortest rows and columns. What a number is, a table of functions says: residues modulo a prime,
 * of which each but 0 is a pivot, or doubles, of which a pivot must not be small in its row.
 *
 * Invariants: rows that are active have their entries in active columns only, and each active
 * column lists exactly the active rows that have an entry there.
 *
 * Source: Markowitz 1957, The elimination form of the inverse and its application to linear
 * programming; Suhl and Suhl 1990, Computing sparse LU factorizations for large-scale linear
 * programming bases.
 */
#ifndef FMB_LP_MARKOWITZ_H
#define FMB_LP_MARKOWITZ_H

#include "base/arena.h"
#include "trace/run.h"

/* Zero has no bit set. */
typedef union fmb_number {
    uint64_t residue;
    double real;
} fmb_number;

typedef struct fmb_markowitz_numbers {
    /* What divide takes in place of a pivot. */
    fmb_number (*make_divisor)(const void *self, fmb_number pivot);
    fmb_number (*divide)(const void *self, fmb_number a, fmb_number divisor);
    /* v[at[k]] -= factor pivot[k], k < size; how many become 0. */
    int (*subtract)(const void *self, fmb_number *v, const int *at, const fmb_number *pivot,
                    int size, fmb_number factor);
    /* No number of a row that is less than this is a pivot; HUGE_VAL: none is, the row vanishes.
     * NULL: all but 0 are pivots. */
    double (*least_pivot)(const fmb_number *v, int size);
    double least_alone; /* likewise where the column has no other entry */
} fmb_markowitz_numbers;

/* Lists of numbers in one pool: list i has size[i] of room[i] from start[i] on. */
typedef struct fmb_strips {
    size_t *start;
    int *size, *room;
    int *entry;
    fmb_number *value; /* beside entry, or NULL: no values */
    size_t used, entry_room, value_room;
} fmb_strips;

/* Rows or columns by the number of their entries: doubly linked, -1 ends. */
typedef struct fmb_buckets {
    int *head, *next, *prev;
} fmb_buckets;

typedef struct fmb_multiplier {
    int before; /* another one of that row, or -1 */
    int pivot, row;
    fmb_number value;
} fmb_multiplier;

typedef struct fmb_markowitz {
    fmb_run *run;
    fmb_arena *arena;
    const fmb_markowitz_numbers *kind;
    const void *self; /* of the functions */
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
    int *met;       /* [size] scratch: where another row has what is at that place */
    size_t entries; /* of active rows */
    int active;     /* rows that are not pivots yet, empty ones included */
} fmb_markowitz;

/* No rows yet; so many entries are to come. Errors: MEMORY, LIMIT. */
fmb_status fmb_markowitz_open(fmb_markowitz *u, fmb_run *run, fmb_arena *arena,
                              const fmb_markowitz_numbers *kind, const void *self, size_t size,
                              size_t entries);
/* Append an entry to the row that is being filled, i; rows are filled one after the other. */
static inline void fmb_markowitz_put(fmb_markowitz *u, int i, int column, fmb_number value)
{
    u->row.entry[u->row.used] = column;
    u->row.value[u->row.used++] = value;
    u->row.size[i]++;
}
/* All rows are filled. */
void fmb_markowitz_begin(fmb_markowitz *u);
/* Take one pivot; *done: there was none. Errors: MEMORY, LIMIT. */
fmb_status fmb_markowitz_step(fmb_markowitz *u, bool *done);

#endif
