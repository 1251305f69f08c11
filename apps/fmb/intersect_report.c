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

/* ---- numbers --------------------------------------------------------------------------------- */

/* In JSON a decimal stands beside the exact number, which makes both an object. */
char *report_rational(const intersect_ask *ask, mpq_srcptr q, app_rounding way)
{
    if (ask->digits == 0 || !ask->json)
        return app_number(q, ask->digits, way);
    json_t *both = app_json_number(q, ask->digits, way);
    char *text = app_need(json_dumps(both, 0));
    json_decref(both);
    return text;
}

/* In JSON doubles are numbers, and decimals already. */
char *report_double(const intersect_ask *ask, double d, app_rounding way)
{
    return app_show_double(d, ask->json ? 0 : ask->digits, way);
}

/* ---- text ------------------------------------------------------------------------------------ */

/* JSON that stands for itself. */
static bool is_plain(const char *json, size_t n)
{
    bool plain = true;
    for (size_t i = 0; i < n; i++)
        plain &= json[i] >= ' ' && json[i] <= '~' && json[i] != '\\';
    return plain;
}

/* Print the name of a pair: a string without its quotes; any other id, and one with a NUL, as
 * written. */
static void print_name(const meeting *m, FILE *out)
{
    if (!m->id) {
        fprintf(out, "line %ld", m->line);
        return;
    }
    size_t n = strlen(m->id), quotes = m->id[0] == '"';
    if (is_plain(m->id, n)) {
        fwrite_unlocked(m->id + quotes, 1, n - 2 * quotes, out);
        return;
    }
    json_t *value = quotes ? json_loads(m->id, JSON_DECODE_ANY, NULL) : NULL;
    char *name =
        app_text(json_is_string(value) ? json_string_value(value) : m->id, APP_TEXT_TERMINAL);
    fputs_unlocked(name, out);
    free(name);
    json_decref(value);
}

/* "x1" of the world, "c1" of the second frame, "t" */
static void write_interval_name(app_table *t, const meeting *m, int i)
{
    char name[32] = "  t";
    if (i < m->dim)
        snprintf(name, sizeof name, "  x%d", i + 1);
    else if (i < m->dim + m->inside)
        snprintf(name, sizeof name, "  c%d", i - m->dim + 1);
    app_table_put(t, name);
}

/* "[1/2,", "(-inf,", "5?]" of an end that may be too far out, "?]" */
static void write_end(app_table *t, const interval *v, fmb_side side)
{
    const char *end = side == FMB_LOWER ? v->lower : v->upper;
    bool round = end && strstr(end, "inf");
    if (side == FMB_LOWER)
        app_buffer_put(&t->text, round ? "(" : "[");
    if (end)
        app_buffer_put(&t->text, end);
    if (v->outer)
        app_buffer_put(&t->text, "?");
    app_buffer_put(&t->text, side == FMB_LOWER ? "," : round ? ")" : "]");
    app_table_end_cell(t);
}

static void write_witness(app_table *t, const interval *v)
{
    if (v->at) {
        app_buffer_put(&t->text, "at ");
        app_buffer_put(&t->text, v->at);
    }
    app_table_end_cell(t);
}

static void print_box(const intersect *x, const meeting *m)
{
    app_table table = {.columns = 4, .align = "lrrl"};
    for (int i = 0; i < m->dim + m->inside + m->moves; i++) {
        const interval *v = &m->interval[i];
        write_interval_name(&table, m, i);
        write_end(&table, v, FMB_LOWER);
        write_end(&table, v, FMB_UPPER);
        write_witness(&table, v);
    }
    app_table_print(&table, x->out);
}

static void print_text(const intersect *x, const meeting *m)
{
    static const char *const word[] = {[FMB_UNKNOWN] = "undecided ",
                                       [FMB_FEASIBLE] = "meet      ",
                                       [FMB_INFEASIBLE] = "apart     "};
    fputs_unlocked(word[m->verdict], x->out);
    print_name(m, x->out);
    if (m->verdict == FMB_UNKNOWN)
        fprintf(x->out, " (%s)", fmb_stop_text(m->stop));
    putc_unlocked('\n', x->out);
    if (m->interval)
        print_box(x, m);
    near_print(&x->ask->near, &m->near, x->out);
}

/* ---- JSON ------------------------------------------------------------------------------------ */

static void put_text(const intersect *x, const char *text)
{
    fputs_unlocked(text, x->out);
}

/* A rational is a string, or an object; a double is a number where JSON has one. */
static void put_value(const intersect *x, const char *text)
{
    bool quoted = text && *text != '{' && (x->ask->boxes == BOXES_EXACT || strstr(text, "inf"));
    put_text(x, quoted ? "\"" : "");
    put_text(x, text ? text : "null");
    put_text(x, quoted ? "\"" : "");
}

static void put_interval(const intersect *x, const interval *v)
{
    put_text(x, "[");
    put_value(x, v->lower);
    put_text(x, ", ");
    put_value(x, v->upper);
    put_text(x, "]");
}

static void put_intervals(const intersect *x, const char *key, const interval *v, int n)
{
    fprintf(x->out, ", \"%s\": [", key);
    for (int i = 0; i < n; i++) {
        put_text(x, i > 0 ? ", " : "");
        put_interval(x, &v[i]);
    }
    put_text(x, "]");
}

static void put_witness(const intersect *x, const meeting *m)
{
    put_text(x, ", \"witness\": [");
    for (int i = 0; i < m->dim; i++) {
        put_text(x, i > 0 ? ", " : "");
        put_value(x, m->interval[i].at);
    }
    put_text(x, "]");
}

static void put_box(const intersect *x, const meeting *m)
{
    const interval *inside = m->interval + m->dim, *time = inside + m->inside;
    bool outer = false;
    put_intervals(x, "world", m->interval, m->dim);
    put_intervals(x, "inside", inside, m->inside);
    if (m->moves) {
        put_text(x, ", \"time\": ");
        put_interval(x, time);
    }
    put_witness(x, m);
    if (m->moves && time->at) {
        put_text(x, ", \"witness_time\": ");
        put_value(x, time->at);
    }
    for (int i = 0; i < m->dim + m->inside + m->moves; i++)
        outer |= m->interval[i].outer;
    if (outer)
        put_text(x, ", \"outer\": true");
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

/* The limit that left answers of the pair open: its verdict, an end, a distance or similar. */
static fmb_stop stop_of(const meeting *m)
{
    if (m->verdict == FMB_UNKNOWN)
        return m->stop;
    for (int i = 0; m->interval && i < m->dim + m->inside + m->moves; i++)
        if (m->interval[i].outer)
            return m->stop;
    return m->near.stop;
}

/* Report a contradiction, so that neither answer is trusted. */
static void tell_contradiction(intersect *x, const meeting *m)
{
    if (!m->near.contradiction)
        return;
    x->contradicted++;
    fputs("fmb: internal error: ", x->err);
    print_name(m, x->err);
    fprintf(x->err, ": %s\n", m->near.contradiction);
}

void report_pair(intersect *x, meeting *m)
{
    if (x->ask->json)
        print_json(x, m);
    else
        print_text(x, m);
    x->tested++;
    if (x->stop == FMB_STOP_DONE)
        x->stop = stop_of(m);
    x->meeting += m->verdict == FMB_FEASIBLE;
    x->undecided += m->verdict == FMB_UNKNOWN;
    x->within += m->near.is_within;
    tell_contradiction(x, m);
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
