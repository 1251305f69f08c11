/* families_flow.c: assignment, transport, and production over periods: degenerate and sparse, as in
 * practice. */
#include "study/program/writer.h"

/* The largest k with k k per <= n, at least 1. */
static int side_of(int n, int per)
{
    int k = 1;
    while ((k + 1) * (k + 1) * per <= n)
        k++;
    return k;
}

/* x_ij >= 0 from a sources to b sinks, the supplies and demands are given. */
static void write_shipments(study_writer *w, int a, int b, int64_t out, int64_t in)
{
    for (int i = 0; i < a; i++) {
        for (int j = 0; j < b; j++)
            study_write_term(w, i * b + j, 1);
        study_write_end(w, FMB_EQ, out);
    }
    for (int j = 0; j < b; j++) {
        for (int i = 0; i < a; i++)
            study_write_term(w, i * b + j, 1);
        study_write_end(w, FMB_EQ, in);
    }
    for (int j = 0; j < a * b; j++)
        study_write_least(w, j, 0);
    study_write_any_goal(w);
}

void study_assignment(study_writer *w)
{
    int k = side_of(w->variables, 1);
    if (study_write_begin(w, k * k))
        write_shipments(w, k, k, 1, 1);
}

/* 12 from each of k sources, 6 into each of 2k sinks: every other vertex is degenerate. */
void study_transport(study_writer *w)
{
    int k = side_of(w->variables, 2);
    if (study_write_begin(w, 2 * k * k))
        write_shipments(w, k, 2 * k, 12, 6);
}

enum { ACTIVITIES = 5, GOODS = 2, PERIOD = ACTIVITIES + GOODS + 1 };

/* Stock of good g: old + what the activities make, some of them out of the other good = new +
 * demand. */
static void write_balance(study_writer *w, int t, int g)
{
    int at = t * PERIOD;
    for (int k = 0; k < ACTIVITIES; k++)
        if (k % GOODS == g)
            study_write_term_q(w, at + k, study_random_between(&w->g, 800, 1600), 1000);
        else if (k == ACTIVITIES - 1)
            study_write_term_q(w, at + k, -study_random_between(&w->g, 50, 250), 1000);
    study_write_term(w, at + ACTIVITIES + g, -1);
    if (t > 0)
        study_write_term_q(w, at - PERIOD + ACTIVITIES + g, 97, 100);
    study_write_end_q(w, FMB_EQ, study_random_between(&w->g, 100, 900), 10);
}

/* Hours of the activities <= those of the period, which grow by a tenth at most. */
static void write_hours(study_writer *w, int t)
{
    int at = t * PERIOD, hours = at + PERIOD - 1;
    for (int k = 0; k < ACTIVITIES; k++)
        study_write_term_q(w, at + k, study_random_between(&w->g, 1, 60), 8);
    study_write_term(w, hours, -1);
    study_write_end(w, FMB_LE, 0);
    if (t == 0)
        return;
    study_write_term(w, hours, 10);
    study_write_term(w, hours - PERIOD, -11);
    study_write_end(w, FMB_LE, 0);
}

/* The objective is the total cost, to be minimized. */
void study_staircase(study_writer *w)
{
    int periods = w->variables < PERIOD ? 1 : w->variables / PERIOD;
    if (!study_write_begin(w, periods * PERIOD))
        return;
    for (int t = 0; t < periods; t++) {
        for (int g = 0; g < GOODS; g++)
            write_balance(w, t, g);
        write_hours(w, t);
    }
    for (int j = 0; j < periods * PERIOD; j++) {
        study_write_least(w, j, 0);
        w->goal[j] = -(double)study_random_between(&w->g, 1, 90);
    }
}
