/* folder.c: see folder.h. */
#include "fmb-qualify/folder.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/file.h"
#include "common/message.h"

int qualify_folder_make(const char *folder)
{
    struct stat info;
    if (mkdir(folder, 0777) == 0)
        return APP_YES;
    if (errno == EEXIST && stat(folder, &info) == 0 && S_ISDIR(info.st_mode))
        return APP_YES;
    return app_error(APP_CANNOT_WRITE, "%s: %s", folder, strerror(errno));
}

int qualify_folder_write(const char *folder, const char *file,
                         void (*put)(FILE *f, const void *what), const void *what)
{
    FILE *f = NULL;
    char *path;
    if (asprintf(&path, "%s/%s", folder, file) < 0)
        app_need(NULL);
    int code = app_file_create(path, &f);
    if (code == APP_YES) {
        put(f, what);
        code = app_file_close(f, path);
    }
    free(path);
    return code;
}
