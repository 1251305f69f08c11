/* plots.c: fmb-qualify plots and leaderboard: an experiment drawn by Python. */
#include <argp.h>
#include <limits.h>
#include <stdlib.h>
#include <unistd.h>

#include "common/message.h"
#include "common/need.h"
#include "fmb-qualify/render.h"

/* The arguments of a script: its output, and files of CSV. */
typedef struct wanted {
    const char *out;
    const char **arguments; /* [count, then NULL]: out, runs, runs ... */
    int count, most;
} wanted;

static const struct argp_option plots_options[] = {
    {"out", 'o', "DIR", 0, "Folder for the figures [fmb-plots]", 1}, {0}};

static const struct argp_option leaderboard_options[] = {
    {"out", 'o', "FILE", 0, "The output file [leaderboard.md]", 1}, {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    wanted *w = state->input;
    switch (key) {
    case 'o':
        w->out = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (w->count == w->most)
            argp_error(state, "expected one file of CSV, found '%s'", arg);
        w->arguments[w->count++] = arg;
        return 0;
    case ARGP_KEY_END:
        if (w->count == 1)
            argp_error(state, "expected a file of CSV");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char plots_doc[] =
    "Draw the CSV output of `fmb-qualify run`: cactus plot, "
    "performance profiles, critical "
    "differences, rows by round, growth, families x rules; a table in LaTeX; "
    "and report.html with them "
    "all. It needs Python with matplotlib, numpy and scipy.";

static const char leaderboard_doc[] =
    "Rank the rules and orders in the CSV output of `fmb-qualify run`: by rows made, by the "
    "most rows at once, by time, and by what proofs cost; in Markdown. Further files are entries "
    "beside it, as fmb.lab.experiment of Python writes them, ranked without a time. Wrong answers "
    "disqualify. It needs Python with matplotlib, numpy and scipy.";

/* Run a script on the CSV; its output has a default name. */
static int render(int argc, char **argv, const struct argp *whole_line, const char *script,
                  wanted w)
{
    int code = APP_YES;
    w.arguments = app_need(calloc((size_t)argc + 2, sizeof *w.arguments));
    w.count = 1;
    argp_parse(whole_line, argc, argv, 0, NULL, &w);
    w.arguments[0] = w.out;
    for (int i = 1; code == APP_YES && i < w.count; i++)
        if (access(w.arguments[i], R_OK) != 0)
            code = app_error(APP_CANNOT_OPEN, "%s: cannot be read", w.arguments[i]);
    if (code == APP_YES && qualify_render(script, w.arguments) != QUALIFY_RENDERED)
        code = APP_INTERNAL;
    free(w.arguments);
    return code;
}

int qualify_plots(int argc, char **argv)
{
    const struct argp whole_line = {plots_options, parse, "RUNS.csv", plots_doc, NULL, NULL, NULL};
    return render(argc, argv, &whole_line, "plots.py", (wanted){.out = "fmb-plots", .most = 2});
}

int qualify_leaderboard(int argc, char **argv)
{
    const struct argp whole_line = {
        leaderboard_options, parse, "RUNS.csv [ENTRY.csv...]", leaderboard_doc, NULL, NULL, NULL};
    return render(argc, argv, &whole_line, "leaderboard.py",
                  (wanted){.out = "leaderboard.md", .most = INT_MAX});
}
