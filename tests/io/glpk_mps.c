/* glpk_mps.c: MPS files: what they say as .fmb text, exactly; what is refused. */
#include <criterion/criterion.h>
#include <glpk.h>
#include <locale.h>
#include <string.h>

#include "parse.h"

#define HEAD "NAME t\nROWS\n N obj\n L a\n G b\n E c\nCOLUMNS\n"

static void check(const meaning *table, size_t n)
{
    check_meanings(FMB_FORMAT_MPS, table, n);
}

Test(glpk_mps, free_form)
{
    static const meaning table[] = {
        {HEAD " x obj 1 a 0.1\n x b 1e2 c -3\n y a .5\nRHS\n R a 1 b 2.50\n R c 0\nENDATA\n",
         "vars: x y\na: 1/10 x + 1/2 y <= 1\nb: -100 x <= -5/2\nc: -3 x = 0\n-x <= 0\n-y <= 0\n"},
        {"* comment\nNAME t\nROWS\n N o\n\n L "
         "long_name_of_a_row\nCOLUMNS\n\tx(1)\tlong_name_of_a_row"
         "\t1.\t$ comment\nENDATA",
         "vars: \"x(1)\"\nlong_name_of_a_row: \"x(1)\" <= 0\n-\"x(1)\" <= 0\n"},
        {"NAME\nOBJSENSE\n    MAX\nROWS\n N o\n N other\n G r\nCOLUMNS\n x r 1 other 2\n RHS r 2\n"
         "RHS\n RHS other 3 r 1e-7\nENDATA\nnothing counts here\n",
         "vars: x RHS\nr: -x - 2 RHS <= -1/10000000\n-x <= 0\n-RHS <= 0\n"},
        {"NAME t\r\nROWS\r\n N o\r\n L r\r\nCOLUMNS\r\n x r 3\r\nENDATA\r\n",
         "vars: x\nr: 3 x <= 0\n-x <= 0\n"},
    };
    check(table, sizeof table / sizeof *table);
}

/* Fields by position: names with blanks (which are dropped), numbers by columns. */
Test(glpk_mps, fixed_form)
{
    static const meaning table[] = {
        {"NAME          fixed form\nROWS\n N  obj\n L  row a\nCOLUMNS\n"
         "    col one   row a              1.5   obj                 -1\n"
         "    COL       row a              -2.\n"
         "RHS\n"
         "    RHS       row a            12.25\n"
         "BOUNDS\n UP BND       col one           0.75\n MI BND       COL\n"
         "ENDATA\n",
         "vars: colone COL\nrowa: 3/2 colone - 2 COL <= 49/4\n-colone <= 0\ncolone <= 3/4\n"},
    };
    check(table, sizeof table / sizeof *table);
}

/* rhs - |R| and rhs, rhs and rhs + |R|, rhs and rhs + R: exactly, though 0.1 + 0.7 is no double. */
Test(glpk_mps, ranges)
{
    static const meaning table[] = {
        {"NAME t\nROWS\n N obj\n L a\n G b\n E c\n E d\n L e\n E f\n G g\nCOLUMNS\n x a 0.1 b 1\n"
         " x c 1 d 1.\n x e 1 f 1\n x g 1\nRHS\n R a 0.3 b 0.1\n R c 5 d -7\nRANGES\n"
         " R a 0.2 b -0.7\n R c 0.1 d -0.1\n R e 0. f 0\n R g 1e30\nENDATA\n",
         "vars: x\na: -1/10 x <= -1/10\na: 1/10 x <= 3/10\nb: -x <= -1/10\nb: x <= 4/5\n"
         "c: -x <= -5\nc: x <= 51/10\nd: -x <= 71/10\nd: x <= -7\ne: x = 0\nf: x = 0\n"
         "g: -x <= 0\n-x <= 0\n"},
    };
    check(table, sizeof table / sizeof *table);
}

Test(glpk_mps, bounds)
{
    static const meaning table[] = {
        {"NAME t\nROWS\n N o\n G r\nCOLUMNS\n i 'MARKER' 'INTORG'\n x r 1\n y r 1\n j 'MARKER' "
         "'INTEND'\n z r 1\n u r 1\n v r 1\n w r 1\n s r 1\n t r 1\nRHS\n R r 1\nBOUNDS\n BV B y\n"
         " FR B z\n UP B u -1\n FX B v 3\n LI B w 2\n UI B w 5\n MI B s\n UP B s 0.1\n LO B t -1\n"
         " PL B t\nENDATA\n",
         "vars: x y z u v w s t\nr: -x - y - z - u - v - w - s - t <= -1\n-x <= 0\n-y <= 0\n"
         "y <= 1\n-u <= 0\nu <= -1\nv = 3\n-w <= -2\nw <= 5\ns <= 1/10\n-t <= 1\n"},
        {"NAME t\nROWS\n N o\n L r\n G s\nCOLUMNS\n x r 1\n y s 0 o 0\nRHS\n R r 1e30 s -1e31\n"
         "BOUNDS\n UP B x 1e+30\n LO B x -1e30\n UP B y 9e29\nENDATA\n",
         "vars: x y\n-y <= 0\ny <= 900000000000000000000000000000\n"},
    };
    check(table, sizeof table / sizeof *table);
}

