/* machine.c: see machine.h. */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench_commit.h"
#include "machine.h"

double thread_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double median(double *times, int n)
{
    qsort(times, (size_t)n, sizeof *times, by_size);
    return n % 2 ? times[n / 2] : (times[n / 2 - 1] + times[n / 2]) / 2;
}

/* The text as a JSON string; control bytes become blanks. */
static void print_string(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            fputc('\\', out);
        fputc((unsigned char)*text < ' ' ? ' ' : *text, out);
    }
    fputc('"', out);
}

/* The processor's name, as Linux tells it. */
static void cpu_name(char *name, size_t size)
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

void print_machine_json(FILE *out)
{
    char name[200];
    cpu_name(name, sizeof name);
    fprintf(out, "\"machine\": ");
    print_string(out, name);
    fprintf(out, ", \"compiler\": ");
    print_string(out, __VERSION__);
    fprintf(out, ", \"flags\": ");
    print_string(out, BENCH_FLAGS);
    fprintf(out, ", \"commit\": ");
    print_string(out, BENCH_COMMIT);
}
