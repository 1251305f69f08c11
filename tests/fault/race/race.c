/* race.c: queries cut short at random moments, from another thread and by limits.
 *
 *   race [--count=N] [--limits=N] [--latency=N] [--most=MS] [--seed=S]
 *
 * count: cancels from another thread, at moments from the first microsecond on, over all scenes,
 * questions and methods; in one of five tries the other thread cancels again and again, also
 * between queries. limits: queries under random small limits of rows, bytes or seconds. Every
 * answer is the truth or unknown, the next tiny query of the same solver is answered, and a solver
 * that is freed has given all its bytes back. latency: cancels of queries about the hard scene,
 * from the cancel to the return, on the wall and of the processor; more than MS milliseconds of it
 * fail. For thread and address sanitizers: see the file run.
 */
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "asking.h"
#include "base/clock.h"
#include "rows.h"
#include "support.h"

enum { QUERIES_PER_SOLVER = 20 };

typedef struct stage {
    scene scene[SCENES_MOST];
    int scenes;
    support_rng g;
    atomic_size_t bytes; /* that solvers hold */
    fmb_solver *v;
    atomic_bool running; /* set by the query's first event */
    atomic_bool over;    /* set when it has returned */
    bool storm;          /* cancel until it is over */
    double wait;         /* from the first event to the cancel [s] */
    clockid_t asker;     /* processor clock of the thread that asks */
    moment cancelled;    /* of the asker */
} stage;

/* An allocator that knows what is left. */
static void *counted(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    stage *t = self;
    void *q = NULL;
    if (new_bytes == 0)
        free(p);
    else if (!(q = realloc(p, new_bytes)))
        return NULL;
    t->bytes += new_bytes - old_bytes;
    return q;
}

static void note(void *self, const fmb_event *e)
{
    stage *t = self;
    if (e->kind == FMB_EVENT_BEGIN)
        atomic_store(&t->running, true);
}

/* A method that this library has. */
static fmb_options some_options(support_rng *g)
{
    fmb_options o = {.size = sizeof o};
    o.method = (fmb_method)support_between(g, FMB_METHOD_AUTO, FMB_METHOD_DD);
    o.threads = support_chance(g, 50) ? (size_t)support_between(g, 2, 5) : 1;
    o.arith = support_chance(g, 20) ? FMB_ARITH_GMP : FMB_ARITH_AUTO;
    o.evidence = support_chance(g, 30) ? FMB_EVIDENCE_WHOLE : FMB_EVIDENCE_ALL;
    return o;
}

static void open_solver(stage *t, const fmb_options *o)
{
    fmb_alloc mem = {counted, t};
    must(fmb_solver_new(o, &mem, &t->v));
    fmb_solver_set_sink(t->v, (fmb_sink){note, t});
}

static void close_solver(stage *t)
{
    fmb_solver_free(t->v);
    t->v = NULL;
    if (t->bytes != 0)
        asking_fail("a solver left %zu bytes behind", t->bytes);
}

static void expect_usable(stage *t)
{
    moment returned;
    fmb_result r = asking(t->v, &t->scene[SCENE_TINY], ASKING_SOLVE, &returned);
    if (r.stop != FMB_STOP_DONE)
        asking_fail("the next query: %s", fmb_stop_text(r.stop));
}

/* ---- the other thread ------------------------------------------------------------------------ */

/* Sleeping is too coarse for the first moments of a query. */
static void wait_until(const stage *t, double end)
{
    for (double left; !atomic_load(&t->over) && (left = end - fmb_monotonic_seconds()) > 0;)
        if (left > 2e-4)
            nanosleep(&(struct timespec){0, (long)((left < 5e-3 ? left / 2 : 2e-3) * 1e9)}, NULL);
}

