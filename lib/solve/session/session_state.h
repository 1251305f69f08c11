/* session_state.h: the layout of a session, and its changes.
 *
 * The oracle's program numbers its rows independently: these *slots* are never renumbered. A new
 * row of the system takes a new slot, a removed one leaves its slot switched off, and one with a
 * new right side keeps its slot if that side is an integer at the slot's scale. So a change costs
 * only its work on the system; changes undone before the next query cost the oracle nothing; and if
 * the update of the oracle fails, the oracle is discarded and built anew.
 *
 * Invariants: slots of rows are distinct, and handles increase from row to row: new rows come last,
 * and a restored row takes its former place. An entry of the journal is undone after all later
 * ones, so there is room for the row that it restores.
 */
#ifndef FMB_SOLVE_SESSION_SESSION_STATE_H
#define FMB_SOLVE_SESSION_SESSION_STATE_H

#include "solve/session/session_private.h"
#include "system/system_private.h"

#define FMB_NO_SLOT SIZE_MAX

typedef struct fmb_session_row {
    fmb_row handle; /* increasing from row to row, as new rows come last */
    size_t slot;    /* a row of the program, or FMB_NO_SLOT */
    bool shifted;   /* the right side is not yet that of the slot */
} fmb_session_row;

typedef enum fmb_change_kind {
    FMB_CHANGE_ADDED = 0, /* the last row */
    FMB_CHANGE_REMOVED,
    FMB_CHANGE_RIGHT,
    FMB_CHANGE_LABEL,
    FMB_CHANGE_VARIABLE /* the last variable was added */
} fmb_change_kind;

typedef struct fmb_change {
    fmb_change_kind kind;
    size_t row;
    fmb_sysrow old;        /* of REMOVED and RIGHT; of LABEL the label alone */
    fmb_session_row place; /* of REMOVED: its handle and slot */
} fmb_change;

struct fmb_session {
    fmb_mem *mem;
    fmb_system *s;
    fmb_row *handles;     /* counts all rows there have been, over all systems */
    fmb_session_row *row; /* [rows of s] */
    size_t row_room;
    fmb_change *journal; /* [changes] since the first level was begun */
    size_t changes, change_room;
    size_t *level; /* [levels] number of changes when the level was begun */
    size_t levels, level_room;
    /* The oracle and its program; see warm.c. */
    fmb_run run;         /* of the current query */
    fmb_program program; /* owns its values */
    fmb_oracle *oracle;  /* NULL: there is no program either */
    size_t *source;      /* [rows of program] the row of s at each slot, during a query */
    size_t source_room;
};

/* Before a change: reserve room for a row and a journal entry. Errors: MEMORY. */
fmb_status fmb_session_reserve(fmb_session *c);
/* A row was appended to the system. */
void fmb_session_note_added(fmb_session *c);
/* Remove row i. */
void fmb_session_remove(fmb_session *c, size_t i);
/* Set the right side of row i. Errors: ARG, MEMORY. */
fmb_status fmb_session_set_right(fmb_session *c, size_t i, const mpq_t b);
/* Set the label of row i to a copy, or to none. Errors: MEMORY. */
fmb_status fmb_session_set_label(fmb_session *c, size_t i, const char *label);
/* A variable was appended to the system. */
void fmb_session_note_variable(fmb_session *c);
/* The number of the row with this handle, SIZE_MAX if there is none. */
size_t fmb_session_find(const fmb_session *c, fmb_row handle);
/* Begin a level (Errors: MEMORY). Below: end it and undo its changes. */
fmb_status fmb_session_push(fmb_session *c);
void fmb_session_pop(fmb_session *c);

#endif
