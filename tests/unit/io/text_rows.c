/* text_rows.c: the meaning of the rows and lines of the .fmb format. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "io/core/cursor.h"
#include "parse.h"

#define COUNT(t) (sizeof(t) / sizeof *(t))

Test(text, rows)
{
    static const meaning table[] = {
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
        {"2*e + 2 e3 <= 2e3", "vars: e e3\n2 e + 2 e3 <= 2000\n"},
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

/* 2 times e, or a number whose exponent was lost? */
Test(text, lost_exponents)
{
    static const char *const texts[] = {"x <= 1e",      "x <= 2.5E+",  "x <= 1/2e\ny <= 1",
                                        "1e- + x <= 1", "1e - 2 <= x", "(2e)x <= 3",
                                        "e + 1e <= 3"};
    static const meaning table[] = {
        {"vars: e x\n2e + x <= 1", "vars: e x\n2 e + x <= 1\n"},
        {"2 e <= 1 + 3*e", "vars: e\n-e <= 1\n"},
        {"2ex <= 1e1e2", "vars: ex e2\n2 ex - 10 e2 <= 0\n"},
        {"2\"e\" <= 1", "vars: e\n2 e <= 1\n"},
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        fmb_system *s = NULL;
        fmb_where w = {0};
        cr_expect(fmb_system_parse(texts[i], strlen(texts[i]), NULL, &s, &w) == FMB_ERR_PARSE, "%s",
                  texts[i]);
        cr_expect(strstr(w.text, "or a number that was cut off"), "%s: %s", texts[i], w.text);
        cr_expect(w.column > 0 && (texts[i][w.column - 1] | 32) == 'e', "%s", texts[i]);
        fmb_system_free(s);
    }
    check_meanings(FMB_FORMAT_TEXT, table, COUNT(table));
}

/* One row, or two whose line break was lost? */
Test(text, lost_line_breaks)
{
    static const char *const texts[] = {"x >= 1  y >= 2",    "0 <= 2 x <= 4",    "x >= -1 y = 2",
                                        "x <= y + 1 z <= 2", "x <= 1/2 (y) < 3", "x <= 1 \"y\" < 3",
                                        "max: x <= 1 y <= 3"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        fmb_system *s = NULL;
        fmb_where w = {0};
        cr_expect(fmb_system_parse(texts[i], strlen(texts[i]), NULL, &s, &w) == FMB_ERR_PARSE, "%s",
                  texts[i]);
        cr_expect(strstr(w.text, "a product, or the ends of two rows"), "%s: %s", texts[i], w.text);
        cr_expect(w.column > 0 && strchr("yxz(\"", texts[i][w.column - 1]), "%s", texts[i]);
        fmb_system_free(s);
    }
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
        {"0 <= 2x <= 4", "vars: x\n-2 x <= 0\n2 x <= 4\n"},
        {"0 <= 2 * x + (3 y) <= 4", "vars: x y\n-2 x - 3 y <= 0\n2 x + 3 y <= 4\n"},
        {"0 <= x*2 <= 3 x", "vars: x\n-2 x <= 0\n-x <= 0\n"},
        {"3 x <= 2x <= 1 y", "vars: x y\nx <= 0\n2 x - y <= 0\n"},
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
        {"max: 3x + 2(y - 1/2)\nx <= y", "vars: x y\nmax: 3 x + 2 y - 1\nx - y <= 0\n"},
        {"x <= 1\n Minimise : -x + x + 4 # none\n", "vars: x\nmin: 4\nx <= 1\n"},
        {"x <= 1\nMAXIMIZE: -x\nmax: x <= 4", "vars: x\nmax: -x\nx <= 1\nmax: x <= 4\n"},
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
        {"max: x\nx <= 1\nmin: x", 3, 1, "one objective, found another"},
        {"max:\n", 1, 5, "a number, a name"},
        {"max: 3x 2y\n", 1, 9, "found '2y'"},
        {"Minimise: x y\n", 1, 13, "found 'y'"},
        {"max: 3 x * y\n", 1, 12, "a constant factor"},
        {"max: x / 0\n", 1, 10, "a divisor other than zero"},
        {"vars: x\nmin: x + z\n", 2, 10, "a variable of the vars line, found 'z'"},
        {"\"max\": 3x + 2y", 1, 15, "found end of file"},
        {"\"min\": x y <= 1", 1, 10, "found 'y'"},
        {"maxi: 3x + 2y", 1, 14, "found end of file"},
        {"x <= 1e100001", 1, 7, "an exponent between"},
        {"x <= 1/0", 1, 8, "a denominator other than zero"},
    };
    check_mistakes(FMB_FORMAT_TEXT, table, COUNT(table));
}

/* What messages quote has room, wherever a character of several bytes comes to stand. */
Test(text, quotes_have_room)
{
    for (int before = 0; before < 60; before++) {
        char name[80], quote[FMB_QUOTE + 8];
        memset(quote, 'z', sizeof quote);
        snprintf(name, sizeof name, "%.*s\xF0\x9F\x98\x80more", before,
                 "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa");
        fmb_quote_name(name, quote);
        size_t size = strlen(quote);
        cr_expect(size < FMB_QUOTE && quote[size - 1] == '\'', "%d: %s", before, quote);
    }
}

/* ---- a form by itself ------------------------------------------------------------------------ */

static fmb_status give_objective(fmb_system *s, const char *text, fmb_where *w)
{
    return fmb_system_parse_objective(s, FMB_SENSE_MIN, text, strlen(text), w);
}

