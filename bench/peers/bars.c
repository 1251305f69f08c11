/* bars.c: see bars.h.
 *
 * A side finishes a problem if any of its drivers does; its best driver counts. If fmb does not
 * finish, its time is the limit.
 */
#include "bars.h"

#include <math.h>

/* least: bound on the best time of the side over fmb's; 0: none. */
typedef struct bar {
    const char *libraries;
    double share, mean, least;
} bar;

/* Of projections, and of vertices and hulls; NULL ends a list. */
static const bar PROJECTION_BARS[] = {
    {"ppl,cddlib,isl,normaliz", 95, 8, 1 / 1.5},
    {"pplite", 90, 6, 0},
    {NULL, 0, 0, 0},
};
static const bar CONE_BARS[] = {
    {"cddlib", 100, 1, 0},  {"ppl", 100, 1, 0}, {"lrslib", 80, 1, 0},
    {"normaliz", 60, 1, 0}, {NULL, 0, 0, 0},
};

static const bar *bars_of_question(peer_question question)
{
    return question == PEER_PROJECT ? PROJECTION_BARS : CONE_BARS;
}

/* Fruitless attempts may cost half the time of the best method. */
static const double PRICE = 1.5;

static bool is_of_side(const peer *p, const bar *b)
{
    return b ? !p->ours && peer_is_listed(b->libraries, p) : p->single;
}

bool bars_same_side(peer_question question, const peer *a, const peer *b)
{
    for (const bar *k = bars_of_question(question); k->libraries; k++)
        if (is_of_side(a, k) && is_of_side(b, k))
            return true;
    return a->ours && b->ours;
}

/* The fastest driver of a side (NULL: fmb's single methods) on a problem, or -1. */
static int best_of_side(const report *r, const entry *e, const bar *b)
{
    int best = -1;
    for (int d = 0; d < r->drivers; d++)
        if (is_of_side(r->driver[d], b) && e->outcome[d].end == CHILD_DONE &&
            (best < 0 || e->outcome[d].typical < e->outcome[best].typical))
            best = d;
    return best;
}

static double seconds_of_fmb(const report *r, const entry *e)
{
    return e->outcome[0].end == CHILD_DONE ? e->outcome[0].typical : r->limits.seconds;
}

/* The best time of a side over fmb's; 0 if no driver of it finished. */
static double ratio_of_side(const report *r, const entry *e, const bar *b)
{
    int d = best_of_side(r, e, b);
    return d < 0 ? 0 : e->outcome[d].typical / seconds_of_fmb(r, e);
}

static void print_behind(const report *r, const bar *b, double ahead)
{
    for (size_t i = 0; i < r->entries; i++) {
        const entry *e = &r->list[i];
        int d = best_of_side(r, e, b);
        double ratio = ratio_of_side(r, e, b);
        if (d >= 0 && ratio < ahead)
            printf("    %-24s %6.2f  fmb %10.1f us, %s %10.1f us\n", e->problem.name, ratio,
                   1e6 * seconds_of_fmb(r, e), r->driver[d]->name, 1e6 * e->outcome[d].typical);
    }
}

static void print_bar(const report *r, const bar *b)
{
    int finished = 0, won = 0;
    double logs = 0, least = INFINITY;
    for (size_t i = 0; i < r->entries; i++) {
        double ratio = ratio_of_side(r, &r->list[i], b);
        if (ratio <= 0)
            continue;
        finished++;
        won += ratio >= 1;
        logs += log(ratio);
        least = fmin(least, ratio);
    }
    if (finished == 0)
        return;
    printf("against %s: %d finished\n  at least as fast on %.1f %% (bar %.0f), geometric mean %.2f "
           "(bar %.0f), least %.2f",
           b->libraries, finished, 100.0 * won / finished, b->share, exp(logs / finished), b->mean,
           least);
    if (b->least > 0)
        printf(" (bar %.2f)", b->least);
    printf("\n");
    print_behind(r, b, 1);
}

static void print_price(const report *r)
{
    int finished = 0, dear = 0;
    double logs = 0, most = 0;
    for (size_t i = 0; i < r->entries; i++) {
        double ratio = ratio_of_side(r, &r->list[i], NULL);
        if (ratio <= 0)
            continue;
        finished++;
        dear += 1 / ratio > PRICE;
        logs -= log(ratio);
        most = fmax(most, 1 / ratio);
    }
    if (finished == 0)
        return;
    printf("price of having tried: %d finished\n  above %.1f on %d, geometric mean %.2f, most "
           "%.2f\n",
           finished, PRICE, dear, exp(logs / finished), most);
    print_behind(r, NULL, 1 / PRICE);
}

void bars_print(const report *r)
{
    printf("\n");
    for (const bar *k = bars_of_question(r->limits.question); k->libraries; k++)
        print_bar(r, k);
    print_price(r);
    int lost = 0;
    for (size_t i = 0; i < r->entries; i++)
        lost += r->list[i].outcome[0].end != CHILD_DONE;
    printf("not finished by fmb: %d\n", lost);
    for (size_t i = 0; i < r->entries; i++)
        if (r->list[i].outcome[0].end != CHILD_DONE)
            printf("    %s\n", r->list[i].problem.name);
}
