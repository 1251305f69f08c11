/* show.h: rows, numbers and names of a system as text for people and as JSON. Rows count from 1. */
#ifndef APP_SHOW_H
#define APP_SHOW_H

/* gmp.h declares what prints and takes argument lists only behind these two. */
#include <stdarg.h>
#include <stdio.h>

#include <fmb/gmp.h>

#include "common/json.h"

/* [give, free()] printf into fresh memory, with GMP's conversions (%Qd). */
char *app_print(const char *format, ...);

/* [give, free()] "x", "row 7 (label)", "3 x + 1/2 y <= 4". */
char *app_show_name(const fmb_system *s, int j);
char *app_show_row_name(const fmb_system *s, size_t i);
char *app_show_row(const fmb_system *s, size_t i);

/* [give, free()] The objective times sign, "3 x - y + 5", without its constant unless that is asked
 * for. */
char *app_show_objective(const fmb_system *s, int sign, bool constant);

/* "p/q" */
json_t *app_json_number(const mpq_t q);
/* The coordinates of generator i, ["p/q", ...]. */
json_t *app_json_generator(const fmb_generators *g, size_t i);
/* obj[name of variable j] = value. */
void app_json_set_variable(json_t *obj, const fmb_system *s, int j, json_t *value);
/* obj.objective of a system, if it has one. */
void app_json_set_objective(json_t *obj, const fmb_system *s);
/* obj.variables, obj.objective and obj.rows of a system. */
void app_json_set_system(json_t *obj, const fmb_system *s);
/* {"row": i + 1, "label": ...}, the label only if there is one. */
json_t *app_json_row_name(const fmb_system *s, size_t i);

#endif
