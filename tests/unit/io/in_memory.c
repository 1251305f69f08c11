/* in_memory.c: writing to memory gives the same bytes as to a stream, and only if they fit; reading
 * from memory gives the same as from a stream. */
#include <criterion/criterion.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/geometry.h>

#include "parse.h"
#include "support/must.h"

/* ---- writing --------------------------------------------------------------------------------- */

/* All that can be written, about one small system. */
typedef struct scene {
    fmb_system *s;
    fmb_generators *g;
    fmb_solver *v;
    fmb_evidence *e;
    fmb_frame f[2];
    fmb_format format;
    size_t claim;
} scene;

typedef fmb_status write_fn(const scene *w, FILE *out);
typedef fmb_status print_fn(const scene *w, char *text, size_t size, size_t *length);

static fmb_status write_system(const scene *w, FILE *out)
{
    return fmb_system_write(w->s, w->format, out);
}

static fmb_status print_system(const scene *w, char *text, size_t size, size_t *length)
{
    return fmb_system_print(w->s, w->format, text, size, length);
}

static fmb_status write_generators(const scene *w, FILE *out)
{
    return fmb_generators_write(w->g, out);
}

static fmb_status print_generators(const scene *w, char *text, size_t size, size_t *length)
{
    return fmb_generators_print(w->g, text, size, length);
}

static fmb_status write_evidence(const scene *w, FILE *out)
{
    return fmb_evidence_write(w->e, w->s, out);
}

static fmb_status print_evidence(const scene *w, char *text, size_t size, size_t *length)
{
    return fmb_evidence_print(w->e, w->s, text, size, length);
}

static fmb_status write_claim(const scene *w, FILE *out)
{
    return fmb_evidence_tell(w->e, w->s, w->claim, out);
}

static fmb_status print_claim(const scene *w, char *text, size_t size, size_t *length)
{
    return fmb_evidence_print_claim(w->e, w->s, w->claim, text, size, length);
}

static fmb_status write_pairs(const scene *w, FILE *out)
{
    return fmb_frame_pairs_write(out, 1, &w->f[0], &w->f[1]);
}

static fmb_status print_pairs(const scene *w, char *text, size_t size, size_t *length)
{
    return fmb_frame_pairs_print(1, &w->f[0], &w->f[1], text, size, length);
}

static const fmb_event EVENT = {.kind = FMB_EVENT_BEGIN, .var = -1, .name = "a \"name\""};

static fmb_status write_event(const scene *w, FILE *out)
{
    (void)w;
    fmb_sink sink = fmb_sink_jsonl(out);
    sink.put(sink.self, &EVENT);
    return FMB_OK;
}

static fmb_status print_event(const scene *w, char *text, size_t size, size_t *length)
{
    (void)w;
    return fmb_event_print(&EVENT, text, size, length);
}

static const double ORIGIN[] = {0, 0}, AXES[] = {1, 0, 0, 1};

static scene open_scene(void)
{
    static const char text[] = "vars: x \"y z\"\na: x + 1/2 \"y z\" <= 3\nx >= 0\n\"y z\" >= 0\n"
                               "max: x\n";
    scene w = {.s = parse(FMB_FORMAT_TEXT, text, sizeof text - 1)};
    w.f[0] = w.f[1] = (fmb_frame){FMB_CUBOID, 2, 2, ORIGIN, AXES, NULL};
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_ALL;
    fmb_box *box = NULL;
    must(fmb_solver_new(&o, NULL, &w.v));
    must(fmb_generate(w.v, w.s, &w.g, NULL));
    must(fmb_bound(w.v, w.s, NULL, 0, &box, NULL));
    must(fmb_solver_evidence(w.v, &w.e));
    fmb_box_free(box);
    return w;
}

static void close_scene(scene *w)
{
    fmb_evidence_free(w->e);
    fmb_generators_free(w->g);
    fmb_solver_free(w->v);
    fmb_system_free(w->s);
}

static void expect_twins(const scene *w, const char *what, write_fn *write, print_fn *print)
{
    char *want = NULL, untouched[] = "?";
    size_t size = 0, length = 0;
    FILE *out = open_memstream(&want, &size);
    cr_assert(out);
    cr_assert_eq(write(w, out), FMB_OK, "%s", what);
    fclose(out);
    must(print(w, NULL, 0, &length));
    cr_assert_eq(length, size, "%s: %zu bytes of %zu", what, length, size);
    length = 0;
    must(print(w, untouched, 1, &length));
    cr_expect(length == size && untouched[0] == '?', "%s: written without room", what);
    char *text = malloc(size + 1);
    memset(text, '?', size + 1);
    must(print(w, text, size, &length));
    cr_expect_eq(text[0], '?', "%s: no room for the NUL", what);
    must(print(w, text, size + 1, &length));
    cr_expect(memcmp(text, want, size + 1) == 0, "%s: %s\nis not\n%s", what, text, want);
    length = 7;
    cr_expect_eq(print(w, NULL, 1, &length), FMB_ERR_ARG, "%s: no text", what);
    cr_expect_eq(print(w, text, size, NULL), FMB_ERR_ARG, "%s: no length", what);
    cr_expect_eq(length, 7, "%s: length of a failure", what);
    free(text);
    free(want);
}

