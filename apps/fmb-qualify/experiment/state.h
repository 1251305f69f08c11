/* state.h: which blocks of an experiment a file of CSV holds: the file itself is the state. */
#ifndef QUALIFY_STATE_H
#define QUALIFY_STATE_H

#include "fmb-qualify/experiment/experiment.h"

/* Mark the complete blocks, done[blocks], and set *end to the end of the last one [bytes]; an
 * interrupted block may follow. A file that is empty or does not exist holds none, and *end is 0.
 * An exit code, after a message: a file of another plan is refused. */
int qualify_state_read(const qualify_experiment *e, const char *path, bool *done, long *end);

#endif
