/* images_apart.c: projections that were invented to judge a choice of ways; now they are in the
 * fit.
 *
 * Sources: Rockafellar, Uryasev 2000 (tails by auxiliary variables, doi 10.21314/JOR.2000.038);
 * Krarup, Bilde 1977 (lots by the stage that makes them); Milanese, Belforte 1982 (parameters that
 * bounded errors leave, doi 10.1109/TAC.1982.1102942).
 */
#include "study/program/writer.h"

/* Capacities of arcs that every cut between two places has: potentials go. */
void study_image_cuts(study_writer *w)
{
    int nodes = study_draw(w, 4, 7), arcs = study_draw(w, 3, 6);
    if (!study_write_image(w, arcs + nodes, arcs))
        return;
    for (int a = 0; a < arcs; a++) {
        for (int more = study_draw(w, 1, 3); more > 0; more--) {
            int from = study_draw(w, 0, nodes - 2);
            study_write_term(w, a, study_draw(w, 1, 3));
            study_write_term(w, arcs + from, -1);
            study_write_term(w, arcs + study_draw(w, from + 1, nodes - 1), 1);
            study_write_end(w, FMB_GE, 0);
        }
        study_write_least(w, a, 0);
    }
    study_write_least(w, arcs, study_draw(w, 3, 9));
    study_write_most(w, arcs + nodes - 1, 0);
    for (int v = 1; v < nodes - 1; v++) {
        study_write_least(w, arcs + v, 0);
        study_write_most(w, arcs + v, 9);
    }
}

/* Some sums of the cells of a table of three ways, whose sum is known. */
void study_image_marginals(study_writer *w)
{
    int a = study_draw(w, 2, 3), b = study_draw(w, 2, 3), c = study_draw(w, 2, 3);
    int kept = study_draw(w, 2, 6), cells = a * b * c;
    if (!study_write_image(w, kept + cells, kept))
        return;
    for (int k = 0; k < kept; k++) {
        int way = study_draw(w, 0, 2), first = study_draw(w, 0, 1), second = study_draw(w, 0, 1);
        study_write_term(w, k, 1);
        for (int x = 0; x < cells; x++) {
            int at[3] = {x / (b * c), x / c % b, x % c};
            if (at[way] == first && at[(way + 1) % 3] == second)
                study_write_term(w, kept + x, -1);
        }
        study_write_end(w, FMB_EQ, 0);
    }
    for (int x = 0; x < cells; x++)
        study_write_least(w, kept + x, 0);
    for (int x = 0; x < cells; x++)
        study_write_term(w, kept + x, 1);
    study_write_end(w, FMB_EQ, study_draw(w, 10, 99));
    for (int x = 0; x < cells; x += study_draw(w, 1, 4))
        study_write_most(w, kept + x, study_draw(w, 3, 30));
}

/* What a first decision costs in a second stage that mends it; the cost stays, too. */
void study_image_recourse(study_writer *w)
{
    int first = study_draw(w, 1, 4), second = study_draw(w, 3, 7), rows = study_draw(w, 4, 10);
    if (!study_write_image(w, first + 1 + second, first + 1))
        return;
    study_write_term(w, first, 1);
    for (int y = 0; y < second; y++) {
        study_write_term(w, first + 1 + y, -study_draw(w, 1, 9));
        study_write_least(w, first + 1 + y, 0);
    }
    study_write_end(w, FMB_GE, 0);
    for (int r = 0; r < rows; r++) {
        for (int x = 0; x < first; x++)
            study_write_term(w, x, study_random_between(&w->g, -5, 5));
        for (int y = 0; y < second; y++)
            if (study_random_chance(&w->g, 50))
                study_write_term(w, first + 1 + y, study_random_between(&w->g, -2, 6));
        study_write_end(w, FMB_GE, study_draw(w, 1, 20));
    }
    for (int x = 0; x < first; x++) {
        study_write_least(w, x, -10);
        study_write_most(w, x, 10);
    }
}

