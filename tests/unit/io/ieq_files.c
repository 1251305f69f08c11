/* ieq_files.c: PORTA files. */
#include <criterion/criterion.h>

#include "parse.h"

#define COUNT(t) (sizeof(t) / sizeof *(t))

Test(ieq, files)
{
    static const meaning table[] = {
        {"DIM = 3\nINEQUALITIES_SECTION\n( 1) +3x1-9x2 <= 1\n(2) x3 >= -1/2\n\n-1x1==0\nEND\n",
         "vars: x1 x2 x3\n3 x1 - 9 x2 <= 1\n-x3 <= 1/2\n-x1 = 0\n"},
        {"DIM=2\n\nVALID\n1 1/2\nLOWER_BOUNDS\n0 0\nUPPER_BOUNDS\n1 1\nELIMINATION_ORDER\n0 1\n"
         "INEQUALITIES_SECTION\nx1 + 1 =< 2 x2 - x1\nEND\n",
         "vars: x1 x2\nproject: x1\n2 x1 - 2 x2 <= -1\n"},
        {"DIM = 1\nINEQUALITIES_SECTION\n0 <= 5\n2 X1 => 1\nEND",
         "vars: x1\n0 <= 5\n-2 x1 <= -1\n"},
        {"DIM = 1\nEND", "vars: x1\n"},
    };
    check_meanings(FMB_FORMAT_IEQ, table, COUNT(table));
}

#define ROWS "DIM = 2\nINEQUALITIES_SECTION\n"

Test(ieq, mistakes)
{
    static const mistake table[] = {
        {"INEQUALITIES_SECTION\n", 1, 1, "'DIM = n' first"},
        {"DIM 3\n", 1, 5, "'=' after DIM"},
        {"DIM = x\n", 1, 7, "a number of variables"},
        {"DIM = 99999999\nEND", 1, 7, "fewer variables"},
        {"DIM = 1\nDIM = 1\n", 2, 1, "one DIM line"},
        {"DIM = 1\nCONV_SECTION\n", 2, 1, "points or rays"},
        {"DIM = 1\nLOWER\n", 2, 1, "the name of a section"},
        {"DIM = 2\nELIMINATION_ORDER\n1\nEND\n", 4, 1, "a place in the order"},
        {ROWS "x1 <= 1\n", 4, 1, "END, found end of file"},
        {ROWS "x3 <= 1\nEND", 3, 2, "between 1 and 2"},
        {ROWS "x0 <= 1\nEND", 3, 2, "between 1 and 2"},
        {ROWS "x1 < 1\nEND", 3, 4, "'<=', '>=' or '=='"},
        {ROWS "x1\nEND", 3, 3, "found end of line"},
        {ROWS "x1 <= 1 2\nEND", 3, 9, "end of line after a row"},
        {ROWS "(1 x1 <= 1\nEND", 3, 4, "')'"},
        {ROWS "+ <= 1\nEND", 3, 3, "a number or a variable"},
        {ROWS "1/0x1 <= 1\nEND", 3, 3, "a denominator"},
    };
    check_mistakes(FMB_FORMAT_IEQ, table, COUNT(table));
}
