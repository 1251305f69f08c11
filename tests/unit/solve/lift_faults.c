/* lift_faults.c: images, sums and hulls without memory, at limits, and interrupted; and invalid
 * maps. */
#include <criterion/criterion.h>

#include <string.h>

#include <fmb/lift.h>

#include "fault/hook.h"
#include "preimages.h"
#include "property/random/rows.h"
#include "support.h"

/* ---- memory, limits -------------------------------------------------------------------------- */

typedef fmb_status verb(fmb_solver *v, const fmb_system *const *s, fmb_system **lift,
                        fmb_system **out, fmb_result *r);

static fmb_status ask_image(fmb_solver *v, const fmb_system *const *s, fmb_system **lift,
                            fmb_system **out, fmb_result *r)
{
    static const char MAP[] = "u = x1 + 1/3 x2\nx1 = x2 - 2\n";
    fmb_system *graph = NULL;
    fmb_where where;
    must(fmb_system_parse_graph(MAP, sizeof MAP - 1, NULL, s[0], &graph, &where));
    fmb_status st = fmb_image(v, s[0], graph, lift, out, r);
    fmb_system_free(graph);
    return st;
}

static fmb_status ask_sum(fmb_solver *v, const fmb_system *const *s, fmb_system **lift,
                          fmb_system **out, fmb_result *r)
{
    return fmb_sum(v, s, 2, lift, out, r);
}

static fmb_status ask_hull(fmb_solver *v, const fmb_system *const *s, fmb_system **lift,
                           fmb_system **out, fmb_result *r)
{
    return fmb_hull_union(v, s, 2, lift, out, r);
}

static verb *const VERBS[] = {ask_image, ask_sum, ask_hull};
enum { VERBS_SIZE = sizeof VERBS / sizeof *VERBS };

static fmb_options with_evidence(void)
{
    fmb_options o = {.size = sizeof o};
    o.evidence = FMB_EVIDENCE_ALL;
    return o;
}

Test(lift_faults, every_request_may_fail)
{
    support_shape shape = {3, 6, 31};
    support_case a = support_make(SUPPORT_PLANTED_POINT, 3, &shape);
    support_case b = support_make(SUPPORT_PLANTED_POINT, 8, &shape);
    const fmb_system *s[2] = {a.s, b.s};
    fmb_options o = with_evidence();
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    for (size_t q = 0; q < VERBS_SIZE; q++) {
        fmb_status st = FMB_ERR_MEMORY;
        for (size_t k = 1; st == FMB_ERR_MEMORY; k += WATCHED) {
            fmb_system *lift = NULL, *out = NULL;
            fmb_solver *v = NULL;
            must(fmb_solver_new(&o, &mem, &v));
            hook_arm(&h, k, k % 2 == 0);
            st = VERBS[q](v, s, &lift, &out, NULL);
            hook_calm(&h);
            cr_assert(st == FMB_OK || (st == FMB_ERR_MEMORY && !lift && !out));
            fmb_system_free(lift);
            fmb_system_free(out);
            fmb_solver_free(v);
            cr_assert_eq(h.live, 0, "verb %zu, request %zu: %zu bytes leak", q, k, h.live);
        }
        cr_assert_eq(st, FMB_OK);
    }
    support_case_clear(&a);
    support_case_clear(&b);
}

Test(lift_faults, lifts_of_generators_without_memory)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    fmb_generators *g = NULL;
    fmb_status st = FMB_ERR_MEMORY;
    must(fmb_generators_new(2, &mem, &g));
    must(fmb_generators_add(g, FMB_VERTEX, (double[]){1, 0.5}));
    must(fmb_generators_add(g, FMB_RAY, (double[]){0, 1}));
    must(fmb_generators_add(g, FMB_LINE, (double[]){1, 0}));
    size_t before = h.live;
    for (size_t k = 1; st == FMB_ERR_MEMORY; k++) {
        fmb_system *lift = NULL;
        hook_arm(&h, k, false);
        st = fmb_lift_generators(g, NULL, &lift);
        hook_calm(&h);
        cr_assert_eq(lift != NULL, st == FMB_OK);
        fmb_system_free(lift);
        cr_assert_eq(h.live, before);
    }
    cr_assert_eq(st, FMB_OK);
    fmb_generators_free(g);
}

/* Rows of what was found at a limit follow from the lift, if there is one. */
static void expect_outer(const fmb_system *lift, const fmb_system *out)
{
    fmb_solver *v = lifts_solver();
    for (size_t i = 0; lift && i < fmb_system_rows(out); i++) {
        fmb_system *beyond = rows_with(lift, SIZE_MAX, out, i, ROW_ABOVE, NULL);
        fmb_result r = {.size = sizeof r};
        must(fmb_solve(v, beyond, &r));
        cr_assert(fmb_system_rel(out, i) != FMB_LE || r.verdict == FMB_INFEASIBLE);
        fmb_system_free(beyond);
    }
    fmb_solver_free(v);
}

