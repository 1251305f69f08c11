/* text_rows.c: what the rows and lines of the .fmb format mean. */
#include <criterion/criterion.h>
#include <string.h>

#include "parse.h"

#define COUNT(t) (sizeof(t) / sizeof *(t))

Test(text, rows)
{
    static const meaning table[] = {
        {"", ""},
        {"# nothing\n\n   \t\n", ""},
        {"3x + 1/2 y <= 4", "vars: x y\n3 x + 1/2 y <= 4\n"},
        {"x - 3y = z + 1", "vars: x y z\nx - 3 y - z = 1\n"},
        {"-x - y <= 1", "vars: x y\n-x - y <= 1\n"},
        {"x >= 2", "vars: x\n-x <= -2\n"},
        {"x > 2 # comment: <= 7", "vars: x\n-x < -2\n"},
        {"x =< 2\nx => 1\nx == 0", "vars: x\nx <= 2\n-x <= -1\nx = 0\n"},
        {"x \xE2\x89\xA4 2\nx \xE2\x89\xA5 1\n\xE2\x88\x92x<3",
         "vars: x\nx <= 2\n-x <= -1\n-x < 3\n"},
        {"x + x - y + y <= 1", "vars: x y\n2 x <= 1\n"},
        {"0 <= 1\n0 <= -1\n1 < 1", "0 <= 1\n0 <= -1\n0 < 0\n"},
        {"x <= 1\r\ny <= 2\r\n", "vars: x y\nx <= 1\ny <= 2\n"},
        {"x<=1", "vars: x\nx <= 1\n"},
    };
    check_meanings(FMB_FORMAT_TEXT, table, COUNT(table));
}

Test(text, numbers)
{
    static const meaning table[] = {
        {"2.5e-3x <= .5", "vars: x\n1/400 x <= 1/2\n"},
        {"0.1 x <= 1.", "vars: x\n1/10 x <= 1\n"},
        {"2e + 2 e3 <= 2e3", "vars: e e3\n2 e + 2 e3 <= 2000\n"},
        {"2e3x <= 1E+2", "vars: x\n2000 x <= 100\n"},
        {"6/4 x <= 1.5/.3", "vars: x\n3/2 x <= 5\n"},
        {"x <= 123456789012345678901234567890", "vars: x\nx <= 123456789012345678901234567890\n"},
        {"x <= 0e999999999", "vars: x\nx <= 0\n"},
        {"x <= 1000e-3\nx <= 1250e-2\nx<= 0.0", "vars: x\nx <= 1\nx <= 25/2\nx <= 0\n"},
        {"x <= 0.00390625", "vars: x\nx <= 1/256\n"},
        {"x <= 390625e-10", "vars: x\nx <= 1/25600\n"},
    };
    check_meanings(FMB_FORMAT_TEXT, table, COUNT(table));
}

Test(text, expressions)
{
    static const meaning table[] = {
        {"2(x - y) <= 3", "vars: x y\n2 x - 2 y <= 3\n"},
        {"2 * (x - (y - 1)) * 3 <= 3", "vars: x y\n6 x - 6 y <= -3\n"},
        {"(x + 1)/2 <= -(y - 1)", "vars: x y\n1/2 x + y <= 1/2\n"},
        {"x - -y + - + -z < 2*-3", "vars: x y z\nx + y + z < -6\n"},
        {"1 / 2 x <= 3(2)", "vars: x\n1/2 x <= 6\n"},
        {"3*x <= 3 x\nx*3/4*2<=1", "vars: x\n0 <= 0\n3/2 x <= 1\n"},
        {"0(x) <= y", "vars: x y\n-y <= 0\n"},
        {"((((x)))) <= (((1)))", "vars: x\nx <= 1\n"},
    };
    check_meanings(FMB_FORMAT_TEXT, table, COUNT(table));
}

/* 200 parentheses are read, 201 are not. */
Test(text, depth)
{
    for (size_t depth = 200; depth <= 201; depth++) {
        char text[512] = {0};
        memset(text, '(', depth);
        text[depth] = 'x';
        memset(text + depth + 1, ')', depth);
        strcat(text, "<1");
        fmb_system *s = NULL;
        fmb_status st = fmb_system_parse(text, strlen(text), NULL, &s, NULL);
        cr_expect(st == (depth == 200 ? FMB_OK : FMB_ERR_PARSE));
        fmb_system_free(s);
    }
}

