/* plot.c: the figures.
 *
 * A point is drawn only where every system was decided: a mean over the easy ones would lie.
 */
#include <math.h>

#include "qualify/rules/report.h"

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

static void put_script(FILE *f, const qualify_plan *p, const picture *what, int moves)
{
    int first = 1, last = PLAN_MOST_DIM;
    while (first < last && !p->dim[first])
        first++;
    while (last > first && !p->dim[last])
        last--;
    fprintf(f,
            "set key outside right noenhanced\nset xlabel 'D'\nset xtics 1\n"
            "set xrange [%d.8:%d.2]\nset logscale y\nset grid\n"
            "set title \"%s, %s frames\"\nset ylabel '%s'\n"
            "plot for [i=2:%zu] data using 1:i with linespoints linetype i-1 "
            "title columnheader(i)\n",
            first - 1, last, what->title, MOTION[moves], what->label, p->sets + 1);
}

static void add_picture(const qualify_plan *p, const picture *what, int moves, qualify_page *page)
{
    qualify_figure figure;
    char name[40], caption[200];
    snprintf(name, sizeof name, "%s-%s", what->name, MOTION[moves]);
    snprintf(caption, sizeof caption, "%s, %s frames.", what->title, MOTION[moves]);
    qualify_figure_begin(&figure);
    put_data(figure.data, p, what, moves);
    put_script(figure.script, p, what, moves);
    qualify_page_figure(page, name, caption, &figure);
}

void qualify_plots(const qualify_plan *p, qualify_page *page)
{
    if (p->grid.complete == 0 || p->grid.sample[0].file)
        return;
    for (int k = 0; k < PICTURES; k++)
        for (int moves = 0; moves < 2; moves++)
            if (has_points(p, &PICTURE[k], moves))
                add_picture(p, &PICTURE[k], moves, page);
}
