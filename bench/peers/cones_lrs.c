/* cones_lrs.c: lrs, reverse search, as the program of that name: its time is that of the process,
 * with reading and printing, minus the time for a single row. Outside the clock: the file it reads.
 */
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "peers.h"

/* The time of a run that takes no longer than the start [s]. */
static const double LEAST_SECONDS = 1e-6;

typedef struct state {
    char in[32], row[32], out[32];
    bool hull;
    double seconds; /* limit of a run */
    double took;    /* CPU time of the last run, without the start [s] */
} state;

/* A new temporary file by this template. */
static FILE *open_temporary(char *name)
{
    int fd = mkstemp(name);
    return fd < 0 ? need(NULL) : need(fdopen(fd, "w"));
}

/* Without an objective, which would tell lrs to stop at its best vertex. */
static void write_rows(const problem *p, bool hull, FILE *out)
{
    fprintf(out, "%c-representation\n", hull ? 'V' : 'H');
    if (p->equalities > 0)
        fprintf(out, "linearity %zu", p->equalities);
    for (size_t i = 0; i < p->m; i++)
        if (p->rows[i].rel == FMB_EQ)
            fprintf(out, " %zu", i + 1);
    fprintf(out, "\nbegin\n%zu %d rational\n", p->m, p->n + 1);
    for (size_t i = 0; i < p->m; i++) {
        mpz_t *a = p->rows[i].a;
        bool vertex = hull && mpz_sgn(a[p->n]) > 0;
        gmp_fprintf(out, vertex ? "1" : "%Zd", a[p->n]);
        for (int j = 0; j < p->n; j++) {
            mpz_t z;
            mpz_init_set(z, a[j]);
            if (!hull)
                mpz_neg(z, z);
            gmp_fprintf(out, vertex ? " %Zd/%Zd" : " %Zd", z, a[p->n]);
            mpz_clear(z);
        }
        fprintf(out, "\n");
    }
    fprintf(out, "end\n");
}

static void ready_lrs(void *self)
{
    (void)self;
}

/* CPU time [s] of the program on that file; negative if it failed. Its time needs a limit of its
 * own, as that of this process does not include it. */
static double run_program(const state *s, const char *in)
{
    struct rusage use;
    int status = 0;
    rlim_t seconds = (rlim_t)s->seconds + 1;
    struct rlimit time = {seconds, seconds};
    pid_t child = fork();
    if (child == 0) {
        int out = open(s->out, O_WRONLY | O_TRUNC);
        setrlimit(RLIMIT_CPU, &time);
        if (out >= 0 && dup2(out, 1) >= 0)
            execlp("lrs", "lrs", in, (char *)NULL);
        _exit(127);
    }
    if (child < 0 || wait4(child, &status, 0, &use) < 0 || !WIFEXITED(status) ||
        WEXITSTATUS(status) != 0)
        return -1;
    return (double)(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
           1e-6 * (double)(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

/* First runs on a single row, to measure the current time of a start. */
static bool run_lrs(void *self)
{
    state *s = self;
    double start = run_program(s, s->row), seconds = run_program(s, s->in);
    s->took = fmax(seconds - start, LEAST_SECONDS);
    return start >= 0 && seconds >= 0;
}

static void write_single_row(FILE *out)
{
    fprintf(out, "H-representation\nbegin\n1 2 rational\n0 1\nend\n");
}

static void *open_lrs(const problem *p, const peer_setup *setup)
{
    if (p->strict)
        return NULL;
    state *s = need(calloc(1, sizeof *s));
    *s = (state){.in = "/tmp/bench-lrs-XXXXXX",
                 .row = "/tmp/bench-lrs-XXXXXX",
                 .out = "/tmp/bench-lrs-XXXXXX",
                 .hull = setup->question == PEER_HULL,
                 .seconds = setup->seconds};
    FILE *in = open_temporary(s->in);
    write_rows(p, s->hull, in);
    fclose(in);
    in = open_temporary(s->row);
    write_single_row(in);
    fclose(in);
    fclose(open_temporary(s->out));
    return s;
}

static double seconds_of_lrs(void *self)
{
    const state *s = self;
    return s->took;
}

static fmb_system *fetch_lrs(void *self)
{
    const state *s = self;
    FILE *in = need(fopen(s->out, "r"));
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_INE};
    fmb_where where = {0};
    fmb_system *out = NULL;
    fmb_generators *g = NULL;
    if ((s->hull ? fmb_system_read(in, &how, &out, &where)
                 : fmb_generators_read(in, &how, &g, &where)) != FMB_OK)
        need(NULL);
    fclose(in);
    if (g)
        out = system_of_generators(g);
    fmb_generators_free(g);
    return out;
}

static void close_lrs(void *self)
{
    state *s = self;
    unlink(s->in);
    unlink(s->row);
    unlink(s->out);
    free(s);
}

const peer peer_lrs = {
    .name = "lrs",
    .library = "lrslib",
    .open = open_lrs,
    .ready = ready_lrs,
    .vertices = run_lrs,
    .hull = run_lrs,
    .fetch = fetch_lrs,
    .elsewhere = seconds_of_lrs,
    .close = close_lrs,
};
