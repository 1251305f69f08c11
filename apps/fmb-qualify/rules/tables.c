/* tables.c: the counts and times. */
#include <math.h>
#include <stdlib.h>

#include "fmb-qualify/numbers.h"
#include "fmb-qualify/rules/report.h"

#define WAY                                                                                        \
    {"systems", "systems", NULL},                                                                  \
    {                                                                                              \
        "rules", "rules", NULL                                                                     \
    }
#define COUNTS                                                                                     \
    {"n", "n", "%.0f"}, {"decided", "decided", "%.0f"}, {"stopped", "stopped", "%.0f"},            \
        {"wrong", "wrong", "%.0f"}, {"pairs", "pairs", "%.1f"}, {"made", "made", "%.1f"},          \
        {"kept", "kept", "%.1f"}, {"sum", "sum", "%.1f"}, {"peak", "peak", "%.1f"},                \
        {"held", NULL, "%.1f"}, {"both_decided", NULL, "%.0f"},                                    \
        {"only_this_decided", NULL, "%.0f"}, {"kept_ratio", "rows", "%.3f"},                       \
    {                                                                                              \
        "sum_ratio", NULL, "%.3f"                                                                  \
    }
#define TIMES                                                                                      \
    {"timed", NULL, "%.0f"}, {"none_gave_up", NULL, "%.0f"}, {"this_gave_up", NULL, "%.0f"},       \
        {"bound", "", NULL}, QUALIFY_RATIO("time_median", "time"),                                 \
        QUALIFY_RATIO("time_total", "total"),                                                      \
    {                                                                                              \
        "sign_test", NULL, "%.3f"                                                                  \
    }

static const qualify_column LINE[] = {WAY, COUNTS, TIMES, {0}};
static const qualify_column OF_CLASS[] = {WAY, {"order", NULL, NULL}, COUNTS, {0}};
static const qualify_column TIME_OF_CLASS[] = {WAY, {"order", NULL, NULL}, TIMES, {0}};

static void say_unknown(const qualify_plan *p, qualify_page *to)
{
    for (size_t i = 0; i < p->sets; i++)
        if (!p->grid.known[i])
            qualify_page_text(to, "Left out: %s (no such rules here).", p->way[i].name);
}

void qualify_tables(const qualify_plan *p, qualify_page *to)
{
    qualify_page_text(
        to, "pairs, made: pairs looked at, rows combined; kept: of those, rows that outlived the "
            "rules of their round; sum, peak: rows alive after a round, added up over the rounds, "
            "and at most: means over the systems decided, of pairs that meet. rows: kept over that "
            "of no rules. time, total: of the verdict over no rules, median of ratios and ratio of "
            "totals, each with its 95 %% interval (bootstrap over the systems); < where no rules "
            "gave up first, > where these did, ~ where both happened.");
    say_unknown(p, to);
    if (qualify_stopped_by_time(p) > 0)
        qualify_page_text(to, "The clock stopped %zu queries: their counts depend on the machine.",
                          qualify_stopped_by_time(p));
    for (size_t k = 0; k < p->orders; k++) {
        char key[PLAN_ORDER_KEY], caption[48];
        qualify_order_key(&p->order[k], key);
        snprintf(caption, sizeof caption, "Order %s", p->order[k].name);
        qualify_page_table(to, key, caption, LINE, key);
    }
    qualify_page_table(to, "classes", NULL, OF_CLASS, "classes");
    qualify_page_table(to, "times", NULL, TIME_OF_CLASS, "times");
}
