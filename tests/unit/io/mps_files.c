/* mps_files.c: MPS files: their exact meaning as .fmb text; refused files. */
#include <criterion/criterion.h>
#include <locale.h>
#include <string.h>

#include "parse.h"

#define ZEROS_100                                                                                  \
    "00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000" \
    "00"                                                                                           \
    "000000"
#define ZEROS ZEROS_100 ZEROS_100 ZEROS_100 ZEROS_100
#define HEAD  "NAME t\nROWS\n N obj\n L a\n G b\n E c\nCOLUMNS\n"

static void check(const meaning *table, size_t n)
{
    check_meanings(FMB_FORMAT_MPS, table, n);
}

/* Between markers and without bounds: up to 1. Any bound, of any kind, and it is not so. */
Test(mps_files, integers_without_bounds)
{
    static const meaning table[] = {
        {"NAME\nROWS\n N o\n L r\nCOLUMNS\n c r 1\n m 'MARKER' 'INTORG'\n x r 1\n y r 1\n z r 1\n "
         "w r 1\n"
         " m 'MARKER' 'INTEND'\n d r 1\nRHS\n b r 9\nBOUNDS\n PL b y\n LO b z 2\n MI b w\nENDATA\n",
         "vars: c x y z w d\ninteger: x y z w\nmin: 0\nr: c + x + y + z + w + d <= 9\n-c <= 0\n-x "
         "<= 0\nx "
         "<= 1\n-y <= 0\n-z <= -2\n-d <= 0\n"},
        {"NAME\nROWS\n N o\nCOLUMNS\n m 'MARKER' 'INTORG'\n x o 1\nBOUNDS\n UP a x 3\n UP b x "
         "2\nENDATA\n",
         "vars: x\ninteger: x\nmin: x\n-x <= 0\nx <= 3\n"},
    };
    check(table, sizeof table / sizeof *table);
}

Test(mps_files, fortran_exponents_and_comments)
{
    static const meaning table[] = {
        {"NAME t ! a title\nROWS\n N o\n L r\nCOLUMNS\n x r 1.0D3 ! metres\n y r 25d-1 * "
         "and\nRHS\n b r 1D+2 "
         "$ so\nENDATA\n",
         "vars: x y\nmin: 0\nr: 1000 x + 5/2 y <= 100\n-x <= 0\n-y <= 0\n"},
        {"NAME\nROWS\n N o\n L !r\n L *s\nCOLUMNS\n x o 1 !r 2\n x *s 3 ! end\nENDATA\n",
         "vars: x\nmin: x\n!r: 2 x <= 0\n*s: 3 x <= 0\n-x <= 0\n"},
        {"NAME          T\nROWS\n N  o\n L  a b\nCOLUMNS\n"
         "    x y       a b       1.0D0          o         2.0D0        written "
         "behind\nRHS\nENDATA\n",
         "vars: \"x y\"\nmin: 2 \"x y\"\na b: \"x y\" <= 0\n-\"x y\" <= 0\n"},
    };
    check(table, sizeof table / sizeof *table);
}

