/* images_unseen.c: projections that were invented once a choice of ways was fixed, to judge it; now
 * they are in the fit.
 *
 * Sources: Schuster, Hilgetag 1994 (fluxes of a steady state, doi 10.1142/S0218339094000131);
 * Dantzig 1954 (shifts, doi 10.1287/opre.2.3.339); Gillies 1959 (what coalitions cannot improve);
 * Wainwright, Jordan 2008 (local consistency, doi 10.1561/2200000001); Afriat 1967 (weights behind
 * what was preferred, doi 10.2307/2525382).
 */
#include "study/program/writer.h"

/* Reactions of a network in balance; those that exchange something with the outside stay. */
void study_image_fluxes(study_writer *w)
{
    int exchanges = study_draw(w, 2, 4), substances = study_draw(w, 3, 6);
    int reactions = substances + study_draw(w, 1, 5), all = exchanges + reactions;
    if (!study_write_image(w, all, exchanges))
        return;
    for (int s = 0; s < substances; s++) {
        if (s < exchanges)
            study_write_term(w, s, s % 2 ? -1 : 1);
        for (int r = 0; r < reactions; r++)
            if (r == s || r == s + 1 || study_random_chance(&w->g, 25))
                study_write_term(w, exchanges + r, study_random_nonzero(&w->g, -2, 2));
        study_write_end(w, FMB_EQ, 0);
    }
    for (int r = 0; r < all; r++) {
        if (r == 0 || !study_random_chance(&w->g, 20)) /* others go both ways */
            study_write_least(w, r, 0);
        if (study_random_chance(&w->g, 40))
            study_write_most(w, r, study_draw(w, 5, 50));
    }
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

/* States that bounded inputs reach in some steps, in units of 2^20 and 2^-20. */
void study_image_reach(study_writer *w)
{
    static const uint64_t unit[] = {1, (uint64_t)1 << 20};
    int states = study_draw(w, 2, 3), inputs = study_draw(w, 1, 2), steps = study_draw(w, 2, 4);
    int at = states * (steps + 1), all = at + inputs * steps;
    if (!study_write_image(w, all, states))
        return;
    for (int t = 0; t < steps; t++)
        for (int x = 0; x < states; x++) {
            int to = t * states, from = to + states;
            study_write_term_q(w, to + x, 1, unit[x % 2]);
            for (int y = 0; y < states; y++)
                study_write_term_q(w, from + y, study_random_between(&w->g, -9, 9),
                                   8 * unit[y % 2]);
            for (int u = 0; u < inputs; u++)
                study_write_term(w, at + t * inputs + u, study_random_between(&w->g, -3, 3));
            study_write_end(w, FMB_EQ, 0);
        }
    for (int x = 0; x < states; x++) {
        int64_t far = study_draw(w, 1, 4) * (int64_t)unit[x % 2];
        study_write_least(w, steps * states + x, -far);
        study_write_most(w, steps * states + x, far);
    }
    for (int u = at; u < all; u++) {
        study_write_least(w, u, -study_draw(w, 1, 3));
        study_write_most(w, u, study_draw(w, 1, 3));
    }
}

/* Shares of a gain that no coalition improves on; those of some players stay. */
void study_image_coalitions(study_writer *w)
{
    int players = study_draw(w, 4, 6), all = (1 << players) - 1;
    if (!study_write_image(w, players, study_draw(w, 2, players - 2)))
        return;
    for (int s = 1; s < all; s++) {
        int size = __builtin_popcount((unsigned)s);
        if (size > 1 && study_random_chance(&w->g, 30))
            continue;
        for (int p = 0; p < players; p++)
            study_write_term(w, p, s >> p & 1);
        int64_t gain = size * size * study_draw(w, 3, 5) - 5;
        study_write_end(w, study_random_chance(&w->g, 10) ? FMB_GT : FMB_GE, gain);
    }
    for (int p = 0; p < players; p++)
        study_write_term(w, p, 1);
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_LE, 5 * players * players);
}

/* Probabilities of pairs along a chain of three values each that agree where pairs meet; those of
 * some values at both ends stay, with bounds on others. */
void study_image_beliefs(study_writer *w)
{
    enum { VALUES = 3 };
    int links = study_draw(w, 2, 3), kept = study_draw(w, 2, 4), pair = VALUES * VALUES;
    if (!study_write_image(w, kept + links * pair, kept))
        return;
    for (int k = 0; k < kept; k++) {
        int first = kept + (k % 2 ? links - 1 : 0) * pair;
        study_write_term(w, k, -1);
        for (int v = 0; v < VALUES; v++)
            study_write_term(w, first + (k % 2 ? v * VALUES + k / 2 : k / 2 * VALUES + v), 1);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int l = 0; l + 1 < links; l++)
        for (int v = 0; v + 1 < VALUES; v++) {
            for (int u = 0; u < VALUES; u++) {
                study_write_term(w, kept + l * pair + u * VALUES + v, 1);
                study_write_term(w, kept + (l + 1) * pair + v * VALUES + u, -1);
            }
            study_write_end(w, FMB_EQ, 0);
        }
    for (int l = 0; l < links; l++) {
        for (int x = 0; x < pair; x++) {
            study_write_least(w, kept + l * pair + x, 0);
            if (study_random_chance(&w->g, 25)) {
                study_write_term(w, kept + l * pair + x, study_draw(w, 3, 9));
                study_write_end(w, FMB_LE, 2);
            }
        }
        for (int x = 0; x < pair; x++)
            study_write_term(w, kept + l * pair + x, 1);
        study_write_end(w, FMB_EQ, 1);
    }
}

