/* folder.h: folders for what studies leave. */
#ifndef QUALIFY_FOLDER_H
#define QUALIFY_FOLDER_H

#include <stdio.h>

/* Make the folder; one that is there is fine, a file is not. An exit code, after a message unless
 * it is APP_YES. */
int qualify_folder_make(const char *folder);
/* The file in it, written by put(f, what). An exit code, as above. */
int qualify_folder_write(const char *folder, const char *file,
                         void (*put)(FILE *f, const void *what), const void *what);

#endif
