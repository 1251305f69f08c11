/* cmd_solve.c: fmb solve FILE. */
#include "common/file.h"
#include "common/message.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/script.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

static const app_usage usage = {
    .args = "FILE",
    .doc =
        "Is the system in FILE feasible? Prints a point that satisfies every row, or the rows in "
        "conflict: with their multipliers they add up to 0 <= negative, or 0 < 0. An SMT-LIB "
        "script "
        "with push, pop or several check-sat is answered check by check: sat, unsat or unknown."
        "\v"
        "Exit codes: 0 feasible, 1 infeasible, 2 undecided, or feasible over the reals where no "
        "integral point was found for the integer variables of the file. Of a script: 2 if some "
        "check is undecided, else that of the last. --proof p.proof of a script writes p.1.proof "
        "and p.1.fmb, the rows that it speaks of, and so on.\n"
        "\n"
        "Examples:\n"
        "  fmb solve diet.fmb\n"
        "  fmb solve netlib.mps --max-seconds 10 --json\n"
        "  fmb solve plan.smt2 --proof - | fmb check plan.smt2 -\n",
};

static void report_json(const app_session *s)
{
    json_t *obj = app_verdict_json(s);
    if (s->result.verdict == FMB_FEASIBLE)
        app_json_set_witness(obj, s);
    app_json_set_stats(obj, &s->result.stats);
    app_json_print(obj);
}

static void report(const app_session *s)
{
    if (s->ask->json)
        report_json(s);
    else if (app_session_reports(s))
        app_verdict_print(s);
}

/* A script with one question becomes the system; one with several becomes *script. */
static int open_script(app_session *s, app_source *source, fmb_script **script)
{
    fmb_where where = {0};
    int code = app_source_read_script(source, script);
    if (code != APP_YES)
        return code;
    if (!fmb_script_asks_often(*script)) {
        fmb_status st = fmb_script_whole(*script, &s->system, &where);
        fmb_script_free(*script);
        *script = NULL;
        code = app_source_outcome(st, source->file, &where);
        return code == APP_YES ? app_session_open_outputs(s) : code;
    }
    if (app_ask_proof_only(s->ask))
        return app_error(APP_USAGE, "--proof -: each answer of a script has a proof of its own");
    if (s->ask->digits > 0 && !s->ask->json)
        return app_error(APP_USAGE, "--decimal: answers to a script are SMT-LIB, which is exact; "
                                    "--json has both");
    return s->ask->trace ? app_file_create(s->ask->trace, &s->trace) : APP_YES;
}

static int open_session(app_session *s, const app_ask *ask, app_source *source, fmb_script **script)
{
    if (!app_source_is_script(source))
        return app_session_open(s, ask);
    int code = app_session_open_solver(s, ask);
    return code == APP_YES ? app_session_end_reading(s, open_script(s, source, script)) : code;
}

int cmd_solve(int argc, char **argv)
{
    app_ask ask;
    app_ask_parse(&ask, &usage, NULL, argc, argv);
    app_session s;
    app_source source = ask.source;
    fmb_script *script = NULL;
    int code = open_session(&s, &ask, &source, &script);
    if (code == 0 && script) {
        code = app_script_answer(&s, script, source.file);
        fmb_script_free(script);
        return app_session_close(&s, code);
    }
    fmb_script_free(script);
    if (code == 0 && fmb_system_sense(s.system) != FMB_SENSE_NONE)
        app_session_note(&s, "the objective does not count here: `fmb optimize` answers it");
    if (code == 0) {
        app_session_begin(&s);
        fmb_status st = fmb_solve(s.solver, s.system, &s.result);
        code = app_session_end(&s, st);
    }
    if (code == 0)
        code = app_integers_seek(&s);
    if (code == 0) {
        report(&s);
        code = s.relaxed && !ask.relax ? APP_UNDECIDED : app_session_verdict_code(&s);
    }
    return app_session_close(&s, code);
}
