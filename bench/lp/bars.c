/* bars.c: see bars.h. Times are CPU times of one thread on this machine; ratios are more reliable
 * than seconds. */
#include "bars.h"

#include <math.h>
#include <string.h>

typedef struct bar bar;
typedef void bar_judge(const bar *b, const lines *all, const line_plan *plan, bar_result *r);

struct bar {
    const char *trial; /* NULL: every trial */
    const char *about;
    bar_judge *judge;
    const char *key; /* a driver, or the end or the beginning of a system's name */
    double limit;
};

static int driver_of(const line_plan *plan, const char *name)
{
    for (int d = 0; d < plan->drivers; d++)
        if (strcmp(plan->driver[d]->name, name) == 0)
            return d;
    return -1;
}

/* The value becomes x, of line l, if it is the largest so far. */
static void take_largest(bar_result *r, const line *l, double x)
{
    static const char *const dress[] = {"", " (scales)", " (fractions)"};
    if (r->known && !(x > r->value))
        return;
    r->known = true;
    r->value = x;
    snprintf(r->worst, sizeof r->worst, "%s%s", l->name, dress[l->dress]);
}

/* fmb's time, or the limit if it did not answer. */
static double time_of(const line *l)
{
    const child_outcome *o = &l->outcome[0];
    return o->end == CHILD_DONE ? o->typical : o->limit;
}

/* ---- judges ---------------------------------------------------------------------------------- */

static void judge_faults(const lines *all, line_fault fault, bar_result *r)
{
    r->known = true;
    for (size_t i = 0; i < all->n; i++)
        if (all->list[i].fault == fault) {
            r->value++;
            snprintf(r->worst, sizeof r->worst, "%s", all->list[i].name);
        }
}

static void judge_undecided(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)b, (void)plan;
    judge_faults(all, LINE_UNDECIDED, r);
}

static void judge_wrong(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)b, (void)plan;
    judge_faults(all, LINE_WRONG, r);
}

static void judge_unproved(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)b, (void)plan;
    judge_faults(all, LINE_UNPROVED, r);
}

/* fmb's time, or its limit if it did not finish, over that of the driver. */
static double against(const line *l, int d)
{
    const child_outcome *them = &l->outcome[d];
    return them->end == CHILD_DONE && them->typical > 0 ? time_of(l) / them->typical : 0;
}

static void judge_mean(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    int d = driver_of(plan, b->key), n = 0;
    double sum = 0;
    for (size_t i = 0; d >= 0 && i < all->n; i++) {
        double x = against(&all->list[i], d);
        sum += x > 0 ? log(x) : 0;
        n += x > 0;
    }
    r->known = n > 0;
    r->value = n > 0 ? exp(sum / n) : 0;
}

static void judge_largest(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    int d = driver_of(plan, b->key);
    for (size_t i = 0; d >= 0 && i < all->n; i++)
        take_largest(r, &all->list[i], against(&all->list[i], d));
}

/* The driver's time over fmb's. */
static void judge_ahead(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    judge_mean(b, all, plan, r);
    r->value = r->value > 0 ? 1 / r->value : 0;
    r->least = true;
}

static bool has_key(const line *l, const char *key)
{
    return strstr(l->name, key) != NULL;
}

static void judge_seconds(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)plan;
    for (size_t i = 0; i < all->n; i++)
        if (has_key(&all->list[i], b->key))
            take_largest(r, &all->list[i], time_of(&all->list[i]));
}

static void judge_peak(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)plan;
    for (size_t i = 0; i < all->n; i++)
        if (has_key(&all->list[i], b->key))
            take_largest(r, &all->list[i], (double)all->list[i].peak);
}

/* The peak memory over its allowance. */
static void judge_memory(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)b, (void)plan;
    for (size_t i = 0; i < all->n; i++)
        take_largest(r, &all->list[i],
                     (double)all->list[i].peak / (50 * (double)all->list[i].bytes + 50e6));
}

