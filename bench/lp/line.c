/* line.c: see line.h. */
#include "line.h"

#include <math.h>
#include <stdlib.h>

#include "../machine.h"

enum { ROUNDS = 32 };

/* ---- judging --------------------------------------------------------------------------------- */

static bool is_done(const child_outcome *o)
{
    return o->end == CHILD_DONE && o->verdict != FMB_UNKNOWN;
}

/* Equal up to the tolerance of doubles; infinities exactly. */
static bool are_near(double x, double y)
{
    if (isinf(x) || isinf(y))
        return x == y;
    return fabs(x - y) <= 1e-6 * fmax(1, fmax(fabs(x), fabs(y)));
}

static bool same_answers(const child_outcome *a, const child_outcome *b)
{
    bool same = a->verdict == b->verdict && (a->numbers == b->numbers || b->numbers == 0);
    for (size_t i = 0; same && i < b->numbers; i++)
        same = are_near(a->number[i], b->number[i]);
    return same;
}

/* fmb is wrong if an exact peer differs, or the planted verdict, or the known optimum. */
static line_fault judge_line(line *l, const subject *s, const line_plan *plan)
{
    const child_outcome *us = &l->outcome[0], *proof = &l->outcome[1];
    if (!is_done(us) || !is_done(proof))
        return LINE_UNDECIDED;
    bool wrong = us->unlike || proof->unlike || !same_answers(us, proof) ||
                 (s->verdict != FMB_UNKNOWN && s->verdict != us->verdict);
    if (s->has_best && l->question == PEER_OPTIMIZE)
        wrong |= us->numbers != 1 || !are_near(us->number[0], s->best);
    for (int d = 2; d < plan->drivers; d++) {
        l->differs[d] = is_done(&l->outcome[d]) && !same_answers(us, &l->outcome[d]);
        wrong |= l->differs[d] && !plan->driver[d]->inexact;
    }
    return wrong ? LINE_WRONG : !proof->proved ? LINE_UNPROVED : LINE_RIGHT;
}

/* ---- measuring ------------------------------------------------------------------------------- */

static double spent(const child_outcome *o)
{
    return o->end == CHILD_DONE ? o->first : o->limit;
}

/* A round: each driver once, in a child of its own. False when the time of the line is used up. */
static bool run_round(line *l, const subject *s, const line_plan *plan, int round,
                      double times[][ROUNDS])
{
    double all = 0;
    for (int d = 0; d < plan->drivers; d++) {
        child_outcome o = {0}, *to = &l->outcome[d];
        if (round > 0 && to->end != CHILD_DONE)
            continue;
        o = child_run(plan->driver[d], s->variant, &plan->limits);
        times[d][round] = o.typical;
        all += spent(&o);
        if (round == 0 || o.end != CHILD_DONE) {
            child_outcome_clear(to);
            *to = o;
        } else
            child_outcome_clear(&o);
    }
    return all < 1;
}

static void take_median(line *l, const line_plan *plan, int rounds, double times[][ROUNDS])
{
    for (int d = 0; d < plan->drivers; d++)
        if (l->outcome[d].end == CHILD_DONE)
            l->outcome[d].typical = median(times[d], rounds);
}

void line_measure(line *l, const subject *s, subject_dress dress, const line_plan *plan)
{
    static double times[LINE_DRIVERS][ROUNDS];
    line_plan p = *plan;
    int rounds = 0;
    *l = (line){.n = s->n, .m = s->m, .terms = s->terms, .bytes = s->bytes, .dress = dress};
    snprintf(l->name, sizeof l->name, "%s", s->name);
    p.limits.variants = s->variants;
    l->question = p.limits.question;
    while (rounds < plan->rounds && rounds < ROUNDS)
        if (!run_round(l, s, &p, rounds++, times))
            break;
    take_median(l, plan, rounds, times);
    l->fault = judge_line(l, s, plan);
    l->verdict = l->outcome[0].verdict;
    l->peak = l->outcome[1].peak;
    for (int d = 0; d < plan->drivers; d++) {
        child_outcome_clear(&l->outcome[d]);
        l->outcome[d].text = NULL;
        l->outcome[d].number = NULL;
    }
}

double line_ratio(const line *l, int d)
{
    const child_outcome *us = &l->outcome[0], *them = &l->outcome[d];
    bool both = us->end == CHILD_DONE && them->end == CHILD_DONE && them->typical > 0;
    return both ? us->typical / them->typical : 0;
}

bool line_is_lean(const line *l)
{
    return (double)l->peak <= 50 * (double)l->bytes + 50e6;
}
