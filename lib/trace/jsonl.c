/* jsonl.c: events as JSON, one object a line. Rows and variables count from 1, as everywhere
 * outside of C. */
#include <fmb/trace.h>

#include <inttypes.h>

static const char *const KIND[] = {"begin", "round", "rule", "lp", "end", "row", "rebase"};

/* Names of rules may come from anywhere. */
static void put_word(FILE *out, const char *key, const char *word)
{
    fprintf(out, ", \"%s\": \"", key);
    for (; *word; word++) {
        if (*word == '"' || *word == '\\')
            fputc('\\', out);
        fputc(*word, out);
    }
    fputc('"', out);
}

static void put_count(FILE *out, const char *key, uint64_t n)
{
    fprintf(out, ", \"%s\": %" PRIu64, key, n);
}

/* The least element of a set that is at least i; 64 words or more: there is none. */
static size_t next_bit(const uint64_t *set, size_t words, size_t i)
{
    while (i < 64 * words && !(set[i / 64] >> (i % 64) & 1))
        i++;
    return i;
}

static void put_columns(FILE *out, const char *key, const uint64_t *set, const fmb_row_event *r)
{
    const char *comma = "";
    size_t end = 64 * r->column_words;
    fprintf(out, ", \"%s\": [", key);
    for (size_t i = 0; (i = next_bit(set, r->column_words, i)) < end; i++) {
        fprintf(out, "%s%d", comma, (r->variable ? r->variable[i] : (int)i) + 1);
        comma = ", ";
    }
    fputc(']', out);
}

static void put_history(FILE *out, const fmb_row_event *r)
{
    const char *comma = "";
    size_t end = 64 * r->history_words;
    fputs(", \"history\": [", out);
    for (size_t i = 0; (i = next_bit(r->history, r->history_words, i)) < end; i++) {
        fprintf(out, "%s%" PRIu64, comma, (uint64_t)r->base[i] + 1);
        comma = ", ";
    }
    fputc(']', out);
}

/* Without histories there is nothing to say about them. */
static void put_row(FILE *out, const fmb_row_event *r)
{
    static const char *const MINIMAL[] = {"null", "false", "true"};
    put_count(out, "row", r->row + 1);
    fprintf(out, ", \"parents\": [%" PRIu64 ", %" PRIu64 "]", r->parent[0] + 1, r->parent[1] + 1);
    if (r->dropped_by)
        put_word(out, "dropped_by", r->dropped_by);
    else
        fputs(", \"dropped_by\": null", out);
    if (r->history) {
        put_history(out, r);
        put_columns(out, "effective", r->effective, r);
        put_columns(out, "implicit", r->implicit, r);
    }
    fprintf(out, ", \"minimal\": %s", MINIMAL[r->minimal + 1]);
}

static void put_place(FILE *out, const fmb_event *e)
{
    fprintf(out, ", \"round\": %d", e->round);
    if (e->var >= 0)
        fprintf(out, ", \"var\": %d", e->var + 1);
}

static void put_rows(FILE *out, const fmb_event *e)
{
    put_count(out, "rows_in", e->rows_in);
    put_count(out, "rows_out", e->rows_out);
}

static void put_round(FILE *out, const fmb_event *e)
{
    put_rows(out, e);
    put_count(out, "pairs", e->pairs);
    put_count(out, "made", e->made);
    put_count(out, "dropped", e->dropped);
    put_count(out, "widened", e->widened);
}

static void put_body(FILE *out, const fmb_event *e)
{
    switch (e->kind) {
    case FMB_EVENT_BEGIN:
    case FMB_EVENT_END:
        break;
    case FMB_EVENT_ROUND:
        put_place(out, e);
        put_round(out, e);
        break;
    case FMB_EVENT_RULE:
        put_place(out, e);
        put_count(out, "dropped", e->dropped);
        break;
    case FMB_EVENT_LP:
        put_rows(out, e);
        break;
    case FMB_EVENT_ROW:
        put_place(out, e);
        put_row(out, e->row);
        break;
    case FMB_EVENT_REBASE:
        put_place(out, e);
        put_count(out, "rows", e->rows_in);
        break;
    }
}

static void put_line(void *self, const fmb_event *e)
{
    FILE *out = self;
    uint64_t micros = (uint64_t)(e->seconds * 1e6);
    fprintf(out, "{\"event\": \"%s\", \"seconds\": %" PRIu64 ".%06" PRIu64, KIND[e->kind],
            micros / 1000000, micros % 1000000);
    if (e->name)
        put_word(out, "name", e->name);
    put_body(out, e);
    fputs("}\n", out);
}

fmb_sink fmb_sink_jsonl(FILE *out)
{
    return (fmb_sink){put_line, out};
}