/* Elements of an array that a nest of loops touches, whose ends depend on outer loops and on a size
 * that stays, too. */
void study_image_accesses(study_writer *w)
{
    int subscripts = study_draw(w, 1, 3), depth = study_draw(w, 3, 6), size = subscripts;
    if (!study_write_image(w, subscripts + 1 + depth, subscripts + 1))
        return;
    for (int s = 0; s < subscripts; s++) {
        study_write_term(w, s, -1);
        for (int d = 0; d < depth; d++)
            study_write_term(w, size + 1 + d, study_random_between(&w->g, -2, 4));
        study_write_end(w, FMB_EQ, study_draw(w, -3, 3));
    }
    for (int d = 0; d < depth; d++) {
        int loop = size + 1 + d, outer = d > 0 ? size + study_draw(w, 1, d) : size;
        study_write_term(w, loop, study_draw(w, 1, 2));
        study_write_term(w, outer, study_random_chance(&w->g, 60) && d > 0 ? -1 : 0);
        study_write_end(w, FMB_GE, 0);
        study_write_term(w, loop, 1);
        study_write_term(w, study_random_chance(&w->g, 50) ? outer : size, -1);
        study_write_end(w, FMB_LE, study_draw(w, -1, 4));
    }
    study_write_least(w, size, 1);
    if (study_random_chance(&w->g, 50))
        study_write_most(w, size, study_draw(w, 20, 999));
}

/* Weights of criteria behind choices: what was preferred weighs more. Some of them stay. */
void study_image_votes(study_writer *w)
{
    int criteria = study_draw(w, 4, 7), choices = study_draw(w, criteria, 3 * criteria);
    if (!study_write_image(w, criteria, study_draw(w, 2, criteria - 2)))
        return;
    for (int c = 0; c < choices; c++) {
        int64_t all = 0;
        for (int x = 0; x < criteria; x++) {
            int64_t better = study_random_between(&w->g, -9, 9);
            if (x + 1 == criteria && all + better * (x + 1) <= 0)
                better = 1 - all / (x + 1);
            all += better * (x + 1); /* weights 1, 2, 3, ... agree with all choices */
            study_write_term(w, x, better);
        }
        study_write_end(w, study_random_chance(&w->g, 50) ? FMB_GT : FMB_GE, 0);
    }
    for (int x = 0; x < criteria; x++)
        study_write_least(w, x, 0);
    for (int x = 0; x < criteria; x++)
        study_write_term(w, x, 1);
    if (study_random_chance(&w->g, 70))
        study_write_end(w, FMB_EQ, 100);
    else
        study_write_end(w, FMB_GE, 1);
}

/* Parts with tolerances in millionths, along chains whose gaps have to stay open; some deviations
 * stay. */
void study_image_tolerances(study_writer *w)
{
    int parts = study_draw(w, 6, 12), chains = study_draw(w, 4, 10);
    if (!study_write_image(w, parts, study_draw(w, 2, 4)))
        return;
    for (int p = 0; p < parts; p++) {
        study_write_term(w, p, 1);
        study_write_end_q(w, FMB_LE, study_draw(w, 10000, 90000), 1000003);
        study_write_term(w, p, 1);
        study_write_end_q(w, FMB_GE, -study_draw(w, 10000, 90000), 1000003);
    }
    for (int c = 0; c < chains; c++) {
        for (int terms = study_draw(w, 3, 5); terms > 0; terms--) {
            int64_t lever = study_random_nonzero(&w->g, -1500000, 1500000);
            study_write_term_q(w, study_draw(w, 0, parts - 1), lever, 1000000);
        }
        int64_t gap = study_draw(w, 5000, 120000);
        study_write_end_q(w, study_random_chance(&w->g, 40) ? FMB_LT : FMB_LE, gap, 1000000);
    }
}

/* Forces in the bars of a plane truss of joints that do not move; loads at some of them stay. */
void study_image_truss(study_writer *w)
{
    int loads = study_draw(w, 2, 4), joints = study_draw(w, 2, 4), more = study_draw(w, 1, 4);
    int bars = 2 * joints + more;
    if (!study_write_image(w, loads + bars, loads))
        return;
    for (int row = 0; row < 2 * joints; row++) {
        if (row < loads)
            study_write_term(w, row, 1);
        for (int b = 0; b < bars; b++)
            if (b == row || study_random_chance(&w->g, 35))
                study_write_term_q(w, loads + b, study_random_nonzero(&w->g, -9999, 9999), 10000);
        study_write_end(w, FMB_EQ, row < loads ? 0 : study_draw(w, -2, 2));
    }
    for (int b = 0; b < bars; b++) {
        int64_t push = study_draw(w, 3, 30), pull = study_draw(w, 3, 40);
        study_write_least(w, loads + b, -push);
        if (!study_random_chance(&w->g, 10))
            study_write_most(w, loads + b, pull);
    }
}
