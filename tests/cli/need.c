/* need.c: memory that runs out is told once, in JSON, too, and while what argp writes is caught. */
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/message.h"

static const char due[] = "{\"error\": {\"file\": null, \"line\": null, \"column\": null, "
                          "\"text\": \"out of memory\", \"exit\": 70}}\n";

int main(void)
{
    int ends[2], status = 0;
    char said[1000] = "";
    size_t size = 0;
    if (pipe(ends) != 0)
        return 1;
    pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        app_errors_as_json();
        app_errors_capture("test");
        app_need(NULL);
    }
    close(ends[1]);
    for (ssize_t n; (n = read(ends[0], said + size, sizeof said - 1 - size)) > 0;)
        size += (size_t)n;
    waitpid(child, &status, 0);
    printf("exit %d: %s", WEXITSTATUS(status), said);
    return WEXITSTATUS(status) != APP_INTERNAL || strcmp(said, due) != 0;
}
