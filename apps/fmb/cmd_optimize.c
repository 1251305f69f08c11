/* cmd_optimize.c: fmb optimize FILE. */
#include <stdlib.h>

#include "common/form.h"
#include "common/message.h"
#include "common/table.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

enum { KEY_MAX = 0x200, KEY_MIN };

static const struct argp_option options[] = {
    {"max", KEY_MAX, "FORM", 0, "Maximize this linear form (3x + 2y)", 1},
    {"min", KEY_MIN, "FORM", 0, "Minimize this one; without either, the objective of FILE", 1},
    {0}};

typedef struct request {
    fmb_sense sense; /* NONE: take the objective of the file */
    const char *form;
} request;

static error_t parse(int key, char *arg, struct argp_state *state)
{
    request *r = state->input;
    if (key != KEY_MAX && key != KEY_MIN)
        return ARGP_ERR_UNKNOWN;
    if (r->form)
        argp_error(state, "--max or --min: given more than once");
    r->sense = key == KEY_MAX ? FMB_SENSE_MAX : FMB_SENSE_MIN;
    r->form = arg;
    return 0;
}

static const struct argp own = {.options = options, .parser = parse};

static const app_usage usage = {
    .args = "FILE",
    .doc =
        "The best value of a linear form over the system in FILE, exactly; a point where it is "
        "reached; and the rows that prove it, with the multipliers of the combination that bounds "
        "the form by this value. A value that no solution reaches is printed as sup or inf, with "
        "the point that solutions approach (->)."
        "\v"
        "FORM is written as in .fmb files, with the names of FILE. Exit codes: 0 the value is "
        "known, or the form is unbounded; 1 infeasible; 2 undecided, or known over the reals while "
        "FILE has integer variables.\n"
        "\n"
        "Examples:\n"
        "  fmb optimize diet.fmb --min '0.4 bread + 0.35 milk'\n"
        "  fmb optimize netlib.mps --max-seconds 10 --json\n"
        "  fmb optimize plan.fmb --proof - | fmb check plan.fmb - --expect optimum\n",
    .own = &own,
    .shows_claims = true,
};

/* The objective of the file, or that of the command line in its place. */
static int choose_objective(const request *r, app_session *s)
{
    if (r->form)
        return app_form_read(r->sense == FMB_SENSE_MAX ? "--max" : "--min", r->form, r->sense,
                             s->system);
    if (fmb_system_sense(s->system) != FMB_SENSE_NONE)
        return APP_YES;
    return app_error(APP_USAGE, "the file has no objective: say --max FORM or --min FORM");
}

static bool is_known(const fmb_optimum *o)
{
    fmb_end_kind kind = fmb_optimum_end(o).kind;
    return kind == FMB_END_FINITE || kind == FMB_END_INFINITE;
}

/* Is there a point worth reporting? */
static bool has_point(const app_session *s, const fmb_optimum *o)
{
    return o && s->result.verdict == FMB_FEASIBLE;
}

/* The value of the form at the point. */
static void evaluate_at_point(const app_session *s, const fmb_optimum *o, mpq_t out)
{
    mpq_t c, x;
    mpq_inits(c, x, NULL);
    fmb_system_objective_constant_q(s->system, out);
    for (size_t k = 0; k < fmb_system_objective_terms(s->system); k++) {
        fmb_optimum_coordinate_q(o, fmb_system_objective_term_q(s->system, k, c), x);
        mpq_mul(c, c, x);
        mpq_add(out, out, c);
    }
    mpq_clears(c, x, NULL);
}

/* ---- text ------------------------------------------------------------------------------------ */

/* After a limit, by what is known: "40 <= max <= 43", "max >= 40", "max <= 43", "unknown (rows)".
 */
static void print_value_at_limit(const app_session *s, const fmb_optimum *o)
{
    bool max = fmb_optimum_sense(o) == FMB_SENSE_MAX, point = has_point(s, o);
    bool outer = fmb_optimum_end(o).kind == FMB_END_OUTER;
    const char *word = max ? "max" : "min";
    mpq_t end, reached;
    mpq_inits(end, reached, NULL);
    fmb_optimum_value_q(o, end);
    if (point)
        evaluate_at_point(s, o, reached);
    char *low = app_number(max ? reached : end, s->ask->digits, APP_DOWN);
    char *high = app_number(max ? end : reached, s->ask->digits, APP_UP);
    if (outer && point)
        printf("%s <= %s <= %s\n", low, word, high);
    else if (outer || point)
        printf("%s %s %s\n", word, max == outer ? "<=" : ">=", max == outer ? high : low);
    else
        printf("unknown (%s)\n", fmb_stop_text(s->result.stop));
    free(low);
    free(high);
    mpq_clears(end, reached, NULL);
}

