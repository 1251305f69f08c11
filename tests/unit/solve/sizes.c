/* sizes.c: structures of programs that were compiled with another version (<fmb/base.h>): shorter
 * ones work, longer ones if the unknown rest is 0; others are refused with a text. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/fmb.h>
#include <fmb/frames.h>
#include <fmb/geometry.h>

#include "property/random/rows.h"

/* A structure of a later version: ours, and a field of which we know nothing. */
#define LATER(type)                                                                                \
    struct {                                                                                       \
        type ours;                                                                                 \
        size_t more;                                                                               \
    }

static fmb_system *some_system(void)
{
    fmb_system *s = NULL;
    must(fmb_system_new(1, NULL, &s));
    must(fmb_system_add(s, (double[]){-1}, FMB_LE, 0));
    return s;
}

/* ---- settings -------------------------------------------------------------------------------- */

static void expect_options(const fmb_options *o, const char *trouble)
{
    fmb_solver *v = NULL;
    char text[200];
    size_t length = fmb_options_trouble(o, text, sizeof text);
    cr_expect_eq(length, strlen(text));
    cr_expect_not_null(strstr(text, trouble), "\"%s\" instead of \"%s\"", text, trouble);
    cr_expect((length == 0) == (*trouble == '\0'));
    cr_expect_eq(fmb_solver_new(o, NULL, &v), *trouble ? FMB_ERR_ARG : FMB_OK);
    fmb_solver_free(v);
}

Test(sizes, options)
{
    LATER(fmb_options) o = {.ours = {.size = sizeof o}};
    char text[4] = "abc";
    expect_options(NULL, "");
    expect_options(&o.ours, "");
    o.more = 1;
    expect_options(&o.ours, "options.size is");
    o.ours.size = sizeof o.ours;
    expect_options(&o.ours, "");
    o.ours.size = 0;
    expect_options(&o.ours, "options.size is 0, and should be");
    o.ours.size = SIZE_MAX;
    expect_options(&o.ours, "options.size is 18446744073709551615, and should be");
    o.ours.size = sizeof o.ours;
    o.ours.method = (fmb_method)9;
    expect_options(&o.ours, "method is 9");
    cr_expect(fmb_options_trouble(&o.ours, text, sizeof text) > sizeof text);
    cr_expect_str_eq(text, "abc");
    cr_expect(fmb_options_trouble(&o.ours, NULL, 0) > 0);
}

/* What stands behind the fields of an older version is not read, and not set. */
Test(sizes, older_options)
{
    fmb_options o;
    memset(&o, 0x5a, sizeof o);
    memset(&o, 0, offsetof(fmb_options, threads));
    o.size = offsetof(fmb_options, threads);
    expect_options(&o, "");
    must(fmb_options_set(&o, "max_rows", "7"));
    cr_expect_eq(o.max_rows, 7);
    cr_expect_eq(fmb_options_set(&o, "threads", "2"), FMB_ERR_ARG);
    o.size = sizeof o;
    expect_options(&o, "symmetry is");
}

/* The default of the table is that of zeros. */
Test(sizes, zero_is_the_default)
{
    const fmb_options zero = {.size = sizeof zero};
    const fmb_option_info *line;
    for (size_t i = 0; (line = fmb_options_describe(i)) != NULL; i++) {
        fmb_options o = zero;
        if (strcmp(line->name, "rules") == 0 || strcmp(line->name, "presolve") == 0)
            continue;
        must(fmb_options_set(&o, line->name, line->initial));
        cr_expect_eq(memcmp(&o, &zero, sizeof o), 0, "%s", line->name);
    }
}

Test(sizes, other_settings)
{
    fmb_pair *k = NULL;
    fmb_evidence *e = NULL;
    fmb_stop stop;
    char text[200];
    fmb_system *s = some_system();
    const fmb_pair_options pair = {.size = 4};
    const fmb_pair_options late = {.size = sizeof late, .max_seconds = -1};
    const fmb_patience patience = {.size = 0}, negative = {.size = sizeof negative, -1, 0, NULL, 0};
    const fmb_mesh_options mesh = {.size = 5000};
    const fmb_reader reader = {.size = 1};
    cr_expect_eq(fmb_pair_new(2, &pair, NULL, &k), FMB_ERR_ARG);
    cr_expect(fmb_pair_options_trouble(&pair, text, sizeof text) > 0);
    cr_expect_not_null(strstr(text, "options.size is 4"), "%s", text);
    cr_expect(fmb_pair_options_trouble(&late, text, sizeof text) > 0);
    cr_expect_str_eq(text, "max_seconds is -1");
    cr_expect_eq(fmb_pair_options_trouble(NULL, text, sizeof text), 0u);
    cr_expect(fmb_patience_trouble(&patience, text, sizeof text) > 0);
    cr_expect_not_null(strstr(text, "patience.size is 0"), "%s", text);
    cr_expect(fmb_patience_trouble(&negative, text, sizeof text) > 0);
    cr_expect_str_eq(text, "max_seconds is -1");
    cr_expect_eq(fmb_patience_trouble(NULL, NULL, 0), 0u);
    FILE *in = tmpfile();
    cr_assert_not_null(in);
    cr_expect_eq(fmb_evidence_read_within(in, s, &patience, &e, &stop, NULL), FMB_ERR_ARG);
    fclose(in);
    cr_expect(fmb_mesh_options_trouble(&mesh, text, sizeof text) > 0);
    cr_expect_not_null(strstr(text, "options.size is 5000"), "%s", text);
    fmb_where where;
    fmb_system *read = NULL;
    cr_expect_eq(fmb_system_parse("x >= 1", 6, &reader, &read, &where), FMB_ERR_ARG);
    cr_expect_not_null(strstr(where.text, "how.size is 1"), "%s", where.text);
    fmb_mesh *m = NULL;
    cr_expect_eq(fmb_mesh_parse("OFF", 3, FMB_MESH_OFF, &reader, &m, &where), FMB_ERR_ARG);
    cr_expect_not_null(strstr(where.text, "how.size is 1"), "%s", where.text);
    fmb_system_free(s);
}

