/* query.c: see query.h. */
#include "fmb/query.h"

#include <fmb/rule.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "common/budget.h"
#include "common/file.h"
#include "common/json.h"
#include "common/message.h"
#include "common/nearest.h"

int app_session_open_outputs(app_session *s)
{
    int code = APP_YES;
    if (s->ask->trace)
        code = app_file_create(s->ask->trace, &s->trace);
    if (code == APP_YES && s->ask->proof)
        code = app_file_create(s->ask->proof, &s->proof);
    return code;
}

static const char *initial_of(const char *name)
{
    const fmb_option_info *info;
    for (size_t i = 0; (info = fmb_options_describe(i)) != NULL; i++)
        if (strcmp(info->name, name) == 0)
            return info->initial;
    return "";
}

/* Report an option that the parser could not check: instructions that this processor lacks, or an
 * unknown step of the presolve. */
static int bad_option(const app_ask *ask)
{
    fmb_options o = ask->options;
    fmb_solver *v = NULL;
    o.simd = FMB_SIMD_AUTO;
    fmb_status st = fmb_solver_new(&o, NULL, &v);
    fmb_solver_free(v);
    if (st == FMB_OK)
        return app_error(APP_USAGE, "--simd: this processor has no such instructions");
    return app_error(APP_USAGE, "--presolve '%s': expected none, or some of %s",
                     o.presolve ? o.presolve : "", initial_of("presolve"));
}

/* The names of the rules there are, separated by commas. */
static void list_rules(const app_rule_library *own, char *out, size_t size)
{
    const fmb_rule *rule;
    size_t used = 0;
    for (size_t i = 0; used < size && (rule = fmb_rule_at(i)) != NULL; i++)
        used += (size_t)snprintf(out + used, size - used, "%s%s", i > 0 ? "," : "", rule->name);
    for (size_t i = 0; used < size && own->rule && own->rule[i]; i++)
        used += (size_t)snprintf(out + used, size - used, ",%s", own->rule[i]->name);
}

/* "; did you mean ...?" for the first word of the list that is no rule. */
static const char *hint_at_rule(const app_rule_library *own, const char *rules,
                                char hint[APP_HINT_SIZE])
{
    char word[64];
    for (const char *w = rules; *w; w += strcspn(w, ","), w += *w == ',') {
        const fmb_rule *rule;
        snprintf(word, sizeof word, "%.*s", (int)strcspn(w, ","), w);
        app_nearest near = app_nearest_to(word);
        for (size_t i = 0; (rule = fmb_rule_at(i)) != NULL; i++)
            app_nearest_try(&near, rule->name);
        for (size_t i = 0; own->rule && own->rule[i]; i++)
            app_nearest_try(&near, own->rule[i]->name);
        if (near.best && near.distance > 0)
            return app_nearest_hint(&near, hint);
    }
    return "";
}

static int bad_rules(const app_session *s)
{
    char known[256] = "", hint[APP_HINT_SIZE];
    const char *rules = s->ask->options.rules;
    list_rules(&s->library, known, sizeof known);
    return app_error(APP_USAGE, "--rules '%s': expected none, or some of %s%s", rules ? rules : "",
                     known, hint_at_rule(&s->library, rules ? rules : "", hint));
}

/* Open the rules, separated into those of an external library and those known by name. */
static int open_rules(app_session *s)
{
    int code = APP_YES;
    if (s->ask->rule_library)
        code = app_rule_library_open(s->ask->rule_library, &s->library);
    if (code == APP_YES && s->ask->order && !app_rule_library_order(&s->library, s->ask->order))
        code = app_rule_library_refuse_order(&s->library, "--order", s->ask->order);
    return code == APP_YES ? app_rule_library_split(&s->library, s->ask->options.rules, &s->rules)
                           : code;
}

/* Set an order of an external library, if one was requested. */
static void set_order(const app_session *s)
{
    if (s->ask->order)
        fmb_solver_set_chooser(s->solver,
                               app_rule_library_order(&s->library, s->ask->order)->chooser);
}

/* Make a solver with the options of the session, replacing an existing one. */
static int make_solver(app_session *s)
{
    fmb_options o = s->options;
    o.rules = s->rules.words;
    fmb_solver_free(s->solver);
    s->solver = NULL;
    fmb_status st = fmb_solver_new(&o, NULL, &s->solver);
    if (st == FMB_OK)
        st = app_rule_set_add(&s->rules, s->solver);
    if (st == FMB_ERR_RULE)
        return bad_rules(s);
    if (st == FMB_ERR_ARG)
        return bad_option(s->ask);
    if (st == FMB_OK)
        set_order(s);
    return st == FMB_OK ? APP_YES : app_status_error(st);
}

static int open_solver(app_session *s)
{
    int code = open_rules(s);
    app_budget_begin(s->options.max_bytes);
    return code == APP_YES ? make_solver(s) : code;
}

