/* The clock of studies: which way answers which queries, in which order, and its statistics. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include "counted_clock.h"
#include "study/clock/clock.h"

enum { MOST_CALLS = 256 };

/* A way that notes what it is asked. */
typedef struct noted {
    char name;
    char *log; /* the ways' names in the order of the calls */
    size_t asked[MOST_CALLS], first[MOST_CALLS], calls;
    fmb_status st;
} noted;

static fmb_status note(void *self, size_t first, size_t n)
{
    noted *w = self;
    w->first[w->calls] = first;
    w->asked[w->calls++] = n;
    if (w->log)
        w->log[strlen(w->log)] = w->name;
    return w->st;
}

Test(clock, ways_take_turns)
{
    char log[MOST_CALLS] = "";
    noted a = {.name = 'a', .log = log}, b = {.name = 'b', .log = log};
    const study_timed way[] = {{note, &a}, {note, &b}};
    study_clock c = {.way = way, .ways = 2, .queries = 10, .groups = 1, .passes = 3};
    cr_assert_eq(study_clock_run(&c), FMB_OK);
    cr_assert_eq(c.complete, 3);
    /* One round that is not counted, then three. */
    cr_assert_str_eq(log, "abbaabba");
    study_clock_clear(&c);
}

Test(clock, each_query_once_a_pass)
{
    noted a = {.name = 'a'};
    const study_timed way[] = {{note, &a}};
    study_clock c = {.way = way, .ways = 1, .queries = 11, .groups = 4, .passes = 2};
    cr_assert_eq(study_clock_run(&c), FMB_OK);
    cr_assert_eq(a.calls, 3 * 4);
    for (size_t i = 0; i < a.calls; i++) {
        size_t end = i % 4 == 3 ? 11 : a.first[i + 1];
        cr_assert_eq(a.first[i] + a.asked[i], end);
        cr_assert(a.asked[i] == 2 || a.asked[i] == 3);
    }
    study_clock_clear(&c);
}

static bool three_times(void *self, size_t done, size_t all)
{
    cr_assert_lt(done, all);
    return ++*(int *)self <= 3;
}

Test(clock, ends_early)
{
    int asked = 0;
    noted a = {.name = 'a'}, b = {.name = 'b'};
    const study_timed way[] = {{note, &a}, {note, &b}};
    study_clock c = {.way = way,
                     .ways = 2,
                     .queries = 1,
                     .groups = 1,
                     .passes = 5,
                     .step = three_times,
                     .self = &asked};
    cr_assert_eq(study_clock_run(&c), FMB_OK);
    cr_assert_eq(c.complete, 0);
    cr_assert_eq(a.calls + b.calls, 3);
    cr_assert(isnan(study_clock_ns(&c, 0).median) && isnan(study_clock_ratio(&c, 0, 1).most));
    study_clock_clear(&c);

    study_clock limited = {.way = way, .ways = 2, .queries = 1, .groups = 1, .passes = 5};
    limited.max_seconds = 1e-9;
    cr_assert_eq(study_clock_run(&limited), FMB_OK);
    cr_assert_eq(limited.complete, 1);
    study_clock_clear(&limited);
}

Test(clock, refuses)
{
    noted a = {.name = 'a', .st = FMB_ERR_MEMORY};
    const study_timed way[] = {{note, &a}};
    study_clock none = {.way = way, .ways = 1, .queries = 0, .groups = 0, .passes = 1};
    cr_assert_eq(study_clock_run(&none), FMB_ERR_ARG);
    study_clock fine = {.way = way, .ways = 1, .queries = 1, .groups = 2, .passes = 1};
    cr_assert_eq(study_clock_run(&fine), FMB_ERR_ARG);
    study_clock many = {.way = way, .ways = 1, .queries = 1, .groups = 1};
    many.passes = STUDY_CLOCK_MOST_PASSES + 1;
    cr_assert_eq(study_clock_run(&many), FMB_ERR_ARG);
    study_clock failing = {.way = way, .ways = 1, .queries = 1, .groups = 1, .passes = 1};
    cr_assert_eq(study_clock_run(&failing), FMB_ERR_MEMORY);
    cr_assert_eq(failing.complete, 0);
    study_clock_clear(&failing);
}

Test(clock, spread)
{
    double odd[] = {3, 1, 2}, even[] = {4, 1, 3, 2};
    study_spread s = study_spread_of(odd, 3);
    cr_assert(s.least == 1 && s.median == 2 && s.most == 3);
    s = study_spread_of(even, 4);
    cr_assert(s.least == 1 && s.median == 2.5 && s.most == 4);
    cr_assert(isnan(study_spread_of(even, 0).median));
}

