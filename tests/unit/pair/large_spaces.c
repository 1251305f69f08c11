/* large_spaces.c: pairs of frames in thousands of dimensions: limits of time and memory hold, and
 * cancels take effect. */
#include <criterion/criterion.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fmb/pair.h>

#include "counted_clock.h"
#include "support/must.h"

/* Two frames of the given number of random axes in R^dim, with one corner in common. */
typedef struct large {
    double *number;
    fmb_frame f[2];
    fmb_pair *k;
} large;

static large large_new(int dim, int naxes, fmb_pair_options o)
{
    size_t d = (size_t)dim, n = d * (size_t)naxes;
    uint64_t x = 1;
    large l = {.number = calloc(d + 2 * n, sizeof *l.number)};
    for (size_t i = d; i < d + 2 * n; i++) {
        x = x * 6364136223846793005u + 1;
        l.number[i] = (double)(x >> 11) * 0x1p-53;
    }
    for (int i = 0; i < 2; i++)
        l.f[i] = (fmb_frame){FMB_CUBOID, dim, naxes, l.number, l.number + d + (i ? n : 0), NULL};
    must(fmb_pair_new(dim, &o, NULL, &l.k));
    return l;
}

static void large_free(large *l)
{
    fmb_pair_free(l->k);
    free(l->number);
}

/* With a box and all if wanted. */
static fmb_verdict ask_large(const large *l, bool boxes)
{
    size_t d = (size_t)l->f[0].dim;
    double *answer = calloc(5 * d + 2, sizeof *answer);
    fmb_verdict verdict;
    fmb_pair_answers out = {.size = sizeof out, .verdict = &verdict};
    if (boxes)
        out = (fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                                 .verdict = &verdict,
                                 .world = answer,
                                 .inside = answer + 2 * d,
                                 .time = answer + 4 * d,
                                 .witness = answer + 4 * d + 2};
    must(fmb_pair_test(l->k, 1, &l->f[0], &l->f[1], &out));
    free(answer);
    return verdict;
}

/* A limit of time holds while the system is made, and while it is solved: the reading that shows
 * its end is the last. */
Test(large_spaces, max_seconds)
{
    const int size[][2] = {{3000, 3000}, {300, 300}, {60, 60}};
    for (size_t i = 0; i < 3; i++)
        for (int boxes = 0; boxes < 2; boxes++)
            for (size_t seconds = 1; seconds < 60; seconds *= 3 * WATCHED) {
                fmb_pair_options o = {.size = sizeof o};
                o.max_seconds = (double)seconds;
                large l = large_new(size[i][0], size[i][1], o);
                counted_clock_start(0, NULL, NULL);
                fmb_verdict verdict = ask_large(&l, boxes);
                counted_clock_stop();
                cr_expect_eq(verdict, FMB_UNKNOWN);
                cr_expect_eq(counted_clock_readings(), seconds + 1, "R^%d: %zu readings in %zu s",
                             size[i][0], counted_clock_readings(), seconds);
                large_free(&l);
            }
}

/* Points need few terms each: no table of dim^2 numbers is made. */
Test(large_spaces, points)
{
    fmb_pair_options o = {.size = sizeof o};
    o.max_bytes = (size_t)64 << 20;
    large l = large_new(10000, 0, o);
    cr_expect_eq(ask_large(&l, true), FMB_FEASIBLE);
    large_free(&l);
}

/* A limit of memory holds for the system, too: nothing beyond it is ever asked for. */
Test(large_spaces, max_bytes)
{
    for (int boxes = 0; boxes < 2; boxes++) {
        fmb_pair_options o = {.size = sizeof o};
        o.max_bytes = (size_t)1 << 20;
        large l = large_new(1000, 1000, o);
        cr_expect_eq(ask_large(&l, boxes), FMB_UNKNOWN);
        large_free(&l);
    }
}

static void cancel_pair(void *k)
{
    fmb_pair_cancel(k);
}

/* Cancelled wherever it asks whether to go on, a query ends without a verdict, and without another
 * question. */
Test(large_spaces, cancel)
{
    const int size[] = {2000, 300, 60};
    for (size_t i = 0; i < 3; i++)
        for (size_t at = 1; at < 60; at *= 3 * WATCHED) {
            fmb_pair_options o = {.size = sizeof o};
            o.max_seconds = COUNTED_FOREVER;
            large l = large_new(size[i], size[i], o);
            counted_clock_start(at, cancel_pair, l.k);
            fmb_verdict verdict = ask_large(&l, false);
            counted_clock_stop();
            cr_expect_eq(verdict, FMB_UNKNOWN, "R^%d", size[i]);
            cr_expect_eq(counted_clock_readings(), at, "R^%d: %zu readings, cancelled at %zu",
                         size[i], counted_clock_readings(), at);
            large_free(&l);
        }
}

/* A page whose first reader cancels. */
static struct {
    double *number;
    size_t bytes;
    fmb_pair *k;
} trap;

static void cancel_at_first_reading(int signal)
{
    (void)signal;
    fmb_pair_cancel(trap.k);
    mprotect(trap.number, trap.bytes, PROT_READ);
}

static void set_trap(fmb_pair *k, const double *number, size_t n)
{
    struct sigaction on_fault = {.sa_handler = cancel_at_first_reading};
    trap.bytes = (size_t)sysconf(_SC_PAGESIZE);
    trap.k = k;
    trap.number =
        mmap(NULL, trap.bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    cr_assert(trap.number != MAP_FAILED && n * sizeof *number <= trap.bytes);
    memcpy(trap.number, number, n * sizeof *number);
    cr_assert_eq(mprotect(trap.number, trap.bytes, PROT_NONE), 0);
    cr_assert_eq(sigaction(SIGSEGV, &on_fault, NULL), 0);
}

/* Pairs that wait for their turn when a cancel comes are not looked at. It comes while numbers of
 * one of the first are read. */
Test(large_spaces, cancel_before_the_last_pair)
{
    enum { DIM = 8, PAIRS = 1000 };
    fmb_pair_options o = {.size = sizeof o};
    o.doubles_only = true;
    large l = large_new(DIM, DIM, o);
    fmb_frame *f = calloc(2 * PAIRS, sizeof *f);
    fmb_verdict *verdict = calloc(PAIRS, sizeof *verdict);
    const double far[DIM] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
    for (int i = 0; i < PAIRS; i++) {
        f[i] = l.f[0];
        f[PAIRS + i] = l.f[1];
        f[i].origin = far;
    }
    set_trap(l.k, far, DIM);
    f[PAIRS / 3].origin = trap.number;
    must(fmb_pair_test(l.k, PAIRS, f, f + PAIRS,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = verdict}));
    cr_expect_eq(trap.number[0], far[0]);
    cr_expect_eq(verdict[PAIRS - 1], FMB_UNKNOWN);
    cr_expect_neq(verdict[0], FMB_UNKNOWN);
    munmap(trap.number, trap.bytes);
    large_free(&l);
    free(f);
    free(verdict);
}
