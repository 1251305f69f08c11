/* child.c: see child.h.
 *
 * The child opens the driver on all variants, runs the first of them cold, then rotates over the
 * others while the runs are short, and writes lines to a pipe:
 *     cannot | gave up | time SECONDS | peak BYTES | verdict V | number X | proved 1 or 0, SECONDS
 *     | result BYTES, then the text | unlike
 * SIGPROF (an interval timer on CPU time, armed for each run) ends a run that takes too long.
 */
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../machine.h"
#include "canon.h"
#include "child.h"
#include "peak.h"

/* The most later runs of a driver. */
enum { LATER_RUNS = 16 * CHILD_VARIANTS };
/* Time limit for the canonical form of a result [s]. */
static const double CANON_SECONDS = 60;

/* ---- inside the child ------------------------------------------------------------------------ */

/* PPL puts a handler of its own on SIGPROF. */
static void arm(double seconds)
{
    signal(SIGPROF, SIG_DFL);
    double whole = (double)(long)seconds;
    struct itimerval t = {
        .it_value = {.tv_sec = (time_t)whole, .tv_usec = (suseconds_t)(1e6 * (seconds - whole))}};
    setitimer(ITIMER_PROF, &t, NULL);
}

/* One run [s]; negative if the driver gave up. */
static double timed_run(const peer *d, void *self, const child_limits *l, fmb_verdict *verdict)
{
    d->ready(self);
    arm(l->seconds);
    double begin = thread_seconds();
    bool done = true;
    if (peer_is_list(l->question))
        done = peer_maker(d, l->question)(self);
    else
        done = (*verdict = peer_way(d, l->question)(self)) != FMB_UNKNOWN;
    double took = thread_seconds() - begin;
    arm(0);
    return !done ? -1 : d->elsewhere ? took + d->elsewhere(self) : took;
}

static char *result_text(const peer *d, void *self, peer_question question)
{
    fmb_system *s = d->fetch(self);
    arm(CANON_SECONDS);
    char *text =
        question == PEER_PROJECT ? canonical_text(s) : canonical_list(s, question == PEER_VERTICES);
    arm(0);
    fmb_system_free(s);
    return text;
}

typedef struct job {
    const peer *driver;
    const child_limits *limits;
    void *self[CHILD_VARIANTS];
    bool ran[CHILD_VARIANTS];
    fmb_verdict verdict[CHILD_VARIANTS];
    FILE *out;
} job;

/* The runs and their times; false if the driver gave up. */
static bool run_all(job *j)
{
    double total = 0;
    for (int i = 0; i <= LATER_RUNS && (i == 0 || total < j->limits->later); i++) {
        int v = i % j->limits->variants;
        size_t before = i == 0 ? peak_begin() : 0;
        double t = timed_run(j->driver, j->self[v], j->limits, &j->verdict[v]);
        if (t < 0) {
            fprintf(j->out, "gave up\n");
            return false;
        }
        fprintf(j->out, "time %.9e\n", t);
        if (i == 0)
            fprintf(j->out, "peak %zu\n", peak_end(before));
        fflush(j->out);
        j->ran[v] = true;
        total += t;
    }
    return true;
}

/* Report the verdict on the first variant, its numbers, and whether its proof holds. */
static void tell_answer(job *j)
{
    const peer *d = j->driver;
    const peer_numbers *numbers = d->numbers ? d->numbers(j->self[0]) : NULL;
    fprintf(j->out, "verdict %d\n", (int)j->verdict[0]);
    for (size_t i = 0; numbers && i < numbers->n; i++)
        fprintf(j->out, "number %.17g\n", numbers->value[i]);
    fflush(j->out);
    if (!d->prove)
        return;
    double begin = thread_seconds();
    bool good = d->prove(j->self[0], j->limits->question);
    fprintf(j->out, "proved %d %.9e\n", good, thread_seconds() - begin);
}

/* Report the first variant's answer, and whether all variants agree. */
static void tell_results(job *j)
{
    char *first = NULL;
    bool unlike = false;
    peer_question question = j->limits->question;
    if (peer_is_list(question))
        first = result_text(j->driver, j->self[0], question);
    else
        tell_answer(j);
    if (first)
        fprintf(j->out, "result %zu\n%s", strlen(first), first);
    fflush(j->out);
    for (int v = 1; v < j->limits->variants && j->ran[v]; v++) {
        char *text = first ? result_text(j->driver, j->self[v], question) : NULL;
        unlike |= first ? strcmp(first, text) != 0 : j->verdict[v] != j->verdict[0];
        free(text);
    }
    if (unlike)
        fprintf(j->out, "unlike\n");
    free(first);
}

