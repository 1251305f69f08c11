/* machine.c: see machine.h. */
#include "common/machine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "common/commit.h"

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

/* What stands behind the key in a line of the file, without quotes. */
static void find_in_file(const char *file, const char *key, char *out, size_t size)
{
    char line[256];
    FILE *f = fopen(file, "r");
    snprintf(out, size, "unknown");
    while (f && fgets(line, sizeof line, f)) {
        if (strncmp(line, key, strlen(key)) != 0)
            continue;
        char *text = line + strlen(key);
        text += strspn(text, "\t :=\"");
        text[strcspn(text, "\"\n")] = '\0';
        snprintf(out, size, "%s", text);
        break;
    }
    if (f)
        fclose(f);
}

app_machine app_machine_find(void)
{
    app_machine m = {.cores = sysconf(_SC_NPROCESSORS_ONLN),
                     .memory = (uint64_t)sysconf(_SC_PHYS_PAGES) * (uint64_t)sysconf(_SC_PAGESIZE),
                     .compiler = COMPILER,
                     .flags = APP_FLAGS,
                     .commit = APP_COMMIT};
    struct utsname name;
    find_in_file("/proc/cpuinfo", "model name", m.cpu, sizeof m.cpu);
    find_in_file("/etc/os-release", "PRETTY_NAME", m.os, sizeof m.os);
    snprintf(m.kernel, sizeof m.kernel, "%s", uname(&name) == 0 ? name.release : "unknown");
    if (getloadavg(&m.load, 1) != 1)
        m.load = 0;
    return m;
}
