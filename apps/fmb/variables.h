/* variables.h: variables named on a command line ("x,y"). */
#ifndef APP_VARIABLES_H
#define APP_VARIABLES_H

#include <fmb/system.h>

/* The most lists of one option, which may be given repeatedly. */
enum { APP_MOST_LISTS = 256 };

typedef struct app_names {
    const char *option; /* "--keep", for messages */
    const char *list[APP_MOST_LISTS];
    int lists;
} app_names;

/* Add one list; false if there is no room. */
bool app_names_add(app_names *names, const char *list);

/* [give, free()] The named variables (named true) or the others, increasing. A list that is itself
 * the name of a variable means that variable, so that names with commas can be given, too. APP_YES,
 * or APP_USAGE with a message. */
int app_names_select(const app_names *names, const fmb_system *s, bool named, int **vars, int *n);

#endif
