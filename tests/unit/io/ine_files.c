/* ine_files.c: cddlib and lrslib files. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

#define COUNT(t) (sizeof(t) / sizeof *(t))

Test(ine, matrices)
{
    static const meaning table[] = {
        {"begin\n2 3 integer\n1 2 3\n-1 0 -4\nend\n",
         "vars: x1 x2\n-2 x1 - 3 x2 <= 1\n4 x2 <= -1\n"},
        {"a title\n* comment\nH-representation\nbegin 1 2 rational 1/2 -.5e1 end",
         "vars: x1\n5 x1 <= 1/2\n"},
        {"begin\n2 2 real\n1.5 1\n* in between\n1\n+1\nend", "vars: x1\n-x1 <= 3/2\n-x1 <= 1\n"},
        {"begin\n**** 2 rational\n1 1\n2 1\nend", "vars: x1\n-x1 <= 1\n-x1 <= 2\n"},
        {"begin\n0 3 rational\nend", "vars: x1 x2\n"},
        {"begin\n2 1 integer\n3 -1\nend", "0 <= 3\n0 <= -1\n"},
        {"begin\r\n1 2 integer\r\n1 1\r\nend\r\n", "vars: x1\n-x1 <= 1\n"},
        {"begin\n1 2 integer\n1 1\n2 2\nend\n", "vars: x1\n-x1 <= 1\n"},
    };
    check_meanings(FMB_FORMAT_INE, table, COUNT(table));
}

#define ROWS "begin\n3 3 integer\n1 1 0\n1 0 1\n2 -1 -1\nend\n"
#define VARS "vars: x1 x2\n"

Test(ine, options)
{
    static const meaning table[] = {
        {"linearity 1 2\n" ROWS, VARS "-x1 <= 1\n-x2 = 1\nx1 + x2 <= 2\n"},
        {"linearity 2 1\n3\n" ROWS, VARS "-x1 = 1\n-x2 <= 1\nx1 + x2 = 2\n"},
        {"equality 1 3\n" ROWS, VARS "-x1 <= 1\n-x2 <= 1\nx1 + x2 = 2\n"},
        {ROWS "strict_inequality 2 1 3\n", VARS "-x1 < 1\n-x2 <= 1\nx1 + x2 < 2\n"},
        {ROWS "project 1 2\n", VARS "project: x2\n-x1 <= 1\n-x2 <= 1\nx1 + x2 <= 2\n"},
        {ROWS "eliminate 1 2\n", VARS "project: x1\n-x1 <= 1\n-x2 <= 1\nx1 + x2 <= 2\n"},
        {ROWS "project 0\n", VARS "project:\n-x1 <= 1\n-x2 <= 1\nx1 + x2 <= 2\n"},
        {ROWS "maximize\n 0 1 -1/2\n", VARS "max: x1 - 1/2 x2\n-x1 <= 1\n-x2 <= 1\nx1 + x2 <= 2\n"},
        {"minimize 3\n -1\n0\nlinearity 1 1\n" ROWS,
         VARS "min: -x1 + 3\n-x1 = 1\n-x2 <= 1\nx1 + x2 <= 2\n"},
        {ROWS "redund 0 0\nverbose\ndebug\nhull\ntestlin\nredund_list 2 1\n3\n*end\n",
         VARS "-x1 <= 1\n-x2 <= 1\nx1 + x2 <= 2\n"},
    };
    check_meanings(FMB_FORMAT_INE, table, COUNT(table));
}

/* Comments in front name variables and rows, if they have the quotes. */
Test(ine, names)
{
    static const meaning table[] = {
        {"* x1 is \"milk\"\n* row 3 is \"a cap\"\n" ROWS,
         "vars: milk x2\n-milk <= 1\n-x2 <= 1\na cap: milk + x2 <= 2\n"},
        {"*x2 is \"x1\"\r\n *  x1  is  \"x2\" \r\n" ROWS,
         "vars: x2 x1\n-x2 <= 1\n-x1 <= 1\nx2 + x1 <= 2\n"},
        {"* x1 is \"x2\"\n" ROWS, "vars: x2 x2_\n-x2 <= 1\n-x2_ <= 1\nx2 + x2_ <= 2\n"},
        {"* x1 is \"\\x1b\\\\\"\nproject 1 1\n" ROWS,
         "vars: \"\\x1b\\\\\" x2\nproject: \"\\x1b\\\\\"\n-\"\\x1b\\\\\" <= 1\n-x2 <= 1\n"
         "\"\\x1b\\\\\" + x2 <= 2\n"},
        {"* x1 is width\n* x is \"y\"\n* rows 1 is \"y\"\n* x2 \"z\"\n" ROWS "* x2 is \"late\"\n",
         VARS "-x1 <= 1\n-x2 <= 1\nx1 + x2 <= 2\n"},
    };
    check_meanings(FMB_FORMAT_INE, table, COUNT(table));
    static const char text[] =
        "* x1 is \"x2\"\n* row 3 is \"a cap\"\nproject 1 1\n" ROWS "maximize\n 1 1/3 -2\n";
    check_every_failure(FMB_FORMAT_INE, text, sizeof text - 1, FMB_OK);
}

