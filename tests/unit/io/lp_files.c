/* lp_files.c: CPLEX LP files: their exact meaning as .fmb text; refused files. */
#include <criterion/criterion.h>
#include <string.h>

#include "parse.h"

#define HEAD "min\n x\nst\n c: x + y >= 1\n"

/* Keywords inside lines. A word that is one, and a variable, is a variable. */
Test(lp_files, one_line)
{
    static const meaning table[] = {
        {"Minimize obj: x + 2 y Subject To c1: x + y >= 1 c2: x - y <= 3 Bounds x <= 4 y <= 5 "
         "General x "
         "Binary y End",
         "vars: x y\ninteger: x y\nmin: x + 2 y\nc1: -x - y <= -1\nc2: x - y <= 3\n-x <= 0\nx <= "
         "4\n-y <= "
         "0\ny <= 5\n"},
        {"max x st x <= 1 \\ a comment st x <= 0\nbounds x free end", "vars: x\nmax: x\nx <= 1\n"},
        {"min w + st + 2 end\nst\n r: st + end >= 1\n s: end + 2 st <= 3\n t: 3 end <= "
         "9\ngeneral\n w st "
         "end\nend\n",
         "vars: w st end\ninteger: w st end\nmin: w + st + 2 end\nr: -st - end <= -1\ns: 2 st + "
         "end <= "
         "3\nt: 3 end <= 9\n-w <= 0\n-st <= 0\n-end <= 0\n"},
    };
    check_meanings(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

Test(lp_files, meanings)
{
    static const meaning table[] = {
        {"\\* comment *\\\nMinimize\n obj: x + 2 y\nSubject To\n c1: x + y >= 1\n"
         " 3 x - 0.1 y\n + 1e-2 z <= 2.50 \\ comment 7\n e: x = .5\nend\n",
         "vars: x y z\nmin: x + 2 y\nc1: -x - y <= -1\n3 x - 1/10 y + 1/100 z <= 5/2\ne: x = "
         "1/2\n-x <= 0\n"
         "-y <= 0\n-z <= 0\n"},
        {HEAD "Bounds\n x <= 4\n -1 <= y <= 1\n z free\n -inf <= w <= 3\n v >= -infinity\n u = 2\n"
              " t >= 1 p <= +inf\n 0.5 <= q\n s = - .25\nGenerals\n x\nBinaries\n b\nEnd\n",
         "vars: x y z w v u t p q s b\ninteger: x b\nmin: x\nc: -x - y <= -1\n-x <= 0\nx <= 4\n-y "
         "<= 1\ny "
         "<= 1\nw <= 3\n"
         "u = 2\n-t <= -1\n-p <= 0\n-q <= -1/2\ns = -1/4\n-b <= 0\nb <= 1\n"},
        {HEAD "Bounds\n x <= 5\nBinary\n x y\nEnd\n",
         "vars: x y\ninteger: x y\nmin: x\nc: -x - y <= -1\n-x <= 0\nx <= 5\n-y <= 0\ny <= 1\n"},
        {"max\n 0 x\nsuch that\n x + y <= +1\n - x > - 2\n x =< 3\nend",
         "vars: x y\nmax: 0\nx + y <= 1\nx <= 2\nx <= 3\n-x <= 0\n-y <= 0\n"},
        {HEAD "bounds\n z <= +inf\n y <= 1e30\n x >= -1e31\nend",
         "vars: x y z\nmin: x\nc: -x - y <= -1\n-y <= 0\n-z <= 0\n"},
    };
    check_meanings(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

/* Words that begin like a keyword are names. */
Test(lp_files, names_like_keywords)
{
    static const meaning table[] = {
        {"min\n e\nst\ne: e + g >= 1\nb: e - g\n<= 0\nbo >= 2\nend",
         "vars: e g bo\nmin: e\ne: -e - g <= -1\nb: e - g <= 0\n-bo <= -2\n-e <= 0\n-g <= 0\n"
         "-bo <= 0\n"},
    };
    check_meanings(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

/* Ranges, constants, both sides, line breaks anywhere, any case, names of other programs. */
Test(lp_files, beyond_glpk)
{
    static const meaning table[] = {
        {"maximum obj: x + 2 y + 3\nSUBJECT TO r: -5 <= x + y <= 8\n s: 8 >= x\n - y >= 2.5\n"
         " t: 3 >= 2 x\nEnd\n",
         "vars: x y\nmax: x + 2 y + 3\nr: -x - y <= 5\nr: x + y <= 8\ns: -x + y <= -5/2\ns: x - y "
         "<= 8\n"
         "t: 2 x <= 3\n-x <= 0\n-y <= 0\n"},
        {"min\nst\n x + 2 - y >= 3\n x >= 2 y + 1 - x\n x + x <= 1\n"
         " -inf <= x - 3 <= 1e31\n x[1,2] = .5\n \xC3\xA9 + 2a <= - -1\n 4 = x\n c:\n x\n <=\n 7\n"
         "end",
         "vars: x y \"x[1,2]\" \xC3\xA9 a\nmin: 0\n-x + y <= -1\n-2 x + 2 y <= -1\n2 x <= 1\n"
         "\"x[1,2]\" = 1/2\n\xC3\xA9 + 2 a <= 1\nx = 4\nc: x <= 7\n-x <= 0\n-y <= 0\n"
         "-\"x[1,2]\" <= 0\n-\xC3\xA9 <= 0\n-a <= 0\n"},
        {HEAD
         "  bOuNd\n 1 >= x >= -Infinity\n +inf >= y\n z > 2 w < 3\n x <= 5\n x <= 4\n gen\n x\n"
         " bounds\n y >= 1\n bin\n b\n end\n",
         "vars: x y z w b\ninteger: x b\nmin: x\nc: -x - y <= -1\nx <= 4\n-y <= -1\n-z <= -2\n-w "
         "<= 0\nw "
         "<= 3\n-b <= 0\n"
         "b <= 1\n"},
    };
    check_meanings(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

/* A keyword with a label's colon, a relation or, but for `st`, a sign behind it is a variable. */
Test(lp_files, names_that_are_keywords)
{
    static const meaning table[] = {
        {"min\nst\nst: 2 x +\nbin + 3 end\n>= 1\nend >= 2\nbounds <= 4\nend\n",
         "vars: x bin end bounds\nmin: 0\nst: -2 x - bin - 3 end <= -1\n-end <= -2\nbounds <= "
         "4\n-x <= 0\n"
         "-bin <= 0\n-end <= 0\n-bounds <= 0\n"},
    };
    check_meanings(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

Test(lp_files, mistakes)
{
    static const mistake table[] = {
        {HEAD "bounds\n x >= -y\nend", 6, 8, "a number or infinity, found 'y'"},
        {HEAD "bounds\n x", 6, 3, "an operator, or one of <=, = and >=, found end of file"},
        {HEAD "bounds\n -2 <= x <=\nend", 7, 1, "a number or infinity, found 'end'"},
        {HEAD " c: x >= 1\nend", 5, 2, "a new name of a row, found 'c:'"},
        {HEAD " d: x >= 1e\nend", 5, 12, "the digits of an exponent"},
        {HEAD " d: x + y <= 1/2\nend", 5, 15, "LP has no fractions"},
        {HEAD " d: 1/2 x <= 1\nend", 5, 6, "LP has no fractions"},
        {HEAD " d: x^2 >= 1\nend", 5, 6, "found '^2'"},
        {HEAD " d: x + [ x ^ 2 ] >= 1\nend", 5, 9, "a number or a variable, found '['"},
        {"max\n obj: inf\nst\n x >= 1\nend", 2, 2, "a finite objective"},
        {HEAD "end\nmore", 6, 1, "nothing behind 'end'"},
        {"x >= 1\n", 1, 1, "'minimize' or 'maximize'"},
        {"", 1, 1, "'minimize' or 'maximize'"},
    };
    check_mistakes(FMB_FORMAT_LP, table, sizeof table / sizeof *table);
}

/* A file that may have been cut short. */
Test(lp_files, no_end)
{
    static const char text[] = "min\n 0 x\nst\n c: x >= 1";
    warnings h = parse_warnings(FMB_FORMAT_LP, text);
    cr_expect(h.n == 1 && h.at[0].line == 4 && strstr(h.at[0].text, "'end' is missing"), "%s",
              h.at[0].text);
}

Test(lp_files, failing_allocations)
{
    static const char *const good = HEAD " d: 0.5 x - 7 y <= 2\nbounds\n x <= 3\n y free\nend\n";
    static const char *const bad = HEAD "bounds\n x free\n x >= -y\nend\n";
    check_every_failure(FMB_FORMAT_LP, good, strlen(good), FMB_OK);
    check_every_failure(FMB_FORMAT_LP, bad, strlen(bad), FMB_ERR_PARSE);
}
