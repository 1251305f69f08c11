/* jsonl.c: events as JSON, one object a line. Names are the library's own static words: no escapes
 * needed. */
#include <fmb/trace.h>

#include <inttypes.h>

static const char *const KIND[] = {"begin", "round", "rule", "lp", "end"};

static void put_line(void *self, const fmb_event *e)
{
    FILE *out = self;
    uint64_t micros = (uint64_t)(e->seconds * 1e6);
    fprintf(out, "{\"event\": \"%s\", \"seconds\": %" PRIu64 ".%06" PRIu64, KIND[e->kind],
            micros / 1000000, micros % 1000000);
    if (e->name)
        fprintf(out, ", \"name\": \"%s\"", e->name);
    if (e->kind == FMB_EVENT_ROUND)
        fprintf(out, ", \"round\": %d, \"var\": %d, \"pairs\": %" PRIu64, e->round, e->var + 1,
                e->pairs);
    if (e->kind != FMB_EVENT_BEGIN && e->kind != FMB_EVENT_END)
        fprintf(out, ", \"rows_in\": %" PRIu64 ", \"rows_out\": %" PRIu64, e->rows_in, e->rows_out);
    fputs("}\n", out);
}

fmb_sink fmb_sink_jsonl(FILE *out)
{
    return (fmb_sink){put_line, out};
}
