/* cmd_solve.c: fmb solve FILE. */
#include "common/message.h"
#include "fmb/commands.h"
#include "fmb/integers.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

static const app_usage usage = {
    .args = "FILE",
    .doc =
        "Is the system in FILE feasible? Prints a point that satisfies every row, or the rows in "
        "conflict: with their multipliers they add up to 0 <= negative, or 0 < 0."
        "\v"
        "Exit codes: 0 feasible, 1 infeasible, 2 undecided, or feasible over the reals where no "
        "integral point was found for the integer variables of the file.\n"
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

int cmd_solve(int argc, char **argv)
{
    app_ask ask;
    app_ask_parse(&ask, &usage, NULL, argc, argv);
    app_session s;
    int code = app_session_open(&s, &ask);
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