/* "max over the reals = 13/2", "inf = 0, not attained", "unbounded above" */
static void print_value(const app_session *s, const fmb_optimum *o)
{
    static const char *const word[][2] = {{"inf", "sup"}, {"min", "max"}};
    fmb_end end = fmb_optimum_end(o);
    bool max = fmb_optimum_sense(o) == FMB_SENSE_MAX;
    const char *reals = s->relaxed ? " over the reals" : "";
    mpq_t value;
    mpq_init(value);
    fmb_optimum_value_q(o, value);
    char *text = app_number(value, s->ask->digits, APP_NEAREST);
    if (end.kind == FMB_END_FINITE)
        printf("%s%s = %s%s\n", word[end.attained][max], reals, text,
               end.attained ? "" : ", not attained");
    else if (end.kind == FMB_END_INFINITE)
        printf("unbounded %s%s\n", max ? "above" : "below", reals);
    else
        print_value_at_limit(s, o);
    free(text);
    mpq_clear(value);
}

/* The letter along which a ray goes: t, unless a variable is called that. */
static const char *ray_letter(const fmb_system *s)
{
    static const char *const letter[] = {"t", "s", "r", "lambda"};
    size_t i = 0;
    while (i < 3 && fmb_system_find(s, letter[i]) >= 0)
        i++;
    return letter[i];
}

/* "3", "3 + 1/2 t", "-t" */
static void put_coordinate(app_buffer *out, const app_session *s, const fmb_optimum *o, int j,
                           mpq_t q)
{
    fmb_optimum_coordinate_q(o, j, q);
    bool start = mpq_sgn(q) != 0;
    if (start)
        app_put_number(out, q, s->ask->digits);
    fmb_optimum_ray_q(o, j, q);
    int sign = mpq_sgn(q);
    if (!start && sign == 0)
        app_buffer_put(out, "0");
    if (sign == 0)
        return;
    app_buffer_put(out, start ? (sign < 0 ? " - " : " + ") : (sign < 0 ? "-" : ""));
    mpq_abs(q, q);
    if (mpq_cmp_ui(q, 1, 1) != 0) {
        app_put_number(out, q, s->ask->digits);
        app_buffer_put(out, " ");
    }
    app_buffer_put(out, ray_letter(s->system));
}

static void print_coordinates(const app_session *s, const fmb_optimum *o)
{
    fmb_end end = fmb_optimum_end(o);
    bool limit = end.kind == FMB_END_FINITE && !end.attained;
    app_table table = {.columns = 3, .align = "lll"};
    mpq_t q;
    mpq_init(q);
    for (int j = 0; j < fmb_system_dim(s->system); j++) {
        app_put_name(&table.text, s->system, j);
        app_table_end_cell(&table);
        app_table_put(&table, limit ? "->" : "=");
        put_coordinate(&table.text, s, o, j, q);
        app_table_end_cell(&table);
    }
    mpq_clear(q);
    app_table_print(&table, stdout);
    if (end.kind == FMB_END_INFINITE)
        printf("for all %s >= 0\n", ray_letter(s->system));
}

/* "sum: -2 x - y <= -13/2, that is 2 x + y - 1 >= 11/2": the rows add up to an upper end of the
 * form, or of its negative; the constant counts for nothing before. */
static void print_sum(const app_session *s, const fmb_optimum *o, const mpq_t sum, bool strict)
{
    static const char *const relation[][2] = {{">=", "<="}, {">", "<"}};
    bool max = fmb_optimum_sense(o) == FMB_SENSE_MAX;
    mpq_t value, constant;
    mpq_inits(value, constant, NULL);
    fmb_system_objective_constant_q(s->system, constant);
    int digits = s->ask->digits;
    char *form = app_show_objective(s->system, max ? 1 : -1, false, digits);
    char *text = app_number(sum, digits, APP_NEAREST);
    printf("sum: %s %s %s", form, strict ? "<" : "<=", text);
    free(text);
    free(form);
    if (!max || mpq_sgn(constant) != 0) {
        fmb_optimum_value_q(o, value);
        form = app_show_objective(s->system, 1, true, digits);
        text = app_number(value, digits, APP_NEAREST);
        printf(", that is %s %s %s", form, relation[strict][max], text);
        free(text);
        free(form);
    }
    putchar('\n');
    mpq_clears(value, constant, NULL);
}

/* The claim whose multipliers prove the value; SIZE_MAX: none. */
static size_t find_value_claim(const app_session *s, const fmb_optimum *o)
{
    fmb_end_kind kind = fmb_optimum_end(o).kind;
    return kind == FMB_END_FINITE  ? app_verdict_claim(s, FMB_CLAIM_BOUND)
           : kind == FMB_END_OUTER ? app_verdict_claim(s, FMB_CLAIM_IMPLIED)
                                   : SIZE_MAX;
}

