/* plans.c: decisions over time: stages, shifts, slots, stocks.
 *
 * Sources: Krarup, Bilde 1977 (lots by the stage that makes them); Dantzig 1954 (shifts, doi
 * 10.1287/opre.2.3.339); Pritsker, Watters, Wolfe 1969 (a variable for each slot of a job, doi
 * 10.1287/mnsc.16.1.93).
 */
#include "study/program/writer.h"

/* What a first decision costs in a second stage that mends it; the cost is kept, too. */
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

/* Stocks over a tree of what may happen: at each node something is made, before it is known which
 * of its children comes. What is made at once, and a bound on all costs, stay. */
void study_image_scenarios(study_writer *w)
{
    int depth = study_draw(w, 2, 3), nodes = (1 << depth) - 1, made = 1, stock = made + nodes;
    if (!study_write_image(w, 1 + 2 * nodes, 2))
        return;
    for (int n = 0; n < nodes; n++) {
        study_write_least(w, made + n, 0);
        if (n > 0 || study_random_chance(&w->g, 50))
            study_write_most(w, made + n, study_draw(w, 8, 20));
        study_write_least(w, stock + n, 0);
        study_write_term(w, stock + n, 1);
        study_write_term(w, made + n, -1);
        if (n > 0)
            study_write_term(w, stock + (n - 1) / 2, -1);
        study_write_end(w, FMB_EQ, n == 0 ? study_draw(w, 0, 5) : -study_draw(w, 1, 12));
    }
    for (int leaf = nodes / 2; leaf < nodes; leaf++) {
        study_write_term(w, 0, -1);
        for (int n = leaf;; n = (n - 1) / 2) {
            study_write_term(w, made + n, study_draw(w, 1, 9));
            study_write_term(w, stock + n, 1);
            if (n == 0)
                break;
        }
        study_write_end(w, FMB_LE, 0);
    }
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

/* How many work each pattern of hours, so that all hours have enough; hours of groups stay. */
void study_image_shifts(study_writer *w)
{
    int groups = study_draw(w, 2, 4), each = study_draw(w, 2, 3), hours = study_draw(w, 4, 8);
    int patterns = groups * each;
    if (!study_write_image(w, groups + patterns, groups))
        return;
    for (int g = 0; g < groups; g++) {
        study_write_term(w, g, -1);
        for (int p = 0; p < each; p++)
            study_write_term(w, groups + g * each + p, study_draw(w, 4, 9));
        study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_LE, 0);
    }
    for (int h = 0; h < hours; h++) {
        for (int p = 0; p < patterns; p++)
            if ((h + p * 3) % hours < 3)
                study_write_term(w, groups + p, 1);
        study_write_end(w, FMB_GE, study_draw(w, 1, 12));
    }
    for (int p = 0; p < patterns; p++) {
        study_write_least(w, groups + p, 0);
        study_write_most(w, groups + p, study_draw(w, 6, 20));
    }
}

/* Begins of jobs, by how much of each is in which slot of its window; slots have room. */
void study_image_slots(study_writer *w)
{
    int jobs = study_draw(w, 2, 4), slots = study_draw(w, 3, 5);
    if (!study_write_image(w, jobs + jobs * slots, jobs))
        return;
    for (int j = 0; j < jobs; j++) {
        study_write_term(w, j, -1);
        for (int s = 0; s < slots; s++)
            study_write_term(w, jobs + j * slots + s, s + 1);
        study_write_end(w, FMB_EQ, 0);
        study_write_sum(w, jobs + j * slots, slots, 1);
        study_write_end(w, FMB_EQ, 1);
    }
    for (int s = 0; s < slots; s++) {
        for (int j = 0; j < jobs; j++)
            study_write_term(w, jobs + j * slots + s, study_draw(w, 1, 4));
        study_write_end(w, FMB_LE, study_draw(w, 3, 5));
    }
    for (int x = jobs; x < jobs + jobs * slots; x++)
        if (study_random_chance(&w->g, 90))
            study_write_least(w, x, 0);
}

