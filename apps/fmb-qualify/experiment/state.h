/* state.h: which blocks of an experiment a file of CSV holds: the file itself is the state. */
#ifndef QUALIFY_STATE_H
#define QUALIFY_STATE_H

#include "fmb-qualify/experiment/experiment.h"

/* Mark the blocks that are whole, done[blocks], and set *end behind the last of them [bytes]; what
 * comes behind is a block that was being written. A file that is empty or not there holds none, and
 * *end is 0. An exit code, after a message: a file of another plan is refused. */
int qualify_state_read(const qualify_experiment *e, const char *path, bool *done, long *end);

#endif
