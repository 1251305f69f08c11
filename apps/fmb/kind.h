/* kind.h: what a file holds that its command could not read. */
#ifndef APP_KIND_H
#define APP_KIND_H

#include "common/source.h"

/* Whichever reader of the library takes the file; if none does, what its name says. What cannot be
 * read twice, as a pipe, has its name alone ("-" is standard input). */
app_kind app_kind_of(const char *path);

#endif
