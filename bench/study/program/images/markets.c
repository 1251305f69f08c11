/* markets.c: prices, shares of a gain, production possibilities.
 *
 * Sources: Banker, Charnes, Cooper 1984 (efficient frontiers, doi 10.1287/mnsc.30.9.1078);
 * Edirisinghe, Naik, Uppal 1993 (hedges with costs, doi 10.2307/2331152); Gillies 1959 (the core
 * of a game).
 */
#include "study/program/writer.h"

/* Production possibilities as mixtures of observed units: inputs and outputs are kept. */
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

/* Shares of a gain that no coalition improves on; those of some players are kept. */
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

/* Prices of packages, no more than those of their parts and no less than those of each; single
 * ones stay. */
void study_image_packages(study_writer *w)
{
    int goods = study_draw(w, 2, 4), all = (1 << goods) - 1;
    if (!study_write_image(w, all, goods))
        return;
    int place[16], singles = 0, others = goods;
    for (int s = 1; s <= all; s++)
        place[s] = (s & (s - 1)) == 0 ? singles++ : others++;
    for (int s = 1; s <= all; s++)
        for (int t = s + 1; t <= all; t++) {
            if ((s & t) == 0) {
                study_write_term(w, place[s | t], 1);
                study_write_term(w, place[s], -1);
                study_write_term(w, place[t], -1);
                study_write_end(w, FMB_LE, 0);
            } else if ((s & t) == s && study_random_chance(&w->g, 40)) {
                study_write_term(w, place[t], 1);
                study_write_term(w, place[s], -1);
                study_write_end(w, FMB_GE, study_draw(w, 0, 3));
            }
        }
    int64_t whole = study_draw(w, 2, 10) * 5;
    study_write_term(w, place[all], 1);
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_GE, whole);
}
