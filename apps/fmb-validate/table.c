/* table.c: the counts in aligned columns. */
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>

#include "common/message.h"
#include "common/table.h"
#include "fmb-validate/report.h"

static void add(app_table *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(app_table *t, const char *format, ...)
{
    va_list args;
    char *text;
    va_start(args, format);
    app_need(vasprintf(&text, format, args) < 0 ? NULL : text);
    va_end(args);
    app_table_add(t, text);
}

static void add_words(app_table *t, size_t n, const char *const *word)
{
    for (size_t i = 0; i < n; i++)
        add(t, "%s", word[i]);
}

static void add_head(app_table *t, const study_validation *asked)
{
    static const char *const HEAD[] = {
        "case",  "family",    "tested",   "meeting", "not meeting", "share %",     "touching",
        "exact", "by solver", "textbook", "left",    "FMB unknown", "SAT unknown", "disagreeing"};
    add_words(t, sizeof HEAD / sizeof *HEAD, HEAD);
    if (asked->boxes)
        add_words(t, 4, (const char *const[]){"boxes", "by solver", "excess", "by doubles %"});
    if (asked->contacts)
        add_words(t, 2, (const char *const[]){"contacts", "by doubles %"});
}

static double percent(uint64_t part, uint64_t all)
{
    return all > 0 ? 100 * (double)part / (double)all : 0;
}

static void add_job(app_table *t, const validate_job *job)
{
    const study_tally *n = &job->tally;
    char text[16];
    validate_case_text(job, text);
    add(t, "%s", text);
    add(t, "%s", study_pair_family_text(job->v.plan.family));
    uint64_t counts[] = {n->tested, n->meeting, n->tested - n->meeting};
    for (int i = 0; i < 3; i++)
        add(t, "%" PRIu64, counts[i]);
    add(t, "%.2f", percent(n->meeting, n->tested));
    uint64_t more[] = {n->touching, n->exact,      n->solved,     n->textbook,
                       n->left,     n->unknown[0], n->unknown[1], n->disagreeing};
    for (int i = 0; i < 8; i++)
        add(t, "%" PRIu64, more[i]);
    if (job->v.boxes) {
        add(t, "%" PRIu64, n->boxes);
        add(t, "%" PRIu64, n->boxes_solved);
        add(t, "%.1e", n->excess);
        add(t, "%.1f", percent(2 * n->boxes - n->doubtful, 2 * n->boxes));
    }
    if (job->v.contacts) {
        add(t, "%" PRIu64, n->contacts);
        add(t, "%.1f", percent(2 * n->contacts - n->contacts_open, 2 * n->contacts));
    }
}

void validate_table(const validate_plan *p)
{
    const study_validation *v = &p->usual;
    app_table t = {.columns = 14U + (v->boxes ? 4 : 0) + (v->contacts ? 2 : 0),
                   .align = "llrrrrrrrrrrrrrrrrrr"};
    add_head(&t, v);
    for (size_t i = 0; i < p->jobs; i++)
        if (p->job[i].tally.tested > 0)
            add_job(&t, &p->job[i]);
    app_table_print(&t, stdout);
}
