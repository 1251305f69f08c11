/* trace.c: events of a query come in order and are consistent, and so are the statistics. */
#include <criterion/criterion.h>
#include <string.h>

#include "counted_clock.h"
#include "fault/samples.h"
#include "fault/verbs.h"
#include "property/random/rows.h"

typedef struct journal {
    int events, begins, ends, rounds, open;
    double seconds;
    const fmb_system *s;
    char last[32];
} journal;

static void note(void *self, const fmb_event *e)
{
    journal *j = self;
    j->events++;
    cr_expect_gt(e->seconds, j->seconds);
    j->seconds = e->seconds;
    cr_expect(e->var >= -1 && e->var < fmb_system_dim(j->s));
    switch (e->kind) {
    case FMB_EVENT_BEGIN:
        cr_expect(j->open == 0 && e->name);
        j->begins++;
        j->open = 1;
        break;
    case FMB_EVENT_ROUND:
        cr_expect_geq(e->var, 0);
        j->rounds++;
        break;
    case FMB_EVENT_RULE:
        cr_expect(e->name && e->dropped > 0);
        break;
    case FMB_EVENT_LP:
    case FMB_EVENT_REBASE:
        break;
    case FMB_EVENT_ENGINE:
        cr_expect(e->attempt && e->attempt->engine && e->attempt->task && e->attempt->ended);
        cr_expect_eq(e->attempt->budget > 0, e->attempt->unit != NULL);
        break;
    case FMB_EVENT_ROW:
        cr_expect_fail("nobody asked for rows");
        break;
    case FMB_EVENT_END:
        cr_expect(j->open == 1 && e->name);
        snprintf(j->last, sizeof j->last, "%s", e->name);
        j->ends++;
        j->open = 0;
        break;
    default:
        cr_expect_fail("event of no kind");
    }
    cr_expect(j->open || e->kind == FMB_EVENT_END, "an event outside of a query");
}

static fmb_solver *solver(fmb_method method)
{
    return must_open((fmb_options){.method = method});
}

/* By the counted clock: it is read at the beginning, for each event, before the last one for the
 * statistics, and not else. */
static void expect_stats(const fmb_result *r, int events, fmb_method method)
{
    const fmb_stats *t = &r->stats;
    cr_expect_eq(t->seconds, (double)events);
    cr_expect_leq(t->rows_made, t->pairs + 1000);
    if (method == FMB_METHOD_LP)
        cr_expect_geq(t->lps, 1);
}

Test(trace, events)
{
    static const fmb_method methods[] = {FMB_METHOD_AUTO, FMB_METHOD_FM, FMB_METHOD_LP};
    for (int m = 0; m < 3; m++)
        for (int i = 0; i < samples_count(); i++)
            for (int q = 0; q < VERBS_COUNT; q++) {
                fmb_solver *v = solver(methods[m]);
                fmb_system *s = sample(i, NULL);
                journal j = {.s = s};
                char answer[VERB_ANSWER] = "";
                fmb_result r = {.size = sizeof r};
                fmb_solver_set_sink(v, (fmb_sink){note, &j});
                counted_clock_start(0, NULL, NULL);
                must(VERBS[q].ask(v, s, &r, answer));
                counted_clock_stop();
                cr_expect(j.begins == 1 && j.ends == 1 && j.events >= 2, "%d begins, %d ends",
                          j.begins, j.ends);
                cr_expect_str_eq(j.last, fmb_verdict_text(r.verdict));
                expect_stats(&r, j.events, q == 0 ? methods[m] : FMB_METHOD_FM);
                fmb_system_free(s);
                fmb_solver_free(v);
            }
}

