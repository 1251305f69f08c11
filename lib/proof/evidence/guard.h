/* guard.h: the limits of a caller who reads or checks a proof. */
#ifndef FMB_PROOF_GUARD_H
#define FMB_PROOF_GUARD_H

#include <fmb/proof.h>

#include "base/mem.h"
#include "base/poll.h"

/* A caller's limits, which count from fmb_guard_begin on. */
typedef struct fmb_guard {
    fmb_patience patience;
    double deadline; /* 0: none */
    unsigned asked;  /* polls so far: the clock is read at every 16th */
    fmb_stop stop;   /* the limit reached, if one of time, or CANCELLED */
} fmb_guard;

/* patience NULL: no limits. From here on the memory charged to mem is limited. Errors: ARG (invalid
 * limits). */
fmb_status fmb_guard_begin(fmb_guard *g, const fmb_patience *patience, fmb_mem *mem);
/* A poll that returns FMB_LIMIT once a limit is reached, and ever after. */
fmb_poll fmb_guard_poll(fmb_guard *g);
/* The reason of an FMB_LIMIT from a function that used the guard or the memory. */
fmb_stop fmb_guard_stop(const fmb_guard *g);

#endif