/* ---- reports --------------------------------------------------------------------------------- */

Test(sizes, results)
{
    LATER(fmb_result) r = {.ours = {.size = sizeof r}};
    fmb_system *s = some_system(), *shadow = NULL;
    fmb_solver *v = NULL;
    must(fmb_solver_new(NULL, NULL, &v));
    must(fmb_solve(v, s, &r.ours));
    cr_expect_eq(r.ours.verdict, FMB_FEASIBLE);
    cr_expect_eq(r.ours.size, sizeof r);
    r.more = 1;
    cr_expect_eq(fmb_solve(v, s, &r.ours), FMB_ERR_ARG);
    cr_expect_not_null(strstr(fmb_solver_trouble(v), "res.size is"), "%s", fmb_solver_trouble(v));
    r.ours.size = 0;
    cr_expect_eq(fmb_project(v, s, (int[]){0}, 1, &shadow, &r.ours), FMB_ERR_ARG);
    cr_expect_null(shadow);

    memset(&r.ours, 0x5a, sizeof r.ours); /* of a version without statistics */
    r.ours.size = offsetof(fmb_result, stats);
    const fmb_stats before = r.ours.stats;
    must(fmb_solve(v, s, &r.ours));
    cr_expect_eq(r.ours.verdict, FMB_FEASIBLE);
    cr_expect_eq(memcmp(&before, &r.ours.stats, sizeof before), 0);
    fmb_solver_free(v);
    fmb_system_free(s);
}

Test(sizes, judgements)
{
    fmb_judgement j = {.size = offsetof(fmb_judgement, held), .claim = 77};
    fmb_system *s = some_system();
    fmb_solver *v = NULL;
    fmb_evidence *e = NULL;
    must(fmb_solver_new(NULL, NULL, &v));
    must(fmb_solve(v, s, NULL));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    cr_expect(j.accepted && j.claim == 77 && j.held == 0);
    j.size = 3;
    cr_expect_eq(fmb_check(s, e, &j), FMB_ERR_ARG);
    fmb_evidence_free(e);
    fmb_solver_free(v);
    fmb_system_free(s);
}

Test(sizes, pairs)
{
    static const double origin[1] = {0}, axes[1] = {1};
    const fmb_frame f = {FMB_CUBOID, 1, 1, origin, axes, NULL};
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_pair *k = NULL;
    must(fmb_pair_new(1, NULL, NULL, &k));
    fmb_pair_answers out = {.size = offsetof(fmb_pair_answers, world), .verdict = &verdict};
    double nothing;
    out.world = &nothing; /* of which that version knew nothing */
    nothing = 77;
    must(fmb_pair_test(k, 1, &f, &f, &out));
    cr_expect_eq(verdict, FMB_FEASIBLE);
    cr_expect(nothing > 76 && nothing < 78);
    out.size = 0;
    cr_expect_eq(fmb_pair_test(k, 1, &f, &f, &out), FMB_ERR_ARG);
    cr_expect_not_null(strstr(fmb_pair_trouble(k), "out.size is 0"), "%s", fmb_pair_trouble(k));
    fmb_frames *set = NULL;
    must(fmb_frames_new(1, 1, &f, NULL, &set));
    cr_expect_eq(fmb_frames_test(k, set, set, 1, &(fmb_frames_pair){0, 0}, &out), FMB_ERR_ARG);
    cr_expect_not_null(strstr(fmb_pair_trouble(k), "out.size is 0"), "%s", fmb_pair_trouble(k));
    fmb_frames_free(set);
    fmb_pair_counts counts = {.size = offsetof(fmb_pair_counts, exact_verdicts), .exact_boxes = 77};
    must(fmb_pair_count(k, &counts));
    cr_expect(counts.pairs == 1 && counts.exact_boxes == 77);
    counts.size = 0;
    cr_expect_eq(fmb_pair_count(k, &counts), FMB_ERR_ARG);
    fmb_frame_arrays arrays = {
        .size = 0, .shape = FMB_CUBOID, .naxes = 1, .origin = origin, .axes = axes};
    cr_expect_eq(fmb_frames_from_arrays(1, 1, &arrays, NULL, &set), FMB_ERR_ARG);
    fmb_pair_free(k);
}

Test(sizes, meshes)
{
    static const double point[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const uint32_t corner[3] = {0, 1, 2};
    LATER(fmb_mesh_answer) a = {.ours = {.size = sizeof a}};
    fmb_mesh *m = NULL;
    must(fmb_mesh_new(3, 3, point, 1, corner, NULL, &m));
    must(fmb_mesh_meet(m, NULL, NULL, &a.ours));
    cr_expect(a.ours.size == sizeof a && a.ours.hits == 0);
    fmb_mesh_answer_clear(&a.ours);
    a.ours.size = offsetof(fmb_mesh_answer, mem); /* no place for what is to be released */
    cr_expect_eq(fmb_mesh_meet(m, NULL, NULL, &a.ours), FMB_ERR_ARG);
    a.ours.size = sizeof a.ours;
    cr_expect_eq(fmb_mesh_meet(m, NULL, &(fmb_mesh_options){.size = 2}, &a.ours), FMB_ERR_ARG);
    fmb_mesh_free(m);
}