/* Silence again, and the JSON lines of the built-in sink. */
Test(trace, sinks)
{
    fmb_solver *v = solver(FMB_METHOD_FM);
    fmb_system *s = sample(0, NULL);
    fmb_result r = {.size = sizeof r};
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    fmb_solver_set_sink(v, fmb_sink_jsonl(out));
    must(fmb_solve(v, s, &r));
    fmb_solver_set_sink(v, (fmb_sink){NULL, NULL});
    fflush(out);
    size_t first = size;
    cr_expect_gt(first, 0);
    must(fmb_solve(v, s, &r));
    fclose(out);
    cr_expect_eq(size, first, "a sink that was taken away is still written to");
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"))
        cr_expect(line[0] == '{' && line[strlen(line) - 1] == '}', "not an object: %s", line);
    free(text);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* ---- every row ------------------------------------------------------------------------------- */

/* Drops the first row that it is asked about, and has a name that JSON must not swallow. */
static bool drop_first(void *state, const fmb_view *w, size_t row)
{
    bool *done = state, first = !*done && fmb_view_column(w) >= 0 && row > 0;
    *done |= first;
    return first;
}

static const fmb_rule odd = {.name = "od\"d\\",
                             .flags = FMB_RULE_BREAKS_HISTORY,
                             .state_bytes = sizeof(bool),
                             .drop_row = drop_first};

/* The lines of rows, rules and re-bases of one query, without their times. */
static void keep_lines(char *text, char *out, size_t size)
{
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        char *rest = strchr(line, ',');
        cr_assert_not_null(rest = strchr(rest + 1, ','));
        if (strstr(line, "\"row\"") || strstr(line, "\"rule\"") || strstr(line, "\"rebase\""))
            snprintf(out + strlen(out), size - strlen(out), "%s\n", rest + 2);
    }
}

static void expect_lines(const fmb_rule *more, const char *expected)
{
    static const int64_t row[][4] = {{0, 1, 1, 1}, {0, -1, 1, -1}, {0, -1, 0, 1}, {0, 0, -1, 0}};
    static const int64_t right[] = {1, 1, 0, 0};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_system *s = rows_none(4);
    char *text = NULL, lines[2000] = "";
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    for (int i = 0; i < 4; i++)
        must(fmb_system_add_int(s, row[i], FMB_LE, right[i]));
    o.method = FMB_METHOD_FM;
    o.order = FMB_ORDER_GIVEN;
    o.rules = "imbert";
    o.presolve = "components";
    o.trace_rows = true;
    must(fmb_solver_new(&o, NULL, &v));
    if (more)
        must(fmb_solver_add_rule(v, more));
    fmb_solver_set_sink(v, fmb_sink_jsonl(out));
    must(fmb_solve(v, s, &r));
    fclose(out);
    keep_lines(text, lines, sizeof lines);
    cr_expect_str_eq(lines, expected);
    free(text);
    fmb_solver_free(v);
    fmb_system_free(s);
}

/* Rows 1 and 2 cancel x2, and x4 by chance. */
Test(trace, rows)
{
    expect_lines(NULL,
                 "\"round\": 1, \"var\": 2, \"row\": 5, \"parents\": [2, 1], \"dropped_by\": null, "
                 "\"history\": [1, 2], \"effective\": [2], \"implicit\": [4], \"minimal\": true}\n"
                 "\"round\": 1, \"var\": 2, \"row\": 6, \"parents\": [3, 1], \"dropped_by\": null, "
                 "\"history\": [1, 3], \"effective\": [2], \"implicit\": [], \"minimal\": true}\n"
                 "\"round\": 2, \"var\": 3, \"row\": 7, \"parents\": [4, 5], \"dropped_by\": "
                 "\"constant\", \"history\": [1, 2, 4], \"effective\": [2, 3], \"implicit\": [4], "
                 "\"minimal\": true}\n"
                 "\"round\": 2, \"var\": 3, \"row\": 7, \"parents\": [4, 6], \"dropped_by\": null, "
                 "\"history\": [1, 3, 4], \"effective\": [2, 3], \"implicit\": [], "
                 "\"minimal\": true}\n"
                 "\"name\": \"constant\", \"round\": 2, \"var\": 3, \"dropped\": 1}\n");
}

