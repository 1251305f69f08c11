/* folder.h: folders for the files of studies. */
#ifndef QUALIFY_FOLDER_H
#define QUALIFY_FOLDER_H

#include <stdio.h>

/* Make the folder; it may exist, but not as a file. An exit code, after a message unless it is
 * APP_YES. */
int qualify_folder_make(const char *folder);
/* The file in it, written by put(f, what). An exit code, as above. */
int qualify_folder_write(const char *folder, const char *file,
                         void (*put)(FILE *f, const void *what), const void *what);

#endif
