/* machine.c: see machine.h. */
#include "common/machine.h"

#include <stdio.h>
#include <string.h>

#include "common/commit.h"

/* The processor's name, as Linux tells it. */
static void find_cpu(char *name, size_t size)
{
    char line[256];
    FILE *f = fopen("/proc/cpuinfo", "r");
    snprintf(name, size, "unknown");
    while (f && fgets(line, sizeof line, f)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !colon)
            continue;
        snprintf(name, size, "%s", colon + 2);
        name[strcspn(name, "\n")] = '\0';
        break;
    }
    if (f)
        fclose(f);
}

app_machine app_machine_find(void)
{
    app_machine m = {.compiler = __VERSION__, .flags = APP_FLAGS, .commit = APP_COMMIT};
    find_cpu(m.cpu, sizeof m.cpu);
    return m;
}
