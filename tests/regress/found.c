/* found.c: systems on which a random test once failed, shrunken; every way to solve, every question
 * and every set of variables kept.
 */
#include <criterion/criterion.h>
#include <stdio.h>
#include <stdlib.h>
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

/* Elimination of long numbers, once redundant rows were guessed in doubles: an edge along which a
 * right side fell gave the tested row itself a multiplier, and the row went, proved by itself. */
static const char PROVED_BY_ITSELF[] =
    "vars: x1 x2 x3 x4 x5 x6 x7 x8 x9\n"
    "-655281056/655281055 x1+1310562112/655281055 x5-655281056/655281055 x6+655281056/655281055 x"
    "7+1965843168/655281055 x8+655281056/655281055 x9=0\n"
    "-183762750/183762749 x2-367525500/183762749 x5-183762750/183762749 x6+918813750/183762749 x7"
    "-551288250/183762749 x8+367525500/183762749 x9=0\n"
    "-294205568/294205571 x5<=0\n"
    "-3231487340/461641049 x4+362973015/362973008 x5<=0\n"
    "-2832525814/404646545 x3+270185752/270185749 x5<=0\n"
    "2992031527/427433074 x3+520606325/74372332 x4-x5<=23382890947/477201856\n"
    "-588526573/588526574 x6<=0\n"
    "-1791662527/255951790 x4+x6<=0\n"
    "-7 x3+169226374/169226373 x6<=0\n"
    "4884363117/697766159 x3+2209996595/315713798 x4-79299392/79299393 x6<=24754838174/505200779"
    "\n"
    "-283030928/283030931 x7<=0\n"
    "-3944747128/563535305 x4+311513047/311513038 x7<=0\n"
    "-792591022/113227289 x3+339533903/339533901 x7<=0\n"
    "2058999556/294142793 x3+7 x4-439081186/439081187 x7<=32475765134/662770717\n"
    "-239863901/239863903 x8<=0\n"
    "-7 x4+85039787/85039786 x8<=0\n"
    "-2570137073/367162440 x3+431029807/431029800 x8<=0\n"
    "7 x3+1062209751/151744250 x4-x8<=46170511471/942255336\n"
    "-75042717/75042718 x9<=0\n"
    "-2104784147/300683450 x4+927360203/927360197 x9<=0\n"
    "-6271612573/895944654 x3+471272520/471272519 x9<=0\n"
    "7 x3+4760244035/680034861 x4-725993512/725993519 x9<=45412880133/926793472\n"
    "-537852232/537852233 x3<=0\n"
    "508751050/508751041 x3<=6983676679/997668096\n"
    "-417384357/417384358 x4<=0\n"
    "425039872/425039867 x4<=3539793936/505684847\n";

static char *project_by(const fmb_system *s, fmb_method method)
{
    fmb_options o = {.size = sizeof o, .method = method};
    fmb_result r = {.size = sizeof r};
    fmb_solver *v = NULL;
    fmb_system *out = NULL;
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    must(fmb_solver_new(&o, NULL, &v));
    must(fmb_project(v, s, (const int[]){0, 1, 2, 3}, 4, &out, &r));
    must(fmb_system_write(out, FMB_FORMAT_TEXT, file));
    fclose(file);
    fmb_system_free(out);
    fmb_solver_free(v);
    return text;
}

Test(regress, proved_by_itself)
{
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_TEXT};
    fmb_system *s = NULL;
    must(fmb_system_parse(PROVED_BY_ITSELF, strlen(PROVED_BY_ITSELF), &how, &s, NULL));
    char *fm = project_by(s, FMB_METHOD_FM), *dd = project_by(s, FMB_METHOD_DD);
    cr_assert_str_eq(fm, dd);
    free(fm);
    free(dd);
    fmb_system_free(s);
}
