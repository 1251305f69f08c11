/* render.c: see render.h. The scripts are beside this program in a build folder, or in the
 * installed data folder. */
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

/* [give, free()] NULL if it is not found. */
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

/* In a process group of its own the child survives a Ctrl-C meant for us: the measured results are
 * still drawn. */
static _Noreturn void become_python(char **words)
{
    setpgid(0, 0);
    execvp(words[0], words);
    _exit(errno == ENOENT ? NOT_FOUND : NOT_STARTED);
}

/* [give, free()] `python3 -B SCRIPT ARGUMENT...`, as execvp takes it. */
static char **words_of(const char *script, const char *const *arguments)
{
    size_t count = 0;
    while (arguments[count])
        count++;
    const char **words = app_need(calloc(count + 4, sizeof *words));
    words[0] = "python3";
    words[1] = "-B";
    words[2] = script;
    memcpy(words + 3, arguments, count * sizeof *words);
    return (char **)words;
}

static qualify_rendered run_script(char **words)
{
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        become_python(words);
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND)
        return QUALIFY_NO_PYTHON;
    return child > 0 && status == 0 ? QUALIFY_RENDERED : QUALIFY_NOT_RENDERED;
}

static void tell_command(char **words)
{
    char *text = NULL;
    size_t length;
    FILE *line = app_need(open_memstream(&text, &length));
    for (size_t i = 0; words[i]; i++)
        fprintf(line, "%s%s", i ? " " : "", words[i]);
    fclose(line);
    app_error(0,
              "python3 is not installed: report.html and the figures are missing; with it, `%s` "
              "makes them",
              (char *)app_need(text));
    free(text);
}

qualify_rendered qualify_render(const char *name, const char *const *arguments)
{
    char *script = find_script(name);
    if (!script) {
        app_error(0, "%s is not installed: report.html and the figures are missing", name);
        return QUALIFY_NO_SCRIPT;
    }
    char **words = words_of(script, arguments);
    qualify_rendered how = run_script(words);
    if (how == QUALIFY_NO_PYTHON)
        tell_command(words);
    free(words);
    free(script);
    return how;
}
