/* table.c: see table.h. */
#include "table.h"

#include <math.h>
#include <string.h>

#include "../machine.h"

static const char *const QUESTION[] = {[PEER_PROJECT] = "project",
                                       [PEER_DECIDE] = "verdict",
                                       [PEER_BOX] = "box",
                                       [PEER_REDUCE] = "reduce",
                                       [PEER_OPTIMIZE] = "optimize"};
static const char *const DRESS[] = {"", "~scales", "~fractions"};
static const char *const FAULT[] = {[LINE_RIGHT] = "",
                                    [LINE_UNDECIDED] = "undecided",
                                    [LINE_UNPROVED] = "NOT PROVED",
                                    [LINE_WRONG] = "WRONG"};

/* ---- text ------------------------------------------------------------------------------------ */

/* The word for an outcome without a time. */
static const char *word_of(const child_outcome *o)
{
    return o->end == CHILD_TIME      ? "> limit"
           : o->end == CHILD_GAVE_UP ? "gave up"
           : o->end == CHILD_CANNOT  ? "-"
                                     : "crashed";
}

static void put_outcome(const child_outcome *o)
{
    if (o->end == CHILD_DONE)
        printf("%12.3f", 1e3 * o->typical);
    else
        printf("%12s", word_of(o));
}

void table_head(const char *title, const line_plan *plan)
{
    printf("\n%s\n%-26s%-9s%5s%7s%8s", title, "system", "question", "n", "m", "terms");
    for (int d = 0; d < plan->drivers; d++)
        printf("%9s ms", plan->driver[d]->name);
    for (int d = 2; d < plan->drivers; d++)
        printf("%5s/%-5.5s", "fmb", plan->driver[d]->name);
    printf("%10s  %s\n", "peak MB", "verdict");
}

void table_line(const line *l, const line_plan *plan)
{
    char name[96];
    snprintf(name, sizeof name, "%s%s", l->name, DRESS[l->dress]);
    printf("%-26s%-9s%5d%7zu%8zu", name, QUESTION[l->question], l->n, l->m, l->terms);
    for (int d = 0; d < plan->drivers; d++)
        put_outcome(&l->outcome[d]);
    for (int d = 2; d < plan->drivers; d++) {
        double x = line_ratio(l, d);
        if (x > 0)
            printf("%11.2f", x);
        else
            printf("%11s", "");
    }
    printf("%9.1f%s  %-10s %s", (double)l->peak / 1e6, line_is_lean(l) ? " " : "!",
           l->fault == LINE_UNDECIDED ? "unknown" : fmb_verdict_text(l->verdict), FAULT[l->fault]);
    for (int d = 2; d < plan->drivers; d++)
        if (l->differs[d])
            printf(" (not %s%s)", plan->driver[d]->name,
                   plan->driver[d]->inexact ? ": doubles" : "");
    printf("\n");
    fflush(stdout);
}

static void summarize_driver(const lines *all, const line_plan *plan, int d)
{
    double sum = 0, most = 0;
    const line *worst = NULL;
    int n = 0;
    for (size_t i = 0; i < all->n; i++) {
        double x = line_ratio(&all->list[i], d);
        if (!(x > 0))
            continue;
        n++;
        sum += log(x);
        if (x > most) {
            most = x;
            worst = &all->list[i];
        }
    }
    if (n > 0)
        printf("fmb/%-10s geometric mean %8.3f of %d, largest %8.2f (%s%s)\n",
               plan->driver[d]->name, exp(sum / n), n, most, worst->name, DRESS[worst->dress]);
}

void table_summary(const lines *all, const line_plan *plan)
{
    int count[LINE_WRONG + 1] = {0};
    double proof = 0, plain = 0;
    for (size_t i = 0; i < all->n; i++) {
        const line *l = &all->list[i];
        count[l->fault]++;
        if (l->outcome[0].end == CHILD_DONE && l->outcome[1].end == CHILD_DONE) {
            plain += l->outcome[0].typical;
            proof += l->outcome[1].typical;
        }
    }
    for (int d = 2; d < plan->drivers; d++)
        summarize_driver(all, plan, d);
    printf("%zu answers: %d right, %d undecided, %d not proved, %d wrong; evidence takes %.2f "
           "times the time\n",
           all->n, count[LINE_RIGHT], count[LINE_UNDECIDED], count[LINE_UNPROVED],
           count[LINE_WRONG], plain > 0 ? proof / plain : 0);
}