/* The line of the same system unchanged; NULL if there is none. */
static const line *plain_twin(const lines *all, size_t i)
{
    for (size_t k = i; k-- > 0;)
        if (all->list[k].dress == DRESS_NONE && strcmp(all->list[k].name, all->list[i].name) == 0)
            return &all->list[k];
    return NULL;
}

static void judge_twins(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)b, (void)plan;
    for (size_t i = 0; i < all->n; i++) {
        const line *plain = all->list[i].dress ? plain_twin(all, i) : NULL;
        if (plain)
            take_largest(r, &all->list[i], time_of(&all->list[i]) / time_of(plain));
    }
}

static void judge_twin_totals(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)b, (void)plan;
    double dressed = 0, plain = 0;
    for (size_t i = 0; i < all->n; i++)
        *(all->list[i].dress ? &dressed : &plain) += time_of(&all->list[i]);
    r->known = plain > 0;
    r->value = plain > 0 ? dressed / plain : 0;
}

static void judge_twin_answers(const bar *b, const lines *all, const line_plan *plan, bar_result *r)
{
    (void)b, (void)plan;
    r->known = true;
    for (size_t i = 0; i < all->n; i++) {
        const line *plain = all->list[i].dress ? plain_twin(all, i) : NULL;
        if (plain && plain->verdict != all->list[i].verdict) {
            r->value++;
            snprintf(r->worst, sizeof r->worst, "%s", plain->name);
        }
    }
}

/* ---- the bars -------------------------------------------------------------------------------- */

static const bar BARS[] = {
    {NULL, "undecided", judge_undecided, NULL, 0},
    {NULL, "wrong", judge_wrong, NULL, 0},
    {NULL, "not proved", judge_unproved, NULL, 0},
    {NULL, "memory by what it may be", judge_memory, NULL, 1},
    {"lp2-verdict", "fmb / GLPK, geometric mean", judge_mean, "glpk", 2},
    {"lp2-verdict", "fmb / GLPK, largest", judge_largest, "glpk", 5},
    {"lp2-verdict", "ahead of QSopt_ex, geometric mean", judge_ahead, "qsopt", 5},
    {"lp2-verdict", "ahead of cddlib, geometric mean", judge_ahead, "cdd-block", 10},
    {"lp2-box", "fmb / GLPK, largest", judge_largest, "glpk", 3},
    {"lp2-reduce", "d_n50_m100_f [s]", judge_seconds, "d_n50_m100_f", 0.015},
    {"lp2-reduce", "s_n50_m100 [s]", judge_seconds, "s_n50_m100_", 0.008},
    {"lp2-reduce", "ball_1k_5 [s]", judge_seconds, "ball_1k_5", 0.3},
    {"lp2-reduce", "s_n50_m500_f [s]", judge_seconds, "s_n50_m500_f", 1},
    {"lp2-reduce", "sphere_3k_3 [s]", judge_seconds, "sphere_3k_3", 5},
    {"random", "2,000 x 100 [s]", judge_seconds, ":2000x100", 1},
    {"random", "5,000 x 200 [s]", judge_seconds, ":5000x200", 1},
    {"random", "20,000 x 300 [s]", judge_seconds, ":20000x300", 10},
    {"random", "20,000 x 300 [bytes]", judge_peak, ":20000x300", 1e9},
    {"scaled", "other verdicts", judge_twin_answers, NULL, 0},
    {"scaled", "scaled / as they are, totals", judge_twin_totals, NULL, 5},
    {"fractions", "fractions / as they are, totals", judge_twin_totals, NULL, 5},
    {"fractions", "fractions / as they are, largest", judge_twins, NULL, 5},
};

int bars_judge(const trial *t, const lines *all, const line_plan *plan, bar_result out[BARS_MOST])
{
    int n = 0;
    for (size_t i = 0; i < sizeof BARS / sizeof *BARS; i++) {
        const bar *b = &BARS[i];
        if (b->trial && strcmp(b->trial, t->name) != 0)
            continue;
        bar_result *r = &out[n++];
        *r = (bar_result){.about = b->about, .limit = b->limit};
        b->judge(b, all, plan, r);
        r->good = !r->known || (r->least ? r->value >= r->limit : r->value <= r->limit);
    }
    return n;
}
