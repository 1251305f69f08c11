/* jsonl.c: events as JSON, one object a line. Rows and variables count from 1, as everywhere
 * outside of C. */
#include <fmb/trace.h>

#include <inttypes.h>

#include "base/memory_stream.h"
#include "num/bitset.h"

static const char *const KIND[] = {"begin", "round", "rule",   "lp",
                                   "end",   "row",   "rebase", "engine"};

/* NULL becomes null. Names of rules may contain any bytes. */
static void print_quoted_word(FILE *out, const char *key, const char *word)
{
    fprintf(out, ", \"%s\": %s", key, word ? "\"" : "null");
    if (!word)
        return;
    for (; *word; word++) {
        if (*word == '"' || *word == '\\')
            fputc('\\', out);
        fputc(*word, out);
    }
    fputc('"', out);
}

static void print_count(FILE *out, const char *key, uint64_t n)
{
    fprintf(out, ", \"%s\": %" PRIu64, key, n);
}

/* The least element of a set that is at least i; at least 64 words: there is none. */
static size_t find_next_element(const uint64_t *set, size_t words, size_t i)
{
    while (i < 64 * words && !fmb_set_has(set, i))
        i++;
    return i;
}

static void print_variables(FILE *out, const char *key, const uint64_t *set, const fmb_row_event *r)
{
    const char *comma = "";
    size_t end = 64 * r->column_words;
    fprintf(out, ", \"%s\": [", key);
    for (size_t i = 0; (i = find_next_element(set, r->column_words, i)) < end; i++) {
        int variable = r->variable ? r->variable[i] : (int)i;
        if (variable < 0) /* the objective's extra variable */
            continue;
        fprintf(out, "%s%d", comma, variable + 1);
        comma = ", ";
    }
    fputc(']', out);
}

static void print_history(FILE *out, const fmb_row_event *r)
{
    const char *comma = "";
    size_t end = 64 * r->history_words;
    fputs(", \"history\": [", out);
    for (size_t i = 0; (i = find_next_element(r->history, r->history_words, i)) < end; i++) {
        fprintf(out, "%s%" PRIu64, comma, (uint64_t)r->base[i] + 1);
        comma = ", ";
    }
    fputc(']', out);
}

/* Print nothing about histories if there are none. */
static void print_derived_row(FILE *out, const fmb_row_event *r)
{
    static const char *const MINIMAL[] = {"null", "false", "true"};
    print_count(out, "row", r->row + 1);
    fprintf(out, ", \"parents\": [%" PRIu64 ", %" PRIu64 "]", r->parent[0] + 1, r->parent[1] + 1);
    print_quoted_word(out, "dropped_by", r->dropped_by);
    if (r->history) {
        print_history(out, r);
        print_variables(out, "effective", r->effective, r);
        print_variables(out, "implicit", r->implicit, r);
    }
    fprintf(out, ", \"minimal\": %s", MINIMAL[r->minimal + 1]);
}

static void print_round_and_variable(FILE *out, const fmb_event *e)
{
    fprintf(out, ", \"round\": %d", e->round);
    if (e->var >= 0)
        fprintf(out, ", \"var\": %d", e->var + 1);
}

static void print_rows_in_and_out(FILE *out, const fmb_event *e)
{
    print_count(out, "rows_in", e->rows_in);
    print_count(out, "rows_out", e->rows_out);
}

static void print_round_counts(FILE *out, const fmb_event *e)
{
    print_rows_in_and_out(out, e);
    print_count(out, "pairs", e->pairs);
    print_count(out, "made", e->made);
    print_count(out, "dropped", e->dropped);
    print_count(out, "widened", e->widened);
}

static void print_attempt(FILE *out, const fmb_attempt *a)
{
    print_quoted_word(out, "name", a->engine);
    print_quoted_word(out, "task", a->task);
    if (a->part >= 0)
        print_count(out, "part", (uint64_t)a->part + 1);
    print_count(out, "columns", a->columns);
    print_count(out, "rows", a->rows);
    if (a->budget > 0) {
        print_count(out, "budget", a->budget);
        print_quoted_word(out, "unit", a->unit);
    }
    if (a->left > 0)
        print_count(out, "left", a->left);
    print_quoted_word(out, "ended", a->ended);
    if (a->spent > 0)
        print_count(out, "spent", a->spent);
}

static void print_kind_of_event(FILE *out, const fmb_event *e)
{
    switch (e->kind) {
    case FMB_EVENT_BEGIN:
    case FMB_EVENT_END:
        break;
    case FMB_EVENT_ROUND:
        print_round_and_variable(out, e);
        print_round_counts(out, e);
        break;
    case FMB_EVENT_RULE:
        print_round_and_variable(out, e);
        print_count(out, "dropped", e->dropped);
        break;
    case FMB_EVENT_LP:
        print_rows_in_and_out(out, e);
        break;
    case FMB_EVENT_ROW:
        print_round_and_variable(out, e);
        print_derived_row(out, e->row);
        break;
    case FMB_EVENT_REBASE:
        print_round_and_variable(out, e);
        print_count(out, "rows", e->rows_in);
        break;
    case FMB_EVENT_ENGINE:
        print_attempt(out, e->attempt);
        break;
    }
}

static void print_event_as_line(void *self, const fmb_event *e)
{
    FILE *out = self;
    uint64_t micros = (uint64_t)(e->seconds * 1e6);
    fprintf(out, "{\"event\": \"%s\", \"seconds\": %" PRIu64 ".%06" PRIu64, KIND[e->kind],
            micros / 1000000, micros % 1000000);
    if (e->name)
        print_quoted_word(out, "name", e->name);
    print_kind_of_event(out, e);
    fputs("}\n", out);
}

static fmb_status write_event(const void *self, FILE *out)
{
    const fmb_event *e = self;
    if (!e || (unsigned)e->kind > FMB_EVENT_ENGINE || (e->kind == FMB_EVENT_ROW && !e->row) ||
        (e->kind == FMB_EVENT_ENGINE && !e->attempt))
        return FMB_ERR_ARG;
    print_event_as_line(out, e);
    return ferror(out) ? FMB_ERR_IO : FMB_OK;
}

fmb_status fmb_event_print(const fmb_event *e, char *text, size_t size, size_t *length)
{
    return fmb_memory_print(write_event, e, text, size, length);
}

fmb_sink fmb_sink_jsonl(FILE *out)
{
    return (fmb_sink){print_event_as_line, out};
}
