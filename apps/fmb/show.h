/* show.h: rows, numbers and names of a system as text for people and as JSON. Rows count from 1. */
#ifndef APP_SHOW_H
#define APP_SHOW_H

/* gmp.h declares printing and argument lists only after these two headers. */
#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>

#include "common/buffer.h"
#include "common/decimal.h"
#include "common/json.h"

/* [give, free()] printf into fresh memory, with GMP's conversions (%Qd). */
char *app_print(const char *format, ...);

/* "x", "row 7 (label)", "3 x + 1/2 y <= 4". digits here and below: of decimals, or 0
 * (common/decimal.h). */
void app_put_name(app_buffer *out, const fmb_system *s, int j);
void app_put_number(app_buffer *out, mpq_srcptr q, int digits);
void app_put_row_name(app_buffer *out, const fmb_system *s, size_t i);
void app_put_row(app_buffer *out, const fmb_system *s, size_t i, int digits);

/* [give, free()] These as texts of their own. */
char *app_show_row_name(const fmb_system *s, size_t i);
char *app_show_row(const fmb_system *s, size_t i, int digits);

/* [give, free()] A double as a decimal that identifies it (shortest.h); with digits, like any other
 * number. */
char *app_show_double(double d, int digits, app_rounding way);

/* [give, free()] The objective times sign, "3 x - y + 5"; its constant only if `constant`.
 */
char *app_show_objective(const fmb_system *s, int sign, bool constant, int digits);

/* "p/q", or with digits {"exact": "p/q", "decimal": "0.333333", "rounded": true} */
json_t *app_json_number(mpq_srcptr q, int digits, app_rounding way);
/* The coordinates of generator i, a list of such numbers. */
json_t *app_json_generator(const fmb_generators *g, size_t i, int digits);
/* obj[name of variable j] = value. */
void app_json_set_variable(json_t *obj, const fmb_system *s, int j, json_t *value);
/* obj.objective of a system, if it has one. */
void app_json_set_objective(json_t *obj, const fmb_system *s, int digits);
/* obj.variables, obj.objective and obj.rows of a system. */
void app_json_set_system(json_t *obj, const fmb_system *s, int digits);
/* {"row": i + 1, "label": ...}, the label only if there is one. */
json_t *app_json_row_name(const fmb_system *s, size_t i);

#endif
