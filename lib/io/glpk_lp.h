/* glpk_lp.h: a CPLEX LP text checked and made ready for GLPK. */
#ifndef FMB_IO_GLPK_LP_H
#define FMB_IO_GLPK_LP_H

#include "io/glpk_decimals.h"

/* What a bounds section waits for. */
typedef enum fmb_lp_state {
    FMB_LP_START = 0, /* a bound, or a variable */
    FMB_LP_LOW_SIGN,  /* - of -1 <= x */
    FMB_LP_LOW,       /* -1 of -1 <= x */
    FMB_LP_LOW_REL,   /* <= of -1 <= x */
    FMB_LP_BETWEEN,   /* x of -1 <= x, or of -1 <= x <= 1 */
    FMB_LP_NAME,      /* x of x <= 1 or x free */
    FMB_LP_HIGH_REL,  /* <= of x <= 1 */
    FMB_LP_HIGH_SIGN  /* - of x <= -1 */
} fmb_lp_state;

typedef struct fmb_lp_edit {
    fmb_cursor *c;
    fmb_decimals *numbers;
    bool bounds; /* in the bounds section */
    fmb_lp_state state;
    char *text;
    size_t size, capacity;
} fmb_lp_edit;

void fmb_lp_edit_init(fmb_lp_edit *e, fmb_cursor *c, fmb_decimals *numbers);
void fmb_lp_edit_clear(fmb_lp_edit *e);
/* The whole text of the cursor into e->text; its numbers are noted. Errors: MEMORY, PARSE. */
fmb_status fmb_lp_edit_run(fmb_lp_edit *e);

#endif
