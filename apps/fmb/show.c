/* show.c: see show.h. */
#include "fmb/show.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/text.h"
#include "fmb/shortest.h"

/* gmp_vasprintf allocates with GMP's functions, which are malloc's: nobody here sets others. */
char *app_print(const char *format, ...)
{
    char *text = NULL;
    va_list args;
    va_start(args, format);
    gmp_vasprintf(&text, format, args);
    va_end(args);
    return app_need(text);
}

void app_put_name(app_buffer *out, const fmb_system *s, int j)
{
    app_text_put(out, fmb_system_name(s, j), APP_TEXT_TERMINAL);
}

void app_put_row_name(app_buffer *out, const fmb_system *s, size_t i)
{
    const char *label = fmb_system_label(s, i);
    char *number = app_buffer_reserve(out, 32);
    out->size += (size_t)sprintf(number, "row %zu", i + 1);
    if (!label)
        return;
    app_buffer_put(out, " (");
    app_text_put(out, label, APP_TEXT_TERMINAL);
    app_buffer_put(out, ")");
}

char *app_show_row_name(const fmb_system *s, size_t i)
{
    app_buffer out = {0};
    app_put_row_name(&out, s, i);
    return out.text;
}

char *app_show_double(double d, int digits, app_rounding way)
{
    if (digits == 0 || !isfinite(d))
        return app_shortest(d);
    mpq_t q;
    mpq_init(q);
    mpq_set_d(q, d);
    char *text = app_number(q, digits, way);
    mpq_clear(q);
    return text;
}

void app_put_number(app_buffer *out, mpq_srcptr q, int digits)
{
    if (digits > 0) {
        char *text = app_number(q, digits, APP_NEAREST);
        app_buffer_put(out, text);
        free(text);
        return;
    }
    size_t most = mpz_sizeinbase(mpq_numref(q), 10) + mpz_sizeinbase(mpq_denref(q), 10) + 2;
    out->size += strlen(mpq_get_str(app_buffer_reserve(out, most), 10, q));
}

/* One term: its sign (none in front of the first if positive), its size unless 1, its variable. */
static void put_term(app_buffer *out, const fmb_system *s, size_t k, int j, mpq_t coef, int digits)
{
    int sign = mpq_sgn(coef);
    app_buffer_put(out, k == 0 ? (sign < 0 ? "-" : "") : (sign < 0 ? " - " : " + "));
    mpq_abs(coef, coef);
    if (mpq_cmp_ui(coef, 1, 1) != 0) {
        app_put_number(out, coef, digits);
        app_buffer_put(out, " ");
    }
    app_put_name(out, s, j);
}

void app_put_row(app_buffer *out, const fmb_system *s, size_t i, int digits)
{
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int j = fmb_system_term_q(s, i, k, q);
        put_term(out, s, k, j, q, digits);
    }
    app_buffer_put(out, fmb_system_terms(s, i) == 0 ? "0 " : " ");
    app_buffer_put(out, fmb_rel_text(fmb_system_rel(s, i)));
    app_buffer_put(out, " ");
    fmb_system_rhs_q(s, i, q);
    app_put_number(out, q, digits);
    mpq_clear(q);
}

char *app_show_row(const fmb_system *s, size_t i, int digits)
{
    app_buffer out = {0};
    app_put_row(&out, s, i, digits);
    return out.text;
}

char *app_show_objective(const fmb_system *s, int sign, bool constant, int digits)
{
    app_buffer out = {0};
    size_t n = fmb_system_objective_terms(s);
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < n; k++) {
        int j = fmb_system_objective_term_q(s, k, q);
        if (sign < 0)
            mpq_neg(q, q);
        put_term(&out, s, k, j, q, digits);
    }
    if (constant)
        fmb_system_objective_constant_q(s, q);
    else
        mpq_set_ui(q, 0, 1);
    if (sign < 0)
        mpq_neg(q, q);
    if (n > 0 && mpq_sgn(q) != 0) {
        app_buffer_put(&out, mpq_sgn(q) < 0 ? " - " : " + ");
        mpq_abs(q, q);
    }
    if (n == 0 || mpq_sgn(q) != 0)
        app_put_number(&out, q, digits);
    mpq_clear(q);
    return out.text;
}

/* ---- JSON ------------------------------------------------------------------------------------ */

/* A JSON string of a text from malloc, which is freed. */
static json_t *json_of_text(char *text)
{
    json_t *value = json_string(text);
    free(text);
    return value;
}

