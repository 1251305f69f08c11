/* files.h: systems from files, and the variables that each file wants to keep. */
#ifndef QUALIFY_FILES_H
#define QUALIFY_FILES_H

#include "study/grid/grid.h"

/* Add a sample with the system in the file, or, unless read, with none: an exit code, after a
 * message unless 0. Keeps path. */
int qualify_files_add(study_grid *g, const char *path, bool read);

/* [give, free()] The system of a case, or what is left of it, as .fmb; marks the variables that the
 * case keeps. */
char *qualify_system_text(fmb_system *s, const study_case *c);

#endif
