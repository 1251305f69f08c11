/* query.h: one question to the solver from its command line to its exit code.
 *
 *   app_session_open -> app_session_begin -> the query -> app_session_end -> a report
 *                    -> app_session_close
 */
#ifndef APP_QUERY_H
#define APP_QUERY_H

#include <fmb/solve.h>

#include "common/rule_library.h"
#include "fmb/ask.h"
#include "fmb/watch.h"

typedef struct app_session {
    const app_ask *ask;
    fmb_options options; /* those asked for, with what is left of max_bytes once all is read */
    app_rule_library library;
    app_rule_set rules;
    fmb_solver *solver;
    fmb_system *system;
    FILE *trace, *proof;
    app_watch watch;
    fmb_result result;
    fmb_evidence *evidence; /* NULL if nothing was proved */
    bool relaxed;           /* the file has integers, and the answer is over the reals */
    bool answered;          /* some query was, to its end */
    bool rules_worked;      /* rows were paired, or a rule dropped some */
} app_session;

/* Check the options, read the system, open the outputs: APP_YES, or an exit code after a message.
 * app_session_close is due in any case. */
int app_session_open(app_session *s, const app_ask *ask);
/* The same in steps, for commands that read more than a system between them. */
int app_session_open_solver(app_session *s, const app_ask *ask);
int app_session_open_outputs(app_session *s);
/* All is read, with that code: the query gets what is left of the memory. The same code, or one
 * after a message; with --json, what was not read to its end is told there, too. */
int app_session_end_reading(app_session *s, int code);
/* Around the query. end takes what the query returned and fetches the evidence; an exit code,
 * APP_YES if there is a result. */
void app_session_begin(app_session *s);
int app_session_end(app_session *s, fmb_status st);

/* Should the report go to standard output? Not if the proof takes its place. */
bool app_session_reports(const app_session *s);
/* The exit code for the verdict, and a word if there is none. */
int app_session_verdict_code(const app_session *s);
/* An answer that a limit cut short is APP_UNDECIDED: a line on standard error says why, and with
 * `what` (or NULL), what there is instead. */
int app_session_undecided(const app_session *s, const char *what);
/* A line on standard error unless --quiet. */
void app_session_note(const app_session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Why fmb_evidence_write failed for the output of that name, in a message; APP_YES for an error of
 * the stream, which stays in it until it is closed. */
int app_session_proof_error(const char *path, fmb_status st);

/* Write the proof, close and free everything; code, or the exit code of what went wrong now. */
int app_session_close(app_session *s, int code);

#endif
