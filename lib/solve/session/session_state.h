/* session_state.h: the inside of a session, and its changes.
 *
 * The oracle's program has rows of its own numbers, *slots*, which are never renumbered. A row of
 * the system that is new takes a new slot, one that is gone leaves its slot switched off, and one
 * whose right side has changed keeps its slot if that is an integer there. So a change costs what
 * it costs the system; changes that are undone before anybody asks cost the oracle nothing; and
 * whatever fails while it follows, it is forgotten and made anew.
 *
 * Invariants: slots of rows are distinct, handles increase from row to row: rows come last, and one
 * that comes back takes its place again. An entry of the journal is undone after all later ones,
 * so that there is room for the row that it puts back.
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
    fmb_session_row place; /* of REMOVED */
} fmb_change;

struct fmb_session {
    fmb_mem *mem;
    fmb_system *s;
    fmb_row *handles;     /* how many there have been, whatever was loaded */
    fmb_session_row *row; /* [rows of s] */
    size_t row_room;
    fmb_change *journal; /* [changes] since the first level was begun */
    size_t changes, change_room;
    size_t *level; /* [levels] changes that there were when it was begun */
    size_t levels, level_room;
    /* What the oracle knows, warm.c. */
    fmb_run run;         /* of the query at hand */
    fmb_program program; /* owns its values */
    fmb_oracle *oracle;  /* NULL: there is no program either */
    size_t *source;      /* [rows of program] its row of s, while a query asks */
    size_t source_room;
};

/* Before a change: room for a row, and for a note of it. Errors: MEMORY. */
fmb_status fmb_session_reserve(fmb_session *c);
/* A row was appended to the system. */
void fmb_session_note_added(fmb_session *c);
/* Row i goes. */
void fmb_session_remove(fmb_session *c, size_t i);
/* Row i gets another right side. Errors: ARG, MEMORY. */
fmb_status fmb_session_set_right(fmb_session *c, size_t i, const mpq_t b);
/* Row i gets a copy of that label, or none. Errors: MEMORY. */
fmb_status fmb_session_set_label(fmb_session *c, size_t i, const char *label);
/* A variable was appended to the system. */
void fmb_session_note_variable(fmb_session *c);
/* The number of a row by its handle, SIZE_MAX where it is not there. */
size_t fmb_session_find(const fmb_session *c, fmb_row handle);
/* A level is begun (Errors: MEMORY); it ends, and its changes are undone. */
fmb_status fmb_session_push(fmb_session *c);
void fmb_session_pop(fmb_session *c);

#endif
