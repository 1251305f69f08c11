/* choices.c: orders, matchings, pay of pairs, decisions under chance.
 *
 * Sources: Groetschel, Juenger, Reinelt 1985 (orders by pairs, doi 10.1007/BF01582011); Edmonds
 * 1965 (matchings); Shapley, Shubik 1971 (pay of pairs, doi 10.1007/BF01753437); Puterman 1994
 * (values and visits of decision processes, doi 10.1002/9780470316887).
 */
#include "study/program/writer.h"

/* How many voters rank one of three or four candidates before another: shares of all orders go. */
void study_image_majority(study_writer *w)
{
    static const char ORDER[24][5] = {"0123", "0213", "1023", "1203", "2013", "2103",
                                      "0132", "0231", "1032", "1230", "2031", "2130",
                                      "0312", "0321", "1302", "1320", "2301", "2310",
                                      "3012", "3021", "3102", "3120", "3201", "3210"};
    int candidates = study_draw(w, 3, 4), orders = candidates == 3 ? 6 : 24, pairs = 0;
    int kept = candidates == 3 ? 3 : study_draw(w, 3, 6), voters = study_draw(w, 7, 99);
    if (!study_write_image(w, kept + orders, kept))
        return;
    for (int a = 0; a < candidates; a++)
        for (int b = a + 1; b < candidates && pairs < kept; b++, pairs++) {
            study_write_term(w, pairs, -1);
            for (int o = 0; o < orders; o++) {
                int first = 0;
                while (ORDER[o][first] != '0' + a && ORDER[o][first] != '0' + b)
                    first++;
                study_write_term(w, kept + o, ORDER[o][first] == '0' + a);
            }
            study_write_end(w, FMB_EQ, 0);
        }
    for (int o = 0; o < orders; o++)
        study_write_least(w, kept + o, study_random_chance(&w->g, 20) ? 1 : 0);
    study_write_sum(w, kept, orders, 1);
    study_write_end(w, FMB_EQ, voters);
    for (int o = 0; o < orders; o += study_draw(w, 1, 5))
        study_write_most(w, kept + o, study_draw(w, 1 + voters / 6, voters));
}

/* Degrees of fractional matchings of a graph, whose arcs are weighed, with bounds of odd sets. */
void study_image_degrees(study_writer *w)
{
    int nodes = study_draw(w, 4, 8), arcs = study_draw(w, nodes, 2 * nodes);
    int kept = study_draw(w, 2, 5 < nodes ? 5 : nodes), from[16], to[16];
    bool long_weights = study_random_chance(&w->g, 40);
    if (!study_write_image(w, kept + arcs, kept))
        return;
    for (int a = 0; a < arcs; a++) {
        from[a] = a % nodes;
        to[a] = (a + study_draw(w, 1, nodes - 1)) % nodes;
        study_write_least(w, kept + a, 0);
    }
    for (int v = 0; v < nodes; v++) {
        int64_t most = study_draw(w, 1, 4), unit = long_weights ? 1000003 : 1;
        study_write_term(w, v < kept ? v : 0, v < kept ? -1 : 0);
        for (int a = 0; a < arcs; a++)
            if (from[a] == v || to[a] == v)
                study_write_term(w, kept + a,
                                 long_weights ? study_random_between(&w->g, 900000, 1100000) : 1);
        study_write_end(w, v < kept ? FMB_EQ : FMB_LE, v < kept ? 0 : most * unit);
        if (v < kept)
            study_write_most(w, v, most * unit);
    }
    for (int v = 0; v + 2 < nodes; v += 2) { /* no more than one arc among three nodes */
        for (int a = 0; a < arcs; a++)
            if (from[a] >= v && from[a] <= v + 2 && to[a] >= v && to[a] <= v + 2)
                study_write_term(w, kept + a, 1);
        study_write_end(w, FMB_LE, 1);
    }
}

/* Pay of workers and firms that no pair improves on; of some of them it stays. */
void study_image_payoffs(study_writer *w)
{
    int workers = study_draw(w, 2, 6), firms = study_draw(w, 2, 6), all = workers + firms;
    int64_t unit = study_random_chance(&w->g, 40) ? 1234567 : 1;
    if (!study_write_image(w, all, study_draw(w, 1, all - 2 < 5 ? all - 2 : 5)))
        return;
    bool strict = study_random_chance(&w->g, 30);
    for (int i = 0; i < workers; i++)
        for (int j = 0; j < firms; j++) {
            /* Workers come first, third, ... so that some of both sides stay. */
            int worker = i < firms ? 2 * i : firms + i,
                firm = j < workers ? 2 * j + 1 : workers + j;
            int64_t gain = study_draw(w, 1, 20) * unit;
            study_write_term(w, worker, 1);
            study_write_term(w, firm, 1);
            study_write_end(w, strict && i == j ? FMB_GT : FMB_GE, gain);
        }
    for (int p = 0; p < all; p++)
        study_write_least(w, p, 0);
    study_write_sum(w, 0, all, 1);
    study_write_end(w, study_random_chance(&w->g, 30) ? FMB_EQ : FMB_LE, 12 * all * unit);
}

/* Bounds of the values of a decision process, of which those of some states stay. */
void study_image_decisions(study_writer *w)
{
    int states = study_draw(w, 3, 10), kept = study_draw(w, 1, states - 2 < 4 ? states - 2 : 4);
    int actions = study_draw(w, 1, 3), next = study_draw(w, 1, 3);
    int64_t whole = study_random_chance(&w->g, 50) ? 100 : 1000000;
    if (!study_write_image(w, states, kept))
        return;
    for (int s = 0; s < states; s++)
        for (int a = 0; a < actions; a++) {
            int64_t left = whole - whole / 20; /* what comes later counts 0.95 */
            study_write_term(w, s, whole);
            for (int k = 0; k < next; k++) {
                int64_t part = k + 1 == next ? left : study_random_between(&w->g, 0, left);
                study_write_term(w, study_draw(w, 0, states - 1), -part);
                left -= part;
            }
            study_write_end(w, FMB_GE, whole * study_draw(w, -5, 9));
        }
    for (int k = study_draw(w, 1, 3); k > 0; k--) {
        for (int s = 0; s < states; s++)
            study_write_term(w, s, study_draw(w, 0, 4));
        study_write_term(w, study_draw(w, 0, states - 1), 1);
        study_write_end(w, FMB_LE, study_draw(w, 300, 900) * states);
    }
}

/* What can be expected of several rewards at once: how often actions are taken goes. */
void study_image_visits(study_writer *w)
{
    int rewards = study_draw(w, 2, 4), states = study_draw(w, 2, 6), actions = study_draw(w, 2, 4);
    if (!study_write_image(w, rewards + states * actions, rewards))
        return;
    for (int r = 0; r < rewards; r++) {
        study_write_term(w, r, -10);
        for (int x = 0; x < states * actions; x++)
            study_write_term(w, rewards + x, study_draw(w, -4, 9));
        study_write_end(w, FMB_EQ, 0);
    }
    int next[32];
    for (int x = 0; x < states * actions; x++) {
        study_write_least(w, rewards + x, 0);
        next[x] = study_draw(w, 0, states - 1);
    }
    for (int s = 0; s + 1 < states; s++) { /* from next[x] half go on to the first state */
        for (int x = 0; x < states * actions; x++)
            study_write_term(w, rewards + x,
                             10 * (x / actions == s) - 5 * (next[x] == s) - 5 * (s == 0));
        study_write_end(w, FMB_EQ, 0);
    }
    study_write_sum(w, rewards, states * actions, 1);
    study_write_end(w, FMB_EQ, 1000);
}
