/* engine.c: what JavaScript needs besides the C headers: the offsets of structure fields, and a
 * memory stream for the trace of a query. It calls all other functions directly. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include <emscripten.h>
#include <fmb/fmb.h>
#include <fmb/geometry.h>

/* ---- layouts --------------------------------------------------------------------------------- */

typedef struct place {
    const char *name;
    size_t value; /* a size or an offset [bytes] */
} place;

#define SIZE(type)                                                                                 \
    {                                                                                              \
#type, sizeof(type)                                                                        \
    }
#define FIELD(type, field)                                                                         \
    {                                                                                              \
#type "." #field, offsetof(type, field)                                                    \
    }

static const place places[] = {
    SIZE(fmb_where),
    FIELD(fmb_where, line),
    FIELD(fmb_where, column),
    SIZE(fmb_options),
    FIELD(fmb_options, size),
    SIZE(fmb_result),
    FIELD(fmb_result, size),
    FIELD(fmb_result, verdict),
    FIELD(fmb_result, stop),
    FIELD(fmb_result, stats),
    FIELD(fmb_stats, rounds),
    FIELD(fmb_stats, pairs),
    FIELD(fmb_stats, rows_made),
    FIELD(fmb_stats, rows_kept),
    FIELD(fmb_stats, rows_dropped),
    FIELD(fmb_stats, rows_peak),
    FIELD(fmb_stats, pivots),
    FIELD(fmb_stats, lps),
    FIELD(fmb_stats, bytes_peak),
    FIELD(fmb_stats, seconds),
    SIZE(fmb_end),
    FIELD(fmb_end, kind),
    FIELD(fmb_end, attained),
    SIZE(fmb_reader),
    FIELD(fmb_reader, size),
    FIELD(fmb_reader, format),
    SIZE(fmb_objective),
    FIELD(fmb_objective, sense),
    FIELD(fmb_objective, coef),
    FIELD(fmb_objective, constant),
    SIZE(fmb_judgement),
    FIELD(fmb_judgement, size),
    FIELD(fmb_judgement, accepted),
    FIELD(fmb_judgement, verdict),
    FIELD(fmb_judgement, held),
    FIELD(fmb_judgement, claim),
    FIELD(fmb_judgement, reason),
    SIZE(fmb_frame),
    FIELD(fmb_frame, shape),
    FIELD(fmb_frame, dim),
    FIELD(fmb_frame, naxes),
    FIELD(fmb_frame, origin),
    FIELD(fmb_frame, axes),
    FIELD(fmb_frame, speed),
    SIZE(fmb_pair_options),
    FIELD(fmb_pair_options, size),
    FIELD(fmb_pair_options, contact),
    FIELD(fmb_pair_options, tightest),
    SIZE(fmb_pair_answers),
    FIELD(fmb_pair_answers, size),
    FIELD(fmb_pair_answers, verdict),
    FIELD(fmb_pair_answers, world),
    FIELD(fmb_pair_answers, inside),
    FIELD(fmb_pair_answers, time),
    FIELD(fmb_pair_answers, witness),
    SIZE(fmb_mesh_options),
    FIELD(fmb_mesh_options, size),
    FIELD(fmb_mesh_options, neighbours),
    FIELD(fmb_mesh_options, motion),
    FIELD(fmb_mesh_options, max_seconds),
    SIZE(fmb_mesh_answer),
    FIELD(fmb_mesh_answer, size),
    FIELD(fmb_mesh_answer, hits),
    FIELD(fmb_mesh_answer, hit),
    FIELD(fmb_mesh_answer, tested),
    FIELD(fmb_mesh_answer, stop),
    SIZE(fmb_mesh_hit),
    FIELD(fmb_mesh_hit, a),
    FIELD(fmb_mesh_hit, b),
    FIELD(fmb_mesh_hit, shared),
    FIELD(fmb_mesh_hit, how),
};

/* The i-th name, "fmb_result" for the size of that structure, "fmb_result.stop" for the offset of a
 * field; NULL past the end. And its value. */
EMSCRIPTEN_KEEPALIVE const char *engine_place_name(size_t i)
{
    return i < sizeof places / sizeof *places ? places[i].name : NULL;
}

EMSCRIPTEN_KEEPALIVE size_t engine_place_value(size_t i)
{
    return places[i].value;
}

/* ---- traces ---------------------------------------------------------------------------------- */

static struct {
    FILE *stream;
    char *text;
    size_t length;
} trace;

/* Trace the queries of v from now on: one JSON object a line. False if memory runs out. */
EMSCRIPTEN_KEEPALIVE bool engine_trace_begin(fmb_solver *v)
{
    trace.stream = open_memstream(&trace.text, &trace.length);
    if (trace.stream)
        fmb_solver_set_sink(v, fmb_sink_jsonl(trace.stream));
    return trace.stream != NULL;
}

/* [give, free] The trace since then; NULL if memory ran out. */
EMSCRIPTEN_KEEPALIVE char *engine_trace_end(fmb_solver *v)
{
    fmb_solver_set_sink(v, (fmb_sink){NULL, NULL});
    return fclose(trace.stream) == 0 ? trace.text : NULL;
}