int app_session_end_reading(app_session *s, int code)
{
    size_t left = app_budget_end();
    if (code == APP_UNDECIDED && s->ask->json)
        app_json_print_unread();
    if (code != APP_YES || left == s->options.max_bytes)
        return code;
    s->options.max_bytes = left;
    return make_solver(s);
}

/* Outputs are opened after the input was read, so that an output that is the input is refused, and
 * before the query, so that a missing folder is not reported only after an hour. */
int app_session_open_solver(app_session *s, const app_ask *ask)
{
    *s = (app_session){.ask = ask, .options = ask->options, .result = {.size = sizeof s->result}};
    return open_solver(s);
}

int app_session_open(app_session *s, const app_ask *ask)
{
    int code = app_session_open_solver(s, ask);
    if (code == APP_YES)
        code = app_session_end_reading(s, app_source_read(&ask->source, &s->system));
    return code == APP_YES ? app_session_open_outputs(s) : code;
}

void app_session_begin(app_session *s)
{
    fmb_sink trace = {NULL, NULL};
    if (s->trace)
        trace = fmb_sink_jsonl(s->trace);
    app_watch_begin(&s->watch, s->solver, trace, s->ask->source.quiet);
}

int app_session_end(app_session *s, fmb_status st)
{
    app_watch_end(&s->watch);
    s->answered |= st == FMB_OK && s->result.stop == FMB_STOP_DONE;
    s->rules_worked |= s->result.stats.rounds > 0 || s->result.stats.rows_dropped > 0;
    if (st == FMB_ERR_RULE || (st == FMB_ERR_ARG && s->ask->rule_library))
        return app_error(APP_USAGE, "%s", fmb_solver_trouble(s->solver));
    if (st != FMB_OK || s->ask->options.evidence == FMB_EVIDENCE_NONE)
        return st == FMB_OK ? APP_YES : app_status_error(st);
    st = fmb_solver_evidence(s->solver, &s->evidence);
    return st == FMB_OK || st == FMB_ERR_STATE ? APP_YES : app_status_error(st);
}

bool app_session_reports(const app_session *s)
{
    return !app_ask_proof_only(s->ask);
}

int app_session_verdict_code(const app_session *s)
{
    switch (s->result.verdict) {
    case FMB_FEASIBLE:
        return APP_YES;
    case FMB_INFEASIBLE:
        return APP_NO;
    case FMB_UNKNOWN:
        break;
    }
    return app_session_undecided(s, NULL);
}

void app_session_note(const app_session *s, const char *format, ...)
{
    if (s->ask->source.quiet)
        return;
    va_list args;
    va_start(args, format);
    fputs("fmb: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
}

int app_session_undecided(const app_session *s, const char *what)
{
    app_session_note(s, "undecided (%s)%s%s", fmb_stop_text(s->result.stop), what ? ": " : "",
                     what ? what : "");
    return APP_UNDECIDED;
}

/* If rules were named, note when a query was answered without any, as by linear programs. */
static void note_idle_rules(const app_session *s)
{
    const char *rules = s->ask->options.rules;
    if (rules && strcmp(rules, "none") != 0 && s->answered && !s->rules_worked)
        app_session_note(s, "--rules had no effect: no rows were paired");
}

int app_session_proof_error(const char *path, fmb_status st)
{
    if (st == FMB_ERR_IO)
        return APP_YES;
    return st == FMB_ERR_RANGE
               ? app_error(APP_CANNOT_WRITE, "%s: a number is too long for a proof", path)
               : app_status_error(st);
}

/* Write the proof; an incomplete one is discarded. */
static int write_proof(app_session *s)
{
    if (!s->proof)
        return APP_YES;
    if (!s->evidence || fmb_evidence_claims(s->evidence) == 0) {
        app_session_note(s, "nothing was proved: %s is empty", s->ask->proof);
        return APP_YES;
    }
    fmb_status st = fmb_evidence_write(s->evidence, s->system, s->proof);
    int code = st == FMB_OK ? APP_YES : app_session_proof_error(s->ask->proof, st);
    if (code != APP_YES) {
        app_file_discard(s->proof);
        s->proof = NULL;
    }
    return code;
}

int app_session_close(app_session *s, int code)
{
    if (code >= APP_USAGE) { /* older files are kept */
        app_file_discard(s->proof);
        app_file_discard(s->trace);
        s->proof = s->trace = NULL;
    }
    if (code < APP_USAGE)
        note_idle_rules(s);
    int failed = write_proof(s);
    int closed = app_file_close(s->proof, s->ask->proof);
    failed = failed ? failed : closed;
    closed = app_file_close(s->trace, s->ask->trace);
    failed = failed ? failed : closed;
    fmb_evidence_free(s->evidence);
    fmb_system_free(s->system);
    fmb_solver_free(s->solver);
    free(s->rules.words);
    app_rule_library_close(&s->library);
    return failed ? failed : code;
}