Test(mps_files, free_form)
{
    static const meaning table[] = {
        {HEAD " x obj 1 a 0.1\n x b 1e2 c -3\n y a .5\nRHS\n R a 1 b 2.50\n R c 0\nENDATA\n",
         "vars: x y\nmin: x\na: 1/10 x + 1/2 y <= 1\nb: -100 x <= -5/2\nc: -3 x = 0\n-x <= 0\n-y "
         "<= 0\n"},
        {"* comment\nNAME t\nROWS\n N o\n\n L "
         "long_name_of_a_row\nCOLUMNS\n\tx(1)\tlong_name_of_a_row"
         "\t1.\t$ comment\nENDATA",
         "vars: \"x(1)\"\nmin: 0\nlong_name_of_a_row: \"x(1)\" <= 0\n-\"x(1)\" <= 0\n"},
        {"NAME\nOBJSENSE\n    MAX\nROWS\n N o\n N other\n G r\nCOLUMNS\n x r 1 other 2\n RHS r 2\n"
         "RHS\n RHS other 3 r 1e-7\nENDATA\nnothing counts here\n",
         "vars: x RHS\nmax: 0\nr: -x - 2 RHS <= -1/10000000\n-x <= 0\n-RHS <= 0\n"},
        {"objsense max\nrows\n n o\n l r\n e s\ncolumns\n x r 1 s 0.30000000000000000001\nbounds\n"
         " up x 7\n lo x 1e-400\nranges\n r 2\nrhs\n r 3 s 1e20\nendata\n",
         "vars: x\nmax: 0\nr: -x <= -1\nr: x <= 3\ns: 30000000000000000001/100000000000000000000 x "
         "= "
         "100000000000000000000\n-x <= -1/1" ZEROS "\nx <= 7\n"},
        {"NAME t\r\nROWS\r\n N o\r\n L r\r\nCOLUMNS\r\n x r 3\r\nENDATA\r\n",
         "vars: x\nmin: 0\nr: 3 x <= 0\n-x <= 0\n"},
    };
    check(table, sizeof table / sizeof *table);
}

/* Fields by position: names with blanks, a set without a name, a comment in the place of a field.
 */
Test(mps_files, fixed_form)
{
    static const meaning table[] = {
        {"NAME          fixed form\nROWS\n N  obj\n L  row a\nCOLUMNS\n"
         "    col one   row a              1.5   obj                 -1\n"
         "    COL       row a              -2.\n"
         "RHS\n"
         "              row a            12.25   $ comment\n"
         "BOUNDS\n UP BND       col one           0.75\n MI BND       COL\n"
         "ENDATA\n",
         "vars: \"col one\" COL\nmin: -\"col one\"\nrow a: 3/2 \"col one\" - 2 COL <= 49/4\n-\"col "
         "one\" <= 0\n"
         "\"col one\" <= 3/4\n"},
    };
    check(table, sizeof table / sizeof *table);
}

/* rhs - |R| and rhs, rhs and rhs + |R|, rhs and rhs + R: exactly, though 0.1 + 0.7 is no double. */
Test(mps_files, ranges)
{
    static const meaning table[] = {
        {"NAME t\nROWS\n N obj\n L a\n G b\n E c\n E d\n L e\n E f\n G g\nCOLUMNS\n x a 0.1 b 1\n"
         " x c 1 d 1.\n x e 1 f 1\n x g 1\nRHS\n R a 0.3 b 0.1\n R c 5 d -7\nRANGES\n"
         " R a 0.2 b -0.7\n R c 0.1 d -0.1\n R e 0. f 0\n R g 1e30\nENDATA\n",
         "vars: x\nmin: 0\na: -1/10 x <= -1/10\na: 1/10 x <= 3/10\nb: -x <= -1/10\nb: x <= 4/5\n"
         "c: -x <= -5\nc: x <= 51/10\nd: -x <= 71/10\nd: x <= -7\ne: x = 0\nf: x = 0\n"
         "g: -x <= 0\n-x <= 0\n"},
    };
    check(table, sizeof table / sizeof *table);
}

Test(mps_files, bounds)
{
    static const meaning table[] = {
        {"NAME t\nROWS\n N o\n G r\nCOLUMNS\n i 'MARKER' 'INTORG'\n x r 1\n y r 1\n j 'MARKER' "
         "'INTEND'\n z r 1\n u r 1\n v r 1\n w r 1\n s r 1\n t r 1\nRHS\n R r 1\nBOUNDS\n BV B y\n"
         " FR B z\n UP B u -1\n FX B v 3\n LI B w 2\n UI B w 5\n MI B s\n UP B s 0.1\n LO B t -1\n"
         " PL B t\nENDATA\n",
         "vars: x y z u v w s t\ninteger: x y w\nmin: 0\nr: -x - y - z - u - v - w - s - t <= "
         "-1\n-x <= "
         "0\nx <= 1\n-y <= 0\n"
         "y <= 1\n-u <= 0\nu <= -1\nv = 3\n-w <= -2\nw <= 5\ns <= 1/10\n-t <= 1\n"},
        {"NAME t\nROWS\n N o\n L r\n G s\nCOLUMNS\n x r 1\n y s 0 o 0\nRHS\n R r 1e30 s -1e31\n"
         "BOUNDS\n UP B x 1e+30\n LO B x -1e30\n UP B y 9e29\nENDATA\n",
         "vars: x y\nmin: 0\n-y <= 0\ny <= 900000000000000000000000000000\n"},
    };
    check(table, sizeof table / sizeof *table);
}

