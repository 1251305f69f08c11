/* intersect_report.c: pairs as text for people, and as one JSON object that is written as they
 * come. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/table.h"
#include "common/text.h"
#include "fmb/intersect.h"
#include "fmb/show.h"

/* ---- text ------------------------------------------------------------------------------------ */

/* [give, free()] What a pair is called: a string without its quotes, any other id, and one that
 * holds a NUL, as it stands. */
static char *name_of(const meeting *m)
{
    if (!m->id)
        return app_print("line %ld", m->line);
    json_t *value = json_loads(m->id, JSON_DECODE_ANY, NULL);
    char *name =
        app_text(json_is_string(value) ? json_string_value(value) : m->id, APP_TEXT_TERMINAL);
    json_decref(value);
    return name;
}

static char *interval_name(const meeting *m, int i)
{
    if (i < m->dim)
        return app_print("  x%d", i + 1);
    return i < m->dim + m->inside ? app_print("  c%d", i - m->dim + 1) : app_print("  t");
}

/* "[1/2,", "(-inf,", "5?]" of an end that may be too far out, "?]" */
static char *end_cell(const interval *v, fmb_side side)
{
    const char *end = side == FMB_LOWER ? v->lower : v->upper;
    bool round = end && strstr(end, "inf");
    return app_print("%s%s%s%s",
                     side == FMB_UPPER ? ""
                     : round           ? "("
                                       : "[",
                     end ? end : "", v->outer ? "?" : "",
                     side == FMB_LOWER ? ","
                     : round           ? ")"
                                       : "]");
}

static void print_box(const intersect *x, const meeting *m)
{
    app_table table = {.columns = 4, .align = "lrrl"};
    for (int i = 0; i < m->dim + m->inside + m->moves; i++) {
        const interval *v = &m->interval[i];
        app_table_add(&table, interval_name(m, i));
        app_table_add(&table, end_cell(v, FMB_LOWER));
        app_table_add(&table, end_cell(v, FMB_UPPER));
        app_table_add(&table, v->at ? app_print("at %s", v->at) : app_print(""));
    }
    app_table_print(&table, x->out);
}

static void print_text(const intersect *x, const meeting *m)
{
    static const char *const word[] = {
        [FMB_UNKNOWN] = "undecided", [FMB_FEASIBLE] = "meet", [FMB_INFEASIBLE] = "apart"};
    char *name = name_of(m);
    fprintf(x->out, "%-9s %s", word[m->verdict], name);
    if (m->verdict == FMB_UNKNOWN)
        fprintf(x->out, " (%s)", fmb_stop_text(m->stop));
    fputc('\n', x->out);
    if (m->interval)
        print_box(x, m);
    near_print(&x->ask->near, &m->near, x->out);
    free(name);
}

/* ---- JSON ------------------------------------------------------------------------------------ */

/* A rational is a string; a double is a number where JSON has one. */
static void put_value(const intersect *x, const char *text)
{
    bool quoted = x->ask->boxes == BOXES_EXACT || (text && strstr(text, "inf"));
    if (!text)
        fputs("null", x->out);
    else
        fprintf(x->out, quoted ? "\"%s\"" : "%s", text);
}

static void put_interval(const intersect *x, const interval *v)
{
    fputc('[', x->out);
    put_value(x, v->lower);
    fputs(", ", x->out);
    put_value(x, v->upper);
    fputc(']', x->out);
}

static void put_intervals(const intersect *x, const char *key, const interval *v, int n)
{
    fprintf(x->out, ", \"%s\": [", key);
    for (int i = 0; i < n; i++) {
        fputs(i > 0 ? ", " : "", x->out);
        put_interval(x, &v[i]);
    }
    fputc(']', x->out);
}

static void put_witness(const intersect *x, const meeting *m)
{
    fputs(", \"witness\": [", x->out);
    for (int i = 0; i < m->dim; i++) {
        fputs(i > 0 ? ", " : "", x->out);
        put_value(x, m->interval[i].at);
    }
    fputc(']', x->out);
}

static void put_box(const intersect *x, const meeting *m)
{
    const interval *inside = m->interval + m->dim, *time = inside + m->inside;
    bool outer = false;
    put_intervals(x, "world", m->interval, m->dim);
    put_intervals(x, "inside", inside, m->inside);
    if (m->moves) {
        fputs(", \"time\": ", x->out);
        put_interval(x, time);
    }
    put_witness(x, m);
    if (m->moves && time->at) {
        fputs(", \"witness_time\": ", x->out);
        put_value(x, time->at);
    }
    for (int i = 0; i < m->dim + m->inside + m->moves; i++)
        outer |= m->interval[i].outer;
    if (outer)
        fputs(", \"outer\": true", x->out);
}

static void print_json(const intersect *x, const meeting *m)
{
    fprintf(x->out, "%s    {\"line\": %ld", x->tested > 0 ? ",\n" : "\n", m->line);
    if (m->id)
        fprintf(x->out, ", \"id\": %s", m->id);
    fprintf(x->out, ", \"verdict\": \"%s\"", fmb_verdict_text(m->verdict));
    if (m->verdict == FMB_UNKNOWN)
        fprintf(x->out, ", \"stop\": \"%s\"", fmb_stop_text(m->stop));
    if (m->interval)
        put_box(x, m);
    near_print_json(&x->ask->near, &m->near, x->out);
    fputc('}', x->out);
}

/* ---- all ------------------------------------------------------------------------------------- */

void report_begin(const intersect *x)
{
    if (x->ask->json)
        fputs("{\n  \"pairs\": [", x->out);
}

static void drop(meeting *m)
{
    for (int i = 0; m->interval && i < m->dim + m->inside + m->moves; i++) {
        free(m->interval[i].lower);
        free(m->interval[i].upper);
        free(m->interval[i].at);
    }
    free(m->interval);
    near_clear(&m->near);
    free(m->id);
    *m = (meeting){0};
}

void report_pair(intersect *x, meeting *m)
{
    if (x->ask->json)
        print_json(x, m);
    else
        print_text(x, m);
    x->tested++;
    x->meeting += m->verdict == FMB_FEASIBLE;
    x->undecided += m->verdict == FMB_UNKNOWN;
    x->within += m->near.is_within;
    drop(m);
}

void report_end(const intersect *x)
{
    size_t apart = x->tested - x->meeting - x->undecided;
    if (x->ask->json)
        fprintf(x->out, "%s],\n  \"tested\": %zu,\n  \"meeting\": %zu,\n  \"undecided\": %zu\n}\n",
                x->tested > 0 ? "\n  " : "", x->tested, x->meeting, x->undecided);
    else
        fprintf(x->out, "%zu tested: %zu meet, %zu apart, %zu undecided\n", x->tested, x->meeting,
                apart, x->undecided);
}
