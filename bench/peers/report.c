/* report.c: see report.h. The table goes to stdout as the runs end. */
#include <math.h>
#include <string.h>

#include "../machine.h"
#include "report.h"

/* ---- judging --------------------------------------------------------------------------------- */

static bool is_decision(const report *r)
{
    return !peer_is_list(r->limits.question);
}

static bool answered(const child_outcome *o, bool decide)
{
    return o->end == CHILD_DONE && (decide ? o->verdict != FMB_UNKNOWN : o->text != NULL);
}

static bool same(const child_outcome *a, const child_outcome *b, bool decide)
{
    return decide ? a->verdict == b->verdict : strcmp(a->text, b->text) == 0;
}

/* Compare the answers with the first exact one (fmb's, if it has one). */
static void judge_answers(const report *r, entry *e)
{
    int first = -1;
    for (int d = 0; d < r->drivers; d++) {
        const child_outcome *o = &e->outcome[d];
        if (!answered(o, is_decision(r))) {
            e->silent |= o->end != CHILD_CANNOT;
            continue;
        }
        if (first < 0 && !r->driver[d]->inexact)
            first = d;
        e->unlike[d] = o->unlike || (first >= 0 && !same(&e->outcome[first], o, is_decision(r)));
        e->wrong |= e->unlike[d] && !r->driver[d]->inexact;
    }
}

void report_judge(const report *r, entry *e)
{
    e->best = -1;
    judge_answers(r, e);
    for (int d = 0; d < r->drivers; d++) {
        bool counts = !r->driver[d]->ours && e->outcome[d].end == CHILD_DONE;
        if (counts && (e->best < 0 || e->outcome[d].typical < e->outcome[e->best].typical))
            e->best = d;
    }
    e->ratio = 0;
    if (e->best >= 0 && r->driver[0]->ours) {
        const child_outcome *us = &e->outcome[0];
        double ours = us->end == CHILD_DONE ? us->typical : r->limits.seconds;
        e->ratio = e->outcome[e->best].typical / ours;
    }
}

/* ---- the table ------------------------------------------------------------------------------- */

static void put_seconds(double t)
{
    if (t < 1e-3)
        printf("%9.1f us", 1e6 * t);
    else if (t < 1)
        printf("%9.2f ms", 1e3 * t);
    else
        printf("%9.2f s ", t);
}

static void put_outcome(const child_outcome *o)
{
    char word[32];
    switch (o->end) {
    case CHILD_DONE:
        put_seconds(o->typical);
        return;
    case CHILD_TIME:
        snprintf(word, sizeof word, "> %.3g s ", o->limit);
        break;
    case CHILD_GAVE_UP:
        snprintf(word, sizeof word, "gave up");
        break;
    case CHILD_CANNOT:
        snprintf(word, sizeof word, "-");
        break;
    case CHILD_CRASHED:
        snprintf(word, sizeof word, "signal %d", o->signal);
        break;
    }
    printf("%12s", word);
}

void report_head(const report *r)
{
    printf("%-20s%-9s%4s%5s%4s%5s", "problem", "family", "n", "m", "eq", "keep");
    for (int d = 0; d < r->drivers; d++)
        printf("%12s", r->driver[d]->name);
    printf("  %-12s%9s  %s\n", "best peer", "best/fmb", "equal");
}

void report_line(const report *r, const entry *e)
{
    const problem *p = &e->problem;
    printf("%-20s%-9s%4d%5zu%4zu%5d", p->name, p->family, p->n, p->m, p->equalities, p->keep);
    for (int d = 0; d < r->drivers; d++)
        put_outcome(&e->outcome[d]);
    printf("  %-12s", e->best >= 0 ? r->driver[e->best]->name : "none");
    if (e->ratio > 0)
        printf("%9.2f", e->ratio);
    else
        printf("%9s", "");
    printf("  %s", e->wrong ? "WRONG:" : "yes");
    for (int d = 0; d < r->drivers; d++) {
        if (e->unlike[d])
            printf(e->wrong ? " %s" : ", but not %s (doubles)", r->driver[d]->name);
    }
    printf("\n");
    fflush(stdout);
}

/* ---- the summary ----------------------------------------------------------------------------- */

typedef struct total {
    int problems, finished, ours, won, wrong;
    double log_ratio, least;
} total;

static total add_up(const report *r, const char *family)
{
    total t = {.least = INFINITY};
    for (size_t i = 0; i < r->entries; i++) {
        const entry *e = &r->list[i];
        if (family && strcmp(family, e->problem.family) != 0)
            continue;
        t.problems++;
        t.ours += e->outcome[0].end == CHILD_DONE;
        t.wrong += e->wrong;
        if (e->ratio <= 0)
            continue;
        t.finished++;
        t.won += e->ratio >= 1;
        t.log_ratio += log(e->ratio);
        t.least = fmin(t.least, e->ratio);
    }
    return t;
}

