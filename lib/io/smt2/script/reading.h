/* reading.h: a reading of an SMT-LIB text that goes on: commands are taken one after another, and
 * what the last of them did can be taken back, so that each is read when it comes to hold and not
 * again for every question that it holds for.
 *
 * Where a Boolean unknown is told behind a command that needs it, all is read once more
 * (formula.h).
 */
#ifndef FMB_IO_READING_H
#define FMB_IO_READING_H

#include "io/smt2/term.h"

/* ---- one reading, by any reader -------------------------------------------------------------- */

/* The command whose '(' is at open and behind the cursor. Errors: PARSE, MEMORY. */
fmb_smt_command fmb_smt_run_command;
/* The same by `run`; a command that needs facts which may still come is passed over. */
fmb_status fmb_smt_run(fmb_smt *r, const char *open, fmb_smt_command *run);
/* A reading begins, with what is known from those before. */
void fmb_smt_begin_reading(fmb_smt_facts *facts);
/* It has ended with st; *again: one that knows more has to follow. Errors: PARSE, and st. */
fmb_status fmb_smt_end_reading(fmb_cursor *c, const fmb_smt_facts *facts, fmb_status st,
                               bool *again);

/* ---- one that goes on ------------------------------------------------------------------------ */

typedef struct fmb_smt_reading {
    fmb_cursor c;
    fmb_where at; /* of c: what went wrong */
    fmb_reader silent;
    fmb_smt_facts facts;
    fmb_system *s; /* what has been read; NULL: no reading is on its way */
    fmb_smt r;
} fmb_smt_reading;

/* All that a reading has made so far. */
typedef struct fmb_smt_mark {
    size_t rows, nodes, formulas, givens, macros, params, budget;
    size_t tolds, declared, open;
    int dim;
    bool learned, objective;
} fmb_smt_mark;

/* Over a text that has been checked; how and mem live as long. Nothing is read yet. */
fmb_smt_reading fmb_smt_reading_of(const char *text, size_t size, const fmb_reader *how,
                                   fmb_mem *mem);
/* Begin, or begin anew with the facts of the reading before. Errors: MEMORY. */
fmb_status fmb_smt_reading_begin(fmb_smt_reading *g);
/* Nothing is read any more, and nothing known. */
void fmb_smt_reading_drop(fmb_smt_reading *g);

fmb_smt_mark fmb_smt_reading_mark(const fmb_smt_reading *g);
/* Back to where the mark was taken in this reading, which began with no fact from behind there. */
void fmb_smt_reading_return(fmb_smt_reading *g, const fmb_smt_mark *m);

#endif
