/* glpk_lp.c: CPLEX LP files: what they say as .fmb text, exactly; what is refused. */
#include <criterion/criterion.h>
#include <string.h>

#include "parse.h"

#define HEAD "min\n x\nst\n c: x + y >= 1\n"

Test(glpk_lp, meanings)
{
    static const meaning table[] = {
        {"\\* comment *\\\nMinimize\n obj: x + 2 y\nSubject To\n c1: x + y >= 1\n"
         " 3 x - 0.1 y\n + 1e-2 z <= 2.50 \\ comment 7\n e: x = .5\nend\n",
         "vars: x y z\nc1: -x - y <= -1\nr.6: 3 x - 1/10 y + 1/100 z <= 5/2\ne: x = 1/2\n-x <= 0\n"
         "-y <= 0\n-z <= 0\n"},
        {HEAD "Bounds\n x <= 4\n -1 <= y <= 1\n z free\n -inf <= w <= 3\n v >= -infinity\n u = 2\n"
              " t >= 1 p <= +inf\n 0.5 <= q\n s = - .25\nGenerals\n x\nBinaries\n b\nEnd\n",
         "vars: x y z w v u t p q s b\nc: -x - y <= -1\n-x <= 0\nx <= 4\n-y <= 1\ny <= 1\nw <= 3\n"
         "u = 2\n-t <= -1\n-p <= 0\n-q <= -1/2\ns = -1/4\n-b <= 0\nb <= 1\n"},
        {HEAD "Bounds\n x <= 5\nBinary\n x y\nEnd\n",
         "vars: x y\nc: -x - y <= -1\n-x <= 0\nx <= 5\n-y <= 0\ny <= 1\n"},
        {"max\n 0 x\nsuch that\n x + y <= +1\n - x > - 2\n x =< 3\nend",
         "vars: x y\nr.4: x + y <= 1\nr.5: x <= 2\nr.6: x <= 3\n-x <= 0\n-y <= 0\n"},
        {HEAD "bounds\n z <= +inf\n y <= 1e30\n x >= -1e31\nend",
         "vars: x y z\nc: -x - y <= -1\n-y <= 0\n-z <= 0\n"},
    };
    check_meanings(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

/* Words that begin like a keyword are names. */
Test(glpk_lp, names_like_keywords)
{
    static const meaning table[] = {
        {"min\n e\nst\ne: e + g >= 1\nb: e - g\n<= 0\nbo >= 2\nend",
         "vars: e g bo\ne: -e - g <= -1\nb: e - g <= 0\nr.7: -bo <= -2\n-e <= 0\n-g <= 0\n"
         "-bo <= 0\n"},
    };
    check_meanings(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

Test(glpk_lp, mistakes)
{
    static const mistake table[] = {
        {HEAD "bounds\n x >= -y\nend", 6, 8, "expected a bound"},
        {HEAD "bounds\n x", 6, 3, "the rest of a bound"},
        {HEAD "bounds\n x f\nend", 6, 4, "expected a bound"},
        {HEAD "bounds\n x <= +i\nend", 6, 8, "expected a bound"},
        {HEAD "bounds\n -2 <= x <=\nend", 7, 1, "the rest of a bound"},
        {HEAD "d: x + x >= 1\nend", 5, 4, "multiple use of variable 'x'"},
        {HEAD " c: x >= 1\nend", 5, 2, "constraint 'c' multiply defined"},
        {HEAD " d: x >= z\nend", 5, 1, "missing right-hand side"},
        {HEAD " d: x >= 1e400\nend", 5, 10, "out of range"},
        {HEAD " d: x >= 1e-400\nend", 5, 10, "at least 1e-307"},
        {HEAD " d: x >= 1e\nend", 5, 10, "incomplete"},
        {HEAD " d: x^2 >= 1\nend", 5, 6, "'^' not recognized"},
        {HEAD " d: 1.00000000000000000001 x + y >= 1\nend", 5, 5, "not tell this one from 1"},
        {HEAD "end\nmore", 6, 1, "beyond 'end'"},
        {"x >= 1\n", 1, 1, "'minimize' or 'maximize'"},
        {"", 1, 1, "'minimize' or 'maximize'"},
    };
    check_mistakes(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

static void hear(void *self, const fmb_where *w)
{
    *(fmb_where *)self = *w;
}

/* A file that may have been cut short. */
Test(glpk_lp, no_end)
{
    static const char text[] = "min\n 0 x\nst\n c: x >= 1";
    fmb_where w = {0};
    fmb_system *s = NULL;
    fmb_reader how = {.format = FMB_FORMAT_LP, .warn = hear, .self = &w};
    cr_assert(fmb_system_parse(text, sizeof text - 1, &how, &s, NULL) == FMB_OK);
    cr_expect(w.line == 4 && strstr(w.text, "'end' missing"), "%ld: %s", w.line, w.text);
    fmb_system_free(s);
}

Test(glpk_lp, failing_allocations)
{
    static const char *const good = HEAD " d: 0.5 x - 7 y <= 2\nbounds\n x <= 3\n y free\nend\n";
    static const char *const bad = HEAD "bounds\n x free\n x >= -y\nend\n";
    check_every_failure(FMB_FORMAT_LP, good, strlen(good), FMB_OK);
    check_every_failure(FMB_FORMAT_LP, bad, strlen(bad), FMB_ERR_PARSE);
}
