/* structured.c: projections whose rows have a pattern: hulls of points, trees, stages, rows
 * in plenty.
 *
 * Sources: Pitowsky 1989 (correlation polytopes, doi 10.1007/BFb0021186); Ziegler 1995 (the moment
 * curve, doi 10.1007/978-1-4613-8431-1).
 */
#include "study/program/writer.h"

/* x is a mean of points with weights >= 0: x is kept, the weights are eliminated. */
static void write_hull_of_points(study_writer *w, int dim, int points, const int64_t *at)
{
    for (int j = 0; j < dim; j++) {
        study_write_term(w, j, -1);
        for (int p = 0; p < points; p++)
            study_write_term(w, dim + p, at[p * dim + j]);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int p = 0; p < points; p++)
        study_write_term(w, dim + p, 1);
    study_write_end(w, FMB_EQ, 1);
    for (int p = 0; p < points; p++)
        study_write_least(w, dim + p, 0);
}

/* On the moment curve, or anywhere in a cube. */
void study_image_points(study_writer *w)
{
    int64_t at[4 * 14];
    int dim = study_draw(w, 2, 4), points = study_draw(w, dim + 3, 14 - dim), t = -3;
    bool curve = study_random_chance(&w->g, 50);
    if (!study_write_image(w, dim + points, dim))
        return;
    for (int p = 0; p < points; p++, t += study_draw(w, 1, 2))
        for (int j = 0; j < dim; j++)
            at[p * dim + j] = !curve ? study_draw(w, -9, 9) : j == 0 ? t : at[p * dim + j - 1] * t;
    write_hull_of_points(w, dim, points, at);
}

/* What three or four events, that happen or not, have to do with each other: probabilities of some
 * of them, and of pairs. */
void study_image_local(study_writer *w)
{
    int64_t at[16 * 6];
    int events = study_draw(w, 3, 4), dim = study_draw(w, events, 6), one[6], other[6];
    int points = 1 << events;
    if (!study_write_image(w, dim + points, dim))
        return;
    for (int j = 0; j < dim; j++) {
        one[j] = study_draw(w, 0, events - 1);
        other[j] = study_draw(w, 0, events - 1);
    }
    for (int p = 0; p < points; p++)
        for (int j = 0; j < dim; j++)
            at[p * dim + j] = (p >> one[j] & 1) * (p >> other[j] & 1);
    write_hull_of_points(w, dim, points, at);
}

/* Few terms a row, and many variables are kept. */
void study_image_scarce(study_writer *w)
{
    int n = study_draw(w, 8, 18);
    if (!study_write_image(w, n, study_draw(w, n / 3, n / 2)))
        return;
    for (int i = study_draw(w, 3 * n / 2, 2 * n); i > 0; i--) {
        for (int k = study_draw(w, 2, 3); k > 0; k--) {
            int64_t coef = study_random_nonzero(&w->g, -5, 5);
            study_write_term(w, study_draw(w, 0, n - 1), coef);
        }
        study_write_end(w, FMB_LE, study_draw(w, 3, 30));
    }
}

/* Variables of a tree, each bound to its parent in two directions or three; some of them stay, from
 * the root on. */
void study_image_tree(study_writer *w)
{
    int n = study_draw(w, 10, 40);
    if (!study_write_image(w, n, study_draw(w, 2, 4)))
        return;
    for (int v = 0; v < n; v++) {
        int parent = v == 0 ? 0 : study_draw(w, 0, v - 1);
        study_write_most(w, v, study_draw(w, 5, 30));
        study_write_least(w, v, -study_draw(w, 5, 30));
        for (int k = study_draw(w, 2, 3); v > 0 && k > 0; k--) {
            study_write_term(w, v, study_random_nonzero(&w->g, -3, 3));
            study_write_term(w, parent, study_random_nonzero(&w->g, -3, 3));
            study_write_end(w, FMB_LE, study_draw(w, 2, 20));
        }
    }
}

/* Goods are made, stored and sold, month by month, by machines that share their hours: stocks at
 * the beginning stay. */
void study_image_stages(study_writer *w)
{
    int goods = study_draw(w, 2, 3), months = study_draw(w, 2, 4), step = 2 * goods;
    if (!study_write_image(w, goods + months * step, goods))
        return;
    for (int t = 0; t < months; t++) {
        int made = goods + t * step, stock = made + goods, before = t == 0 ? 0 : stock - step;
        for (int g = 0; g < goods; g++) {
            study_write_term(w, stock + g, 1);
            study_write_term(w, before + g, -1);
            study_write_term(w, made + g, -1);
            study_write_end(w, FMB_EQ, -study_draw(w, 1, 9));
            study_write_least(w, made + g, 0);
            study_write_least(w, stock + g, 0);
            study_write_most(w, stock + g, study_draw(w, 8, 20));
        }
        for (int machine = 0; machine < 2; machine++) {
            for (int g = 0; g < goods; g++)
                study_write_term(w, made + g, study_draw(w, 0, 4));
            study_write_end(w, FMB_LE, study_draw(w, 15, 40));
        }
    }
    for (int g = 0; g < goods; g++) {
        study_write_least(w, g, 0);
        study_write_most(w, g, 30);
    }
}

/* Sums of some of the variables are bounded; all of them are >= 0. */
void study_image_packing(study_writer *w)
{
    int n = study_draw(w, 8, 16);
    if (!study_write_image(w, n, study_draw(w, 2, 5)))
        return;
    for (int i = study_draw(w, n / 2, n); i > 0; i--) {
        for (int j = 0; j < n; j++)
            study_write_term(w, j, study_random_chance(&w->g, 30));
        study_write_end(w, i % 3 ? FMB_LE : FMB_GE, i % 3 ? study_draw(w, 5, 20) : 1);
    }
    for (int j = 0; j < n; j++)
        study_write_least(w, j, 0);
}

/* Many rows for few variables. */
void study_image_crowd(study_writer *w)
{
    int n = study_draw(w, 4, 6);
    if (!study_write_image(w, n, study_draw(w, 2, 3)))
        return;
    for (int i = study_draw(w, 8 * n, 120 / n * n); i > 0; i--) {
        for (int j = 0; j < n; j++)
            study_write_term(w, j, study_draw(w, -99, 99));
        study_write_end(w, FMB_LE, study_draw(w, 400, 900));
    }
}

/* A few rows, and sums of two of them, mostly with larger right sides: these are redundant. */
void study_image_redundant(study_writer *w)
{
    int64_t row[12][8];
    int n = study_draw(w, 5, 7), first = n + study_draw(w, 2, 5);
    if (!study_write_image(w, n, study_draw(w, 2, 4)))
        return;
    for (int i = 0; i < first; i++)
        for (int j = 0; j < n; j++)
            row[i][j] = study_draw(w, -7, 7);
    for (int i = 0; i < 3 * first; i++) {
        int a = i < first ? i : study_draw(w, 0, first - 1);
        int b = i < first ? i : study_draw(w, 0, first - 1);
        for (int j = 0; j < n; j++)
            study_write_term(w, j, row[a][j] + row[b][j]);
        study_write_end(w, FMB_LE, 40 + study_draw(w, 0, i < first ? 5 : 30));
    }
}
