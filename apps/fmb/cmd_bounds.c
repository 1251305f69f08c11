/* cmd_bounds.c: fmb bounds FILE. */
#include <stdlib.h>

#include "common/message.h"
#include "common/table.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/show.h"
#include "fmb/variables.h"
#include "fmb/verdict.h"

enum { KEY_VARS = 0x200 };

static const struct argp_option options[] = {
    {"vars", KEY_VARS, "NAMES", 0, "Only these variables (x,y); all of them if not given", 1}, {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    if (key != KEY_VARS)
        return ARGP_ERR_UNKNOWN;
    if (!app_names_add(state->input, arg))
        argp_error(state, "--vars: given too often");
    return 0;
}

static const struct argp own = {.options = options, .parser = parse};

static const app_usage usage = {
    .args = "FILE",
    .doc =
        "The tightest interval of every variable over the system in FILE, exactly. A round "
        "bracket is an end that no solution reaches; 5? is an end that may be too far out, ? one "
        "that is not known (at a limit)."
        "\v"
        "Exit codes: 0 all ends known, 1 infeasible, 2 undecided.\n"
        "\n"
        "Examples:\n"
        "  fmb bounds diet.fmb\n"
        "  fmb bounds diet.fmb --vars bread,milk --json\n",
    .own = &own,
};

/* Ends of intervals are rounded outward. */
static app_rounding outward(fmb_side side)
{
    return side == FMB_LOWER ? APP_DOWN : APP_UP;
}

static const char *infinity(fmb_side side)
{
    return side == FMB_LOWER ? "-inf" : "inf";
}

/* [give, free()] "1/2", "-inf", or NULL: unknown. */
static char *end_text(const fmb_box *box, int i, fmb_side side, int digits)
{
    if (fmb_box_end(box, i, side).kind == FMB_END_INFINITE)
        return app_print("%s", infinity(side));
    mpq_t q;
    mpq_init(q);
    bool known = fmb_box_end_q(box, i, side, q);
    char *text = known ? app_number(q, digits, outward(side)) : NULL;
    mpq_clear(q);
    return text;
}

/* "[1/2,", "inf)" and "5?]" */
static char *end_cell(const fmb_box *box, int i, fmb_side side, int digits)
{
    char *value = end_text(box, i, side, digits);
    fmb_end end = fmb_box_end(box, i, side);
    bool square = end.attained || end.kind == FMB_END_OUTER;
    const char *opening = side == FMB_UPPER ? "" : square ? "[" : "(";
    const char *closing = side == FMB_LOWER ? "," : square ? "]" : ")";
    char *cell = app_print("%s%s%s%s", opening, value ? value : "",
                           value && end.kind != FMB_END_OUTER ? "" : "?", closing);
    free(value);
    return cell;
}

static void print_box(const app_session *s, const fmb_box *box)
{
    app_table table = {.columns = 3, .align = "lrr"};
    for (int i = 0; i < fmb_box_size(box); i++) {
        app_put_name(&table.text, s->system, fmb_box_var(box, i));
        app_table_end_cell(&table);
        app_table_add(&table, end_cell(box, i, FMB_LOWER, s->ask->digits));
        app_table_add(&table, end_cell(box, i, FMB_UPPER, s->ask->digits));
    }
    app_table_print(&table, stdout);
}

static json_t *end_json(const fmb_box *box, int i, fmb_side side, int digits)
{
    if (fmb_box_end(box, i, side).kind == FMB_END_INFINITE)
        return json_string(infinity(side));
    mpq_t q;
    mpq_init(q);
    bool known = fmb_box_end_q(box, i, side, q);
    json_t *value = known ? app_json_number(q, digits, outward(side)) : json_null();
    mpq_clear(q);
    return value;
}

static bool is_outer(const fmb_box *box, int i, fmb_side side)
{
    return fmb_box_end(box, i, side).kind == FMB_END_OUTER;
}

static bool is_open(const fmb_box *box, int i, fmb_side side)
{
    return is_outer(box, i, side) || fmb_box_end(box, i, side).kind == FMB_END_UNKNOWN;
}

/* Is every end the tightest? */
static bool is_tight(const fmb_box *box)
{
    for (int i = 0; i < fmb_box_size(box); i++)
        if (is_open(box, i, FMB_LOWER) || is_open(box, i, FMB_UPPER))
            return false;
    return true;
}

static json_t *box_json(const app_session *s, const fmb_box *box)
{
    json_t *all = app_need(json_object());
    for (int i = 0; i < fmb_box_size(box); i++) {
        json_t *one = app_need(json_object());
        app_json_set(one, "lower", end_json(box, i, FMB_LOWER, s->ask->digits));
        app_json_set(one, "upper", end_json(box, i, FMB_UPPER, s->ask->digits));
        app_json_set(one, "lower_attained", json_boolean(fmb_box_end(box, i, FMB_LOWER).attained));
        app_json_set(one, "upper_attained", json_boolean(fmb_box_end(box, i, FMB_UPPER).attained));
        if (is_outer(box, i, FMB_LOWER))
            app_json_set(one, "lower_outer", json_true());
        if (is_outer(box, i, FMB_UPPER))
            app_json_set(one, "upper_outer", json_true());
        app_json_set_variable(all, s->system, fmb_box_var(box, i), one);
    }
    return all;
}

static void report(const app_session *s, const fmb_box *box)
{
    if (s->ask->json) {
        json_t *obj = app_verdict_json(s);
        if (box && !is_tight(box))
            app_json_set(obj, "outer", json_true());
        if (box)
            app_json_set(obj, "bounds", box_json(s, box));
        app_json_set_stats(obj, &s->result.stats);
        app_json_print(obj);
    } else if (app_session_reports(s)) {
        if (box)
            print_box(s, box);
        else
            app_verdict_print(s);
    }
}

static int exit_code(const app_session *s, const fmb_box *box)
{
    if (!box)
        return s->result.verdict == FMB_INFEASIBLE ? APP_NO : app_session_undecided(s, NULL);
    if (is_tight(box))
        return APP_YES;
    return app_session_undecided(s, "an outer box");
}

int cmd_bounds(int argc, char **argv)
{
    app_ask ask;
    app_names names = {.option = "--vars"};
    app_ask_parse(&ask, &usage, &names, argc, argv);
    app_session s;
    int *vars = NULL, n = 0;
    fmb_box *box = NULL;
    int code = app_session_open(&s, &ask);
    if (code == 0 && names.lists > 0)
        code = app_names_select(&names, s.system, true, &vars, &n);
    if (code == 0) {
        app_integers_note(&s);
        app_session_begin(&s);
        fmb_status st = fmb_bound(s.solver, s.system, vars, n, &box, &s.result);
        code = app_session_end(&s, st);
    }
    if (code == 0) {
        report(&s, box);
        code = exit_code(&s, box);
    }
    fmb_box_free(box);
    free(vars);
    return app_session_close(&s, code);
}