Test(glpk_mps, mistakes)
{
    static const mistake table[] = {
        {HEAD " x a 1.00000000000000000001\n y a 1\nENDATA\n", 8, 6, "differ as doubles"},
        {HEAD " x a 0.1\n y a 0.10000000000000000001\nENDATA\n", 9, 6,
         "not tell this one from 0.1"},
        {HEAD " x a 1e-320\nENDATA\n", 8, 6, "at least 1e-307"},
        {HEAD " x a 1e400\nENDATA\n", 8, 6, "cannot convert '1e400'"},
        {HEAD " x a inf\nENDATA\n", 8, 6, "cannot convert 'inf'"},
        {HEAD " x q 1\nENDATA\n", 8, 4, "row 'q' not found"},
        {HEAD " x a 1 b 2 c 3\nENDATA\n", 8, 1, "at most two numbers a line"},
        {HEAD " x a 1\nBOUNDS\n FX B x 1\n FX B x 2\nENDATA\n", 11, 7, "'x' has both"},
        {HEAD " x a 1\nBOUNDS\n UI B x 1.5\nENDATA\n", 10, 9, "a whole number"},
        {HEAD " x a 1\nBOUNDS\n UP B z 1\nENDATA\n", 10, 7, "column 'z' not found"},
        {HEAD " x a 1\n", 9, 1, "unexpected end of file"},
        {"", 1, 1, "unexpected end of file"},
    };
    check_mistakes(FMB_FORMAT_MPS, table, sizeof table / sizeof *table);
}

/* 10000000000000000000000000 and 1e25 are one number. */
Test(glpk_mps, spellings)
{
    static const meaning table[] = {
        {HEAD " x a 0.10 b 1e1\n y a 1e-1 b 10.\n z a .1e0 b 0010.000\n w a 100E-3 b +1.0E+01\n"
              "ENDATA\n",
         "vars: x y z w\na: 1/10 x + 1/10 y + 1/10 z + 1/10 w <= 0\n"
         "b: -10 x - 10 y - 10 z - 10 w <= 0\nc: 0 = 0\n-x <= 0\n-y <= 0\n-z <= 0\n-w <= 0\n"},
    };
    check(table, sizeof table / sizeof *table);
}

/* ---- surroundings ---------------------------------------------------------------------------- */

/* The terminal is left alone, and so are problems of the caller. */
Test(glpk_mps, neighbours)
{
    glp_prob *mine = glp_create_prob();
    glp_add_rows(mine, 3);
    glp_term_out(GLP_OFF);
    fmb_system_free(parse(FMB_FORMAT_MPS, HEAD "ENDATA\n", strlen(HEAD "ENDATA\n")));
    cr_expect(glp_term_out(GLP_ON) == GLP_OFF);
    cr_expect(glp_get_num_rows(mine) == 3);
    glp_delete_prob(mine);
    glp_free_env();
}

/* Decimals have points, whatever the locale says. */
Test(glpk_mps, other_locale)
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

typedef struct heard {
    int n;
    char text[4][160];
} heard;

static void hear(void *self, const fmb_where *w)
{
    heard *h = self;
    if (h->n < 4)
        strcpy(h->text[h->n], w->text);
    h->n++;
}

Test(glpk_mps, warnings)
{
    static const char text[] =
        "NAME t\nROWS\n N o\n L r\nCOLUMNS\n i 'MARKER' 'INTORG'\n x r 1 o 1\n"
        "RHS\n R r 1e30\nBOUNDS\n UP B x -1\nENDATA\n";
    heard h = {0};
    fmb_system *s = NULL;
    fmb_reader how = {.format = FMB_FORMAT_MPS, .warn = hear, .self = &h};
    cr_assert(fmb_system_parse(text, sizeof text - 1, &how, &s, NULL) == FMB_OK);
    cr_expect(h.n == 4);
    cr_expect(strstr(h.text[0], "integrality"));
    cr_expect(strstr(h.text[1], "1e30"));
    cr_expect(strstr(h.text[2], "'x' has a negative upper bound"));
    cr_expect(strstr(h.text[3], "objective"));
    fmb_system_free(s);
}

Test(glpk_mps, failing_allocations)
{
    static const char *const good = HEAD " x obj 1 a 0.1\n x b 1e2 c -3\n y a .5\nRHS\n R a 1 b 2\n"
                                         "RANGES\n R a 3 b 0.7\nBOUNDS\n UP B x 4\n FX B y 2\n"
                                         "ENDATA\n";
    static const char *const bad = HEAD " x a 1\nBOUNDS\n FX B x 1\n FX B x 2\nENDATA\n";
    check_every_failure(FMB_FORMAT_MPS, good, strlen(good), FMB_OK);
    check_every_failure(FMB_FORMAT_MPS, bad, strlen(bad), FMB_ERR_PARSE);
}
