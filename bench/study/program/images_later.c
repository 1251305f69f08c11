/* images_later.c: projections that came after a choice of ways was fixed; now in the fit, too.
 *
 * Sources: Banker, Charnes, Cooper 1984 (what can be made of what, doi 10.1287/mnsc.30.9.1078);
 * Edirisinghe, Naik, Uppal 1993 (hedges with costs, doi 10.2307/2331152); Mishra, Schwartz, Sharir
 * 1987 (grips with friction, doi 10.1007/BF01840373); Tjeng, Xiao, Tedrake 2019 and McCormick 1976
 * (bounds of gates, doi 10.1007/BF01580665).
 */
#include "study/program/writer.h"

/* What can be made of what, as mixtures of observed units show: inputs and outputs stay. */
void study_image_frontier(study_writer *w)
{
    int inputs = study_draw(w, 1, 3), outputs = study_draw(w, 1, 2), units = study_draw(w, 5, 12);
    int kept = inputs + outputs;
    if (!study_write_image(w, kept + units, kept))
        return;
    for (int k = 0; k < kept; k++) {
        study_write_term(w, k, 1);
        for (int u = 0; u < units; u++)
            study_write_term(w, kept + u, -study_draw(w, 1, 60));
        study_write_end(w, k < inputs ? FMB_GE : FMB_LE, 0);
        study_write_least(w, k, 0);
    }
    for (int u = 0; u < units; u++)
        study_write_least(w, kept + u, 0);
    for (int u = 0; u < units; u++)
        study_write_term(w, kept + u, 1);
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_LE, 1);
}

/* Money and shares that are enough to pay at the ends of a tree of prices, where trades cost. */
void study_image_hedge(study_writer *w)
{
    int depth = study_draw(w, 1, 3), inner = (1 << depth) - 1, nodes = 2 * inner + 1;
    int price[16] = {study_draw(w, 40, 60)};
    if (!study_write_image(w, 2 * nodes + 2 * inner, 2))
        return;
    for (int v = 1; v < nodes; v++)
        price[v] = price[(v - 1) / 2] + (v % 2 ? study_draw(w, 2, 9) : -study_draw(w, 2, 9));
    for (int v = 0; v < inner; v++) {
        int buy = 2 * nodes + 2 * v, sell = buy + 1;
        study_write_least(w, buy, 0);
        study_write_least(w, sell, 0);
        for (int child = 2 * v + 1; child <= 2 * v + 2; child++) {
            study_write_term(w, 2 * child, 50); /* money */
            study_write_term(w, 2 * v, -50);
            study_write_term(w, buy, 51 * price[v]);
            study_write_term(w, sell, -49 * price[v]);
            study_write_end(w, FMB_LE, 0);
            study_write_term(w, 2 * child + 1, 1); /* shares */
            study_write_term(w, 2 * v + 1, -1);
            study_write_term(w, buy, -1);
            study_write_term(w, sell, 1);
            study_write_end(w, FMB_EQ, 0);
        }
    }
    for (int v = inner; v < nodes; v++) {
        study_write_term(w, 2 * v, 1);
        study_write_term(w, 2 * v + 1, price[v]);
        study_write_end(w, FMB_GE, price[v] > price[0] ? price[v] - price[0] : 0);
    }
}

/* Forces and turning moments that fingers with friction withstand, none too strong. */
void study_image_grip(study_writer *w)
{
    int kept = study_draw(w, 3, 5), fingers = study_draw(w, 2, 4), edges = study_draw(w, 2, 3);
    if (!study_write_image(w, kept + fingers * edges, kept))
        return;
    for (int k = 0; k < kept; k++) {
        study_write_term(w, k, 1);
        for (int j = 0; j < fingers * edges; j++)
            study_write_term(w, kept + j, study_random_between(&w->g, -6, 6));
        study_write_end(w, FMB_EQ, 0);
    }
    for (int f = 0; f < fingers; f++) {
        for (int j = 0; j < edges; j++)
            study_write_least(w, kept + f * edges + j, 0);
        for (int j = 0; j < edges; j++)
            study_write_term(w, kept + f * edges + j, study_draw(w, 1, 3));
        study_write_end(w, FMB_LE, study_draw(w, 4, 12));
    }
}

/* Where gate g stands: the last one stays, behind what goes in. */
static int place_of_gate(int in, int gates, int g)
{
    return g == gates - 1 ? in : in + 1 + g;
}

/* Gates behind one another, relaxed to numbers between 0 and 1: what goes in and comes out stays.
 */
void study_image_gates(study_writer *w)
{
    int in = study_draw(w, 2, 4), gates = study_draw(w, 2, 6);
    if (!study_write_image(w, in + gates, in + 1))
        return;
    for (int v = 0; v < in + gates; v++) {
        study_write_least(w, v, 0);
        study_write_most(w, v, 1);
    }
    for (int g = 0; g < gates; g++) { /* of the gate before it, and something earlier */
        int self = place_of_gate(in, gates, g);
        int a = g == 0 ? 0 : place_of_gate(in, gates, g - 1);
        int b = g < 2 ? study_draw(w, 1, in - 1) : study_draw(w, 0, in + g - 2);
        b = b < in ? b : place_of_gate(in, gates, b - in);
        bool both = study_random_chance(&w->g, 50); /* and, or */
        for (int side = 0; side < 2; side++) {
            study_write_term(w, self, 1);
            study_write_term(w, side ? b : a, -1);
            study_write_end(w, both ? FMB_LE : FMB_GE, 0);
        }
        study_write_term(w, self, 1);
        study_write_term(w, a, -1);
        study_write_term(w, b, -1);
        study_write_end(w, both ? FMB_GE : FMB_LE, both ? -1 : 0);
    }
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