/* Clocks of an automaton after some steps, each with a guard, resets and a delay. */
void study_image_automaton(study_writer *w)
{
    int clocks = study_draw(w, 2, 4), steps = study_draw(w, 2, 4);
    int all = clocks * (steps + 1) + steps, last = clocks * (steps + 1);
    if (!study_write_image(w, all, clocks))
        return;
    for (int s = 0; s < steps; s++) {
        int after = s * clocks, before = after + clocks, delay = last + s;
        int reset = study_draw(w, 0, clocks - 1), guard = study_draw(w, 0, clocks - 1);
        study_write_least(w, delay, 0);
        for (int c = 0; c < clocks; c++) {
            study_write_term(w, after + c, 1);
            study_write_term(w, before + c, c == reset ? 0 : -1);
            study_write_term(w, delay, -study_draw(w, 1, 2));
            study_write_end(w, FMB_EQ, 0);
            study_write_most(w, after + c, study_draw(w, 6, 20));
        }
        study_write_term(w, before + guard, 1);
        int64_t least = study_draw(w, 1, 4);
        study_write_end(w, study_random_chance(&w->g, 30) ? FMB_GT : FMB_GE, least);
        study_write_term(w, before + guard, 1);
        study_write_term(w, before + (guard + 1) % clocks, -1);
        study_write_end(w, FMB_LE, study_draw(w, 0, 5));
    }
    for (int c = 0; c < clocks; c++) {
        study_write_least(w, steps * clocks + c, 0);
        study_write_most(w, steps * clocks + c, study_draw(w, 3, 9));
    }
}

/* Two to four terms a row, most of the variables stay. */
void study_image_mostly_kept(study_writer *w)
{
    int n = study_draw(w, 7, 12), rows = study_draw(w, n + 4, 3 * n);
    if (!study_write_image(w, n, n - study_draw(w, 2, 4)))
        return;
    for (int r = 0; r < rows; r++) {
        for (int t = study_draw(w, 2, 4); t > 0; t--) {
            int64_t coef = study_random_nonzero(&w->g, -9, 9);
            study_write_term(w, study_draw(w, 0, n - 1), coef);
        }
        int64_t right = study_draw(w, 1, 40);
        study_write_end(w, study_random_chance(&w->g, 10) ? FMB_LT : FMB_LE, right);
    }
}

/* Values whose largest ones do not sum up to more than a bound: tails, by auxiliary variables. */
void study_image_tails(study_writer *w)
{
    int values = study_draw(w, 3, 6), bounds = study_draw(w, 1, 2);
    if (!study_write_image(w, values + bounds * (values + 1), values))
        return;
    for (int b = 0; b < bounds; b++) {
        int level = values + b * (values + 1);
        study_write_term(w, level, study_draw(w, 1, values - 1));
        for (int x = 0; x < values; x++)
            study_write_term(w, level + 1 + x, study_draw(w, 1, 2));
        study_write_end(w, FMB_LE, study_draw(w, 5, 20));
        for (int x = 0; x < values; x++) {
            study_write_least(w, level + 1 + x, 0);
            study_write_term(w, level + 1 + x, 1);
            study_write_term(w, x, -study_draw(w, 1, 3));
            study_write_term(w, level, 1);
            study_write_end(w, FMB_GE, 0);
        }
    }
    for (int x = 0; x < values; x++)
        study_write_least(w, x, 0);
}

/* Which periods make something, if lots are told by the period that uses them. */
void study_image_lots(study_writer *w)
{
    int periods = study_draw(w, 2, 4), lots = periods * (periods + 1) / 2, at = periods;
    if (!study_write_image(w, periods + lots, periods))
        return;
    for (int t = 0; t < periods; t++) {
        for (int s = 0; s <= t; s++) {
            study_write_term(w, at + s, 1);
            study_write_term(w, s, -study_draw(w, 1, 9));
            study_write_end(w, FMB_LE, 0);
            study_write_least(w, at + s, 0);
        }
        for (int s = 0; s <= t; s++)
            study_write_term(w, at + s, 1);
        study_write_end(w, FMB_GE, study_draw(w, 1, 9));
        at += t + 1;
    }
    for (int t = 0; t < periods; t++)
        study_write_most(w, t, study_draw(w, 10, 20));
}

/* Parameters of a model that measurements with bounded errors leave, some of which are not asked
 * for; numbers of ten digits. */
void study_image_parameters(study_writer *w)
{
    int n = study_draw(w, 4, 7), kept = study_draw(w, 2, 3), measured = study_draw(w, n + 1, 3 * n);
    if (!study_write_image(w, n, kept))
        return;
    for (int i = 0; i < measured; i++) {
        int64_t coef[8], right = 0;
        for (int j = 0; j < n; j++) {
            coef[j] = study_random_between(&w->g, -9999999999, 9999999999);
            right += coef[j] / 7 * (j % 3);
        }
        for (int side = 0; side < 2; side++) {
            for (int j = 0; j < n; j++)
                study_write_term(w, j, coef[j]);
            int64_t error = study_random_between(&w->g, 1000000000, 9999999999);
            study_write_end(w, side ? FMB_LE : FMB_GE, side ? right + error : right - error);
        }
    }
}

