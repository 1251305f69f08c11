/* canonical.c: equal sets have identical projections, whatever their description and the method. */
#include <stdlib.h>
#include <string.h>

#include <criterion/criterion.h>

#include <fmb/io.h>

#include "property/random/rows.h"
#include "support.h"

static const fmb_method METHODS[] = {FMB_METHOD_AUTO, FMB_METHOD_FM, FMB_METHOD_LP, FMB_METHOD_HULL,
                                     FMB_METHOD_DD};
enum { WAYS = 2 * sizeof METHODS / sizeof *METHODS };

static fmb_system *parse(const char *text)
{
    fmb_system *s = NULL;
    must(fmb_system_parse(text, strlen(text), NULL, &s, NULL));
    return s;
}

static char *text_of(const fmb_system *s)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    must(fmb_system_write(s, FMB_FORMAT_TEXT, out));
    fclose(out);
    return text;
}

/* The first n variables of the system have that projection, by every way. */
static void expect_form(const char *system, int n, const char *form)
{
    fmb_system *s = parse(system);
    for (int way = 0; way < WAYS; way++) {
        static const int keep[] = {0, 1, 2, 3};
        fmb_options o = {.size = sizeof o};
        fmb_solver *v = NULL;
        fmb_system *p = NULL;
        fmb_result r = {.size = sizeof r};
        o.method = METHODS[way / 2];
        o.arith = way % 2 ? FMB_ARITH_GMP : FMB_ARITH_AUTO;
        o.evidence = FMB_EVIDENCE_WHOLE;
        must(fmb_solver_new(&o, NULL, &v));
        must(fmb_project(v, s, keep, n, &p, &r));
        char *text = text_of(p);
        cr_expect_str_eq(text, form, "way %d of %s", way, system);
        cr_expect_str_eq(fmb_solver_trouble(v), "", "way %d: not whole", way);
        cr_assert_eq(support_proved_rows(v, s), r.verdict == FMB_FEASIBLE ? fmb_system_rows(p) : 0);
        free(text);
        fmb_system_free(p);
        fmb_solver_free(v);
    }
    fmb_system_free(s);
}

/* A quadrant without its corner: any row with both variables says that it is missing. */
Test(canonical, a_missing_corner)
{
    const char *form = "vars: x y\n-x <= 0\n-y <= 0\n-x - y < 0\n";
    expect_form("vars: x y\nx >= 0\ny >= 0\nx + y > 0\n", 2, form);
    expect_form("vars: x y\n2 x + y > 0\ny >= 0\n3 x >= 0\n", 2, form);
    expect_form("vars: x y z\nx + 9 y - z > 0\ny >= 0\nx >= 0\nz >= 0\n", 2, form);
}

/* Four facets meet in the tip of a pyramid; two of them are enough to say that it is missing. */
Test(canonical, a_missing_tip_that_is_not_simple)
{
    const char *form = "vars: x y z\n-z < 0\nx - z <= 0\n-x - z <= 0\ny - z <= 0\n-y - z <= 0\n";
    expect_form("vars: x y z\nx <= z\n-x <= z\ny <= z\n-y <= z\nz > 0\n", 3, form);
    expect_form("vars: x y z\nx <= z\n-x <= z\ny <= z\n-y <= z\n2 z + x > 0\n", 3, form);
    expect_form("vars: x y z\n4 z + x - 2 y > 0\n-y <= z\ny <= z\n-x <= z\nx <= z\n", 3, form);
}

/* A cube without an edge, and without a corner that is on it or is not. */
Test(canonical, missing_edges_and_corners)
{
    const char *cube = "vars: x y z\n0 <= x <= 1\n0 <= y <= 1\n0 <= z <= 1\n";
    const char *faces = "x <= 1\n-x <= 0\ny <= 1\n-y <= 0\nz <= 1\n-z <= 0\n";
    char text[400], form[400];
    snprintf(text, sizeof text, "%sx + 5 y > 0\nx + y + z > 0\n", cube);
    snprintf(form, sizeof form, "vars: x y z\n%s-x - y < 0\n", faces);
    expect_form(text, 3, form);
    snprintf(text, sizeof text, "%sx + 5 y > 0\nx + 7 y + z < 9\n", cube);
    snprintf(form, sizeof form, "vars: x y z\n%s-x - y < 0\nx + y + z < 3\n", faces);
    expect_form(text, 3, form);
}

/* A face of a facet that is missing needs no row. */
Test(canonical, missing_facets)
{
    const char *form = "vars: x y\n-x < 0\n-y <= 0\n";
    expect_form("vars: x y\nx > 0\ny >= 0\n", 2, form);
    expect_form("vars: x y\nx > 0\ny >= 0\nx + y > 0\n2 x + y >= 0\n", 2, form);
}

/* Equations in echelon form, and nothing else names their pivots; the corner that is missing is one
 * of the triangle that they leave. */
Test(canonical, flat_sets)
{
    const char *form = "vars: x y z\nx + y + z = 1\n-y <= 0\n-z <= 0\ny + z <= 1\n-y - z < 0\n";
    expect_form("vars: x y z\nx >= 0\ny >= 0\nz >= 0\nx + y + z = 1\nx < 1\n", 3, form);
    expect_form("vars: x y z\nx >= 0\ny >= 0\nz >= 0\nx + y + z <= 1\nx + y + z >= 1\n"
                "2 y + 3 z > 0\n",
                3, form);
    expect_form("vars: x y z\n2 x + 4 y = 2\n4 x + 8 y = 4\n-3 y + 6 z = 9\n6 y > 0\n", 3,
                "vars: x y z\nx + 4 z = 7\ny - 2 z = -3\n-2 z < -3\n");
}

Test(canonical, unbounded_sets)
{
    expect_form("vars: x y z\nx <= z\n2 y < 6\n4 y - 4 x <= 2\n", 2,
                "vars: x y\ny < 3\n-2 x + 2 y <= 1\n");
    expect_form("vars: x y z\nx < z\n", 2, "vars: x y\n");
    expect_form("vars: x y z\nx < z\nz <= x\n", 2, "vars: x y\n0 <= -1\n");
}
