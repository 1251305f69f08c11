/* query.h: one query of the solver, from command line to exit code.
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
    fmb_options options; /* as requested, with the rest of max_bytes after reading */
    app_rule_library library;
    app_rule_set rules;
    fmb_solver *solver;
    fmb_system *system;
    FILE *trace, *proof;
    app_watch watch;
    fmb_result result;
    fmb_evidence *evidence; /* NULL if nothing was proved */
    bool relaxed;           /* the file has integers, and the answer is over the reals */
    bool answered;          /* some query was completed */
    bool rules_worked;      /* rows were paired, or a rule dropped some */
} app_session;

/* Check the options, read the system, open the outputs: APP_YES, or an exit code after a message.
 * app_session_close must be called even then. */
int app_session_open(app_session *s, const app_ask *ask);
/* The steps of app_session_open, for commands that read more than a system between them. */
int app_session_open_solver(app_session *s, const app_ask *ask);
int app_session_open_outputs(app_session *s);
/* End of reading, with that code: the query gets the rest of the memory. Returns code, or another
 * after a message; with --json, incomplete reading is reported there, too. */
int app_session_end_reading(app_session *s, int code);
/* Call these before and after the query. end takes the status of the query and fetches the
 * evidence; an exit code, APP_YES if there is a result. */
void app_session_begin(app_session *s);
int app_session_end(app_session *s, fmb_status st);

/* Should the report go to standard output? Not if the proof takes its place. */
bool app_session_reports(const app_session *s);
/* The exit code for the verdict, with a message if it is unknown. */
int app_session_verdict_code(const app_session *s);
/* An answer cut short by a limit is APP_UNDECIDED: a line on standard error says why, and `what`
 * (or NULL) describes the partial answer. */
int app_session_undecided(const app_session *s, const char *what);
/* A line on standard error unless --quiet. */
void app_session_note(const app_session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Report why fmb_evidence_write failed for the output of that name; APP_YES for an error of the
 * stream, which is reported when it is closed. */
int app_session_proof_error(const char *path, fmb_status st);

/* Write the proof, close and free everything; returns code, or the exit code of an error here. */
int app_session_close(app_session *s, int code);

#endif