/* Sums of some vectors with weights that need not end, and that leave a flat or open image. */
void study_image_weights(study_writer *w)
{
    int kept = study_draw(w, 3, 6), weights = study_draw(w, 4, 10), rank = study_draw(w, 2, kept);
    if (!study_write_image(w, kept + weights, kept))
        return;
    for (int k = 0; k < kept; k++) {
        study_write_term(w, k, 1);
        if (k >= rank)
            study_write_term(w, k - rank, study_random_between(&w->g, -2, 2));
        for (int j = 0; j < weights && k < rank; j++)
            study_write_term(w, kept + j, study_random_between(&w->g, -4, 4));
        study_write_end(w, FMB_EQ, 0);
    }
    for (int j = 0; j < weights; j++) {
        study_write_least(w, kept + j, 0);
        if (study_random_chance(&w->g, 60))
            study_write_most(w, kept + j, study_draw(w, 1, 9));
    }
}

/* Ingredients of a mixture and what it holds; some contents stay, in strict bounds. */
void study_image_mixture(study_writer *w)
{
    int contents = study_draw(w, 2, 5), of = study_draw(w, 5, 12);
    if (!study_write_image(w, contents + of, contents))
        return;
    for (int c = 0; c < contents; c++) {
        study_write_term(w, c, -100);
        for (int j = 0; j < of; j++)
            if (study_random_chance(&w->g, 70))
                study_write_term(w, contents + j, study_draw(w, 0, 400));
        study_write_end(w, FMB_EQ, 0);
        study_write_term(w, c, 1);
        study_write_end(w, FMB_LT, study_draw(w, 100, 400));
    }
    for (int j = 0; j < of; j++) {
        study_write_least(w, contents + j, 0);
        study_write_most(w, contents + j, study_draw(w, 10, 60));
        study_write_term(w, contents + j, 1);
    }
    study_write_end(w, FMB_EQ, 100);
    for (int r = study_draw(w, 0, 3); r > 0; r--) {
        study_write_term(w, contents + study_draw(w, 0, of - 1), 1);
        int coef = study_draw(w, -3, 3);
        study_write_term(w, contents + study_draw(w, 0, of - 1), coef);
        study_write_end(w, FMB_LE, study_draw(w, 10, 60));
    }
}

/* Points whose distances from others, by absolute values, sum up to no more than bounds. */
void study_image_sites(study_writer *w)
{
    int dims = study_draw(w, 2, 4), sites = study_draw(w, 2, 4);
    if (!study_write_image(w, dims + sites * dims, dims))
        return;
    for (int s = 0; s < sites; s++) {
        int far = dims + s * dims;
        for (int d = 0; d < dims; d++) {
            int at = study_draw(w, -9, 9);
            for (int side = -1; side <= 1; side += 2) {
                study_write_term(w, far + d, 1);
                study_write_term(w, d, -side);
                study_write_end(w, FMB_GE, -side * at);
            }
        }
        for (int d = 0; d < dims; d++)
            study_write_term(w, far + d, study_draw(w, 1, 3));
        study_write_end(w, FMB_LE, study_draw(w, 15, 50));
    }
}

/* Loops with steps: iterations of two nests that touch the same elements; the difference stays. */
void study_image_dependences(study_writer *w)
{
    int depth = study_draw(w, 2, 4), kept = depth, subscripts = study_draw(w, 1, 2);
    if (!study_write_image(w, kept + 2 * depth + 1, kept))
        return;
    int size = kept + 2 * depth;
    for (int d = 0; d < depth; d++) {
        int from = kept + d, to = from + depth;
        study_write_term(w, d, 1);
        study_write_term(w, from, 1);
        study_write_term(w, to, -1);
        study_write_end(w, FMB_EQ, 0);
        for (int at = from; at <= to; at += depth) {
            study_write_least(w, at, 0);
            study_write_term(w, at, 1);
            study_write_term(w, d > 0 && study_random_chance(&w->g, 50) ? at - 1 : size, -1);
            study_write_end(w, FMB_LE, -1);
        }
    }
    for (int s = 0; s < subscripts; s++) {
        for (int d = 0; d < depth; d++) {
            int step = study_draw(w, -2, 3);
            study_write_term(w, kept + d, step);
            study_write_term(w, kept + depth + d, -step - (d == 0));
        }
        study_write_end(w, s == 0 ? FMB_EQ : FMB_LE, study_draw(w, -3, 3));
    }
    study_write_least(w, size, 2);
    study_write_most(w, size, study_draw(w, 8, 200));
}
