/* cmd_reduce.c: fmb reduce FILE. */
#include <stdlib.h>

#include "common/message.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

enum { KEY_TO = 0x200 };

static const struct argp_option options[] = {{"to", KEY_TO, APP_FORMATS_TO, 0,
                                              "Write this format (default: that of FILE where it "
                                              "can be written, else fmb)",
                                              1},
                                             {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    if (key != KEY_TO)
        return ARGP_ERR_UNKNOWN;
    if (!app_format_to(arg, state->input))
        argp_error(state, "--to: expected " APP_FORMATS_TO ", found '%s'", arg);
    return 0;
}

static const struct argp own = {.options = options, .parser = parse};

static const app_usage usage = {
    .args = "FILE",
    .doc = "An irredundant system with the same solutions as the one in FILE: some of its rows, "
           "with inequalities that always hold with equality written as equalities. Standard error "
           "lists the redundant rows, and the rows that imply each."
           "\v"
           "Exit codes: 0 done, 1 infeasible, 2 undecided (rows not yet tested are kept).\n"
           "\n"
           "Examples:\n"
           "  fmb reduce shape.ine > small.ine\n"
           "  fmb reduce shape.ine --proof shape.proof --json\n",
    .own = &own,
    .shows_claims = true,
};

/* ---- why rows went --------------------------------------------------------------------------- */

/* "2 * row 3 + 1 * row 5" */
static void put_combination(const app_session *s, size_t claim)
{
    mpq_t q;
    mpq_init(q);
    bool first = true;
    for (size_t i = fmb_evidence_next_row(s->evidence, claim, 0); i != SIZE_MAX;
         i = fmb_evidence_next_row(s->evidence, claim, i + 1)) {
        fmb_evidence_multiplier_q(s->evidence, claim, i, q);
        char *text = app_number(q, s->ask->digits, APP_NEAREST);
        fprintf(stderr, "%s%s * row %zu", first ? "" : " + ", text, i + 1);
        free(text);
        first = false;
    }
    if (first)
        fputs("always true", stderr);
    mpq_clear(q);
}

static void print_reasons(const app_session *s)
{
    for (size_t i = 0; s->evidence && i < fmb_evidence_claims(s->evidence); i++) {
        fmb_claim_kind kind = fmb_evidence_kind(s->evidence, i);
        if (kind != FMB_CLAIM_REDUNDANT && kind != FMB_CLAIM_EQUALITY)
            continue;
        char *name = app_show_row_name(s->system, fmb_evidence_row(s->evidence, i));
        fprintf(stderr, "%s %s: ", name,
                kind == FMB_CLAIM_REDUNDANT ? "redundant" : "always an equality");
        put_combination(s, i);
        fputc('\n', stderr);
        free(name);
    }
}

static json_t *removed_json(const app_session *s)
{
    json_t *list = app_need(json_array());
    for (size_t i = 0; s->evidence && i < fmb_evidence_claims(s->evidence); i++) {
        if (fmb_evidence_kind(s->evidence, i) != FMB_CLAIM_REDUNDANT)
            continue;
        json_t *item = app_json_row_name(s->system, fmb_evidence_row(s->evidence, i));
        app_json_set(item, "reason", json_string("redundant"));
        app_json_set(item, "multipliers", app_json_multipliers(s, i));
        app_json_append(list, item);
    }
    return list;
}

static json_t *equalities_json(const app_session *s, const fmb_fate *fate)
{
    json_t *list = app_need(json_array());
    for (size_t i = 0; i < fmb_system_rows(s->system); i++)
        if (fate[i] == FMB_FATE_EQUALITY)
            app_json_append(list, json_integer((json_int_t)i + 1));
    return list;
}

/* ---- the report ------------------------------------------------------------------------------ */

static size_t untested(const app_session *s, const fmb_fate *fate)
{
    size_t n = 0;
    for (size_t i = 0; i < fmb_system_rows(s->system); i++)
        n += fate[i] == FMB_FATE_UNKNOWN;
    return n;
}

static void report_json(const app_session *s, const fmb_fate *fate, const fmb_system *small)
{
    json_t *obj = app_verdict_json(s);
    if (small)
        app_json_set_system(obj, small, s->ask->digits);
    app_json_set(obj, "removed", removed_json(s));
    app_json_set(obj, "equalities", equalities_json(s, fate));
    app_json_set_stats(obj, &s->result.stats);
    app_json_print(obj);
}

/* small NULL: there is no memory for it; the system as read has the same solutions. */
static int report(const app_session *s, fmb_format to, const fmb_fate *fate,
                  const fmb_system *small)
{
    if (s->ask->json) {
        report_json(s, fate, small);
        return APP_YES;
    }
    if (!s->ask->source.quiet)
        print_reasons(s);
    if (!app_session_reports(s))
        return APP_YES;
    return app_source_write(small ? small : s->system,
                            to ? to : app_source_written(&s->ask->source));
}

static int exit_code(const app_session *s, const fmb_fate *fate, const fmb_system *small)
{
    if (s->result.verdict == FMB_INFEASIBLE)
        return APP_NO;
    if (s->result.stop == FMB_STOP_DONE)
        return APP_YES;
    app_session_note(s, "undecided (%s): %zu rows not tested%s", fmb_stop_text(s->result.stop),
                     untested(s, fate), small ? "" : "; all rows are kept unchanged");
    return APP_UNDECIDED;
}

int cmd_reduce(int argc, char **argv)
{
    app_ask ask;
    fmb_format to = FMB_FORMAT_AUTO;
    app_ask_parse(&ask, &usage, &to, argc, argv);
    app_session s;
    fmb_fate *fate = NULL;
    fmb_system *small = NULL;
    int code = app_session_open(&s, &ask);
    if (code == 0) {
        fate = app_need(calloc(fmb_system_rows(s.system) + 1, sizeof *fate));
        app_integers_note(&s);
        app_session_begin(&s);
        fmb_status st = fmb_reduce(s.solver, s.system, fate, &small, &s.result);
        code = app_session_end(&s, st);
    }
    if (code == 0)
        code = report(&s, to, fate, small);
    if (code == 0)
        code = exit_code(&s, fate, small);
    fmb_system_free(small);
    free(fate);
    return app_session_close(&s, code);
}
