/* plots.c: fmb-qualify plots: figures of an experiment, by plots.py. */
#include <argp.h>
#include <unistd.h>

#include "common/message.h"
#include "fmb-qualify/render.h"

typedef struct wanted {
    const char *runs, *folder;
} wanted;

static const struct argp_option options[] = {
    {"out", 'o', "DIR", 0, "Folder for the figures [fmb-plots]", 1}, {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    wanted *w = state->input;
    switch (key) {
    case 'o':
        w->folder = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (w->runs)
            argp_error(state, "expected one file of CSV, found '%s'", arg);
        w->runs = arg;
        return 0;
    case ARGP_KEY_END:
        if (!w->runs)
            argp_error(state, "expected a file of CSV");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char doc[] = "Draw what `fmb-qualify run` left in a file of CSV: cactus plot, "
                          "performance profiles, critical "
                          "differences, rows by round, growth, families x rules; a table in LaTeX; "
                          "and report.html with them "
                          "all. It needs Python with matplotlib, numpy and scipy.";

int qualify_plots(int argc, char **argv)
{
    const struct argp whole_line = {options, parse, "RUNS.csv", doc, NULL, NULL, NULL};
    wanted w = {.folder = "fmb-plots"};
    argp_parse(&whole_line, argc, argv, 0, NULL, &w);
    if (access(w.runs, R_OK) != 0)
        return app_error(APP_CANNOT_OPEN, "%s: cannot be read", w.runs);
    return qualify_render("plots.py", w.runs, w.folder) == QUALIFY_RENDERED ? APP_YES
                                                                            : APP_INTERNAL;
}
