/* form.h: a linear form on the command line. */
#ifndef APP_FORM_H
#define APP_FORM_H

#include <fmb/io.h>

/* Make the text of the option ("--max"), "3x + 2y", the objective of s: APP_YES, or APP_USAGE after
 * a message that shows the place of the error. */
int app_form_read(const char *option, const char *text, fmb_sense sense, fmb_system *s);

#endif
