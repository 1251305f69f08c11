/* view.h: the implementation of the window of <fmb/rule.h>. */
#ifndef FMB_ELIM_VIEW_H
#define FMB_ELIM_VIEW_H

#include "elim/store/store.h"

typedef struct fmb_scratch fmb_scratch;

struct fmb_view {
    fmb_elim *e;
    const fmb_rule *rule; /* being called; NULL: a chooser is */
    const uint32_t *lower, *upper;
    size_t lowers, uppers;
    int var;               /* of the round, -1: between rounds */
    fmb_scratch **scratch; /* blocks to release after the callback */
    fmb_status *status;    /* the first failure inside an accessor */
};

/* A view on its owner's stack frame; close it after every callback. */
typedef struct fmb_window {
    fmb_view view;
    fmb_scratch *blocks;
    fmb_status failed;
} fmb_window;

void fmb_window_open(fmb_window *w, fmb_elim *e, const fmb_rule *rule, int var);
/* Release the scratch blocks; returns the first failure of an accessor. */
fmb_status fmb_window_close(fmb_window *w);

#endif
