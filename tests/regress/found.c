/* found.c: systems on which a random test once failed, shrunken; every way to solve, every question
 * and every set of variables kept.
 */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/io.h>

#include "property/random/agree.h"
#include "property/random/options.h"

static const struct {
    const char *what, *text;
} FOUND[] = {
    {"reduce: an equality in disguise leans on another one",
     "x1 <= 0\nx1 - x2 <= 0\nx2 <= 0\n-x1 <= 0\n"},
    {"reduce: the same, the first row goes", "-x1 - x2 <= 0\n-x1 <= 0\n-x2 <= 0\nx1 + x2 <= 0\n"},
    {"project: the proof of an equality uses another one backwards",
     "-x2 <= 0\n-x1 - x2 <= 0\nx2 <= 0\nx1 <= 0\n"},
    {"project: the same beside an equality",
     "-x2 + x3 <= 0\n-x2 <= 0\nx3 <= 0\n-x1 - x2 + x3 = 0\n-x1 <= 0\n"},
    {"project: the same, with products beyond 2^62",
     "x1 <= 0\nx1 + 2147483646x2 <= -4611686009837453316\n-x1 <= 0\n-1/5x2 <= 2147483646/5\n"},
    {"project: the same, one variable bounded twice",
     "-x2 <= -1\n-x1 <= 0\nx2 <= 1\nx1 - x2 <= -1\n"},
    {"reduce: the step to a violation ends beyond a strict row",
     "-x1 - x2 < -1\nx2 <= 1\nx2 < 1\nx1 < 1\n"},
    {"reduce: the same, another row tested", "-x2 < 0\n-x1 + x2 <= 1\n-x1 + x2 < 1\nx1 < 0\n"},
    {"reduce: the same, among rows that are not strict",
     "x3 + x4 <= 0\n-x1 - x2 - 3x5 < 0\nx1 - x2 - x3 <= 0\n-3x2 - 3x4 + 3x5 <= 9\nx3 <= 0\n"
     "x4 <= -2\n-x1 - 5x2 + 2x4 <= -1\n"},
};

static void expect_agreement(agree *g, fmb_solver *v, const truth *t, const char *what)
{
    int dim = fmb_system_dim(t->s), keep[8];
    bool good = agree_solve(g, v, t) && agree_bound(g, v, t) && agree_reduce(g, v, t, NULL);
    for (unsigned set = 0; good && set < 1u << dim; set++) {
        int n = 0;
        for (int j = 0; j < dim; j++)
            if (set >> j & 1)
                keep[n++] = j;
        good = agree_project(g, v, t, keep, n, NULL);
    }
    cr_assert(good, "%s: %s", what, g->why);
}

Test(regress, found)
{
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_TEXT};
    agree g = {.max_rows = 5000};
    for (size_t k = 0; k < sizeof FOUND / sizeof *FOUND; k++) {
        fmb_system *s = NULL;
        truth t;
        must(fmb_system_parse(FOUND[k].text, strlen(FOUND[k].text), &how, &s, NULL));
        truth_init(&t, s, g.max_rows);
        for (int i = 0; i < options_count(); i++) {
            fmb_options o = options_at(i);
            fmb_solver *v = NULL;
            must(fmb_solver_new(&o, NULL, &v));
            expect_agreement(&g, v, &t, FOUND[k].what);
            fmb_solver_free(v);
        }
        truth_clear(&t);
        fmb_system_free(s);
    }
    cr_assert(g.unjudged == 0 && g.undecided == 0);
}