json_t *app_json_number(mpq_srcptr q, int digits, app_rounding way)
{
    bool exact;
    json_t *value = json_of_text(app_number(q, 0, APP_NEAREST));
    if (digits == 0)
        return value;
    json_t *obj = app_need(json_object());
    app_json_set(obj, "exact", value);
    app_json_set(obj, "decimal", json_of_text(app_decimal(q, digits, way, &exact)));
    app_json_set(obj, "rounded", json_boolean(!exact));
    return obj;
}

void app_json_set_variable(json_t *obj, const fmb_system *s, int j, json_t *value)
{
    char *name = app_text(fmb_system_name(s, j), APP_TEXT_JSON);
    app_json_set(obj, name, value);
    free(name);
}

/* null if the row has none. */
static json_t *json_label(const fmb_system *s, size_t i)
{
    const char *label = fmb_system_label(s, i);
    return label ? app_json_text(label) : json_null();
}

json_t *app_json_row_name(const fmb_system *s, size_t i)
{
    json_t *obj = app_need(json_object());
    app_json_set(obj, "row", json_integer((json_int_t)i + 1));
    app_json_set(obj, "label", json_label(s, i));
    return obj;
}

/* The coefficients of row i over all variables. */
static json_t *coefficients(const fmb_system *s, size_t i, mpq_t q, int digits)
{
    json_t *list = app_need(json_array());
    mpq_t zero;
    mpq_init(zero);
    size_t k = 0;
    int next = k < fmb_system_terms(s, i) ? fmb_system_term_q(s, i, k, q) : -1;
    for (int j = 0; j < fmb_system_dim(s); j++) {
        if (j != next) {
            app_json_append(list, app_json_number(zero, digits, APP_NEAREST));
            continue;
        }
        app_json_append(list, app_json_number(q, digits, APP_NEAREST));
        k++;
        next = k < fmb_system_terms(s, i) ? fmb_system_term_q(s, i, k, q) : -1;
    }
    mpq_clear(zero);
    return list;
}

static json_t *row(const fmb_system *s, size_t i, mpq_t q, int digits)
{
    json_t *obj = app_need(json_object());
    if (fmb_system_label(s, i))
        app_json_set(obj, "label", json_label(s, i));
    app_json_set(obj, "coefficients", coefficients(s, i, q, digits));
    app_json_set(obj, "relation", json_string(fmb_rel_text(fmb_system_rel(s, i))));
    fmb_system_rhs_q(s, i, q);
    app_json_set(obj, "rhs", app_json_number(q, digits, APP_NEAREST));
    return obj;
}

/* The coefficients of the objective over all variables. */
static json_t *objective_coefficients(const fmb_system *s, mpq_t q, int digits)
{
    json_t *list = app_need(json_array());
    size_t k = 0;
    for (int j = 0; j < fmb_system_dim(s); j++) {
        bool named = fmb_system_objective_term_q(s, k, q) == j;
        if (!named)
            mpq_set_ui(q, 0, 1);
        app_json_append(list, app_json_number(q, digits, APP_NEAREST));
        k += named;
    }
    return list;
}

void app_json_set_objective(json_t *obj, const fmb_system *s, int digits)
{
    fmb_sense sense = fmb_system_sense(s);
    if (sense == FMB_SENSE_NONE)
        return;
    mpq_t q;
    mpq_init(q);
    json_t *o = app_need(json_object());
    app_json_set(o, "sense", json_string(sense == FMB_SENSE_MAX ? "max" : "min"));
    app_json_set(o, "coefficients", objective_coefficients(s, q, digits));
    fmb_system_objective_constant_q(s, q);
    app_json_set(o, "constant", app_json_number(q, digits, APP_NEAREST));
    app_json_set(obj, "objective", o);
    mpq_clear(q);
}

void app_json_set_system(json_t *obj, const fmb_system *s, int digits)
{
    json_t *names = app_need(json_array()), *rows = app_need(json_array());
    for (int j = 0; j < fmb_system_dim(s); j++)
        app_json_append(names, app_json_text(fmb_system_name(s, j)));
    mpq_t q;
    mpq_init(q);
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        app_json_append(rows, row(s, i, q, digits));
    mpq_clear(q);
    app_json_set(obj, "variables", names);
    app_json_set_objective(obj, s, digits);
    app_json_set(obj, "rows", rows);
}

json_t *app_json_generator(const fmb_generators *g, size_t i, int digits)
{
    json_t *list = app_need(json_array());
    mpq_t q;
    mpq_init(q);
    for (int j = 0; j < fmb_generators_dim(g); j++) {
        fmb_generators_coordinate_q(g, i, j, q);
        app_json_append(list, app_json_number(q, digits, APP_NEAREST));
    }
    mpq_clear(q);
    return list;
}
