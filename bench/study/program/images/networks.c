/* networks.c: flows and cuts in networks, sums of tables.
 *
 * Sources: Jewell 1962 (flows with gains, doi 10.1287/opre.10.4.476); Schuster, Hilgetag 1994
 * (fluxes of a steady state, doi 10.1142/S0218339094000131).
 */
#include "study/program/writer.h"

/* Capacities of arcs that every cut between two places has: potentials are eliminated. */
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

/* What comes into a network whose arcs lose or gain hundredths; some nodes let things go. */
void study_image_leaks(study_writer *w)
{
    int ends = study_draw(w, 2, 4), nodes = study_draw(w, 3, 6), arcs = nodes + study_draw(w, 1, 5);
    if (!study_write_image(w, ends + arcs, ends))
        return;
    int from[16], to[16], gain[16];
    for (int a = 0; a < arcs; a++) {
        from[a] = a < nodes ? a : study_draw(w, 0, nodes - 1);
        to[a] = (from[a] + study_draw(w, 1, nodes - 1)) % nodes;
        gain[a] = study_draw(w, 70, 115);
    }
    for (int v = 0; v < nodes; v++) {
        if (v < ends)
            study_write_term(w, v, v % 2 ? -1 : 1);
        for (int a = 0; a < arcs; a++) {
            if (from[a] == v)
                study_write_term(w, ends + a, -1);
            else if (to[a] == v)
                study_write_term_q(w, ends + a, gain[a], 100);
        }
        study_write_end(w, study_random_chance(&w->g, 25) ? FMB_GE : FMB_EQ, 0);
    }
    for (int a = 0; a < arcs; a++) {
        study_write_least(w, ends + a, 0);
        if (study_random_chance(&w->g, 80))
            study_write_most(w, ends + a, study_draw(w, 3, 30));
    }
}

/* Loads of links, by how much of each demand takes which route. */
void study_image_routes(study_writer *w)
{
    int links = study_draw(w, 3, 6), kept = study_draw(w, 2, 3), demands = study_draw(w, 2, 4);
    int each = study_draw(w, 2, 3), routes = demands * each;
    if (!study_write_image(w, kept + routes, kept))
        return;
    for (int l = 0; l < links; l++) {
        if (l < kept)
            study_write_term(w, l, -1);
        for (int r = 0; r < routes; r++)
            if (r % links == l || study_random_chance(&w->g, 40))
                study_write_term(w, kept + r, 1);
        study_write_end(w, l < kept ? FMB_EQ : FMB_LE, l < kept ? 0 : study_draw(w, 15, 60));
    }
    for (int d = 0; d < demands; d++) {
        study_write_sum(w, kept + d * each, each, 1);
        int64_t demand = study_draw(w, 3, 20);
        study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_GE, demand);
    }
    for (int r = 0; r < routes; r++)
        study_write_least(w, kept + r, 0);
}

/* Sums of some variables are between bounds, as counters along a road or pipe tell. */
void study_image_measured(study_writer *w)
{
    int n = study_draw(w, 5, 9), sums = study_draw(w, n - 1, 2 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n - 3)))
        return;
    for (int s = 0; s < sums; s++) {
        int first = study_draw(w, 0, n - 2), count = study_draw(w, 2, n - first);
        int64_t least = study_draw(w, 2, 4) * count;
        study_write_sum(w, first, count, 1);
        study_write_end(w, FMB_GE, least);
        study_write_sum(w, first, count, 1);
        study_write_end(w, FMB_LE, least + study_draw(w, 2, 30));
    }
    for (int x = 0; x < n; x++)
        study_write_least(w, x, 0);
}
