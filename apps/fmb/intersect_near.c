/* intersect_near.c: see intersect_near.h. */
#include "fmb/intersect_near.h"

#include <stdlib.h>

#include "common/exit_code.h"
#include "common/form.h"
#include "common/json.h"
#include "common/message.h"
#include "fmb/show.h"

/* A form without variables is a number. */
int near_read_margin(near_ask *ask, const char *text)
{
    fmb_system *none = NULL;
    fmb_status st = fmb_system_new(0, NULL, &none);
    int code =
        st == FMB_OK ? app_form_read("--within", text, FMB_SENSE_MIN, none) : app_status_error(st);
    if (!ask->within)
        mpq_init(ask->margin);
    ask->within = true;
    fmb_system_objective_constant_q(none, ask->margin);
    if (code == APP_YES && mpq_sgn(ask->margin) < 0) {
        code = app_error(APP_USAGE, "--within: expected a number that is not negative, found '%s'",
                         text);
    }
    fmb_system_free(none);
    return code;
}

void near_ask_clear(near_ask *ask)
{
    if (ask->within)
        mpq_clear(ask->margin);
}

bool near_is_asked(const near_ask *ask)
{
    return ask->distance || ask->depth || ask->common || ask->separate || ask->within;
}

/* ---- bodies as frames ------------------------------------------------------------------------ */

/* Numbers of a frame that stands for a polytope: its vertices, the first one as the origin. */
typedef struct hull_frame {
    mpq_t *number;
    size_t size;
} hull_frame;

static void take_vertices(const fmb_generators *g, hull_frame *room, fmb_frame_q *out)
{
    size_t n = fmb_generators_size(g), dim = (size_t)fmb_generators_dim(g);
    room->size = n * dim;
    room->number = app_need(malloc((room->size + 1) * sizeof *room->number));
    for (size_t i = 0; i < room->size; i++) {
        mpq_init(room->number[i]);
        fmb_generators_coordinate_q(g, i / dim, (int)(i % dim), room->number[i]);
    }
    *out = (fmb_frame_q){.shape = FMB_SIMPLEX_BY_CORNERS,
                         .dim = (int)dim,
                         .naxes = (int)n - 1,
                         .origin = room->number,
                         .axes = room->number + dim};
}

static bool are_vertices(const fmb_generators *g)
{
    size_t n = fmb_generators_size(g), i = 0;
    while (i < n && fmb_generators_kind(g, i) == FMB_VERTEX)
        i++;
    return n > 0 && n <= FMB_FRAME_MOST_DIM && i == n;
}

/* *known: it is a frame now. */
static fmb_status frame_of_body(fmb_solver *v, const fmb_body *body, hull_frame *room,
                                fmb_frame_q *out, bool *known)
{
    fmb_generators *g = NULL;
    *known = !body->rows;
    if (*known) {
        *out = body->frame;
        return FMB_OK;
    }
    fmb_result r = {.size = sizeof r};
    fmb_status st = fmb_generate(v, body->rows, &g, &r);
    *known = st == FMB_OK && g && r.stop == FMB_STOP_DONE && are_vertices(g);
    if (*known)
        take_vertices(g, room, out);
    fmb_generators_free(g);
    return st;
}

static bool has_strict_row(const fmb_body *body)
{
    size_t i = 0, n = body->rows ? fmb_system_rows(body->rows) : 0;
    while (i < n && fmb_system_rel(body->rows, i) != FMB_LT)
        i++;
    return i < n;
}

static void hull_frame_clear(hull_frame *room)
{
    for (size_t i = 0; i < room->size; i++)
        mpq_clear(room->number[i]);
    free(room->number);
}

/* ---- questions ------------------------------------------------------------------------------- */

/* The distance is at most the margin. */
static bool is_within_margin(const near_ask *ask, const fmb_proximity *p)
{
    mpq_t most, measure;
    mpq_inits(most, measure, NULL);
    mpq_set(most, ask->margin);
    if (ask->norm == FMB_NORM_EUCLIDEAN)
        mpq_mul(most, most, most);
    fmb_proximity_measure_q(p, measure);
    bool within = mpq_cmp(measure, most) <= 0;
    mpq_clears(most, measure, NULL);
    return within;
}

static void note_stop(const fmb_result *r, near_found *out)
{
    if (out->stop == FMB_STOP_DONE)
        out->stop = r->stop;
}

static fmb_status ask_when_apart(const near_ask *ask, fmb_solver *v, const fmb_frame_q *f,
                                 fmb_contact contact, near_found *out)
{
    fmb_status st = FMB_OK;
    fmb_result r = {.size = sizeof r};
    if (ask->within || ask->distance)
        st = fmb_distance_q(v, f, ask->norm, &out->distance, &r);
    note_stop(&r, out);
    if (st == FMB_OK && ask->separate)
        st = fmb_separate_q(v, f, contact, &out->row, &r);
    note_stop(&r, out);
    out->is_within = ask->within && out->distance && is_within_margin(ask, out->distance);
    return st;
}