Test(text, objectives_alone)
{
    static const mistake bad[] = {
        {"", 1, 1, "a number, a name or '(', found end of file"},
        {"x + z", 1, 5, "a variable of the system, found 'z'"},
        {"x <= 4", 1, 3, "an operator or the end of the form, found '<='"},
        {"x\n+ y", 1, 2, "the end of the form, found end of line"},
        {"x # y", 1, 3, "the end of the form, found '#'"},
        {"x * x", 1, 5, "a constant factor"},
        {"x / (1 - 1)", 1, 5, "a divisor other than zero"},
        {"x + \"", 1, 5, "a closing quote"},
        {"x + \x01", 1, 5, "control byte"},
    };
    fmb_where w = {0};
    fmb_system *s = parse(FMB_FORMAT_TEXT, "vars: x \"a b\"\nx <= 1", 20);
    for (size_t i = 0; i < COUNT(bad); i++) {
        cr_expect(give_objective(s, bad[i].text, &w) == FMB_ERR_PARSE, "%s", bad[i].text);
        cr_expect(w.line == bad[i].line && w.column == bad[i].column &&
                      strstr(w.text, bad[i].piece),
                  "%s: %ld:%ld: %s", bad[i].text, w.line, w.column, w.text);
        cr_expect(give_objective(s, bad[i].text, NULL) == FMB_ERR_PARSE);
        cr_expect(fmb_system_sense(s) == FMB_SENSE_NONE && fmb_system_dim(s) == 2);
    }
    cr_assert(give_objective(s, " 2x - \"a b\"/3 + 0.5 ", &w) == FMB_OK);
    char *says = write_text(s, FMB_FORMAT_TEXT);
    cr_expect(strcmp(says, "vars: x \"a b\"\nmin: 2 x - 1/3 \"a b\" + 1/2\nx <= 1\n") == 0, "%s",
              says);
    free(says);
    cr_expect(fmb_system_parse_objective(NULL, FMB_SENSE_MAX, "x", 1, &w) == FMB_ERR_ARG);
    cr_expect(w.line == 0 && strcmp(w.text, "s is NULL") == 0);
    cr_expect(fmb_system_parse_objective(s, FMB_SENSE_MAX, NULL, 1, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_system_parse_objective(s, FMB_SENSE_NONE, "x", 1, &w) == FMB_ERR_ARG);
    fmb_system_free(s);
}

/* ---- slips ----------------------------------------------------------------------------------- */

/* A name that stands once and looks like a slip of another is told, with its place. */
Test(text, slips)
{
    static const struct {
        const char *text;
        long line, column;
        const char *piece;
    } table[] = {
        {"milk + bread <= 4\n 3mlik >= 1", 2, 3, "'mlik' stands here only; did you mean 'milk'?"},
        {"milk <= 4\nmilkk >= 1", 2, 1, "'milkk' stands here only; did you mean 'milk'?"},
        {"mlk <= 4\nmilk >= 1\nmilk <= 9\n", 1, 1, "'mlk' stands here only; did you mean 'milk'?"},
        {"milk <= 4\nmilk >= 1\nmulk <= 9\n", 3, 1, "'mulk'"},
        {"milk <= 4\nproject: mlik\n", 2, 10, "'mlik'"},
        {"\"a\\x1b milk\" <= 4 + \"a\\x1b mlik\"", 1, 21, "'a? mlik' stands here only"},
        {"\xC3\xA9t\xC3\xA9x <= 1\n\xC3\xA9tx\xC3\xA9 <= 1", 0, 0, ""},
    };
    for (size_t i = 0; i < COUNT(table); i++) {
        warnings h = parse_warnings(FMB_FORMAT_TEXT, table[i].text);
        cr_expect(h.n == (table[i].line > 0) && h.at[0].line == table[i].line &&
                      h.at[0].column == table[i].column && strstr(h.at[0].text, table[i].piece),
                  "%s: %d, %ld:%ld: %s", table[i].text, h.n, h.at[0].line, h.at[0].column,
                  h.at[0].text);
    }
}

/* Names of a scheme, short names and declared names are no slips; nor is a name that stands twice.
 */
Test(text, no_slips)
{
    static const char *const texts[] = {
        "x1 <= 4\nx1 >= 1\nx12 >= 2\nx2 <= 1",
        "speed1 <= 4\nspeed1 >= 1\nspeed2 >= 2\nspeed12 <= 1\nspeed21 <= 2",
        "dist_a <= 4\ndist_a >= 1\ndist_b >= 2",
        "flow_ab <= 4\nflow_ab >= 1\nflow_ba >= 2",
        "x <= 1\nx >= 0\ny <= 1\nxy <= 2\nyx <= 2\nyx >= 1",
        "milk <= 4\nmilk >= 1\nmlik >= 2\nmlik <= 3",
        "vars: milk mlik\nmilk <= 4\nmilk >= 1\nmlik >= 2",
        "milk <= 4\nsilk >= 1",
        "seat <= 1\nseta <= 1\nsaet <= 1\nesat <= 1",
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        warnings h = parse_warnings(FMB_FORMAT_TEXT, texts[i]);
        cr_expect(h.n == 0, "%s: %s", texts[i], h.at[0].text);
    }
}

/* Many names are compared with few others each, or this would take hours; no memory is lost. */
Test(text, slips_among_many)
{
    static const char text[] = "milk + bread <= 4\n 3mlik >= 1\nmax: 2milk - 1/3 bread + 7";
    char *many = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&many, &size);
    for (int i = 0; i < 50000; i++)
        fprintf(f, "%c%c%c%cname <= 1\n", 'a' + i % 26, 'a' + i / 26 % 26, 'a' + i / 676 % 26,
                'a' + i / 17576);
    fclose(f);
    cr_expect(parse_warnings(FMB_FORMAT_TEXT, many).n == 0);
    free(many);
    check_every_failure(FMB_FORMAT_TEXT, text, sizeof text - 1, FMB_OK);
}
