/* gmp.c: with long numbers the sum of what the library and GMP hold stays below the limit, up to
 * what one step works on: GMP's allocators are ours here, and count.
 *
 * GMP ends the process where it gets no memory, so whatever a file can ask for must be stopped
 * before. Every system is asked of under a row of limits: a stop or an answer, never more memory.
 */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/generators.h>

#include "counted_clock.h"
#include "property/random/rows.h"
#include "samples.h"
#include "verbs.h"

/* ---- what is held ---------------------------------------------------------------------------- */

static size_t held, peak; /* [bytes] by GMP and the library */
static size_t written;    /* [bytes] all that GMP and the library have asked for */

static void count(size_t old_bytes, size_t new_bytes)
{
    held += new_bytes - old_bytes;
    written += new_bytes;
    peak = held > peak ? held : peak;
}

static void *gmp_get(size_t n)
{
    count(0, n);
    return malloc(n);
}

static void *gmp_resize(void *p, size_t old_bytes, size_t new_bytes)
{
    count(old_bytes, new_bytes);
    return realloc(p, new_bytes);
}

static void gmp_put(void *p, size_t n)
{
    count(n, 0);
    free(p);
}

static void *resize(void *self, void *p, size_t old_bytes, size_t new_bytes)
{
    (void)self;
    count(old_bytes, new_bytes);
    if (new_bytes > 0)
        return realloc(p, new_bytes);
    free(p);
    return NULL;
}

static const fmb_alloc counted = {resize, NULL};

static void watch_gmp(void)
{
    mp_set_memory_functions(gmp_get, gmp_resize, gmp_put);
}

/* ---- systems of long numbers ----------------------------------------------------------------- */

/* Digits that follow from seed. */
static void long_number(mpq_t q, int digits, unsigned seed)
{
    mpz_ui_pow_ui(mpq_numref(q), 10, (unsigned long)digits);
    mpz_tdiv_q_ui(mpq_numref(q), mpq_numref(q), 7 + seed % 97);
    mpz_add_ui(mpq_numref(q), mpq_numref(q), seed);
    mpz_set_ui(mpq_denref(q), 1);
    if (seed % 3 == 0)
        mpq_neg(q, q);
}

/* n variables in m dense rows of integers of so many digits, all true at 0. */
static fmb_system *long_rows(int n, int m, int digits)
{
    fmb_system *s = NULL;
    mpq_t a[16], b;
    int var[16];
    must(fmb_system_new(n, &counted, &s));
    mpq_init(b);
    for (int j = 0; j < n; j++) {
        mpq_init(a[j]);
        var[j] = j;
    }
    for (int i = 0; i < m; i++) {
        for (int j = 0; j < n; j++)
            long_number(a[j], digits, (unsigned)(i * 31 + j * 17 + i * j + 1));
        long_number(b, digits, (unsigned)(i + 5));
        mpq_abs(b, b);
        must(fmb_system_add_q(s, (size_t)n, var, a, FMB_LE, b));
    }
    for (int j = 0; j < n; j++)
        mpq_clear(a[j]);
    mpq_clear(b);
    return s;
}

/* x_(j+1) within 10^9000 x_j and 10^-9000 x_j, and so on. */
static fmb_system *far_exponents(int n)
{
    fmb_system *s = NULL;
    mpq_t a[2], b;
    must(fmb_system_new(n, &counted, &s));
    mpq_inits(a[0], a[1], b, NULL);
    for (int i = 0; i < 4 * n; i++) {
        int j = i % n, k = (i * 5 + 1) % n, var[2] = {j, k};
        if (j == k)
            continue;
        mpq_set_si(a[0], i % 3 == 0 ? -1 : 1, 1);
        mpz_ui_pow_ui(i % 2 ? mpq_numref(a[1]) : mpq_denref(a[1]), 10, 9000);
        mpz_set_ui(i % 2 ? mpq_denref(a[1]) : mpq_numref(a[1]), 1);
        if (i % 5 < 2)
            mpq_neg(a[1], a[1]);
        mpq_set_ui(b, (unsigned)i + 1, 1);
        must(fmb_system_add_q(s, 2, var, a, FMB_LE, b));
    }
    mpq_clears(a[0], a[1], b, NULL);
    return s;
}

/* ---- queries --------------------------------------------------------------------------------- */

/* What one step works on, and is not counted before it is made [bytes]. */
enum { STEP = 1 << 18 };

/* Ask w of s with a limit; more than it, and what one step works on, is never held beside the
 * system. What fmb_reduce gives out at a limit is there if its rows have room, too. */
static fmb_stop ask_within(const char *name, int w, fmb_method method, const fmb_system *s,
                           size_t limit)
{
    static const int keep[] = {0, 1};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_box *box = NULL;
    fmb_system *out = NULL;
    size_t before = held;
    o.evidence = FMB_EVIDENCE_ALL;
    o.method = method;
    o.max_bytes = limit;
    o.max_seconds = 200; /* readings of the clock */
    must(fmb_solver_new(&o, &counted, &v));
    peak = held;
    counted_clock_start(0, NULL, NULL);
    if (w == 0)
        must(fmb_solve(v, s, &r));
    else if (w == 1)
        must(fmb_bound(v, s, NULL, 0, &box, &r));
    else if (w == 2)
        must(fmb_project(v, s, keep, 2, &out, &r));
    else
        must(fmb_reduce(v, s, NULL, &out, &r));
    counted_clock_stop();
    cr_expect(w != 3 || out || r.stop != FMB_STOP_DONE, "%s: no answer, and no limit", name);
    cr_expect_leq(peak - before, limit + limit / 4 + STEP,
                  "%s, query %d, method %d: %zu bytes of %zu", name, w, (int)method, peak - before,
                  limit);
    fmb_box_free(box);
    fmb_system_free(out);
    fmb_solver_free(v);
    cr_expect_eq(held, before, "%s, query %d: %zu bytes stay", name, w, held - before);
    return r.stop;
}

