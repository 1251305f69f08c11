/* machine.c: see machine.h. */
#include "machine.h"

#include <stdlib.h>
#include <time.h>

#include "common/machine.h"

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

void print_machine_json(FILE *out)
{
    app_machine m = app_machine_find();
    fprintf(out, "\"machine\": ");
    print_string(out, m.cpu);
    fprintf(out, ", \"cores\": %ld, \"load\": %.2f, \"os\": ", m.cores, m.load);
    print_string(out, m.os);
    fprintf(out, ", \"kernel\": ");
    print_string(out, m.kernel);
    fprintf(out, ", \"compiler\": ");
    print_string(out, m.compiler);
    fprintf(out, ", \"flags\": ");
    print_string(out, m.flags);
    fprintf(out, ", \"commit\": ");
    print_string(out, m.commit);
}
