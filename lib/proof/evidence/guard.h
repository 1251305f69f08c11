/* guard.h: limits of whoever reads or judges a proof. */
#ifndef FMB_PROOF_GUARD_H
#define FMB_PROOF_GUARD_H

#include <fmb/proof.h>

#include "base/mem.h"
#include "base/poll.h"

/* A caller's patience, from the moment it began to wait. */
typedef struct fmb_guard {
    fmb_patience patience;
    double deadline; /* 0: none */
    unsigned asked;  /* the clock is read at every 16th call */
    fmb_stop stop;   /* the first limit of time that was reached, or CANCELLED */
} fmb_guard;

/* patience NULL: for ever. What is charged to mem is limited from here on. Errors: ARG (limits that
 * are none). */
fmb_status fmb_guard_begin(fmb_guard *g, const fmb_patience *patience, fmb_mem *mem);
/* A poll; FMB_LIMIT when a limit is reached, and ever after. */
fmb_poll fmb_guard_poll(fmb_guard *g);
/* Why FMB_LIMIT was returned by something that used the guard or memory. */
fmb_stop fmb_guard_stop(const fmb_guard *g);

#endif
