/* reading.h: an incremental reading of an SMT-LIB text: commands are executed one after another,
 * and the last ones can be undone, so that each command is read once and not again for every
 * question that depends on it.
 *
 * If a Boolean unknown is decided after a command that needs it, everything is read once more
 * (formula.h).
 */
#ifndef FMB_IO_READING_H
#define FMB_IO_READING_H

#include "io/smt2/term.h"

/* ---- one reading, by any reader -------------------------------------------------------------- */

/* Execute the command whose '(' is at open, just before the cursor. Errors: PARSE, MEMORY. */
fmb_smt_command fmb_smt_run_command;
/* Execute it by `run`; a command that needs facts which may still be found is skipped. */
fmb_status fmb_smt_run(fmb_smt *r, const char *open, fmb_smt_command *run);
/* Begin a reading, with the facts of the readings before. */
void fmb_smt_begin_reading(fmb_smt_facts *facts);
/* End a reading with st; *again: another one, with more facts, must follow. Errors: PARSE, st. */
fmb_status fmb_smt_end_reading(fmb_cursor *c, const fmb_smt_facts *facts, fmb_status st,
                               bool *again);

/* ---- one that goes on ------------------------------------------------------------------------ */

typedef struct fmb_smt_reading {
    fmb_cursor c;
    fmb_where at; /* the error, for c */
    fmb_reader silent;
    fmb_smt_facts facts;
    fmb_system *s; /* the rows read so far; NULL: no reading was begun */
    fmb_smt r;
} fmb_smt_reading;

/* A state of a reading, by the sizes of all its lists. */
typedef struct fmb_smt_mark {
    size_t rows, nodes, formulas, givens, macros, params, budget;
    size_t tolds, declared, open;
    int dim;
    bool learned, objective;
} fmb_smt_mark;

/* A reading of a checked text, not yet begun; how and mem outlive it. */
fmb_smt_reading fmb_smt_reading_of(const char *text, size_t size, const fmb_reader *how,
                                   fmb_mem *mem);
/* Begin, or restart with the facts found so far. Errors: MEMORY. */
fmb_status fmb_smt_reading_begin(fmb_smt_reading *g);
/* Discard everything read, and all facts. */
void fmb_smt_reading_drop(fmb_smt_reading *g);

fmb_smt_mark fmb_smt_reading_mark(const fmb_smt_reading *g);
/* Undo all after a mark of this reading, which must not have begun with facts found after it. */
void fmb_smt_reading_return(fmb_smt_reading *g, const fmb_smt_mark *m);

#endif
