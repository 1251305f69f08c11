/* trend.c: see trend.h. */
#include "trace/trend.h"

#include <math.h>

/* How much the last step counts in how long a step is, and that in the factor. */
#define LATEST_LENGTH 0.4
#define LATEST_FACTOR 0.3
/* A step of which less is done tells nothing of its length. */
#define LEAST_SHARE 0.1
/* Factors are told up to so many steps ahead; from there on work stays as it is. */
#define MOST_STEPS_AHEAD 32

/* Source: Holt 1957, Forecasting seasonals and trends by exponentially weighted averages. */
void fmb_trend_end_step(fmb_trend *t, uint64_t work)
{
    fmb_trend_pause(t, work);
    double length = log(fmax(1, t->now)), before = t->length;
    t->length =
        t->steps == 0 ? length : before + t->growth + LATEST_LENGTH * (length - before - t->growth);
    if (t->steps++ > 0)
        t->growth += LATEST_FACTOR * (t->length - before - t->growth);
    t->now = 0;
}

/* Growth fades away while steps become fewer: the last one is about as long as the one before. So
 * the exponent is the sum of growth (1 - i / steps). */
static double sum_of_steps(double first, double growth, size_t steps)
{
    double sum = 0, work = first;
    for (size_t i = 0; i < steps && i < MOST_STEPS_AHEAD; i++) {
        work *= exp(growth * (1 - (double)i / (double)steps));
        sum += work;
    }
    return steps > MOST_STEPS_AHEAD ? sum + work * (double)(steps - MOST_STEPS_AHEAD) : sum;
}

double fmb_trend_left(const fmb_trend *t, double share, size_t steps)
{
    bool tells = t->now > 0 && share >= LEAST_SHARE;
    if (steps == 0)
        return 0;
    if (!tells && t->steps == 0)
        return INFINITY;
    double whole = tells ? t->now / share : exp(t->length + t->growth);
    /* A step that takes longer than expected may be half done. */
    double rest = fmax(whole - t->now, tells ? 0 : t->now);
    return rest + sum_of_steps(t->now + rest, t->growth, steps - 1);
}