/* Numbers of which the results are known: two passes, two ways, two groups of two queries. */
Test(clock, results)
{
    double seconds[] = {1, 3, 2, 2, /**/ 2, 6, 4, 8};
    const study_timed way[] = {{note, NULL}, {note, NULL}};
    study_clock c = {.way = way,
                     .ways = 2,
                     .queries = 4,
                     .groups = 2,
                     .passes = 2,
                     .seconds = seconds,
                     .complete = 2};
    study_spread s = study_clock_ns(&c, 0);
    cr_assert(s.least == 1e9 && s.median == 1.5e9 && s.most == 2e9);
    study_ratio r = study_clock_ratio(&c, 0, 1); /* 4/4, 8/12; the medians are 6 and 8 */
    cr_assert(r.ratio == 0.75 && r.least == 8.0 / 12 && r.most == 1);
    cr_assert_eq(study_clock_group_ns(&c, 0, &s), FMB_OK);
    cr_assert(s.least == 0.75e9 && s.most == 2.25e9);
    cr_assert_eq(study_clock_group_ratio(&c, 0, 1, &r), FMB_OK);
    cr_assert(r.ratio == 0.75 && r.least == 0.5 && r.most == 0.9); /* 1.5/3, 4.5/5 */
}

/* Whoever divides the medians finds the ratio; it lies between the least and the most. */
Test(clock, ratios)
{
    const double a[] = {5, 9, 1, 4, 8}, b[] = {1, 3, 2, 8, 4};
    study_ratio r = study_ratio_of_medians(a, b, 5), m = study_median_of_ratios(a, b, 5),
                t = study_ratio_of_sums(a, b, 5);
    cr_assert(r.ratio == 5.0 / 3 && m.ratio == 2 && t.ratio == 27.0 / 18);
    const study_ratio *all[] = {&r, &m, &t};
    for (int i = 0; i < 3; i++) {
        cr_assert(all[i]->least == 0.5 && all[i]->most == 5);
        cr_assert(all[i]->least <= all[i]->low && all[i]->low < all[i]->ratio);
        cr_assert(all[i]->ratio < all[i]->high && all[i]->high <= all[i]->most);
    }
    study_ratio again = study_ratio_of_medians(a, b, 5), one = study_ratio_of_medians(a, b, 1);
    cr_assert(again.low == r.low && again.high == r.high, "another seed");
    cr_assert(one.low == 5 && one.ratio == 5 && one.high == 5);
    cr_assert(isnan(study_ratio_of_sums(a, b, 0).ratio));
}

/* The interval of a mean's ratio is as wide as theory says: of n pairs x / 1, x evenly from 0 to 2,
 * the sum's lies 1.96 / sqrt(3 n) to either side. */
Test(clock, interval)
{
    enum { N = 900 };
    double a[N], b[N];
    for (int i = 0; i < N; i++) {
        a[i] = 2 * (i + 0.5) / N;
        b[i] = 1;
    }
    study_ratio r = study_ratio_of_sums(a, b, N);
    double wide = 1.96 / sqrt(3.0 * N);
    cr_assert_float_eq(r.ratio, 1, 1e-12);
    cr_assert_float_eq(r.low, 1 - wide, wide / 5);
    cr_assert_float_eq(r.high, 1 + wide, wide / 5);
}

/* A way whose queries take so many seconds each, by a clock that counts. */
static fmb_status let_pass(void *self, size_t first, size_t n)
{
    (void)first;
    counted_clock_pass(*(size_t *)self * n);
    return FMB_OK;
}

/* Of 20 queries, and a second from one reading to the next. */
Test(clock, measures)
{
    size_t slow = 10, fast = 1;
    const study_timed way[] = {{let_pass, &slow}, {let_pass, &fast}};
    study_clock c = {.way = way, .ways = 2, .queries = 20, .groups = 1, .passes = 3};
    counted_clock_start(0, NULL, NULL);
    cr_assert_eq(study_clock_run(&c), FMB_OK);
    counted_clock_stop();
    study_spread s = study_clock_ns(&c, 0);
    cr_assert(s.least == 201e9 / 20 && s.most == s.least);
    study_ratio r = study_clock_ratio(&c, 0, 1);
    cr_assert(r.ratio == 201.0 / 21 && r.least == r.ratio && r.most == r.ratio);
    study_clock_clear(&c);
}
