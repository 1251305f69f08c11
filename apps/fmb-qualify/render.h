/* render.h: the scripts that make report.html and the figures: report.py of report.json, plots.py
 * and leaderboard.py of the CSV of an experiment. */
#ifndef QUALIFY_RENDER_H
#define QUALIFY_RENDER_H

typedef enum qualify_rendered {
    QUALIFY_RENDERED = 0,
    QUALIFY_NO_PYTHON, /* after a message, like the next one */
    QUALIFY_NO_SCRIPT,
    QUALIFY_NOT_RENDERED /* the script failed, and said why */
} qualify_rendered;

/* Run the script of that name with these arguments; NULL ends them. */
qualify_rendered qualify_render(const char *name, const char *const *arguments);

/* fmb-qualify plots, fmb-qualify leaderboard. */
int qualify_plots(int argc, char **argv);
int qualify_leaderboard(int argc, char **argv);

#endif
