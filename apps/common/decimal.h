/* decimal.h: exact numbers as decimals, where a command line asks for that. */
#ifndef APP_DECIMAL_H
#define APP_DECIMAL_H

#include <argp.h>
#include <gmp.h>
#include <stdbool.h>

/* Where a number goes that is no decimal of so few digits: to the nearest one, a tie to the even
 * one; or the ends of intervals outward. */
typedef enum app_rounding { APP_NEAREST = 0, APP_DOWN, APP_UP } app_rounding;

/* Parser of --decimal[=N], to be a child of a command's own; its input is an int: the significant
 * digits, or 0, as it was, where it is not given. */
extern const struct argp app_decimal_argp;

/* [give, free()] q, in lowest terms, as a decimal of that many significant digits, and of more
 * where it is less than 10^15 and has more in front of its point; it is written as printf's %.15g
 * writes doubles, with an exponent below 10^-4 and from 10^15 on. *exact: nothing was rounded. */
char *app_decimal(mpq_srcptr q, int digits, app_rounding way, bool *exact);

/* [give, free()] "1/3" where digits is 0; else the decimal, behind a '~' if it was rounded. */
char *app_number(mpq_srcptr q, int digits, app_rounding way);

#endif
