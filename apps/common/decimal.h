/* decimal.h: exact numbers as decimals, if the command line requests it. */
#ifndef APP_DECIMAL_H
#define APP_DECIMAL_H

#include <argp.h>
#include <gmp.h>
#include <stdbool.h>

/* How a number that has more digits is rounded: to the nearest decimal, ties to even; or outward,
 * for ends of intervals. */
typedef enum app_rounding { APP_NEAREST = 0, APP_DOWN, APP_UP } app_rounding;

/* Parser of --decimal[=N], a child of a command's parser; its input is an int: the significant
 * digits; if the option is not given, it stays as it was, 0. */
extern const struct argp app_decimal_argp;

/* [give, free()] q, in lowest terms, as a decimal of that many significant digits, and of more
 * where it is less than 10^15 and has more in front of its point; it is written as printf's %.15g
 * writes doubles, with an exponent below 10^-4 and from 10^15 on. *exact: nothing was rounded. */
char *app_decimal(mpq_srcptr q, int digits, app_rounding way, bool *exact);

/* [give, free()] "1/3" if digits is 0; else the decimal, preceded by '~' if it was rounded. */
char *app_number(mpq_srcptr q, int digits, app_rounding way);

#endif