static fmb_status ask_when_meeting(const near_ask *ask, fmb_solver *v, const fmb_frame_q *f,
                                   near_found *out)
{
    fmb_status st = FMB_OK;
    fmb_result r = {.size = sizeof r};
    if (ask->depth)
        st = fmb_depth_q(v, f, ask->norm, &out->depth, &r);
    note_stop(&r, out);
    if (st == FMB_OK && ask->common)
        st = fmb_common_q(v, f, &out->common, &r);
    note_stop(&r, out);
    out->is_within = ask->within;
    return st;
}

/* The frame of a polytope is its closure. Where a row is strict only their relative interiors are
 * sure to be apart, as if they were open; and all of its rows are strict with open contact, when it
 * may be empty unlike that frame, and nothing contradicts the verdict. */
fmb_status near_find(const near_ask *ask, fmb_solver *v, const fmb_frame_line *line,
                     fmb_contact contact, fmb_verdict verdict, near_found *out)
{
    hull_frame room[2] = {{0}, {0}};
    fmb_frame_q f[2];
    bool known = true, may_be_empty = false;
    fmb_status st = FMB_OK;
    for (int k = 0; k < 2; k++)
        may_be_empty |= contact == FMB_CONTACT_OPEN && line->body[k].rows;
    if (has_strict_row(&line->body[0]) || has_strict_row(&line->body[1]))
        contact = FMB_CONTACT_OPEN;
    for (int k = 0; st == FMB_OK && known && k < 2; k++)
        st = frame_of_body(v, &line->body[k], &room[k], &f[k], &known);
    if (st == FMB_OK && known && verdict != FMB_UNKNOWN)
        st = verdict == FMB_FEASIBLE ? ask_when_meeting(ask, v, f, out)
                                     : ask_when_apart(ask, v, f, contact, out);
    if (st == FMB_OK && known && !may_be_empty)
        out->contradiction = near_contradiction(ask, contact, verdict, out);
    hull_frame_clear(&room[0]);
    hull_frame_clear(&room[1]);
    return st;
}

void near_clear(near_found *f)
{
    fmb_proximity_free(f->distance);
    fmb_proximity_free(f->depth);
    fmb_generators_free(f->common);
    fmb_system_free(f->row);
    *f = (near_found){0};
}

/* ---- numbers and points ---------------------------------------------------------------------- */

/* The point of frame which; the shift, if that is -1. */
static json_t *proximity_coordinates(const near_ask *ask, const fmb_proximity *p, int which)
{
    int dim = fmb_proximity_dim(p);
    json_t *list = app_need(json_array());
    mpq_t q;
    mpq_init(q);
    for (int j = 0; j < dim; j++) {
        if (which < 0)
            fmb_proximity_shift_q(p, j, q);
        else
            fmb_proximity_point_q(p, which, j, q);
        app_json_append(list, app_json_number(q, ask->digits, APP_NEAREST));
    }
    mpq_clear(q);
    return list;
}

/* ---- text ------------------------------------------------------------------------------------ */

/* As app_number writes it. */
static void print_number(const json_t *number, FILE *out)
{
    fputs(json_is_true(json_object_get(number, "rounded")) ? "~" : "", out);
    const json_t *decimal = json_object_get(number, "decimal");
    fputs(json_string_value(decimal ? decimal : number), out);
}

static void print_list(json_t *list, FILE *out)
{
    size_t i;
    json_t *number;
    fputc('(', out);
    json_array_foreach(list, i, number)
    {
        fputs(i > 0 ? ", " : "", out);
        print_number(number, out);
    }
    fputc(')', out);
    json_decref(list);
}

/* q becomes a number that is rounded to that many decimal digits as its square root is, which is
 * irrational: with t = floor(sqrt(q) 10^k) of more digits both lie strictly between t and t + 1
 * times 10^-k, and what decimals are rounded at are integers times 10^-k, too. */
static void take_root(mpq_t q, int digits)
{
    long size = (long)mpz_sizeinbase(mpq_numref(q), 10) - (long)mpz_sizeinbase(mpq_denref(q), 10);
    long k = digits + 18 - size / 2;
    mpz_t t, unit;
    mpz_inits(t, unit, NULL);
    mpz_ui_pow_ui(unit, 100, (unsigned long)labs(k));
    mpz_mul(k < 0 ? mpq_denref(q) : mpq_numref(q), k < 0 ? mpq_denref(q) : mpq_numref(q), unit);
    mpz_fdiv_q(t, mpq_numref(q), mpq_denref(q));
    mpz_sqrt(t, t);
    mpz_mul_2exp(t, t, 1);
    mpz_add_ui(t, t, 1);
    mpz_ui_pow_ui(unit, 10, (unsigned long)labs(k));
    mpq_set_ui(q, 1, 2);
    mpz_set(mpq_numref(q), t);
    mpz_mul(k < 0 ? mpq_numref(q) : mpq_denref(q), k < 0 ? mpq_numref(q) : mpq_denref(q), unit);
    mpq_canonicalize(q);
    mpz_clears(t, unit, NULL);
}

