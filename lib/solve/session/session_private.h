/* session_private.h: a system that changes, and the oracle that stays with it.
 *
 * The system is an ordinary one; changes (session_state.h) are made to it at once, and noted. What
 * the oracle knows of it follows when it is asked.
 */
#ifndef FMB_SOLVE_SESSION_SESSION_PRIVATE_H
#define FMB_SOLVE_SESSION_SESSION_PRIVATE_H

#include <fmb/session.h>

#include "lp/oracle/oracle.h"

typedef struct fmb_session fmb_session;

/* [give] s is copied; *handles counts the rows that there have been. Errors: MEMORY. */
fmb_status fmb_session_new(fmb_mem *mem, const fmb_system *s, fmb_row *handles, fmb_session **out);
void fmb_session_free(fmb_session *c);
const fmb_system *fmb_session_system(const fmb_session *c);

/* A query begins to ask: its oracle, over all variables, catches up with the system, within the
 * limits of the run. Errors: MEMORY, LIMIT: fmb_session_forget then. */
fmb_status fmb_session_enter(fmb_session *c, const fmb_run *run);
fmb_oracle *fmb_session_oracle(const fmb_session *c);
/* It asks no more: counters and stop go to its run. */
void fmb_session_leave(fmb_session *c, fmb_run *run);
/* The next query begins with nothing. */
void fmb_session_forget(fmb_session *c);
/* Weights of the oracle, while a query asks, become such over the integers of rows of the system.
 */
void fmb_session_take_weights(const fmb_session *c, fmb_weights *w);

#endif
