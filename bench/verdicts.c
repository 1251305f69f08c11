/* verdicts.c: verdicts on bench-tiny's problems, timed: built here and for WebAssembly, so that
 * both can be compared. All systems are made first; a pass asks each once, with one solver and no
 * evidence. The median of several passes, in processor time, for each kind and for all. usage:
 * verdicts [PASSES [PAIRS]] */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#endif

#include <fmb/fmb.h>

#include "shapes.h"

typedef struct item {
    char kind[16];
    fmb_system *s;
} item;

/* Processor time [s]; Emscripten's clocks know none, but Node does. */
#ifdef __EMSCRIPTEN__
EM_JS(double, seconds, (void), {
    const used = process.cpuUsage();
    return (used.user + used.system) / 1e6;
});
#else
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
#endif

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Seconds for all items of a kind (NULL: of any); their number, and how many are feasible. */
static double pass(fmb_solver *v, const item *list, unsigned n, const char *kind, unsigned *asked,
                   unsigned *feasible)
{
    *asked = *feasible = 0;
    double begin = seconds();
    for (unsigned i = 0; i < n; i++) {
        if (kind && strcmp(kind, list[i].kind) != 0)
            continue;
        fmb_result r = {.size = sizeof r};
        if (fmb_solve(v, list[i].s, &r) != FMB_OK)
            exit(70);
        ++*asked;
        *feasible += r.verdict == FMB_FEASIBLE;
    }
    return seconds() - begin;
}

static void measure(fmb_solver *v, const item *list, unsigned n, const char *kind, int passes)
{
    double *time = calloc((size_t)passes, sizeof *time);
    unsigned asked, feasible;
    if (!time)
        exit(70);
    pass(v, list, n, kind, &asked, &feasible);
    for (int k = 0; k < passes; k++)
        time[k] = pass(v, list, n, kind, &asked, &feasible);
    qsort(time, (size_t)passes, sizeof *time, compare);
    printf("%s %u %u %.3f\n", kind ? kind : "all", asked, feasible, 1e6 * time[passes / 2] / asked);
    free(time);
}

int main(int argc, char **argv)
{
    int passes = argc > 1 ? atoi(argv[1]) : 9;
    unsigned n = argc > 2 ? (unsigned)atoi(argv[2]) : 7168;
    fmb_options o = {.size = sizeof o, .evidence = FMB_EVIDENCE_NONE};
    fmb_solver *v = NULL;
    item *list = calloc(n, sizeof *list);
    if (!list || passes < 1 || fmb_solver_new(&o, NULL, &v) != FMB_OK)
        return 70;
    for (unsigned i = 0; i < n; i++)
        if (!(list[i].s = shape_pair(i, list[i].kind)))
            return 70;
    unsigned asked, feasible;
    for (int k = 0; k < 3; k++) /* warm-up, for engines that compile hot code */
        pass(v, list, n, NULL, &asked, &feasible);
    for (unsigned i = 0; i < SHAPE_KINDS && i < n; i++)
        measure(v, list, n, list[i].kind, passes);
    measure(v, list, n, NULL, passes);
    for (unsigned i = 0; i < n; i++)
        fmb_system_free(list[i].s);
    free(list);
    fmb_solver_free(v);
}
