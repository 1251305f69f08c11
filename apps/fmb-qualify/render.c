/* render.c: see render.h. The script lies beside this program, as it is built, or where it was
 * installed. */
#include "fmb-qualify/render.h"

#include <errno.h>
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/message.h"

enum { NOT_FOUND = 127, NOT_STARTED = 126 };

/* [give, free()] NULL if it is nowhere. */
static char *find_script(void)
{
    static const char *const PLACE[] = {"%s/report.py", "%s/../share/fmb/report.py",
                                        QUALIFY_DATA "/report.py"};
    char self[4096], *path = NULL;
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    self[length > 0 ? length : 0] = '\0';
    const char *folder = dirname(self);
    for (size_t i = 0; !path && i < sizeof PLACE / sizeof *PLACE; i++) {
        if (asprintf(&path, PLACE[i], folder) < 0)
            app_need(NULL);
        if (access(path, R_OK) == 0)
            continue;
        free(path);
        path = NULL;
    }
    return path;
}

/* In a group of its own the child outlives a Ctrl-C that is meant for us: what is measured is to be
 * drawn. */
static _Noreturn void become_python(const char *script, const char *folder)
{
    setpgid(0, 0);
    execlp("python3", "python3", "-B", script, folder, (char *)NULL);
    _exit(errno == ENOENT ? NOT_FOUND : NOT_STARTED);
}

static int run_script(const char *script, const char *folder)
{
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        become_python(script, folder);
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND) {
        app_error(0,
                  "python3 is not installed: report.html and the figures are missing; with it, "
                  "`python3 %s %s` makes them",
                  script, folder);
        return APP_YES;
    }
    if (child > 0 && status == 0)
        return APP_YES;
    return app_error(APP_INTERNAL, "report.html and the figures of %s could not be made", folder);
}

int qualify_render(const char *folder)
{
    char *script = find_script();
    int code = APP_YES;
    if (script)
        code = run_script(script, folder);
    else
        app_error(0, "report.py is not installed: report.html and the figures are missing");
    free(script);
    return code;
}