/* The row that was dropped leaves its number to the next one, and histories start anew. */
Test(trace, rows_dropped)
{
    expect_lines(&odd,
                 "\"round\": 1, \"var\": 2, \"row\": 5, \"parents\": [2, 1], \"dropped_by\": "
                 "\"od\\\"d\\\\\", \"history\": [1, 2], \"effective\": [2], \"implicit\": [4], "
                 "\"minimal\": true}\n"
                 "\"round\": 1, \"var\": 2, \"row\": 5, \"parents\": [3, 1], \"dropped_by\": null, "
                 "\"history\": [1, 3], \"effective\": [2], \"implicit\": [], \"minimal\": true}\n"
                 "\"name\": \"od\\\"d\\\\\", \"round\": 1, \"var\": 2, \"dropped\": 1}\n"
                 "\"round\": 1, \"rows\": 2}\n"
                 "\"round\": 2, \"var\": 3, \"row\": 6, \"parents\": [4, 5], \"dropped_by\": null, "
                 "\"history\": [4, 5], \"effective\": [3], \"implicit\": [], \"minimal\": true}\n");
}

/* Eliminating by hand: two rows for and two against x, then y alone. */
Test(trace, counted)
{
    static const int64_t row[][2] = {{1, 1}, {1, -1}, {-1, 2}, {-1, -3}};
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    fmb_system *s = rows_none(2);
    for (int i = 0; i < 4; i++)
        must(fmb_system_add_int(s, row[i], FMB_LE, 10 + i));
    o.method = FMB_METHOD_FM;
    o.order = FMB_ORDER_GIVEN;
    o.rules = "none";
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_solve(v, s, &r));
    cr_expect_eq(r.verdict, FMB_FEASIBLE);
    cr_expect_eq(r.trust, FMB_TRUST_EXACT);
    cr_expect_eq(r.stop, FMB_STOP_DONE);
    cr_expect_geq(r.stats.rounds, 1);
    cr_expect_geq(r.stats.pairs, 4);
    cr_expect_geq(r.stats.rows_peak, 4);
    cr_expect_eq(r.stats.promotions, 0);
    cr_expect_gt(r.stats.bytes_peak, 0);
    fmb_solver_free(v);
    fmb_system_free(s);
}

Test(words, texts)
{
    for (int i = 0; i <= FMB_ERR_RANGE; i++)
        cr_expect(fmb_status_text((fmb_status)i)[0]);
    cr_expect_str_eq(fmb_verdict_text(FMB_FEASIBLE), "feasible");
    cr_expect_str_eq(fmb_verdict_text(FMB_INFEASIBLE), "infeasible");
    cr_expect_str_eq(fmb_verdict_text(FMB_UNKNOWN), "unknown");
    cr_expect_str_eq(fmb_stop_text(FMB_STOP_DONE), "done");
    cr_expect_str_eq(fmb_stop_text(FMB_STOP_TIME), "time");
    cr_expect_str_eq(fmb_stop_text(FMB_STOP_ROWS), "rows");
    cr_expect_str_eq(fmb_stop_text(FMB_STOP_BYTES), "bytes");
    cr_expect_str_eq(fmb_stop_text(FMB_STOP_CANCELLED), "cancelled");
    cr_expect_not_null(fmb_status_text((fmb_status)99));
    cr_expect_not_null(fmb_verdict_text((fmb_verdict)99));
    cr_expect_not_null(fmb_stop_text((fmb_stop)99));
    cr_expect_not_null(strchr(fmb_version(), '.'));
}

static void note_round(void *self, const fmb_event *e)
{
    bool *seen = self;
    if (e->kind == FMB_EVENT_ROUND)
        seen[e->var] = true;
}

/* Variables are those of the system, also where it falls into parts. */
Test(trace, variables_of_the_system)
{
    static const int64_t rows[][4] = {{1, 0, 0, 0}, {0, 0, 1, 1}, {0, 0, -1, 1}, {0, 0, 1, -1}};
    static const bool expected[] = {true, false, true, true};
    bool seen[4] = {false};
    fmb_system *s = NULL;
    fmb_solver *v = solver(FMB_METHOD_FM);
    fmb_result r = {.size = sizeof r};
    must(fmb_system_new(4, NULL, &s));
    for (int i = 0; i < 4; i++)
        must(fmb_system_add_int(s, rows[i], FMB_LE, 1));
    fmb_solver_set_sink(v, (fmb_sink){note_round, seen});
    must(fmb_solve(v, s, &r));
    for (int j = 0; j < 4; j++)
        cr_expect_eq(seen[j], expected[j], "x%d", j + 1);
    fmb_system_free(s);
    fmb_solver_free(v);
}