static void count(void *self, const fmb_where *where)
{
    long *lines = self;
    lines[0]++;
    lines[lines[0] < 4 ? lines[0] : 3] = where->line;
}

/* What is ignored is told, once each and with its line. */
Test(ine, warnings)
{
    static const char text[] = "nonnegative\n" ROWS "maximize\n 0 1 1\npermutation group\n 2 3,4\n"
                               "verbose\n";
    long lines[4] = {0};
    fmb_system *s;
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_INE, .warn = count, .self = lines};
    cr_assert(fmb_system_parse(text, sizeof text - 1, &how, &s, NULL) == FMB_OK);
    cr_expect(lines[0] == 2 && lines[1] == 1 && lines[2] == 10, "%ld: %ld %ld", lines[0], lines[1],
              lines[2]);
    cr_expect(fmb_system_rows(s) == 3);
    cr_expect(fmb_system_sense(s) == FMB_SENSE_MAX);
    fmb_system_free(s);
}

/* A name that cannot be given is none, and no error. */
Test(ine, names_that_do_not_fit)
{
    static const char *const texts[] = {
        "* x3 is \"milk\"\n" ROWS,    "* x0 is \"milk\"\n" ROWS,
        "* row 4 is \"milk\"\n" ROWS, "* x1 is \"milk\" and more\n" ROWS,
        "* x1 is \"milk\n" ROWS,      "* x1 is \"\\x00\"\n" ROWS,
        "* x1 is \"\"\n" ROWS,        "* x2 is \"x1\"\n" ROWS,
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        long lines[4] = {0};
        fmb_system *s;
        fmb_reader how = {
            .size = sizeof how, .format = FMB_FORMAT_INE, .warn = count, .self = lines};
        cr_assert(fmb_system_parse(texts[i], strlen(texts[i]), &how, &s, NULL) == FMB_OK);
        cr_expect(lines[0] == 1 && lines[1] == 1, "%s", texts[i]);
        char *says = write_text(s, FMB_FORMAT_TEXT);
        cr_expect(strcmp(says, VARS "-x1 <= 1\n-x2 <= 1\nx1 + x2 <= 2\n") == 0, "%s", says);
        free(says);
        fmb_system_free(s);
    }
}

Test(ine, mistakes)
{
    static const mistake table[] = {
        {"title\n", 2, 1, "a line 'begin'"},
        {"V-representation\n" ROWS, 1, 1, "V-representation"},
        {"begin\nx 3 integer\n", 2, 1, "a number of rows"},
        {"begin\n3 0 integer\n", 2, 3, "at least one column"},
        {"begin\n3 3 complex\n", 2, 5, "'integer', 'rational' or 'real'"},
        {"begin\n2 3 integer\n1 2 3\n1 2\nend\n", 5, 1, "number 3 of the 3 of row 2, found 'end'"},
        {"begin\n1 3 integer\n1 2 3\n4\nend\n", 4, 1, "'end' after 1 rows"},
        {"begin\n1 3 integer\n1 2 3", 3, 6, "'end' after 1 rows, found end of file"},
        {"begin\n1 3 integer\n1 2x 3\nend", 3, 3, "a number, found '2x'"},
        {"begin\n1 3 integer\n1 1/0 3\nend", 3, 5, "a denominator"},
        {"linearity 1 4\n" ROWS, 1, 13, "between 1 and 3"},
        {"linearity 1 0\n" ROWS, 1, 13, "between 1 and 3"},
        {"linearity 2 1\n" ROWS, 2, 1, "a row number, found 'begin'"},
        {"linearity 1 1 2\n" ROWS, 1, 15, "end of line after a list of 1"},
        {"linearity 1 1\n" ROWS "strict_inequality 1 1\n", 8, 21, "not both"},
        {ROWS "project 1 3\n", 7, 11, "between 1 and 2"},
        {ROWS "project 1 1\neliminate 1 2\n", 8, 1, "found another"},
        {ROWS "maximize\n 0 1\n", 9, 1, "number 3 of the 3 of the objective, found end of file"},
        {ROWS "maximize 0 1\nverbose\n", 8, 1,
         "number 3 of the 3 of the objective, found 'verbose'"},
        {ROWS "minimize 0 1 x\n", 7, 14, "number 3 of the 3 of the objective, found 'x'"},
        {ROWS "minimize 0 1 2x\n", 7, 14, "a number, found '2x'"},
        {ROWS "minimize 0 1 1\n1\n", 8, 1, "an objective of 3 numbers, found '1'"},
        {"maximize 1 1 1\n" ROWS "minimize 0 1 1\n", 8, 1, "one objective, found another"},
        {ROWS ROWS, 7, 1, "a second 'begin'"},
        {"begin\n0 99999999 integer\nend", 2, 1, "fewer variables"},
    };
    check_mistakes(FMB_FORMAT_INE, table, COUNT(table));
}
