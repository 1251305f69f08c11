/* draft.h: a row under construction, and names taken from the text. */
#ifndef FMB_IO_DRAFT_H
#define FMB_IO_DRAFT_H

#include "io/core/cursor.h"

/* sum coef[k] x_var[k] REL rhs. coef[0..capacity) are initialised. */
typedef struct fmb_draft {
    int *var;
    mpq_t *coef;
    size_t n, capacity;
    mpq_t rhs;
    fmb_mem *mem;
} fmb_draft;

void fmb_draft_init(fmb_draft *d, fmb_mem *mem);
void fmb_draft_clear(fmb_draft *d);
/* No terms, right side 0. */
void fmb_draft_reset(fmb_draft *d);
/* Room for one more term: *slot is its coefficient (old value undefined), to be set by the caller;
 * equal variables are added up in the end. Errors: MEMORY. */
fmb_status fmb_draft_term(fmb_draft *d, int var, mpq_ptr *slot);
/* One more term. Errors: MEMORY. */
fmb_status fmb_draft_add(fmb_draft *d, int var, mpq_srcptr coef);
void fmb_draft_negate(fmb_draft *d);
/* Append the row to s; p: the place named if it exceeds the budget. Errors: MEMORY, PARSE. */
fmb_status fmb_draft_append(fmb_cursor *c, const char *p, const fmb_draft *d, fmb_rel rel,
                            fmb_system *s);

/* Make the sum minus its right side the objective of s; p as above. Errors: MEMORY, PARSE. */
fmb_status fmb_draft_set_objective(fmb_cursor *c, const char *p, const fmb_draft *d,
                                   fmb_sense sense, fmb_system *s);

/* Find the variable with this name, or append it. Errors: MEMORY. */
fmb_status fmb_span_variable(fmb_cursor *c, fmb_span name, fmb_system *s, int *index);
/* Index of the variable of that name, or -1 in *index. Errors: MEMORY. */
fmb_status fmb_span_find(fmb_cursor *c, fmb_span name, const fmb_system *s, int *index);
/* Label of row i from a piece of text. Errors: MEMORY. */
fmb_status fmb_span_label(fmb_cursor *c, fmb_span label, fmb_system *s, size_t i);

/* A header may declare at most this many variables beyond one for each byte of the text. */
#define FMB_IO_FREE_VARIABLES 100000
/* Append n variables with default names, declared by a header at p. Errors: MEMORY, PARSE. */
fmb_status fmb_io_declare(fmb_cursor *c, const char *p, size_t n, fmb_system *s);

#endif