Test(lift_faults, limits_are_results)
{
    support_shape shape = {3, 8, 0};
    support_case a = support_make(SUPPORT_PLANTED_POINT, 3, &shape);
    support_case b = support_make(SUPPORT_PLANTED_POINT, 8, &shape);
    const fmb_system *s[2] = {a.s, b.s};
    for (size_t q = 0; q < VERBS_SIZE; q++) {
        size_t limited = 0;
        fmb_stop stop = FMB_STOP_BYTES;
        for (size_t bytes = 256; stop != FMB_STOP_DONE; bytes += bytes / 16) {
            fmb_system *lift = NULL, *out = NULL;
            fmb_solver *v = NULL;
            fmb_result r = {.size = sizeof r};
            fmb_options o = with_evidence();
            o.max_bytes = bytes;
            must(fmb_solver_new(&o, NULL, &v));
            must(VERBS[q](v, s, &lift, &out, &r));
            stop = r.stop;
            cr_assert(out && (lift || r.verdict == FMB_UNKNOWN));
            cr_assert(stop == FMB_STOP_DONE || stop == FMB_STOP_BYTES);
            expect_outer(lift, out);
            limited += stop != FMB_STOP_DONE;
            fmb_system_free(lift);
            fmb_system_free(out);
            fmb_solver_free(v);
        }
        cr_expect_gt(limited, 10);
    }
    support_case_clear(&a);
    support_case_clear(&b);
}

/* A watcher that wants to hear no more. */
static void cancel_at_first_event(void *self, const fmb_event *e)
{
    (void)e;
    fmb_solver_cancel(*(fmb_solver **)self);
}

Test(lift_faults, a_cancel_between_the_steps_of_a_hull_counts)
{
    fmb_system *s = rows_none(2), *out = NULL;
    fmb_solver *v = lifts_solver();
    fmb_result r = {.size = sizeof r};
    must(fmb_system_add_int(s, (int64_t[]){3, 1}, FMB_LE, 5));
    must(fmb_system_add_int(s, (int64_t[]){-1, 2}, FMB_LE, 5));
    fmb_solver_set_sink(v, (fmb_sink){cancel_at_first_event, &v});
    must(fmb_hull_union(v, (const fmb_system *[]){s, s, s}, 3, NULL, &out, &r));
    cr_expect_eq(r.stop, FMB_STOP_CANCELLED);
    cr_expect_eq(fmb_system_dim(out), 2);
    fmb_system_free(out);
    fmb_solver_set_sink(v, (fmb_sink){NULL, NULL});
    must(fmb_hull_union(v, (const fmb_system *[]){s, s, s}, 3, NULL, &out, &r));
    cr_expect(r.stop == FMB_STOP_DONE && fmb_system_rows(out) == 2);
    fmb_system_free(out);
    fmb_system_free(s);
    fmb_solver_free(v);
}

/* ---- maps ------------------------------------------------------------------------------------ */

/* x and y are kept, z is not. */
static fmb_system *some_system(void)
{
    static const char TEXT[] = "vars: x z \"y y\"\nproject: x \"y y\"\n0 <= x <= z\n";
    fmb_system *s = NULL;
    fmb_where where;
    must(fmb_system_parse(TEXT, sizeof TEXT - 1, NULL, &s, &where));
    return s;
}

Test(lift_faults, a_map_in_place)
{
    static const char MAP[] = "# in place\n x = x + 2\"y y\" - 1/2 # and more\n\n\"x'\" = 3(x-x)\n";
    fmb_system *s = some_system(), *graph = NULL;
    fmb_where where;
    mpq_t q;
    must(fmb_system_parse_graph(MAP, sizeof MAP - 1, NULL, s, &graph, &where));
    cr_assert(fmb_system_dim(graph) == 4 && fmb_system_rows(graph) == 2);
    cr_expect_str_eq(fmb_system_name(graph, 2), "x");
    cr_expect_str_eq(fmb_system_name(graph, 3), "x'");
    cr_expect_str_eq(fmb_system_name(graph, 0), "x''");
    mpq_init(q);
    fmb_system_rhs_q(graph, 0, q);
    cr_expect_eq(mpq_cmp_si(q, 1, 2), 0);
    cr_expect(fmb_system_term_q(graph, 0, 1, q) == 1 && mpq_cmp_si(q, 2, 1) == 0);
    cr_expect(fmb_system_term_q(graph, 0, 2, q) == 2 && mpq_cmp_si(q, -1, 1) == 0);
    cr_expect_eq(fmb_system_terms(graph, 1), 1);
    mpq_clear(q);
    fmb_system_free(graph);
    fmb_system_free(s);
}

