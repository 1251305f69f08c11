/* gnuplot.c: see gnuplot.h. */
#include "qualify/gnuplot.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/message.h"

enum { NOT_FOUND = 127, NOT_STARTED = 126 };

/* gnuplot knows no other way to change folders before it opens its script. In a group of its own
 * the child outlives a Ctrl-C that is meant for us: what is measured is to be drawn. */
static _Noreturn void become_gnuplot(const char *folder, const char *script)
{
    setpgid(0, 0);
    if (chdir(folder) == 0)
        execlp("gnuplot", "gnuplot", script, (char *)NULL);
    _exit(errno == ENOENT ? NOT_FOUND : NOT_STARTED);
}

qualify_drawn qualify_gnuplot(const char *folder, const char *script)
{
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        become_gnuplot(folder, script);
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND)
        return QUALIFY_NO_GNUPLOT;
    if (child > 0 && status == 0)
        return QUALIFY_DRAWN;
    app_error(0, "gnuplot failed on %s/%s", folder, script);
    return QUALIFY_NOT_DRAWN;
}