static void put_total(const char *name, const total *t)
{
    printf("%-10s%9d%7d%11d%9d%8.0f%%%12.2f%9.2f%7d\n", name, t->problems, t->ours, t->finished,
           t->won, t->finished ? 100.0 * t->won / t->finished : 0,
           t->finished ? exp(t->log_ratio / t->finished) : 0, t->finished ? t->least : 0, t->wrong);
}

/* Totals against one peer: the problems that it finished; if fmb did not, its time is the limit. */
static total add_up_peer(const report *r, int d)
{
    total t = {.least = INFINITY};
    for (size_t i = 0; i < r->entries; i++) {
        const child_outcome *us = &r->list[i].outcome[0], *them = &r->list[i].outcome[d];
        t.problems++;
        t.ours += us->end == CHILD_DONE;
        t.wrong += r->list[i].unlike[d];
        if (them->end != CHILD_DONE)
            continue;
        double ratio = them->typical / (us->end == CHILD_DONE ? us->typical : r->limits.seconds);
        t.finished++;
        t.won += ratio >= 1;
        t.log_ratio += log(ratio);
        t.least = fmin(t.least, ratio);
    }
    return t;
}

/* Is problem i the first of its family? */
static bool opens_family(const report *r, size_t i)
{
    for (size_t k = 0; k < i; k++) {
        if (strcmp(r->list[k].problem.family, r->list[i].problem.family) == 0)
            return false;
    }
    return true;
}

void report_summary(const report *r)
{
    printf("\n%-10s%9s%7s%11s%9s%9s%12s%9s%7s\n", "family", "problems", "fmb", "some peer",
           "fmb won", "share", "geo. mean", "least", "wrong");
    for (size_t i = 0; i < r->entries; i++) {
        if (!opens_family(r, i))
            continue;
        total t = add_up(r, r->list[i].problem.family);
        put_total(r->list[i].problem.family, &t);
    }
    total t = add_up(r, NULL);
    put_total("all", &t);
    printf("\n%-10s%9s%7s%11s%9s%9s%12s%9s%7s\n", "peer", "problems", "fmb", "peer", "fmb won",
           "share", "geo. mean", "least", "unlike");
    for (int d = 0; d < r->drivers; d++) {
        t = add_up_peer(r, d);
        if (!r->driver[d]->ours)
            put_total(r->driver[d]->name, &t);
    }
}

/* ---- JSON ------------------------------------------------------------------------------------ */

static void json_outcome(FILE *out, const report *r, const entry *e, int d)
{
    static const char *const word[] = {[CHILD_DONE] = "done",
                                       [CHILD_TIME] = "time",
                                       [CHILD_GAVE_UP] = "gave up",
                                       [CHILD_CANNOT] = "cannot",
                                       [CHILD_CRASHED] = "crashed"};
    const child_outcome *o = &e->outcome[d];
    fprintf(out, "%s\"%s\": {\"end\": \"%s\"", d ? ", " : "", r->driver[d]->name, word[o->end]);
    if (o->end == CHILD_DONE)
        fprintf(out, ", \"us\": %.3f, \"first_us\": %.3f, \"runs\": %d", 1e6 * o->typical,
                1e6 * o->first, o->runs);
    fprintf(out, "}");
}

static void json_entry(FILE *out, const report *r, const entry *e)
{
    const problem *p = &e->problem;
    fprintf(out,
            "{\"problem\": \"%s\", \"family\": \"%s\", \"n\": %d, \"m\": %zu, \"equalities\": %zu, "
            "\"keep\": %d, \"best\": ",
            p->name, p->family, p->n, p->m, p->equalities, p->keep);
    if (e->best >= 0)
        fprintf(out, "\"%s\"", r->driver[e->best]->name);
    else
        fprintf(out, "null");
    fprintf(out, ", \"ratio\": %.4f, \"equal\": %s, \"drivers\": {", e->ratio,
            e->wrong ? "false" : "true");
    for (int d = 0; d < r->drivers; d++)
        json_outcome(out, r, e, d);
    fprintf(out, "}}");
}

bool report_json(const report *r, const char *path)
{
    FILE *out = fopen(path, "w");
    if (!out)
        return false;
    static const char *const word[PEER_QUESTIONS] = {[PEER_PROJECT] = "project",
                                                     [PEER_DECIDE] = "decide",
                                                     [PEER_VERTICES] = "vertices",
                                                     [PEER_HULL] = "hull"};
    total t = add_up(r, NULL);
    fprintf(out, "{");
    print_machine_json(out);
    fprintf(out,
            ", \"question\": \"%s\", \"seconds\": %g, \"problems\": %d, \"some_peer\": %d, "
            "\"fmb_won\": %d, \"geometric_mean\": %.4f, \"wrong\": %d, \"lines\": [\n",
            word[r->limits.question], r->limits.seconds, t.problems, t.finished, t.won,
            t.finished ? exp(t.log_ratio / t.finished) : 0, t.wrong);
    for (size_t i = 0; i < r->entries; i++) {
        json_entry(out, r, &r->list[i]);
        fprintf(out, i + 1 < r->entries ? ",\n" : "\n");
    }
    fprintf(out, "]}\n");
    return fclose(out) == 0;
}
