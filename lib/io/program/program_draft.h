/* program_draft.h: a linear program being read from MPS or CPLEX LP into a system: its variables
 * with their bounds, the names of its rows, and which one-time warnings were given.
 *
 * Rows are appended to the system as they are read; fmb_program_finish appends a row for each
 * finite bound. A side or bound of 1e30 and more is infinite, as in the programs that write such
 * files.
 *
 * Invariant: end[j] belongs to variable j of s, j < ends = dim of s.
 */
#ifndef FMB_IO_PROGRAM_DRAFT_H
#define FMB_IO_PROGRAM_DRAFT_H

#include "io/core/io_private.h"
#include "system/names.h"

/* A bound of a variable. */
typedef struct fmb_program_end {
    const char *at; /* its place in the text; NULL: it is not given */
    bool finite;
    mpq_t value;
} fmb_program_end;

/* The two ends of a row or variable. */
enum { FMB_PROGRAM_LOW = 0, FMB_PROGRAM_HIGH = 1 };

typedef struct fmb_program_draft {
    fmb_cursor *c;
    fmb_system *s;
    fmb_names rows;
    fmb_program_end (*end)[2]; /* the defaults are 0 and infinity */
    size_t ends, capacity;
    char *name; /* scratch: a name as a string */
    size_t name_capacity;
    mpq_t huge[2]; /* -1e30, 1e30 */
    bool warned_infinite;
} fmb_program_draft;

void fmb_program_open(fmb_program_draft *p, fmb_cursor *c, fmb_system *s);
void fmb_program_close(fmb_program_draft *p);

/* The variable of that name, which is appended if there is none. Errors: MEMORY. */
fmb_status fmb_program_variable(fmb_program_draft *p, fmb_span name, int *j);
/* The row of that name, counted in order of naming; if new it must not exist yet, else it must.
 * Errors: MEMORY, PARSE. */
fmb_status fmb_program_row(fmb_program_draft *p, fmb_span name, bool new, size_t *i);

/* Does q, read at `at`, mean infinity for that end? */
bool fmb_program_is_infinite(fmb_program_draft *p, const char *at, mpq_srcptr q, int end);
/* Set a bound of variable j, read at `at`; q NULL: infinite. */
void fmb_program_bound(fmb_program_draft *p, int j, int end, const char *at, mpq_srcptr q);

/* Append low <= terms <= high, where NULL is infinite: a row for each end, or one equation if they
 * are equal. at: the place named in errors; label.n 0: no label. Errors: MEMORY, PARSE. */
fmb_status fmb_program_append(fmb_program_draft *p, const char *at, fmb_draft *terms,
                              mpq_srcptr low, mpq_srcptr high, fmb_span label);
/* Append the bounds as rows. Errors: MEMORY, PARSE. */
fmb_status fmb_program_finish(fmb_program_draft *p);

#endif