void table_bars(const bar_result *r, int n)
{
    printf("\n%-40s%12s%12s  %-8s%s\n", "bar", "is", "has to be", "", "decided by");
    for (int i = 0; i < n; i++) {
        char limit[32];
        snprintf(limit, sizeof limit, "%s %.4g", r[i].least ? ">=" : "<=", r[i].limit);
        if (r[i].known)
            printf("%-40s%12.4g%12s  %-8s%s\n", r[i].about, r[i].value, limit,
                   r[i].good ? "good" : "BROKEN", r[i].worst);
        else
            printf("%-40s%12s%12s  %-8s\n", r[i].about, "?", limit, "not run");
    }
    fflush(stdout);
}

/* ---- JSON ------------------------------------------------------------------------------------ */

static void json_outcome(FILE *out, const char *name, const child_outcome *o, bool first)
{
    fprintf(out, "%s\"%s\": ", first ? "" : ", ", name);
    if (o->end == CHILD_DONE)
        fprintf(out, "{\"ms\": %.6f, \"first_ms\": %.6f}", 1e3 * o->typical, 1e3 * o->first);
    else
        fprintf(out, "\"%s\"", word_of(o));
}

static void json_line(FILE *out, const line *l, const line_plan *plan)
{
    fprintf(out,
            "    {\"system\": \"%s\", \"dress\": \"%s\", \"question\": \"%s\", \"n\": %d, "
            "\"m\": %zu, \"terms\": %zu, \"bytes\": %zu, \"peak_bytes\": %zu, \"verdict\": \"%s\", "
            "\"fault\": \"%s\", \"drivers\": {",
            l->name, DRESS[l->dress], QUESTION[l->question], l->n, l->m, l->terms, l->bytes,
            l->peak, fmb_verdict_text(l->verdict), FAULT[l->fault]);
    for (int d = 0; d < plan->drivers; d++)
        json_outcome(out, plan->driver[d]->name, &l->outcome[d], d == 0);
    fprintf(out, "}}");
}

static void json_bar(FILE *out, const bar_result *r)
{
    fprintf(out,
            "    {\"bar\": \"%s\", \"value\": %.6g, \"limit\": %.6g, \"at_least\": %s, "
            "\"known\": %s, \"good\": %s, \"worst\": \"%s\"}",
            r->about, r->value, r->limit, r->least ? "true" : "false", r->known ? "true" : "false",
            r->good ? "true" : "false", r->worst);
}

bool table_json(const char *path, const table_part *part, int parts, uint64_t seed)
{
    FILE *out = fopen(path, "w");
    if (!out)
        return false;
    fprintf(out, "{");
    print_machine_json(out);
    fprintf(out, ", \"seed\": %llu, \"parts\": [\n", (unsigned long long)seed);
    for (int p = 0; p < parts; p++) {
        fprintf(out, "  {\"name\": \"%s\", \"lines\": [\n", part[p].name);
        for (size_t i = 0; i < part[p].lines.n; i++) {
            json_line(out, &part[p].lines.list[i], &part[p].plan);
            fprintf(out, i + 1 < part[p].lines.n ? ",\n" : "\n");
        }
        fprintf(out, "  ], \"bars\": [\n");
        for (int i = 0; i < part[p].bars; i++) {
            json_bar(out, &part[p].bar[i]);
            fprintf(out, i + 1 < part[p].bars ? ",\n" : "\n");
        }
        fprintf(out, "  ]}%s\n", p + 1 < parts ? "," : "");
    }
    fprintf(out, "]}\n");
    return fclose(out) == 0;
}