Test(in_memory, writing)
{
    scene w = open_scene();
    const fmb_format formats[] = {FMB_FORMAT_TEXT, FMB_FORMAT_INE, FMB_FORMAT_SMT2, FMB_FORMAT_MPS,
                                  FMB_FORMAT_LP};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        w.format = formats[i];
        expect_twins(&w, fmb_format_text(w.format), write_system, print_system);
    }
    expect_twins(&w, "generators", write_generators, print_generators);
    expect_twins(&w, "evidence", write_evidence, print_evidence);
    for (w.claim = 0; w.claim < fmb_evidence_claims(w.e); w.claim++)
        expect_twins(&w, "claim", write_claim, print_claim);
    expect_twins(&w, "pairs", write_pairs, print_pairs);
    expect_twins(&w, "event", write_event, print_event);
    close_scene(&w);
}

/* What cannot be written is told as a stream is told, and nothing is written. */
Test(in_memory, not_written)
{
    scene w = open_scene();
    char text[] = "?";
    size_t length = 7;
    cr_expect_eq(fmb_system_print(w.s, FMB_FORMAT_IEQ, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_print(NULL, FMB_FORMAT_TEXT, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_generators_print(NULL, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_evidence_print(NULL, w.s, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_evidence_print(w.e, NULL, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_evidence_print_claim(w.e, w.s, 1000, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_frame_pairs_print(1, NULL, w.f, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_event_print(NULL, text, 2, &length), FMB_ERR_ARG);
    const fmb_event row = {.kind = FMB_EVENT_ROW}, none = {.kind = (fmb_event_kind)77};
    cr_expect_eq(fmb_event_print(&row, text, 2, &length), FMB_ERR_ARG);
    cr_expect_eq(fmb_event_print(&none, text, 2, &length), FMB_ERR_ARG);
    const fmb_event engine = {.kind = FMB_EVENT_ENGINE};
    cr_expect_eq(fmb_event_print(&engine, text, 2, &length), FMB_ERR_ARG);
    cr_expect(strcmp(text, "?") == 0 && length == 7);
    close_scene(&w);
}

/* What an attempt leaves open is null. */
Test(in_memory, attempt_without_words)
{
    char text[256];
    size_t length = 0;
    const fmb_attempt open = {.part = -1, .budget = 5};
    const fmb_event e = {.kind = FMB_EVENT_ENGINE, .var = -1, .attempt = &open};
    cr_assert_eq(fmb_event_print(&e, text, sizeof text, &length), FMB_OK);
    cr_expect_str_eq(text, "{\"event\": \"engine\", \"seconds\": 0.000000, \"name\": null, "
                           "\"task\": null, \"columns\": 0, \"rows\": 0, \"budget\": 5, "
                           "\"unit\": null, \"ended\": null}\n");
}

/* ---- reading --------------------------------------------------------------------------------- */

Test(in_memory, evidence)
{
    scene w = open_scene();
    char text[4096];
    size_t length;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_where at = {0};
    fmb_stop stop = FMB_STOP_TIME;
    must(fmb_evidence_print(w.e, w.s, text, sizeof text, &length));
    cr_assert(length < sizeof text);
    must(fmb_evidence_parse(text, length, w.s, &e, &at));
    must(fmb_check(w.s, e, &j));
    cr_expect(j.accepted, "%s", j.reason);
    fmb_evidence_free(e);
    e = NULL;
    must(fmb_evidence_parse_within(text, length, w.s, NULL, &e, &stop, &at));
    cr_expect(e && stop == FMB_STOP_DONE);
    fmb_evidence_free(e);
    e = NULL;
    cr_expect_eq(fmb_evidence_parse(text, length - 2, w.s, &e, &at), FMB_ERR_PARSE);
    cr_expect(!e && at.line > 1);
    cr_expect_eq(fmb_evidence_parse("", 0, w.s, &e, &at), FMB_ERR_PARSE);
    cr_expect(at.line == 1 && at.column == 1, "%ld:%ld", at.line, at.column);
    cr_expect_eq(fmb_evidence_parse(NULL, 0, w.s, &e, &at), FMB_ERR_PARSE);
    cr_expect_eq(fmb_evidence_parse(NULL, 1, w.s, &e, &at), FMB_ERR_ARG);
    close_scene(&w);
}

static void expect_pair(const char *text, size_t size)
{
    fmb_frame_reader *r = NULL;
    const fmb_frame_line *line = NULL;
    fmb_where at;
    must(fmb_frame_reader_from_text(text, size, NULL, &r));
    must(fmb_frame_reader_next(r, &line, &at));
    cr_assert(line && line->dim == 2);
    cr_expect_eq(line->frame[1].axes[3], 1);
    must(fmb_frame_reader_next(r, &line, &at));
    cr_expect_null(line);
    fmb_frame_reader_free(r);
}

Test(in_memory, frames)
{
    static const char json[] = "{\"A\": {\"type\": \"cuboid\", \"orig\": [0, 0], \"comp\": "
                               "[[1, 0], [0, 1]]}, \"B\": {\"type\": \"cuboid\", \"orig\": "
                               "[0, 0], \"comp\": [[1, 0], [0, 1]]}}";
    scene w = open_scene();
    char bytes[1024];
    size_t length;
    fmb_frame_reader *r = NULL;
    const fmb_frame_line *line = NULL;
    must(fmb_frame_pairs_print(1, &w.f[0], &w.f[1], bytes, sizeof bytes, &length));
    cr_assert(length < sizeof bytes);
    expect_pair(bytes, length);
    expect_pair(json, sizeof json - 1);
    must(fmb_frame_reader_from_text("", 0, NULL, &r));
    must(fmb_frame_reader_next(r, &line, NULL));
    cr_expect_null(line);
    fmb_frame_reader_free(r);
    cr_expect_eq(fmb_frame_reader_from_text(NULL, 1, NULL, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_frame_reader_from_text("", 0, NULL, NULL), FMB_ERR_ARG);
    close_scene(&w);
}

Test(in_memory, scripts)
{
    static const char text[] = "(declare-const x Real)(check-sat)(assert (< x 0))(check-sat)";
    fmb_script *s = NULL;
    fmb_script_kind kind = FMB_SCRIPT_END;
    fmb_where at = {0};
    char *copy = malloc(sizeof text - 1);
    memcpy(copy, text, sizeof text - 1);
    must(fmb_script_parse(copy, sizeof text - 1, NULL, &s, &at));
    free(copy); /* the script has its own */
    cr_expect(fmb_script_asks_often(s));
    must(fmb_script_next(s, &kind, &at));
    cr_expect_eq(kind, FMB_SCRIPT_CHECK);
    fmb_script_free(s);
    s = NULL;
    cr_expect_eq(fmb_script_parse("(", 1, NULL, &s, &at), FMB_ERR_PARSE);
    cr_expect_eq(fmb_script_parse(NULL, 1, NULL, &s, &at), FMB_ERR_ARG);
    cr_expect_eq(fmb_script_parse("", 0, NULL, NULL, &at), FMB_ERR_ARG);
    cr_expect_null(s);
}

Test(in_memory, tetgen)
{
    static const char node[] = "4 3\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 1\n",
                      ele[] = "1 4\n1 1 2 3 4\n";
    fmb_mesh *m = NULL;
    fmb_where at = {0};
    bool in_cells = false;
    must(fmb_mesh_parse_tetgen(node, sizeof node - 1, ele, sizeof ele - 1, NULL, &m, &at, NULL));
    cr_expect_eq(fmb_mesh_cells(m), 1);
    fmb_mesh_free(m);
    m = NULL;
    cr_expect_eq(fmb_mesh_parse_tetgen(node, sizeof node - 1, "1 5", 3, NULL, &m, &at, &in_cells),
                 FMB_ERR_PARSE);
    cr_expect(in_cells && at.line == 1 && !m);
    cr_expect_eq(fmb_mesh_parse_tetgen(NULL, 1, ele, 1, NULL, &m, &at, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_mesh_parse_tetgen(NULL, 0, NULL, 0, NULL, &m, &at, &in_cells), FMB_ERR_PARSE);
    cr_expect(!in_cells && !m);
}

/* ---- places ---------------------------------------------------------------------------------- */

Test(in_memory, places)
{
    static const struct {
        fmb_where where;
        const char *name, *says;
    } table[] = {{{3, 5, "expected a number"}, "a.fmb", "a.fmb:3:5: expected a number"},
                 {{3, 0, "expected a number"}, "a.fmb", "a.fmb:3: expected a number"},
                 {{0, 5, "out is NULL"}, "a.fmb", "a.fmb: out is NULL"},
                 {{3, 5, "expected a number"}, NULL, "3:5: expected a number"},
                 {{0, 0, "out is NULL"}, NULL, "out is NULL"}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        char text[64] = "?";
        size_t n = strlen(table[i].says);
        cr_expect_eq(fmb_where_text(&table[i].where, table[i].name, NULL, 0), n);
        cr_expect_eq(fmb_where_text(&table[i].where, table[i].name, text, n), n);
        cr_expect(text[0] == '?', "written without room");
        cr_expect_eq(fmb_where_text(&table[i].where, table[i].name, text, n + 1), n);
        cr_expect(strcmp(text, table[i].says) == 0, "%s", text);
    }
    cr_expect_eq(fmb_where_text(NULL, "a", NULL, 0), 0);
}