/* "5", "sqrt(2) = 1.41421", "~1.41421" */
static void print_measure(const near_ask *ask, const fmb_proximity *p, FILE *out)
{
    mpq_t q;
    mpq_init(q);
    fmb_proximity_measure_q(p, q);
    bool square = ask->norm == FMB_NORM_EUCLIDEAN, whole = !square;
    if (square && mpz_perfect_square_p(mpq_numref(q)) && mpz_perfect_square_p(mpq_denref(q))) {
        mpz_sqrt(mpq_numref(q), mpq_numref(q));
        mpz_sqrt(mpq_denref(q), mpq_denref(q));
        whole = true;
    }
    bool root = !whole && ask->digits == 0;
    if (!whole && !root)
        take_root(q, ask->digits);
    char *text = root ? app_print("sqrt(%Qd) = %.6g", q, fmb_proximity_length(p))
                      : app_number(q, ask->digits, APP_NEAREST);
    fputs(text, out);
    free(text);
    mpq_clear(q);
}

static void print_common(const near_ask *ask, const fmb_generators *g, FILE *out)
{
    size_t n = fmb_generators_size(g);
    fprintf(out, "  common    %zu %s\n", n, n == 1 ? "vertex" : "vertices");
    for (size_t i = 0; i < n; i++) {
        fputs("    ", out);
        print_list(app_json_generator(g, i, ask->digits), out);
        fputc('\n', out);
    }
}

void near_print(const near_ask *ask, const near_found *f, FILE *out)
{
    if (f->distance) {
        fputs("  distance  ", out);
        print_measure(ask, f->distance, out);
        fputs(f->is_within ? " (within), from " : ", from ", out);
        print_list(proximity_coordinates(ask, f->distance, 0), out);
        fputs(" to ", out);
        print_list(proximity_coordinates(ask, f->distance, 1), out);
        fputc('\n', out);
    }
    if (f->depth) {
        fputs("  depth     ", out);
        print_measure(ask, f->depth, out);
        fputs(", moving B by ", out);
        print_list(proximity_coordinates(ask, f->depth, -1), out);
        fputc('\n', out);
    }
    if (f->row) {
        char *row = app_show_row(f->row, 0, ask->digits);
        fprintf(out, "  row       %s for A, >= for B\n", row);
        free(row);
    }
    if (f->common)
        print_common(ask, f->common, out);
    if (f->stop != FMB_STOP_DONE)
        fprintf(out, "  undecided (%s)\n", fmb_stop_text(f->stop));
}

/* ---- JSON ------------------------------------------------------------------------------------ */

static void put_member(const char *key, json_t *value, FILE *out)
{
    fprintf(out, ", \"%s\": ", key);
    json_dumpf(value, out, JSON_ENCODE_ANY);
    json_decref(value);
}

static json_t *measure_json(const near_ask *ask, const fmb_proximity *p)
{
    json_t *obj = app_need(json_object());
    mpq_t q;
    mpq_init(q);
    fmb_proximity_measure_q(p, q);
    app_json_set(obj, "norm", json_string(ask->norm == FMB_NORM_EUCLIDEAN ? "euclidean" : "max"));
    app_json_set(obj, ask->norm == FMB_NORM_EUCLIDEAN ? "square" : "length",
                 app_json_number(q, ask->digits, APP_NEAREST));
    app_json_set(obj, "shift", proximity_coordinates(ask, p, -1));
    mpq_clear(q);
    return obj;
}

static json_t *distance_json(const near_ask *ask, const fmb_proximity *p)
{
    json_t *obj = measure_json(ask, p);
    mpq_t q;
    mpq_init(q);
    fmb_proximity_time_q(p, q);
    app_json_set(obj, "from", proximity_coordinates(ask, p, 0));
    app_json_set(obj, "to", proximity_coordinates(ask, p, 1));
    app_json_set(obj, "time", app_json_number(q, ask->digits, APP_NEAREST));
    mpq_clear(q);
    return obj;
}

static json_t *common_json(const near_ask *ask, const fmb_generators *g)
{
    json_t *list = app_need(json_array());
    for (size_t i = 0; i < fmb_generators_size(g); i++)
        app_json_append(list, app_json_generator(g, i, ask->digits));
    return list;
}

void near_print_json(const near_ask *ask, const near_found *f, FILE *out)
{
    if (ask->within)
        put_member("within", json_boolean(f->is_within), out);
    if (f->distance)
        put_member("distance", distance_json(ask, f->distance), out);
    if (f->depth)
        put_member("depth", measure_json(ask, f->depth), out);
    if (f->row) {
        json_t *row = app_need(json_object());
        app_json_set_system(row, f->row, ask->digits);
        put_member("separating", row, out);
    }
    if (f->common)
        put_member("common", common_json(ask, f->common), out);
    if (f->stop != FMB_STOP_DONE)
        put_member("stop", json_string(fmb_stop_text(f->stop)), out);
}
