/* race.c: queries cut short from another thread and by limits, at readings of a clock that counts.
 *
 *   race [--count=N] [--limits=N] [--seed=S]
 *
 * count: cancels from another thread, at readings from the second on, over all scenes, questions
 * and methods; in one of five tries the other thread cancels again and again from then on, also
 * between queries. limits: queries under random small limits of rows, bytes or readings. Every
 * answer is the truth or unknown, a query that is cut short does not go on to read the clock, the
 * next tiny query of the same solver is answered, and a solver that is freed has given all its
 * bytes back. For thread and address sanitizers: see the file run.
 */
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "asking.h"
#include "counted_clock.h"
#include "rows.h"
#include "support.h"

enum { QUERIES_PER_SOLVER = 20 };

/* What the threads tell each other is relaxed: a sanitizer sees no order among them but the one
 * that the library makes. */
typedef struct stage {
    scene scene[SCENES_MOST];
    int scenes;
    support_rng g;
    atomic_size_t bytes; /* that solvers hold */
    fmb_solver *v;
    bool storm;            /* cancel until it is over */
    atomic_bool wanted;    /* a cancel, by the query */
    atomic_bool cancelled; /* as the query wanted */
    atomic_bool over;      /* no query runs any more */
    size_t cancelled_at;   /* reading of the clock at which it had been */
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

/* A method that this library has. */
static fmb_options some_options(support_rng *g)
{
    fmb_options o = {.size = sizeof o};
    o.method = (fmb_method)support_between(g, FMB_METHOD_AUTO, FMB_METHOD_DD);
    o.threads = support_chance(g, 50) ? (size_t)support_between(g, 2, 5) : 1;
    o.arith = support_chance(g, 20) ? FMB_ARITH_GMP : FMB_ARITH_AUTO;
    o.evidence = support_chance(g, 30) ? FMB_EVIDENCE_WHOLE : FMB_EVIDENCE_ALL;
    o.max_seconds = COUNTED_FOREVER;
    return o;
}

static void open_solver(stage *t, const fmb_options *o)
{
    fmb_alloc mem = {counted, t};
    must(fmb_solver_new(o, &mem, &t->v));
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
    size_t readings;
    fmb_result r = asking(t->v, &t->scene[SCENE_TINY], ASKING_SOLVE, &readings);
    if (r.stop != FMB_STOP_DONE)
        asking_fail("the next query: %s", fmb_stop_text(r.stop));
}

/* ---- the other thread ------------------------------------------------------------------------ */

static bool is_set(atomic_bool *flag)
{
    return atomic_load_explicit(flag, memory_order_relaxed);
}

static void set(atomic_bool *flag, bool value)
{
    atomic_store_explicit(flag, value, memory_order_relaxed);
}

static void wait_for(atomic_bool *flag, atomic_bool *or_flag)
{
    while (!is_set(flag) && !is_set(or_flag))
        sched_yield();
}

static void *canceller(void *self)
{
    stage *t = self;
    wait_for(&t->wanted, &t->over);
    do {
        fmb_solver_cancel(t->v);
        set(&t->cancelled, true);
        sched_yield();
    } while (t->storm && !is_set(&t->over));
    return NULL;
}

/* Whoever of the query reads the clock goes on when the other thread has cancelled it. */
static void want_cancel(void *self)
{
    stage *t = self;
    set(&t->wanted, true);
    wait_for(&t->cancelled, &t->cancelled);
    t->cancelled_at = counted_clock_readings();
}

/* Threads of a query that may be about to read the clock when they had better not, the reading at
 * its end, and one where time is kept for what follows a limit. */
static size_t readings_left(size_t threads)
{
    return threads - 1 + 2;
}

/* One query, cancelled at reading `at` of the clock, and in a storm three more; the first one's
 * result. */
static fmb_result cancelled_query(stage *t, const scene *c, asking_kind kind, size_t at,
                                  size_t threads)
{
    pthread_t thread;
    size_t readings, last;
    set(&t->wanted, false);
    set(&t->cancelled, false);
    set(&t->over, false);
    if (pthread_create(&thread, NULL, canceller, t) != 0)
        asking_fail("no thread");
    counted_clock_start(at, want_cancel, t);
    fmb_result r = asking(t->v, c, kind, &readings);
    for (int more = 0; t->storm && more < 3; more++)
        asking(t->v, c, kind, &last);
    counted_clock_stop();
    set(&t->over, true);
    pthread_join(thread, NULL);
    if (r.stop != FMB_STOP_CANCELLED && r.stop != FMB_STOP_DONE)
        asking_fail("%s: stopped for %s", c->name, fmb_stop_text(r.stop));
    if (r.stop == FMB_STOP_CANCELLED && readings > t->cancelled_at + readings_left(threads))
        asking_fail("%s: cancelled at reading %zu, %zu readings", c->name, t->cancelled_at,
                    readings);
    return r;
}

/* From 2, when a query has begun, to 1,000, each binary order as often as the others. */
static size_t some_reading(support_rng *g)
{
    int most = 2 << support_between(g, 0, 8);
    return (size_t)support_between(g, most, 2 * most - 1);
}

/* Half of the time a slow one. */
static const scene *some_scene(stage *t)
{
    int from = support_chance(&t->g, 50) ? SCENE_SLOW : 0;
    return &t->scene[support_between(&t->g, from, t->scenes - 1)];
}

static asking_kind some_kind(stage *t)
{
    return (asking_kind)support_between(&t->g, 0, ASKING_KINDS - 1);
}

static void cancels(stage *t, int count)
{
    int cancelled = 0;
    size_t threads = 1;
    for (int i = 0; i < count; i++) {
        fmb_options o = some_options(&t->g);
        if (i % QUERIES_PER_SOLVER == 0) {
            open_solver(t, &o);
            threads = o.threads;
        }
        size_t at = some_reading(&t->g);
        t->storm = i % 5 == 4;
        const scene *c = some_scene(t);
        fmb_result r = cancelled_query(t, c, some_kind(t), at, threads);
        cancelled += r.stop == FMB_STOP_CANCELLED;
        expect_usable(t);
        if ((i + 1) % QUERIES_PER_SOLVER == 0 || i + 1 == count)
            close_solver(t);
    }
    printf("%d queries, %d of them cancelled; the others were over before\n", count, cancelled);
    if (count >= 100 && cancelled < count / 8)
        asking_fail("too few queries were cancelled");
}

/* ---- limits ---------------------------------------------------------------------------------- */

/* What is limited in rows or bytes alone may take long. */
enum { MOST_READINGS = 1000 };

static fmb_stop limit(support_rng *g, fmb_options *o)
{
    int kind = support_between(g, 0, 2), size = 1 << support_between(g, 0, 14);
    o->max_seconds = MOST_READINGS;
    if (kind == 0)
        o->max_rows = (size_t)support_between(g, 1, size);
    else if (kind == 1)
        o->max_bytes = 64 * (size_t)support_between(g, 1, size);
    else
        o->max_seconds = (double)some_reading(g);
    return kind == 0 ? FMB_STOP_ROWS : kind == 1 ? FMB_STOP_BYTES : FMB_STOP_TIME;
}

static void limits(stage *t, int count)
{
    int reached = 0;
    for (int i = 0; i < count; i++) {
        fmb_options o = some_options(&t->g);
        fmb_stop stop = limit(&t->g, &o);
        size_t readings;
        open_solver(t, &o);
        const scene *c = some_scene(t);
        counted_clock_start(0, NULL, NULL);
        fmb_result r = asking(t->v, c, some_kind(t), &readings);
        counted_clock_stop();
        if (r.stop != FMB_STOP_DONE && r.stop != stop && r.stop != FMB_STOP_TIME)
            asking_fail("%s: stopped for %s", c->name, fmb_stop_text(r.stop));
        if (o.threads == 1 && (double)readings > 1 + o.max_seconds + (double)readings_left(1))
            asking_fail("%s: %zu readings under a limit of %g", c->name, readings, o.max_seconds);
        reached += r.stop == stop;
        asking(t->v, &t->scene[SCENE_TINY], ASKING_SOLVE, &readings);
        close_solver(t);
    }
    printf("%d limits, %d of them reached\n", count, reached);
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
    int count = 1000, limited = 500, seed = 1;
    for (int i = 1; i < argc; i++)
        if (!number(argv[i], "--count=", &count) && !number(argv[i], "--limits=", &limited) &&
            !number(argv[i], "--seed=", &seed)) {
            fprintf(stderr, "usage: race [--count=N] [--limits=N] [--seed=S]\n");
            return 64;
        }
    t.g.state = (uint64_t)seed;
    t.scenes = scenes_all(t.scene);
    cancels(&t, count);
    limits(&t, limited);
    for (int i = 0; i < t.scenes; i++)
        fmb_system_free(t.scene[i].s);
    return 0;
}