/* Sums over windows of time, and stocks by then: these stay. */
void study_image_windows(study_writer *w)
{
    int kept = study_draw(w, 2, 4), n = study_draw(w, 5, 10), wide = study_draw(w, 2, 4);
    if (!study_write_image(w, kept + n, kept))
        return;
    for (int k = 0; k < kept; k++) {
        study_write_term(w, k, -1);
        study_write_sum(w, kept, (k + 1) * n / kept, 1);
        study_write_end(w, study_random_chance(&w->g, 70) ? FMB_EQ : FMB_GE, 0);
    }
    for (int t = 0; t + wide <= n; t++) {
        study_write_sum(w, kept + t, wide, 1);
        study_write_end(w, FMB_LE, study_draw(w, 3, 20));
        if (study_random_chance(&w->g, 40)) {
            study_write_sum(w, kept + t, wide, 1);
            study_write_end(w, FMB_GE, study_draw(w, 0, 2));
        }
    }
    for (int x = kept; x < kept + n; x++) {
        study_write_least(w, x, 0);
        if (study_random_chance(&w->g, 40))
            study_write_most(w, x, study_draw(w, 1, 9));
    }
}

/* Totals of totals, each with rough bounds; the top ones are kept. */
void study_image_totals(study_writer *w)
{
    int tops = study_draw(w, 2, 4), each = study_draw(w, 2, 3), n = tops + tops * each;
    int leaves = study_draw(w, n / 2, n), all = n + leaves;
    if (!study_write_image(w, all, tops))
        return;
    for (int t = 0; t < tops; t++) {
        study_write_term(w, t, -1);
        study_write_sum(w, tops + t * each, each, 1);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int m = tops; m < n; m++) {
        study_write_term(w, m, -1);
        for (int l = n; l < all; l++)
            if ((l + m) % (n - tops) == 0 || study_random_chance(&w->g, 25))
                study_write_term(w, l, study_draw(w, 1, 3));
        study_write_end(w, FMB_EQ, 0);
        study_write_most(w, m, study_draw(w, 10, 60));
    }
    for (int l = n; l < all; l++) {
        study_write_least(w, l, 0);
        study_write_most(w, l, study_draw(w, 2, 12));
    }
}

/* What a state costs to be steered, by absolute values of inputs. */
void study_image_steered(study_writer *w)
{
    int states = study_draw(w, 1, 3), steps = study_draw(w, 2, 4), at = states + 1;
    if (!study_write_image(w, at + 2 * steps, at))
        return;
    for (int t = 0; t < steps; t++) {
        for (int side = -1; side <= 1; side += 2) {
            study_write_term(w, at + steps + t, 1);
            study_write_term(w, at + t, side);
            study_write_end(w, FMB_GE, 0);
        }
        for (int row = study_draw(w, 1, 3); row > 0; row--) {
            for (int x = 0; x < states; x++)
                study_write_term(w, x, study_random_between(&w->g, -5, 5));
            for (int u = 0; u <= t; u++)
                study_write_term(w, at + u, study_random_between(&w->g, -3, 3));
            study_write_end(w, FMB_LE, study_draw(w, 3, 15));
        }
    }
    study_write_sum(w, at + steps, steps, 1);
    study_write_term(w, states, -1);
    study_write_end(w, FMB_LE, 0);
    study_write_box(w, at, steps, -study_draw(w, 2, 6), 6);
}

/* Power that a heater may take in each hour, so that a room that cools stays warm enough. */
void study_image_warmth(study_writer *w)
{
    int hours = study_draw(w, 3, 6), rooms = study_draw(w, 1, 2), room = hours;
    if (!study_write_image(w, hours + rooms * (hours + 1) + rooms * hours, hours))
        return;
    int heat = hours + rooms * (hours + 1);
    for (int t = 0; t < hours; t++) {
        study_write_term(w, t, 1);
        for (int r = 0; r < rooms; r++)
            study_write_term(w, heat + r * hours + t, -1);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int r = 0; r < rooms; r++, room += hours + 1) {
        int keeps = study_draw(w, 6, 9);
        for (int t = 0; t < hours; t++) {
            study_write_least(w, heat + r * hours + t, 0);
            study_write_most(w, heat + r * hours + t, study_draw(w, 3, 8));
            study_write_term(w, room + t + 1, 10);
            study_write_term(w, room + t, -keeps);
            study_write_term(w, heat + r * hours + t, -study_draw(w, 6, 14));
            study_write_end(w, FMB_EQ, 0);
        }
        for (int t = 0; t <= hours; t++) {
            study_write_least(w, room + t, 5);
            study_write_most(w, room + t, study_draw(w, 9, 15));
        }
    }
}