/* The first set of each section counts, the others are only checked. */
Test(mps_files, sets)
{
    static const meaning table[] = {
        {HEAD " x a 1 b 1\nRHS\n R a 4\n S a 5\n S b 5\nRANGES\n R b 2\n S a 3\nBOUNDS\n UP B x 3\n"
              " FX C x 9\nENDATA\n",
         "vars: x\nmin: 0\na: x <= 4\nb: -x <= 0\nb: x <= 2\nc: 0 = 0\n-x <= 0\nx <= 3\n"},
    };
    check(table, sizeof table / sizeof *table);
}

Test(mps_files, mistakes)
{
    static const mistake table[] = {
        {HEAD " x a 1e400000\nENDATA\n", 8, 7, "an exponent between"},
        {HEAD " x a inf\nENDATA\n", 8, 6, "expected a number, found 'inf'"},
        {HEAD " x q 1\nENDATA\n", 8, 4, "the name of a row, found 'q'"},
        {HEAD " x a 1 b 2 c 3\nENDATA\n", 8, 12, "at most two numbers a line"},
        {HEAD " x a 1\nBOUNDS\n FX B x 1\n FX B x 2\nENDATA\n", 11, 7, "one bound of each side"},
        {HEAD " x a 1\nBOUNDS\n UP B x\nENDATA\n", 10, 8, "a number, found end of line"},
        {HEAD " x a 1\nBOUNDS\n UI B x 1.5\nENDATA\n", 10, 9, "a whole number"},
        {HEAD " x a 1\nBOUNDS\n UP B z 1\nENDATA\n", 10, 7, "the name of a column, found 'z'"},
        {HEAD " x a 1\n", 9, 1, "expected ENDATA, found end of file"},
        {"", 1, 1, "expected ENDATA, found end of file"},
    };
    check_mistakes(FMB_FORMAT_MPS, table, sizeof table / sizeof *table);
}

/* 10000000000000000000000000 and 1e25 are one number. */
Test(mps_files, spellings)
{
    static const meaning table[] = {
        {HEAD " x a 0.10 b 1e1\n y a 1e-1 b 10.\n z a .1e0 b 0010.000\n w a 100E-3 b +1.0E+01\n"
              "ENDATA\n",
         "vars: x y z w\nmin: 0\na: 1/10 x + 1/10 y + 1/10 z + 1/10 w <= 0\n"
         "b: -10 x - 10 y - 10 z - 10 w <= 0\nc: 0 = 0\n-x <= 0\n-y <= 0\n-z <= 0\n-w <= 0\n"},
    };
    check(table, sizeof table / sizeof *table);
}

/* ---- surroundings ---------------------------------------------------------------------------- */

/* Decimals have points, whatever the locale says. */
Test(mps_files, other_locale)
{
    static const char text[] = HEAD " x a 0.5\nENDATA\n";
    if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8"))
        cr_skip_test("no locale with a decimal comma here");
    fmb_system *s = parse(FMB_FORMAT_MPS, text, sizeof text - 1);
    mpq_t q;
    mpq_init(q);
    fmb_system_term_q(s, 0, 0, q);
    cr_expect(mpq_cmp_ui(q, 1, 2) == 0);
    mpq_clear(q);
    fmb_system_free(s);
}

