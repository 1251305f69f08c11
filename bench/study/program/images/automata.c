/* automata.c: clocks of automata, loops of programs, gates.
 *
 * Source: Tjeng, Xiao, Tedrake 2019 and McCormick 1976 (bounds of gates, doi 10.1007/BF01580665).
 */
#include "study/program/writer.h"

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

/* Loops with steps: iterations of two nests on the same elements; the difference is kept. */
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
