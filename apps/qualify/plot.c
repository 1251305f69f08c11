/* plot.c: data files, a gnuplot script, and gnuplot itself if it is there.
 *
 * A point is drawn only where every system was decided: a mean over the easy ones would lie.
 */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/file.h"
#include "common/message.h"
#include "qualify/report.h"

/* One picture for each motion. */
typedef struct picture {
    const char *name, *title, *label;
    double (*value)(const study_digest *d);
} picture;

static double rows(const study_digest *d)
{
    return d->stopped == 0 && d->lived > 0 ? d->lived : (double)NAN;
}

static double seconds(const study_digest *d)
{
    return d->systems > 0 && d->timed == d->systems && d->gave_up == 0 ? d->median_ratio
                                                                       : (double)NAN;
}

static const picture PICTURE[] = {
    {"rows", "Rows alive after a round, added up over the rounds (mean)", "rows", rows},
    {"time", "Time against no rules (median of ratios; at most that where no rules gave up)",
     "time / time without rules", seconds},
};
enum { PICTURES = sizeof PICTURE / sizeof *PICTURE };
static const char *const MOTION[] = {"static", "dynamic"};

static void put_data(FILE *f, const qualify_plan *p, const picture *what, int moves)
{
    fprintf(f, "D");
    for (size_t i = 0; i < p->sets; i++)
        fprintf(f, " \"%s\"", p->set[i]);
    fputc('\n', f);
    for (int dim = 1; dim <= PLAN_MOST_DIM; dim++) {
        qualify_select which = {dim, moves, ANY, ANY, NULL};
        if (!p->dim[dim])
            continue;
        fprintf(f, "%d", dim);
        for (size_t i = 0; i < p->sets; i++) {
            study_digest d = qualify_digest(p, i, &which);
            double x = what->value(&d);
            if (isnan(x))
                fputs(" -", f);
            else
                fprintf(f, " %.6g", x);
        }
        fputc('\n', f);
    }
}

/* Is there a point to draw? gnuplot fails on a picture without any. */
static bool has_points(const qualify_plan *p, const picture *what, int moves)
{
    bool any = false;
    for (int dim = 1; dim <= PLAN_MOST_DIM; dim++)
        for (size_t i = 0; p->motion[moves] && p->dim[dim] && i < p->sets; i++) {
            study_digest d = qualify_digest(p, i, &(qualify_select){dim, moves, ANY, ANY, NULL});
            any |= !isnan(what->value(&d));
        }
    return any;
}

static int write_data(const qualify_plan *p, const picture *what, int moves)
{
    FILE *f = NULL;
    char *path, *name;
    if (asprintf(&name, "%s-%s.dat", what->name, MOTION[moves]) < 0)
        app_need(NULL);
    int code = qualify_create(p, name, &f, &path);
    if (code == APP_YES) {
        put_data(f, p, what, moves);
        code = app_file_close(f, path);
    }
    free(path);
    free(name);
    return code;
}

static void put_picture(FILE *f, const qualify_plan *p, const picture *what, int moves)
{
    static const char *const TERMINAL[] = {"svg size 900,600 dynamic background 'white'",
                                           "png size 900,600"};
    static const char *const ENDING[] = {"svg", "png"};
    for (int i = 0; i < 2; i++)
        fprintf(f,
                "set terminal %s\nset output '%s-%s.%s'\nset title \"%s, %s frames\"\n"
                "set ylabel '%s'\nplot for [i=2:%zu] '%s-%s.dat' using 1:i with linespoints "
                "linetype i-1 title columnheader(i)\nset output\n",
                TERMINAL[i], what->name, MOTION[moves], ENDING[i], what->title, MOTION[moves],
                what->label, p->sets + 1, what->name, MOTION[moves]);
}

static void put_head(FILE *f, const qualify_plan *p)
{
    int first = 1, last = PLAN_MOST_DIM;
    while (first < last && !p->dim[first])
        first++;
    while (last > first && !p->dim[last])
        last--;
    fprintf(f,
            "# gnuplot plots.gp\nset datafile missing '-'\nset key outside right noenhanced\n"
            "set xlabel 'D'\nset xtics 1\nset xrange [%d.8:%d.2]\nset logscale y\nset grid\n",
            first - 1, last);
}

static int write_script(const qualify_plan *p)
{
    FILE *f = NULL;
    char *path;
    int code = qualify_create(p, "plots.gp", &f, &path);
    if (code == APP_YES) {
        put_head(f, p);
        for (int k = 0; k < PICTURES; k++)
            for (int moves = 0; moves < 2; moves++)
                if (has_points(p, &PICTURE[k], moves))
                    put_picture(f, p, &PICTURE[k], moves);
        code = app_file_close(f, path);
    }
    free(path);
    return code;
}

/* In a child, as gnuplot knows no other way to change folders before it opens its script. */
static int run_gnuplot(const char *folder)
{
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        if (chdir(folder) == 0)
            execlp("gnuplot", "gnuplot", "plots.gp", (char *)NULL);
        _exit(errno == ENOENT ? 127 : 126);
    }
    if (child < 0 || waitpid(child, &status, 0) != child)
        return app_error(APP_INTERNAL, "gnuplot cannot be started: %s", strerror(errno));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
        app_error(APP_YES,
                  "gnuplot is not installed: the pictures are missing; with it, `gnuplot "
                  "plots.gp` in %s makes them",
                  folder);
        return APP_YES;
    }
    return status == 0 ? APP_YES : app_error(APP_INTERNAL, "gnuplot failed on %s/plots.gp", folder);
}

static bool has_frames(const qualify_plan *p)
{
    return p->grid.complete > 0 && !p->grid.sample[0].file;
}

int qualify_write_plots(const qualify_plan *p)
{
    if (!has_frames(p))
        return APP_YES;
    int code = APP_YES;
    for (int k = 0; code == APP_YES && k < PICTURES; k++)
        for (int moves = 0; code == APP_YES && moves < 2; moves++)
            if (p->motion[moves])
                code = write_data(p, &PICTURE[k], moves);
    if (code == APP_YES)
        code = write_script(p);
    return code == APP_YES ? run_gnuplot(p->out) : code;
}
