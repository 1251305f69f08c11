/* glpk_run.h: GLPK's readers, without its terminal, its aborts and its ideas of locale.
 *
 * Source: GLPK 5.0 Reference Manual, 2020, sections 2.9 (problem data files) and 6.1 (environment).
 */
#ifndef FMB_IO_GLPK_RUN_H
#define FMB_IO_GLPK_RUN_H

#include <glpk.h>
#include <locale.h>

#include "io/io.h"

typedef enum fmb_glpk_form { FMB_GLPK_FIXED = 0, FMB_GLPK_FREE, FMB_GLPK_LP } fmb_glpk_form;

/* GLPK in this thread, from open to close: with the C locale, and silent. */
typedef struct fmb_glpk {
    fmb_cursor *c;
    bool ours; /* the environment did not exist before */
    int term;  /* was its terminal on? */
    locale_t c_locale, old_locale;
    char *log; /* what GLPK has said in the last call */
    size_t size, capacity;
    bool lost; /* the log ran out of memory */
    char file[32];
} fmb_glpk;

/* Errors: MEMORY. */
fmb_status fmb_glpk_open(fmb_glpk *g, fmb_cursor *c);
void fmb_glpk_close(fmb_glpk *g);
/* Read a text into p. Errors: PARSE (the log says why), MEMORY, IO. */
fmb_status fmb_glpk_read(fmb_glpk *g, fmb_glpk_form form, fmb_span text, glp_prob **p);

/* Line of the last message, 0 if it has none. */
long fmb_glpk_line(const fmb_glpk *g);
/* The last message as an error. */
fmb_status fmb_glpk_fail(const fmb_glpk *g);
/* Pass on warnings; data that was left out is an error. Errors: PARSE. */
fmb_status fmb_glpk_warn(const fmb_glpk *g);

#endif
