/* practice.c: projections from planning, engineering and information theory.
 *
 * Sources: Yeung 1997 (elemental inequalities of entropies, doi 10.1109/18.641556); Deza, Laurent
 * 1997 (the metric cone, doi 10.1007/978-3-642-04295-9).
 */
#include "study/program/writer.h"

/* x_a - x_b REL right. */
static void write_difference(study_writer *w, int a, int b, fmb_rel rel, int64_t right)
{
    study_write_term(w, a, 1);
    study_write_term(w, b, -1);
    study_write_end(w, rel, right);
}

/* Jobs begin one after another, as a net of precedences tells; the end stays, and some begins. */
void study_image_schedule(study_writer *w)
{
    int n = study_draw(w, 7, 16);
    if (!study_write_image(w, n, study_draw(w, 2, 4)))
        return;
    for (int j = 1; j < n; j++) {
        study_write_least(w, j, study_draw(w, 0, 4));
        write_difference(w, 0, j, FMB_GE, study_draw(w, 1, 9));
        for (int k = study_draw(w, 0, 2); k > 0 && j > 1; k--) {
            int lasts = study_draw(w, 1, 9);
            write_difference(w, j, study_draw(w, 1, j - 1), FMB_GE, lasts);
        }
    }
    study_write_most(w, 0, 20 * n);
}

/* Markings that a Petri net may reach, by its state equation: places are kept, not firings. */
void study_image_petri(study_writer *w)
{
    int places = study_draw(w, 3, 6), firings = study_draw(w, 4, 8);
    if (!study_write_image(w, places + firings, places))
        return;
    for (int p = 0; p < places; p++) {
        study_write_term(w, p, 1);
        for (int t = 0; t < firings; t++)
            if (study_random_chance(&w->g, 60))
                study_write_term(w, places + t, study_random_nonzero(&w->g, -2, 2));
        study_write_end(w, FMB_EQ, study_draw(w, 0, 5));
        study_write_least(w, p, 0);
    }
    for (int t = 0; t < firings; t++) {
        study_write_least(w, places + t, 0);
        study_write_most(w, places + t, study_draw(w, 2, 9));
    }
}

/* Reservoirs along a river, over some hours: what each lets through in all stays. */
void study_image_hydro(study_writer *w)
{
    int lakes = study_draw(w, 2, 3), hours = study_draw(w, 2, 4), rest = lakes * hours;
    if (!study_write_image(w, lakes + 2 * rest, lakes))
        return;
    for (int l = 0; l < lakes; l++) {
        study_write_term(w, l, 1);
        for (int h = 0; h < hours; h++)
            study_write_term(w, lakes + l * hours + h, -1);
        study_write_end(w, FMB_EQ, 0);
        for (int h = 0; h < hours; h++) {
            int out = lakes + l * hours + h, level = out + rest;
            int64_t comes = study_draw(w, 0, 4) + (h == 0 ? 10 : 0);
            study_write_term(w, level, 1);
            study_write_term(w, out, 1);
            if (h > 0)
                study_write_term(w, level - 1, -1);
            if (l > 0)
                study_write_term(w, out - hours, -1);
            study_write_end(w, FMB_EQ, comes);
            study_write_least(w, out, 0);
            study_write_most(w, out, study_draw(w, 5, 9));
            study_write_least(w, level, 0);
            study_write_most(w, level, study_draw(w, 15, 30));
        }
    }
}

/* What may be fed into a network of lines: flows follow from angles, which are eliminated. */
void study_image_power(study_writer *w)
{
    int buses = study_draw(w, 4, 7), kept = study_draw(w, 2, 4);
    if (!study_write_image(w, kept + buses, kept))
        return;
    for (int k = 0; k < kept; k++) {
        study_write_term(w, k, 1);
        int64_t all = 0;
        for (int b = 0; b < buses; b++) {
            int64_t susceptance = b == k ? 0 : study_draw(w, 0, 5);
            study_write_term(w, kept + b, susceptance);
            all += susceptance;
        }
        study_write_term(w, kept + k, -all - 1);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int a = 0; a < buses; a++)
        for (int step = 1; step <= 2; step++) {
            int64_t most = study_draw(w, 5, 40);
            write_difference(w, kept + a, kept + (a + step) % buses, FMB_LE, most);
            write_difference(w, kept + (a + step) % buses, kept + a, FMB_LE, most);
        }
}

