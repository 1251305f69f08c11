/* render.c: see render.h. The scripts lie beside this program, as it is built, or where it was
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
static char *find_script(const char *name)
{
    static const char *const PLACE[] = {"%s/%s", "%s/../share/fmb/%s"};
    enum { PLACES = sizeof PLACE / sizeof *PLACE };
    char self[4096], *path = NULL;
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    self[length > 0 ? length : 0] = '\0';
    const char *folder = dirname(self);
    for (size_t i = 0; !path && i <= PLACES; i++) {
        if (asprintf(&path, i < PLACES ? PLACE[i] : "%s/%s", i < PLACES ? folder : QUALIFY_DATA,
                     name) < 0)
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
static _Noreturn void become_python(const char *script, const char *const argument[2])
{
    setpgid(0, 0);
    execlp("python3", "python3", "-B", script, argument[0], argument[1], (char *)NULL);
    _exit(errno == ENOENT ? NOT_FOUND : NOT_STARTED);
}

static qualify_rendered run_script(const char *script, const char *const argument[2])
{
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        become_python(script, argument);
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND)
        return QUALIFY_NO_PYTHON;
    return child > 0 && status == 0 ? QUALIFY_RENDERED : QUALIFY_NOT_RENDERED;
}

qualify_rendered qualify_render(const char *name, const char *first, const char *second)
{
    char *script = find_script(name);
    qualify_rendered how = QUALIFY_NO_SCRIPT;
    if (script)
        how = run_script(script, (const char *const[2]){first, second});
    if (how == QUALIFY_NO_PYTHON)
        app_error(0,
                  "python3 is not installed: report.html and the figures are missing; with it, "
                  "`python3 %s %s%s%s` makes them",
                  script, first, second ? " " : "", second ? second : "");
    if (how == QUALIFY_NO_SCRIPT)
        app_error(0, "%s is not installed: report.html and the figures are missing", name);
    free(script);
    return how;
}