static void *canceller(void *self)
{
    stage *t = self;
    while (!atomic_load(&t->running) && !atomic_load(&t->over))
        continue;
    wait_until(t, fmb_monotonic_seconds() + t->wait);
    t->cancelled = asking_moment(t->asker);
    fmb_solver_cancel(t->v);
    while (t->storm && !atomic_load(&t->over)) {
        wait_until(t, fmb_monotonic_seconds() + t->wait);
        fmb_solver_cancel(t->v);
    }
    return NULL;
}

/* One query, cancelled; from the cancel to its return, or zeros if it was over before. */
static moment cancelled_query(stage *t, const scene *c, asking_kind kind, int *cancels)
{
    pthread_t thread;
    moment returned, last;
    atomic_store(&t->running, false);
    atomic_store(&t->over, false);
    if (pthread_create(&thread, NULL, canceller, t) != 0)
        asking_fail("no thread");
    fmb_result r = asking(t->v, c, kind, &returned);
    for (int more = 0; t->storm && more < 3; more++)
        asking(t->v, c, kind, &last);
    atomic_store(&t->over, true);
    pthread_join(thread, NULL);
    if (r.stop != FMB_STOP_CANCELLED && r.stop != FMB_STOP_DONE)
        asking_fail("%s: stopped for %s", c->name, fmb_stop_text(r.stop));
    *cancels += r.stop == FMB_STOP_CANCELLED;
    if (r.stop != FMB_STOP_CANCELLED)
        return (moment){0};
    return (moment){returned.wall - t->cancelled.wall, returned.cpu - t->cancelled.cpu};
}

/* From a microsecond to 4 milliseconds, each binary order as often as the others. */
static double some_wait(support_rng *g)
{
    double wait = 1e-6;
    for (int k = support_between(g, 0, 8); k > 0; k--)
        wait *= 2;
    return wait * (1 + support_between(g, 0, 999) / 1000.0);
}

/* Half of the time a slow one. */
static const scene *some_scene(stage *t)
{
    int from = support_chance(&t->g, 50) ? SCENE_SLOW : 0;
    return &t->scene[support_between(&t->g, from, t->scenes - 1)];
}

static void cancels(stage *t, int count)
{
    int cancelled = 0;
    for (int i = 0; i < count; i++) {
        fmb_options o = some_options(&t->g);
        if (i % QUERIES_PER_SOLVER == 0)
            open_solver(t, &o);
        t->wait = some_wait(&t->g);
        t->storm = i % 5 == 4;
        cancelled_query(t, some_scene(t), (asking_kind)support_between(&t->g, 0, ASKING_KINDS - 1),
                        &cancelled);
        t->storm = false;
        expect_usable(t);
        if ((i + 1) % QUERIES_PER_SOLVER == 0 || i + 1 == count)
            close_solver(t);
    }
    printf("%d cancels, %d of them in time; the rest came after the answer\n", count, cancelled);
    if (count >= 100 && cancelled < count / 8)
        asking_fail("too few queries were cancelled");
}

/* ---- limits ---------------------------------------------------------------------------------- */

static fmb_stop limit(support_rng *g, fmb_options *o)
{
    int kind = support_between(g, 0, 2), size = 1 << support_between(g, 0, 14);
    if (kind == 0)
        o->max_rows = (size_t)support_between(g, 1, size);
    else if (kind == 1)
        o->max_bytes = 64 * (size_t)support_between(g, 1, size);
    else
        o->max_seconds = some_wait(g);
    return kind == 0 ? FMB_STOP_ROWS : kind == 1 ? FMB_STOP_BYTES : FMB_STOP_TIME;
}

