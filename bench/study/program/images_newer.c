/* images_newer.c: projections that were invented before the last fit of the choice of ways, to
 * judge it: no fit has seen them, and none may.
 *
 * Sources: Jewell 1962 (flows with gains, doi 10.1287/opre.10.4.476); Postnikov 2009 (sums of
 * simplices, doi 10.1093/imrn/rnn153); McCormick 1976 (envelopes of products, doi
 * 10.1007/BF01580665); Pritsker, Watters, Wolfe 1969 (a variable for each slot of a job, doi
 * 10.1287/mnsc.16.1.93); Beale, Tomlin 1970 (functions by their bends).
 */
#include "study/program/writer.h"

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

/* A sum of simplices, each on some of the axes: all of it lies in a plane. */
void study_image_simplices(study_writer *w)
{
    int n = study_draw(w, 3, 5), simplices = study_draw(w, 3, 6), at = n, all = n;
    unsigned corner[6];
    for (int s = 0; s < simplices; s++) {
        corner[s] = (unsigned)study_draw(w, 1, (1 << n) - 1);
        all += __builtin_popcount(corner[s]);
    }
    if (!study_write_image(w, all, n))
        return;
    for (int x = 0; x < n; x++) {
        study_write_term(w, x, -1);
        at = n;
        for (int s = 0; s < simplices; s++)
            for (int y = 0; y < n; y++)
                if (corner[s] >> y & 1) {
                    study_write_term(w, at, y == x);
                    at++;
                }
        study_write_end(w, FMB_EQ, 0);
    }
    at = n;
    for (int s = 0; s < simplices; s++) {
        int corners = __builtin_popcount(corner[s]);
        for (int y = 0; y < corners; y++) {
            study_write_least(w, at + y, 0);
            study_write_term(w, at + y, 1);
        }
        study_write_end(w, FMB_EQ, study_draw(w, 1, 9));
        at += corners;
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

/* Lines and planes close to points of ten digits: some coefficients and the greatest error stay,
 * the errors of points go. */
void study_image_fits(study_writer *w)
{
    int n = study_draw(w, 2, 4), points = study_draw(w, 3, 7), kept = study_draw(w, 1, n) + 1;
    if (!study_write_image(w, n + 1 + points, kept))
        return;
    for (int p = 0; p < points; p++) {
        int64_t x[4], y = study_random_between(&w->g, -9999999999, 9999999999);
        for (int j = 0; j < n; j++)
            x[j] = study_random_between(&w->g, -9999999999, 9999999999);
        for (int side = -1; side <= 1; side += 2) {
            study_write_term(w, n + 1 + p, 1000000000);
            for (int j = 0; j < n; j++)
                study_write_term(w, 1 + j, side * x[j]);
            study_write_end(w, FMB_GE, side * y);
        }
        study_write_term(w, n + 1 + p, study_draw(w, 1, 3));
        study_write_term(w, 0, -1);
        study_write_end(w, FMB_LE, 0);
    }
    study_write_sum(w, n + 1, points, 1);
    study_write_end(w, FMB_LE, study_draw(w, 40, 400));
    study_write_box(w, 1, n, -99, 99);
}

/* Moments of a distribution on some numbers, in units of powers of 2, and bounds on tails. */
void study_image_moments(study_writer *w)
{
    int moments = study_draw(w, 2, 4), numbers = study_draw(w, 5, 12), shift = study_draw(w, 0, 8);
    if (!study_write_image(w, moments + numbers, moments))
        return;
    for (int m = 0; m < moments; m++) {
        int64_t unit = (int64_t)1 << (shift * (m % 3));
        study_write_term(w, m, m % 2 ? unit : -unit);
        for (int k = 0; k < numbers; k++) {
            int64_t power = 1;
            for (int e = 0; e <= m; e++)
                power *= 2 * k - numbers + 2;
            study_write_term_q(w, moments + k, m % 2 ? -power : power, (uint64_t)1 << (2 * m));
        }
        study_write_end(w, FMB_EQ, 0);
    }
    study_write_sum(w, moments, numbers, 1);
    study_write_end(w, FMB_EQ, 1);
    for (int k = 0; k < numbers; k++)
        study_write_least(w, moments + k, 0);
    for (int tail = study_draw(w, 1, 4); tail > 0; tail--) {
        int from = study_draw(w, 1, numbers - 2);
        study_write_sum(w, moments + from, numbers - from, 20);
        study_write_end(w, FMB_LE, study_draw(w, 4, 19));
    }
}

/* Rows that follow from given ones, by multipliers: a cone of them, and some strictly. */
void study_image_implied(study_writer *w)
{
    int n = study_draw(w, 2, 5), given = study_draw(w, n + 2, 2 * n + 3);
    if (!study_write_image(w, n + 1 + given, n + 1))
        return;
    for (int j = 0; j < n; j++) {
        study_write_term(w, j, -1);
        for (int g = 0; g < given; g++)
            study_write_term(w, n + 1 + g, study_draw(w, -3, 3));
        study_write_end(w, FMB_EQ, 0);
    }
    study_write_term(w, n, -1);
    for (int g = 0; g < given; g++)
        study_write_term(w, n + 1 + g, study_draw(w, 1, 9));
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_LT : FMB_LE, 0);
    for (int g = 0; g < given; g++)
        study_write_least(w, n + 1 + g, 0);
    if (study_random_chance(&w->g, 50))
        study_write_most(w, n, study_draw(w, 3, 30));
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

/* Sums of products of numbers in boxes, each by its envelope. */
void study_image_products(study_writer *w)
{
    int numbers = study_draw(w, 2, 4), sums = study_draw(w, 1, 2), products = study_draw(w, 2, 5);
    int kept = sums + study_draw(w, 1, numbers), x = sums, z = sums + numbers;
    if (!study_write_image(w, z + products, kept))
        return;
    for (int s = 0; s < sums; s++) {
        study_write_term(w, s, -1);
        for (int p = 0; p < products; p++)
            study_write_term(w, z + p, study_random_nonzero(&w->g, -5, 5));
        study_write_end(w, FMB_EQ, 0);
    }
    for (int p = 0; p < products; p++) {
        int a = study_draw(w, 0, numbers - 2), b = study_draw(w, a + 1, numbers - 1);
        for (int corner = 0; corner < 4; corner++) { /* (a - ea)(b - eb) at the ends 0 and 7 */
            int ea = corner & 1 ? 7 : 0, eb = corner & 2 ? 7 : 0;
            study_write_term(w, z + p, 1);
            study_write_term(w, x + a, -eb);
            study_write_term(w, x + b, -ea);
            study_write_end(w, ea == eb ? FMB_GE : FMB_LE, -ea * eb);
        }
    }
    study_write_box(w, x, numbers, 0, 7);
}

/* Functions of one number each by their bends, under a bound on all values; numbers stay. */
void study_image_bends(study_writer *w)
{
    int functions = study_draw(w, 2, 3), bends = study_draw(w, 3, 6);
    int kept = functions + 1, all = kept + functions * bends;
    if (!study_write_image(w, all, kept))
        return;
    study_write_term(w, functions, -1);
    for (int b = kept; b < all; b++)
        study_write_term(w, b, study_draw(w, -9, 20));
    study_write_end(w, study_random_chance(&w->g, 30) ? FMB_LT : FMB_EQ, 0);
    for (int f = 0; f < functions; f++) {
        int at = 0, first = kept + f * bends;
        study_write_term(w, f, -1);
        for (int b = 0; b < bends; b++)
            study_write_term(w, first + b, at += study_draw(w, 1, 9));
        study_write_end(w, FMB_EQ, 0);
        study_write_sum(w, first, bends, 1);
        study_write_end(w, FMB_EQ, 1);
        for (int b = 0; b < bends; b++)
            study_write_least(w, first + b, 0);
    }
    study_write_sum(w, 0, functions, 1);
    study_write_end(w, FMB_LE, study_draw(w, 8, 40));
}

/* The cell of planes with normals of -1, 0 and 1 that a planted point is in, without its walls. */
void study_image_cells(study_writer *w)
{
    int n = study_draw(w, 4, 8), planes = study_draw(w, 2 * n, 4 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n - 2)))
        return;
    for (int p = 0; p < planes; p++) {
        int64_t at = 0, right = study_draw(w, -6, 6);
        for (int x = 0; x < n; x++) {
            int normal = study_draw(w, -1, 1);
            study_write_term(w, x, normal);
            at += normal * (x % 3 - 1); /* the point is -1, 0, 1, -1, ... */
        }
        study_write_end(w, at < right ? FMB_LT : at > right ? FMB_GT : FMB_EQ, right);
    }
}