/* Each with its true place; integrality is no warning but a mark. */
Test(mps_files, warnings)
{
    static const char text[] =
        "NAME t\nROWS\n N o\n L r\n L s\nCOLUMNS\n i 'MARKER' 'INTORG'\n x r 1 o 1\n"
        " j 'MARKER' 'INTEND'\n y s 1\nRHS\n R r 1e30 s 1e31\n S r 2\n S s 2\nBOUNDS\n UP B x -1\n"
        "ENDATA\n";
    static const struct {
        long line, column;
        const char *piece;
    } expected[] = {{13, 2, "another set"}, {4, 4, "1e30"}, {16, 7, "negative upper bound"}};
    warnings h = parse_warnings(FMB_FORMAT_MPS, text);
    fmb_system *s = parse(FMB_FORMAT_MPS, text, sizeof text - 1);
    cr_expect(h.n == 3);
    for (int i = 0; i < 3; i++)
        cr_expect(h.at[i].line == expected[i].line && h.at[i].column == expected[i].column &&
                      strstr(h.at[i].text, expected[i].piece),
                  "%ld:%ld: %s", h.at[i].line, h.at[i].column, h.at[i].text);
    cr_expect(fmb_system_is_integer(s, 0) && !fmb_system_is_integer(s, 1));
    fmb_system_free(s);
}

/* The first row of type N, or the one that OBJNAME names; a right side is minus the constant. */
Test(mps_files, objectives)
{
#define TWO  " N o\n N p\n L r\nCOLUMNS\n x o 1 p .5\n x r 1\n y p -2\nRHS\n R p 3 r 4\nENDATA\n"
#define REST "r: x <= 4\n-x <= 0\n-y <= 0\n"
    static const meaning table[] = {
        {"ROWS\n" TWO, "vars: x y\nmin: x\n" REST},
        {"OBJSENSE\n MAXIMIZE\nOBJNAME\n p\nROWS\n" TWO, "vars: x y\nmax: 1/2 x - 2 y - 3\n" REST},
        {"OBJSENSE MIN\nOBJNAME p\nROWS\n" TWO, "vars: x y\nmin: 1/2 x - 2 y - 3\n" REST},
        {"ROWS\n L r\nCOLUMNS\n x r 1\nENDATA\n", "vars: x\nr: x <= 0\n-x <= 0\n"},
    };
    static const mistake bad[] = {
        {"OBJNAME\n r\nROWS\n" TWO, 2, 2, "the name of a row of type N, found 'r'"},
        {"OBJNAME q\nROWS\n" TWO, 1, 9, "the name of a row of type N, found 'q'"},
    };
    check(table, sizeof table / sizeof *table);
    check_mistakes(FMB_FORMAT_MPS, bad, sizeof bad / sizeof *bad);
}

/* Markers, and the kinds of bounds that make a column integer. */
Test(mps_files, integers)
{
    static const char text[] =
        HEAD " M 'MARKER' 'INTORG'\n x a 1\n y a 1\n M 'MARKER' 'INTEND'\n z a 1\n u a 1\n v a 1\n"
             " w a 1\nBOUNDS\n BV B u\n LI B v 1\n UI B w 2\nENDATA\n";
    static const bool expected[] = {true, true, false, true, true, true};
    fmb_system *s = parse(FMB_FORMAT_MPS, text, sizeof text - 1);
    for (int j = 0; j < 6; j++)
        cr_expect(fmb_system_is_integer(s, j) == expected[j], "column %d", j + 1);
    fmb_system_free(s);
}

Test(mps_files, failing_allocations)
{
    static const char *const good = HEAD " x obj 1 a 0.1\n x b 1e2 c -3\n y a .5\nRHS\n R a 1 b 2\n"
                                         "RANGES\n R a 3 b 0.7\nBOUNDS\n UP B x 4\n FX B y 2\n"
                                         "ENDATA\n";
    static const char *const bad = HEAD " x a 1\nBOUNDS\n FX B x 1\n FX B x 2\nENDATA\n";
    check_every_failure(FMB_FORMAT_MPS, good, strlen(good), FMB_OK);
    check_every_failure(FMB_FORMAT_MPS, bad, strlen(bad), FMB_ERR_PARSE);
}
