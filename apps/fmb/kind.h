/* kind.h: the kind of a file that its command could not read. */
#ifndef APP_KIND_H
#define APP_KIND_H

#include "common/source.h"

/* The kind of the first library reader that accepts the file; if none does, the kind by its name. A
 * file that cannot be read twice, such as a pipe, is judged by its name ("-": standard input). */
app_kind app_kind_of(const char *path);

#endif