/* A nest of loops whose bounds name outer counters; sizes and tiles are kept. */
void study_image_loops(study_writer *w)
{
    int depth = study_draw(w, 2, 4), tile = study_draw(w, 2, 32);
    if (!study_write_image(w, 2 + 2 * depth, study_draw(w, 2, 2 + depth)))
        return;
    for (int d = 0; d < depth; d++) {
        int of = 2 + d, at = 2 + depth + d;
        study_write_least(w, at, 0);
        write_difference(w, at, study_draw(w, 0, 1), FMB_LE, -1);
        if (d > 0) {
            int off = study_draw(w, -2, 2);
            write_difference(w, at, at - 1, study_random_chance(&w->g, 50) ? FMB_LE : FMB_GE, off);
        }
        study_write_term(w, at, 1);
        study_write_term(w, of, -tile);
        study_write_end(w, FMB_GE, 0);
        study_write_term(w, at, 1);
        study_write_term(w, of, -tile);
        study_write_end(w, FMB_LE, tile - 1);
    }
    study_write_most(w, 0, study_draw(w, 100, 999));
    study_write_most(w, 1, study_draw(w, 100, 999));
}

/* The variable of a set of three or four sources; some sets come first, and stay. */
static void write_entropy(study_writer *w, int set, int first, int sets, int64_t coef)
{
    if (set > 0)
        study_write_term(w, (set - 1 + first) % sets, coef);
}

/* Entropies of all sets of three or four sources, of which some depend on others or have bounds. */
void study_image_entropy(study_writer *w)
{
    int sources = study_draw(w, 3, 4), sets = (1 << sources) - 1, first = study_draw(w, 0, sets);
    if (!study_write_image(w, sets, study_draw(w, 2, sources)))
        return;
    for (int i = 0; i < sources; i++) {
        write_entropy(w, sets, first, sets, 1);
        write_entropy(w, sets & ~(1 << i), first, sets, -1);
        study_write_end(w, FMB_GE, 0);
        for (int j = 0; j < i; j++)
            for (int s = 0; s <= sets; s++) {
                int a = 1 << i, b = 1 << j;
                if (s & (a | b))
                    continue;
                write_entropy(w, s | a, first, sets, 1);
                write_entropy(w, s | b, first, sets, 1);
                write_entropy(w, s | a | b, first, sets, -1);
                write_entropy(w, s, first, sets, -1);
                study_write_end(w, FMB_GE, 0);
            }
        write_entropy(w, 1 << i, first, sets, 1);
        study_write_end(w, FMB_LE, study_draw(w, 2, 20));
    }
}

/* Distances of four to six points, some of them bounded; some are kept. */
void study_image_metric(study_writer *w)
{
    int points = study_draw(w, 4, 6), at[6][6], n = 0, pairs = points * (points - 1) / 2;
    if (!study_write_image(w, pairs, study_draw(w, pairs / 3, pairs - 3)))
        return;
    for (int i = 0; i < points; i++)
        for (int j = 0; j < i; j++) {
            at[i][j] = at[j][i] = n++;
            study_write_most(w, at[i][j], study_draw(w, 3, 20));
        }
    for (int i = 0; i < points; i++)
        for (int j = 0; j < points; j++)
            for (int k = 0; k < j; k++)
                if (i != j && i != k) {
                    study_write_term(w, at[j][k], 1);
                    study_write_term(w, at[i][j], -1);
                    study_write_term(w, at[i][k], -1);
                    study_write_end(w, FMB_LE, 0);
                }
}

/* What two or three players who share some strategies may be sure of, each in a game of his own. */
void study_image_games(study_writer *w)
{
    int values = study_draw(w, 2, 3), strategies = study_draw(w, 4, 7);
    if (!study_write_image(w, values + strategies, values))
        return;
    for (int v = 0; v < values; v++)
        for (int answer = study_draw(w, 3, 5); answer > 0; answer--) {
            study_write_term(w, v, 1);
            for (int s = 0; s < strategies; s++)
                study_write_term(w, values + s, study_random_between(&w->g, -9, 9));
            study_write_end(w, FMB_LE, 0);
        }
    for (int s = 0; s < strategies; s++)
        study_write_least(w, values + s, 0);
    for (int s = 0; s < strategies; s++)
        study_write_term(w, values + s, 1);
    study_write_end(w, FMB_EQ, 1);
}
