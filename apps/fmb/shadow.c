/* shadow.c: see shadow.h. */
#include "fmb/shadow.h"

#include "common/exit_code.h"
#include "common/json.h"
#include "fmb/show.h"
#include "fmb/verdict.h"

static void report_json(const app_session *s, const fmb_system *shadow)
{
    json_t *obj = app_verdict_json(s);
    if (s->result.stop != FMB_STOP_DONE)
        app_json_set(obj, "outer", json_true());
    if (shadow)
        app_json_set_system(obj, shadow);
    app_json_set_stats(obj, &s->result.stats);
    app_json_print(obj);
}

int app_shadow_report(const app_session *s, const fmb_system *shadow, fmb_format to)
{
    int code = APP_YES;
    if (s->ask->json)
        report_json(s, shadow);
    else if (shadow && app_session_reports(s))
        code = app_source_write(shadow, to);
    if (code != APP_YES)
        return code;
    if (s->result.stop == FMB_STOP_DONE)
        return app_session_verdict_code(s);
    app_session_note(s, "undecided (%s)%s", fmb_stop_text(s->result.stop),
                     shadow ? ": an outer projection" : "");
    return APP_UNDECIDED;
}