Test(lift_faults, bad_maps_are_told_where)
{
    static const struct {
        const char *text;
        long line, column;
        const char *says;
    } bad[] = {{"", 0, 0, "expected lines NAME = FORM, found none"},
               {"# x\n\n", 0, 0, "expected lines NAME = FORM, found none"},
               {"u = x\nv = z", 2, 5, "expected a variable of the system, found 'z'"},
               {"u = x\nv = x y", 2, 7, "expected an operator or the end of the form, found 'y'"},
               {"u = x\n u = x", 2, 2, "expected a new name, found 'u' again"},
               {"u = x <= 3", 1, 7, "expected an operator or the end of the form, found '<='"},
               {"u <= x", 1, 3, "expected '=' behind a name, found '<='"},
               {"u: x", 1, 2, "expected '=' behind a name, found ':'"},
               {"3 = x", 1, 1, "expected the name of a variable, found '3'"},
               {"u = x *", 1, 8, "expected a number, a name or '(', found end of file"},
               {"u = x * x", 1, 9, "expected a constant factor: rows are linear"}};
    fmb_system *s = some_system(), *const mark = s;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        fmb_system *graph = mark;
        fmb_where where = {0};
        cr_expect_eq(
            fmb_system_parse_graph(bad[i].text, strlen(bad[i].text), NULL, s, &graph, &where),
            FMB_ERR_PARSE);
        cr_expect(graph == mark && where.line == bad[i].line && where.column == bad[i].column,
                  "%zu: %ld:%ld", i, where.line, where.column);
        cr_expect_str_eq(where.text, bad[i].says);
    }
    fmb_system *graph = NULL;
    const fmb_reader tight = {.size = sizeof tight, .max_bytes = 3};
    cr_expect_eq(fmb_system_parse_graph("u = x", 5, &tight, s, &graph, NULL), FMB_ERR_PARSE);
    cr_expect_eq(fmb_system_parse_graph("u = x", 5, NULL, NULL, &graph, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_parse_graph(NULL, 5, NULL, s, &graph, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_read_graph(NULL, NULL, s, &graph, NULL), FMB_ERR_ARG);
    fmb_system_free(s);
}

Test(lift_faults, maps_without_memory)
{
    hook h = {0};
    fmb_alloc mem = hook_alloc(&h);
    const fmb_reader how = {.size = sizeof how, .mem = &mem};
    fmb_system *s = some_system();
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 1; st == FMB_ERR_MEMORY; k++) {
        fmb_system *graph = NULL;
        hook_arm(&h, k, false);
        st = fmb_system_parse_graph("x = x + 1\ny = 2/3x", 18, &how, s, &graph, NULL);
        hook_calm(&h);
        fmb_system_free(graph);
        cr_assert_eq(h.live, 0, "request %zu", k);
    }
    cr_assert_eq(st, FMB_OK);
    fmb_system_free(s);
}

Test(lift_faults, a_polyhedron_is_read_either_way)
{
    static const char EXT[] = "* a point\nV-representation\nbegin\n1 3 integer\n1 4 5\nend\n";
    static const char INE[] = "H-representation\nbegin\n1 3 integer\n1 4 5\nend\n";
    fmb_system *s = NULL;
    fmb_generators *g = NULL;
    fmb_where where;
    FILE *file = tmpfile();
    must(fmb_polyhedron_parse(EXT, sizeof EXT - 1, NULL, &s, &g, &where));
    cr_expect(!s && fmb_generators_size(g) == 1);
    fmb_generators_free(g);
    must(fmb_polyhedron_parse(INE, sizeof INE - 1, NULL, &s, &g, &where));
    cr_expect(!g && fmb_system_rows(s) == 1);
    fmb_system_free(s);
    cr_assert(fputs("u = x\n", file) >= 0 && fflush(file) == 0);
    rewind(file);
    must(fmb_polyhedron_read(file, NULL, &s, &g, &where));
    cr_expect(!g && fmb_system_dim(s) == 2);
    rewind(file);
    fmb_system *graph = NULL;
    must(fmb_system_read_graph(file, NULL, s, &graph, &where));
    cr_expect_eq(fmb_system_dim(graph), 3);
    fclose(file);
    fmb_system_free(graph);
    fmb_system_free(s);
    const fmb_reader text = {.size = sizeof text, .format = FMB_FORMAT_TEXT};
    cr_expect_eq(fmb_polyhedron_parse(EXT, sizeof EXT - 1, &text, &s, &g, &where), FMB_ERR_PARSE);
    cr_expect_eq(fmb_polyhedron_parse(EXT, sizeof EXT - 1, NULL, NULL, &g, &where), FMB_ERR_ARG);
    cr_expect_eq(fmb_polyhedron_parse(NULL, 3, NULL, &s, &g, &where), FMB_ERR_ARG);
    cr_expect_eq(fmb_polyhedron_read(NULL, NULL, &s, &g, &where), FMB_ERR_ARG);
}