static void print_optimum(const app_session *s, const fmb_optimum *o)
{
    print_value(s, o);
    if (has_point(s, o))
        print_coordinates(s, o);
    size_t claim = find_value_claim(s, o);
    if (claim == SIZE_MAX)
        return;
    bool strict;
    mpq_t sum;
    mpq_init(sum);
    app_verdict_print_multipliers(s, claim, sum, &strict);
    print_sum(s, o, sum, strict && !fmb_optimum_end(o).attained);
    mpq_clear(sum);
}

/* ---- JSON ------------------------------------------------------------------------------------ */

static json_t *value_json(const app_session *s, const fmb_optimum *o)
{
    fmb_end end = fmb_optimum_end(o);
    bool max = fmb_optimum_sense(o) == FMB_SENSE_MAX;
    app_rounding beyond = max ? APP_UP : APP_DOWN, before = max ? APP_DOWN : APP_UP;
    json_t *obj = app_need(json_object()), *value = json_null();
    mpq_t q;
    mpq_init(q);
    if (fmb_optimum_value_q(o, q))
        value =
            app_json_number(q, s->ask->digits, end.kind == FMB_END_OUTER ? beyond : APP_NEAREST);
    else if (end.kind == FMB_END_INFINITE)
        value = json_string(max ? "inf" : "-inf");
    app_json_set(obj, "value", value);
    app_json_set(obj, "attained", json_boolean(end.attained));
    if (end.kind == FMB_END_OUTER)
        app_json_set(obj, "outer", json_true());
    if (!is_known(o) && has_point(s, o)) {
        evaluate_at_point(s, o, q);
        app_json_set(obj, "reached", app_json_number(q, s->ask->digits, before));
    }
    mpq_clear(q);
    return obj;
}

typedef void coordinate_of(const fmb_optimum *o, int j, mpq_t out);

static json_t *coordinates_json(const app_session *s, const fmb_optimum *o, coordinate_of *of)
{
    json_t *obj = app_need(json_object());
    mpq_t q;
    mpq_init(q);
    for (int j = 0; j < fmb_system_dim(s->system); j++) {
        of(o, j, q);
        app_json_set_variable(obj, s->system, j, app_json_number(q, s->ask->digits, APP_NEAREST));
    }
    mpq_clear(q);
    return obj;
}

static void report_json(const app_session *s, const fmb_optimum *o)
{
    json_t *obj = app_verdict_json(s);
    app_json_set_objective(obj, s->system, s->ask->digits);
    if (o) {
        fmb_end end = fmb_optimum_end(o);
        bool limit = end.kind == FMB_END_FINITE && !end.attained;
        app_json_set(obj, "optimum", value_json(s, o));
        if (has_point(s, o))
            app_json_set(obj, limit ? "limit" : "witness",
                         coordinates_json(s, o, fmb_optimum_coordinate_q));
        if (end.kind == FMB_END_INFINITE)
            app_json_set(obj, "ray", coordinates_json(s, o, fmb_optimum_ray_q));
        size_t claim = find_value_claim(s, o);
        if (claim != SIZE_MAX)
            app_json_set(obj, "multipliers", app_json_multipliers(s, claim));
    }
    app_json_set_stats(obj, &s->result.stats);
    app_json_print(obj);
}

/* ---- the command ----------------------------------------------------------------------------- */

static void report(const app_session *s, const fmb_optimum *o)
{
    if (s->ask->json)
        report_json(s, o);
    else if (app_session_reports(s) && o)
        print_optimum(s, o);
    else if (app_session_reports(s))
        app_verdict_print(s);
}

static int exit_code(const app_session *s, const fmb_optimum *o)
{
    if (!o)
        return s->result.verdict == FMB_INFEASIBLE ? APP_NO : app_session_undecided(s, NULL);
    if (is_known(o))
        return s->relaxed && !s->ask->relax ? APP_UNDECIDED : APP_YES;
    bool bounds = fmb_optimum_end(o).kind == FMB_END_OUTER || has_point(s, o);
    return app_session_undecided(s, bounds ? "bounds of the optimum" : NULL);
}

int cmd_optimize(int argc, char **argv)
{
    app_ask ask;
    request r = {.sense = FMB_SENSE_NONE};
    app_ask_parse(&ask, &usage, &r, argc, argv);
    app_session s;
    fmb_optimum *o = NULL;
    int code = app_session_open(&s, &ask);
    if (code == 0)
        code = choose_objective(&r, &s);
    if (code == 0) {
        app_session_begin(&s);
        fmb_status st = fmb_optimize(s.solver, s.system, NULL, &o, &s.result);
        code = app_session_end(&s, st);
    }
    if (code == 0) {
        app_integers_judge(&s, o);
        report(&s, o);
        code = exit_code(&s, o);
    }
    fmb_optimum_free(o);
    return app_session_close(&s, code);
}