Test(text, chains_and_labels)
{
    static const meaning table[] = {
        {"0 <= z < 2.5", "vars: z\n-z <= 0\nz < 5/2\n"},
        {"cap: 0 <= z < 2.5", "vars: z\ncap: -z <= 0\ncap: z < 5/2\n"},
        {"x = y = z > 1", "vars: x y z\nx - y = 0\ny - z = 0\n-z < -1\n"},
        {"a label 1 : x <= 1", "vars: x\na label 1: x <= 1\n"},
        {"\"a:b#\\\"\\\\\": x <= 1", "vars: x\n\"a:b#\\\"\\\\\": x <= 1\n"},
        {"\"vars\": x <= 1", "vars: x\n\"vars\": x <= 1\n"},
    };
    check_meanings(FMB_FORMAT_TEXT, table, COUNT(table));
}

Test(text, names)
{
    static const meaning table[] = {
        {"x_1 + y.a[2]' + _z <= 1", "vars: x_1 y.a[2]' _z\nx_1 + y.a[2]' + _z <= 1\n"},
        {"\xCE\xB1 + \xC3\xA9t\xC3\xA9 <= 1",
         "vars: \xCE\xB1 \xC3\xA9t\xC3\xA9\n\xCE\xB1 + \xC3\xA9t\xC3\xA9 <= 1\n"},
        {"2\"x(1)\" + \"a b\" <= 1", "vars: \"x(1)\" \"a b\"\n2 \"x(1)\" + \"a b\" <= 1\n"},
        {"\"x\" + x <= 1", "vars: x\n2 x <= 1\n"},
        {"\"a\\x01\\xff\" <= 1", "vars: \"a\\x01\\xff\"\n\"a\\x01\\xff\" <= 1\n"},
    };
    check_meanings(FMB_FORMAT_TEXT, table, COUNT(table));
}

Test(text, lines)
{
    static const meaning table[] = {
        {"vars: z, y x\nx <= 1", "vars: z y x\nx <= 1\n"},
        {"vars: x\nvars : y # more\n", "vars: x y\n"},
        {"vars: x y z\nproject: z x\nx <= y", "vars: x y z\nproject: x z\nx - y <= 0\n"},
        {"x <= y\neliminate: y z", "vars: x y z\nproject: x\nx - y <= 0\n"},
        {"vars: x\nproject:\n", "vars: x\nproject:\n"},
    };
    check_meanings(FMB_FORMAT_TEXT, table, COUNT(table));
}

Test(text, mistakes)
{
    static const mistake table[] = {
        {"x", 1, 2, "one of <= < = > >=, found end of file"},
        {"x <=", 1, 5, "a number, a name or '(', found end of file"},
        {"x <= 1 2", 1, 8, "found '2'"},
        {"x(1) <= 2", 1, 2, "found '(1)'"},
        {"x y <= 2", 1, 3, "found 'y'"},
        {"x*y <= 2", 1, 3, "a constant factor"},
        {"1/x <= 2", 1, 3, "a constant divisor"},
        {"x/(y) <= 2", 1, 3, "a constant divisor"},
        {"x/(1-1) <= 2", 1, 3, "a divisor other than zero"},
        {"x <= 1\n y != 2", 2, 4, "not equal"},
        {"x <> 2", 1, 3, "not equal"},
        {"x \xE2\x89\xA0 2", 1, 3, "not equal"},
        {"vars: x\n x + yy <= 2", 2, 6, "a variable of the vars line, found 'yy'"},
        {"vars: x y x", 1, 11, "a new name"},
        {"x <= 1\nvars: x", 2, 1, "before"},
        {"0 <= 1\nvars: x", 2, 1, "before the first row"},
        {": x <= 1", 1, 1, "a label"},
        {"\"a\" b: x <= 1", 1, 5, "':' after a label"},
        {"\"a <= 1", 1, 1, "a closing quote"},
        {"\"\" <= 1", 1, 1, "a name between"},
        {"\"a\\n\" <= 1", 1, 3, "hexadecimal"},
        {"vars: 1x", 1, 7, "the name of a variable"},
        {"project: x\neliminate: y", 2, 1, "found both"},
        {"(x <= 1", 1, 4, "')'"},
        {"x) <= 1", 1, 2, "found ')'"},
        {"c: d: x <= 1", 1, 5, "found ':'"},
        {"x^2 <= 1", 1, 2, "found '^2'"},
        {"x <= 1e100001", 1, 7, "an exponent between"},
        {"x <= 1/0", 1, 8, "a denominator other than zero"},
    };
    check_mistakes(FMB_FORMAT_TEXT, table, COUNT(table));
}
