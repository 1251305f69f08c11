/* program_draft.h: a linear program on its way into a system, from MPS or CPLEX LP: its variables
 * with their bounds, the names of its rows, and the warnings that are given once.
 *
 * Rows go into the system as their reader has them; fmb_program_finish puts a row behind them for
 * each finite bound. A side or bound of 1e30 and more is infinite, as in the programs that write
 * such files.
 *
 * Invariant: end[j] belongs to variable j of s, j < ends = dim of s.
 */
#ifndef FMB_IO_PROGRAM_DRAFT_H
#define FMB_IO_PROGRAM_DRAFT_H

#include "io/core/io_private.h"
#include "system/names.h"

/* A bound of a variable. */
typedef struct fmb_program_end {
    const char *at; /* where the text gives it; NULL: it does not */
    bool finite;
    mpq_t value;
} fmb_program_end;

/* Of a row or variable: which of its two ends. */
enum { FMB_PROGRAM_LOW = 0, FMB_PROGRAM_HIGH = 1 };

typedef struct fmb_program_draft {
    fmb_cursor *c;
    fmb_system *s;
    fmb_names rows;
    fmb_program_end (*end)[2]; /* at first 0 and infinity */
    size_t ends, capacity;
    char *name; /* scratch: a name as a string */
    size_t name_capacity;
    mpq_t huge[2]; /* -1e30, 1e30 */
    bool warned_infinite;
} fmb_program_draft;

void fmb_program_open(fmb_program_draft *p, fmb_cursor *c, fmb_system *s);
void fmb_program_close(fmb_program_draft *p);

/* The variable of that name, which becomes one if there is none. Errors: MEMORY. */
fmb_status fmb_program_variable(fmb_program_draft *p, fmb_span name, int *j);
/* The row of that name, counted in order of naming; if new it must not exist yet, else it must.
 * Errors: MEMORY, PARSE. */
fmb_status fmb_program_row(fmb_program_draft *p, fmb_span name, bool new, size_t *i);

/* Is q, at a place of the text, infinite as that end? */
bool fmb_program_is_infinite(fmb_program_draft *p, const char *at, mpq_srcptr q, int end);
/* The bound of variable j that the text gives at a place; q NULL: infinite. */
void fmb_program_bound(fmb_program_draft *p, int j, int end, const char *at, mpq_srcptr q);

/* Append low <= terms <= high, an end NULL being infinite: a row for each end, one equation where
 * they are equal. at is to blame for what goes wrong; label.n 0: none. Errors: MEMORY, PARSE. */
fmb_status fmb_program_append(fmb_program_draft *p, const char *at, fmb_draft *terms,
                              mpq_srcptr low, mpq_srcptr high, fmb_span label);
/* The bounds as rows. Errors: MEMORY, PARSE. */
fmb_status fmb_program_finish(fmb_program_draft *p);

#endif
