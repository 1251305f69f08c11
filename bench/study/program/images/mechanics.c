/* mechanics.c: forces, positions, tolerances, reachable states.
 *
 * Source: Mishra, Schwartz, Sharir 1987 (grips with friction, doi 10.1007/BF01840373).
 */
#include "study/program/writer.h"

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

/* Forces in the bars of a plane truss in equilibrium; loads at some joints are kept. */
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

/* Ingredients of a mixture and its contents; some contents are kept, in strict bounds. */
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