static void limit_memory(size_t bytes)
{
    struct rlimit space = {bytes, bytes}, core = {0, 0};
    if (bytes > 0)
        setrlimit(RLIMIT_AS, &space);
    setrlimit(RLIMIT_CORE, &core);
}

/* Discard both output streams: peers write to them. */
static void mute(void)
{
    if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr))
        _exit(70);
}

static void run_child(const peer *d, const problem *variants, const child_limits *l, int out)
{
    job j = {.driver = d, .limits = l, .out = need(fdopen(out, "w"))};
    peer_setup setup = {l->options, l->question, l->seconds};
    mute();
    limit_memory(l->bytes);
    for (int v = 0; v < l->variants; v++) {
        j.self[v] = d->open(&variants[v], &setup);
        if (!j.self[v]) {
            fprintf(j.out, "cannot\n");
            fflush(j.out);
            _exit(0);
        }
    }
    if (run_all(&j))
        tell_results(&j);
    fflush(j.out);
    for (int v = 0; v < l->variants; v++)
        d->close(j.self[v]);
    _exit(0);
}

/* ---- outside --------------------------------------------------------------------------------- */

/* All output of the child until it ends; kills it if it sleeps much longer than it may run. */
static char *listen(int in, pid_t child, double patience, size_t *size)
{
    char *text = NULL, part[4096];
    FILE *to = need(open_memstream(&text, size));
    for (;;) {
        struct pollfd p = {.fd = in, .events = POLLIN};
        int ready = poll(&p, 1, (int)(1000 * patience));
        if (ready < 0 && errno == EINTR)
            continue;
        if (ready == 0)
            kill(child, SIGPROF);
        ssize_t n = read(in, part, sizeof part);
        if (n <= 0)
            break;
        fwrite(part, 1, (size_t)n, to);
    }
    fclose(to);
    return text;
}

static void take_number(child_outcome *o, double x)
{
    if ((o->numbers & (o->numbers - 1)) == 0)
        o->number = need(realloc(o->number, (o->numbers ? 2 * o->numbers : 1) * sizeof x));
    o->number[o->numbers++] = x;
}

static void understand(child_outcome *o, char *text)
{
    double later[LATER_RUNS];
    bool first = true;
    for (char *at = text, *line; *at;) {
        line = at;
        at += strcspn(at, "\n");
        at += *at == '\n';
        double t;
        size_t bytes;
        int v;
        double x;
        if (strncmp(line, "cannot", 6) == 0) {
            o->end = CHILD_CANNOT;
        } else if (strncmp(line, "gave up", 7) == 0) {
            o->end = CHILD_GAVE_UP;
        } else if (strncmp(line, "unlike", 6) == 0) {
            o->unlike = true;
        } else if (sscanf(line, "time %lf", &t) == 1) {
            if (first)
                o->first = t;
            else
                later[o->runs++] = t;
            first = false;
        } else if (sscanf(line, "peak %zu", &bytes) == 1) {
            o->peak = bytes;
        } else if (sscanf(line, "number %lf", &x) == 1) {
            take_number(o, x);
        } else if (sscanf(line, "proved %d %lf", &v, &x) == 2) {
            o->has_proof = true;
            o->proved = v;
            o->proving = x;
        } else if (sscanf(line, "verdict %d", &v) == 1) {
            o->verdict = (fmb_verdict)v;
        } else if (sscanf(line, "result %zu", &bytes) == 1) {
            o->text = need(strndup(at, bytes));
            at += strlen(o->text);
        }
    }
    o->typical = o->runs ? median(later, o->runs) : o->first;
    if (first && o->end == CHILD_DONE)
        o->end = CHILD_CRASHED;
}

void child_outcome_clear(child_outcome *o)
{
    free(o->text);
    free(o->number);
}

child_outcome child_run(const peer *driver, const problem *variants, const child_limits *limits)
{
    child_outcome o = {.limit = limits->seconds};
    int ends[2], status = 0;
    fflush(NULL);
    if (pipe(ends) != 0)
        need(NULL);
    pid_t child = fork();
    if (child < 0)
        need(NULL);
    if (child == 0) {
        close(ends[0]);
        run_child(driver, variants, limits, ends[1]);
    }
    close(ends[1]);
    size_t size = 0;
    char *text = listen(ends[0], child, 60 + 20 * limits->seconds, &size);
    close(ends[0]);
    waitpid(child, &status, 0);
    understand(&o, text);
    free(text);
    bool killed = WIFSIGNALED(status);
    o.signal = killed ? WTERMSIG(status) : 0;
    if (o.first == 0 && killed)
        o.end = o.signal == SIGPROF ? CHILD_TIME : CHILD_CRASHED;
    return o;
}