/* Every query, method and limit; some stop, some do not. */
static void ask_all(const char *name, fmb_system *s)
{
    size_t stopped = 0;
    for (int w = 0; w < 4; w++)
        for (fmb_method method = FMB_METHOD_AUTO; method <= FMB_METHOD_DD; method++)
            for (size_t limit = (size_t)1 << 16; limit <= (size_t)1 << 22; limit *= 4)
                stopped += ask_within(name, w, method, s, limit) == FMB_STOP_BYTES;
    cr_expect_gt(stopped, 0, "%s", name);
    fmb_system_free(s);
}

Test(gmp, long_rows)
{
    watch_gmp();
    ask_all("5,000 digits", long_rows(4, 12, 5000));
}

Test(gmp, klein)
{
    watch_gmp();
    ask_all("dense", long_rows(12, 30, 60));
}

Test(gmp, exponents)
{
    watch_gmp();
    ask_all("10^9000", far_exponents(8));
}

/* x_j >= -1, and rows whose numbers are so long, each of which bounds every x_j by the others. */
static fmb_system *long_budgets(int n, int m, int digits)
{
    fmb_system *s = NULL;
    mpq_t a[8], b;
    int var[8];
    must(fmb_system_new(n, &counted, &s));
    mpq_init(b);
    for (int j = 0; j < n; j++) {
        int64_t least[8] = {0};
        least[j] = -1;
        must(fmb_system_add_int(s, least, FMB_LE, 1));
        mpq_init(a[j]);
        var[j] = j;
    }
    for (int i = 0; i < m; i++) {
        for (int j = 0; j < n; j++) {
            mpz_ui_pow_ui(mpq_numref(a[j]), 10, (unsigned)digits);
            mpz_add_ui(mpq_numref(a[j]), mpq_numref(a[j]), (unsigned)(i * i + 7 * j * i + j + 1));
        }
        mpq_set(b, a[i % n]);
        must(fmb_system_add_q(s, (size_t)n, var, a, FMB_LE, b));
    }
    for (int j = 0; j < n; j++)
        mpq_clear(a[j]);
    mpq_clear(b);
    return s;
}

/* What is done once a limit is reached is little, also with long numbers: the rows are read into a
 * store, which writes four times what the system has, and are not multiplied with each other. */
Test(gmp, at_a_limit)
{
    watch_gmp();
    fmb_system *s = long_budgets(6, 12, 50000);
    fmb_options o = {.size = sizeof o, .max_rows = 1, .method = FMB_METHOD_FM};
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    fmb_box *box = NULL;
    size_t system = held;
    must(fmb_solver_new(&o, &counted, &v));
    counted_clock_start(0, NULL, NULL);
    written = 0;
    must(fmb_bound(v, s, NULL, 0, &box, &r));
    counted_clock_stop();
    cr_expect_eq(r.stop, FMB_STOP_ROWS);
    cr_expect_lt(written, 5 * system, "%zu bytes of results, the system has %zu", written, system);
    fmb_box_free(box);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* Rows of long numbers that a limit of time left no time to load are not loaded behind it: at the
 * third reading some of them are, and all of them write more than the system has. */
Test(gmp, loading_ends_at_a_limit)
{
    watch_gmp();
    fmb_system *s = long_budgets(6, 12, 50000), *out = NULL;
    fmb_options o = {.size = sizeof o, .max_seconds = 3};
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    size_t system = held;
    int keep[] = {0, 1};
    must(fmb_solver_new(&o, &counted, &v));
    counted_clock_start(0, NULL, NULL);
    written = 0;
    must(fmb_project(v, s, keep, 2, &out, &r));
    counted_clock_stop();
    cr_expect_eq(r.stop, FMB_STOP_TIME);
    cr_expect_lt(written, system, "%zu bytes of results, the system has %zu", written, system);
    fmb_system_free(out);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* Whether to go on is asked for each ray of long numbers that is made, as one of them may take
 * long. */
Test(gmp, each_ray)
{
    fmb_system *s = long_budgets(5, 10, 300);
    fmb_options o = {.size = sizeof o, .max_seconds = COUNTED_FOREVER, .method = FMB_METHOD_DD};
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    fmb_generators *g = NULL;
    must(fmb_solver_new(&o, &counted, &v));
    counted_clock_start(0, NULL, NULL);
    must(fmb_generate(v, s, &g, &r));
    counted_clock_stop();
    cr_assert_eq(r.stop, FMB_STOP_DONE);
    cr_expect_gt(fmb_generators_size(g), 20, "%zu rays", fmb_generators_size(g));
    cr_expect_gt(counted_clock_readings(), fmb_generators_size(g), "%zu readings, %zu rays",
                 counted_clock_readings(), fmb_generators_size(g));
    fmb_generators_free(g);
    fmb_solver_free(v);
    fmb_system_free(s);
}