static void limits(stage *t, int count)
{
    int reached = 0;
    for (int i = 0; i < count; i++) {
        fmb_options o = some_options(&t->g);
        fmb_stop stop = limit(&t->g, &o);
        moment returned;
        double begin = fmb_monotonic_seconds();
        /* What is limited in rows or bytes alone may take long. */
        if (stop != FMB_STOP_TIME)
            o.max_seconds = 0.05;
        open_solver(t, &o);
        const scene *c = some_scene(t);
        fmb_result r =
            asking(t->v, c, (asking_kind)support_between(&t->g, 0, ASKING_KINDS - 1), &returned);
        if (r.stop != FMB_STOP_DONE && r.stop != stop && r.stop != FMB_STOP_TIME)
            asking_fail("%s: stopped for %s", c->name, fmb_stop_text(r.stop));
        if (returned.wall - begin > 5)
            asking_fail("%s: %g s under a limit of %g s", c->name, returned.wall - begin,
                        o.max_seconds);
        reached += r.stop == stop;
        asking(t->v, &t->scene[SCENE_TINY], ASKING_SOLVE, &returned);
        close_solver(t);
    }
    printf("%d limits, %d of them reached\n", count, reached);
}

/* ---- latency --------------------------------------------------------------------------------- */

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_times(const char *clock, double *taken, int n)
{
    qsort(taken, (size_t)n, sizeof *taken, by_value);
    printf("  %s: median %.3f ms, 99th percentile %.3f ms, most %.3f ms\n", clock,
           1e3 * taken[n / 2], 1e3 * taken[n * 99 / 100], 1e3 * taken[n - 1]);
}

static void latency(stage *t, int count, int most)
{
    double *wall = calloc((size_t)count + 1, sizeof *wall);
    double *cpu = calloc((size_t)count + 1, sizeof *cpu), slowest = 0;
    int cancelled = 0;
    for (int i = 0; wall && cpu && i < count; i++) {
        fmb_options o = some_options(&t->g);
        int before = cancelled;
        open_solver(t, &o);
        t->wait = some_wait(&t->g) * support_between(&t->g, 1, 80);
        moment m =
            cancelled_query(t, &t->scene[SCENE_HARD], (asking_kind)(i % ASKING_KINDS), &cancelled);
        wall[before] = m.wall;
        cpu[before] = m.cpu;
        if (1e3 * m.cpu > 10)
            printf("  question %d, method %d, arithmetic %d, cancelled after %.3f s: %.3f ms\n",
                   i % ASKING_KINDS, (int)o.method, (int)o.arith, t->wait, 1e3 * m.cpu);
        slowest = m.cpu > slowest ? m.cpu : slowest;
        close_solver(t);
    }
    printf("from cancel to return, %d cancels:\n", cancelled);
    if (cancelled > 0) {
        print_times("wall", wall, cancelled);
        print_times("processor time", cpu, cancelled);
    }
    free(wall);
    free(cpu);
    if (1e3 * slowest > most)
        asking_fail("a cancel took %g s", slowest);
}

/* ---------------------------------------------------------------------------------------------- */

static bool number(const char *arg, const char *name, int *out)
{
    size_t n = strlen(name);
    if (strncmp(arg, name, n) != 0)
        return false;
    *out = atoi(arg + n);
    return true;
}

int main(int argc, char **argv)
{
    static stage t;
    int count = 1000, limited = 500, late = 100, most = 250, seed = 1;
    for (int i = 1; i < argc; i++)
        if (!number(argv[i], "--count=", &count) && !number(argv[i], "--limits=", &limited) &&
            !number(argv[i], "--latency=", &late) && !number(argv[i], "--most=", &most) &&
            !number(argv[i], "--seed=", &seed)) {
            fprintf(stderr, "usage: race [--count=N] [--limits=N] [--latency=N] [--most=MS] "
                            "[--seed=S]\n");
            return 64;
        }
    t.g.state = (uint64_t)seed;
    pthread_getcpuclockid(pthread_self(), &t.asker);
    t.scenes = scenes_all(t.scene);
    cancels(&t, count);
    limits(&t, limited);
    latency(&t, late, most);
    for (int i = 0; i < t.scenes; i++)
        fmb_system_free(t.scene[i].s);
    return 0;
}
