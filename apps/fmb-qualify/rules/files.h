/* files.h: systems from files, and the variables that each file marks as kept. */
#ifndef QUALIFY_FILES_H
#define QUALIFY_FILES_H

#include "study/grid/grid.h"

/* Add a sample with the system in the file, or without one if read is false. An exit code, after a
 * message unless 0. Borrows path. */
int qualify_files_add(study_grid *g, const char *path, bool read);

/* [give, free()] The system of a case, perhaps reduced, as .fmb; marks the case's kept variables.
 */
char *qualify_system_text(fmb_system *s, const study_case *c);

#endif
