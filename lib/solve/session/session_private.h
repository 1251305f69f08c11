/* session_private.h: a system that changes between queries, with an oracle that is kept.
 *
 * The system is an ordinary one; changes (session_state.h) are made to it at once and recorded in a
 * journal. The oracle's program is brought up to date when a query begins.
 */
#ifndef FMB_SOLVE_SESSION_SESSION_PRIVATE_H
#define FMB_SOLVE_SESSION_SESSION_PRIVATE_H

#include <fmb/session.h>

#include "lp/oracle/oracle.h"

typedef struct fmb_session fmb_session;

/* [give] s is copied; *handles counts the rows of all systems so far. Errors: MEMORY. */
fmb_status fmb_session_new(fmb_mem *mem, const fmb_system *s, fmb_row *handles, fmb_session **out);
void fmb_session_free(fmb_session *c);
const fmb_system *fmb_session_system(const fmb_session *c);

/* A query begins: bring the oracle, over all variables, up to date with the system, within the
 * limits of the run. Errors: MEMORY, LIMIT: call fmb_session_forget then. */
fmb_status fmb_session_enter(fmb_session *c, const fmb_run *run);
fmb_oracle *fmb_session_oracle(const fmb_session *c);
/* The query stops using the oracle: add counters to its run, and copy the stop. */
void fmb_session_leave(fmb_session *c, fmb_run *run);
/* Discard the oracle; the next query builds a new one. */
void fmb_session_forget(fmb_session *c);
/* During a query: convert weights of the oracle into weights of the system's integer rows. */
void fmb_session_take_weights(const fmb_session *c, fmb_weights *w);

#endif
