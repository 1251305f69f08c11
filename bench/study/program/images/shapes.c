/* shapes.c: sums of simplices and vectors, cells, polars, lattices.
 *
 * Source: Postnikov 2009 (sums of simplices, doi 10.1093/imrn/rnn153).
 */
#include "study/program/writer.h"

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

/* Sums of some vectors with weights that need not end, and that leave a flat or open image. */
void study_image_weights(study_writer *w)
{
    int kept = study_draw(w, 3, 6), weights = study_draw(w, 4, 10), rank = study_draw(w, 2, kept);
    if (!study_write_image(w, kept + weights, kept))
        return;
    for (int k = 0; k < kept; k++) {
        study_write_term(w, k, 1);
        if (k >= rank)
            study_write_term(w, k - rank, study_random_between(&w->g, -2, 2));
        for (int j = 0; j < weights && k < rank; j++)
            study_write_term(w, kept + j, study_random_between(&w->g, -4, 4));
        study_write_end(w, FMB_EQ, 0);
    }
    for (int j = 0; j < weights; j++) {
        study_write_least(w, kept + j, 0);
        if (study_random_chance(&w->g, 60))
            study_write_most(w, kept + j, study_draw(w, 1, 9));
    }
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

/* A box between some pairs of planes. */
void study_image_planes(study_writer *w)
{
    int n = study_draw(w, 4, 9), planes = study_draw(w, 1, 4);
    int64_t most = study_random_chance(&w->g, 70) ? 9 : 9999999999;
    if (!study_write_image(w, n, study_draw(w, 2, n - 1)))
        return;
    study_write_box(w, 0, n, 0, study_draw(w, 1, 9));
    for (int p = 0; p < planes; p++)
        for (int side = -1; side <= 1; side += 2) {
            for (int x = 0; x < n; x++)
                study_write_term(w, x, side * (most / 2 + (x + 1) * (p + 2) * 7 % 11 * most / 22));
            study_write_end(w, FMB_LE, side > 0 ? most * (n + p) : -most * p / 2);
        }
}

/* Many rows of numbers around 0: polars of points; one or two variables are eliminated. */
void study_image_polar(study_writer *w)
{
    int n = study_draw(w, 4, 6), rows = study_draw(w, n + 2, 3 * n + 6);
    int64_t most = study_random_chance(&w->g, 50) ? 30 : 2000000000;
    if (!study_write_image(w, n, n - study_draw(w, 1, 2)))
        return;
    for (int r = 0; r < rows; r++) {
        for (int x = 0; x < n; x++)
            study_write_term(w, x, study_random_between(&w->g, -most, most));
        study_write_end(w, FMB_LE, most);
    }
}

/* Heights on a lattice, whose neighbours differ by no more than a bound; corners stay. */
void study_image_lattice(study_writer *w)
{
    int wide = study_draw(w, 2, 4), high = study_draw(w, 2, 3), n = wide * high;
    if (!study_write_image(w, n, study_draw(w, 2, n > 4 ? 4 : 2)))
        return;
    for (int i = 0; i < n; i++)
        for (int way = 0; way < 2; way++) {
            int x = way ? i + wide : i % wide + 1 < wide ? i + 1 : n;
            for (int side = -1; side <= 1 && x < n; side += 2) {
                study_write_term(w, i * (n - 1) % n, side);
                study_write_term(w, x * (n - 1) % n, -side);
                study_write_end(w, FMB_LE, study_draw(w, 1, 6));
            }
        }
    study_write_sum(w, 0, n, 1);
    study_write_end(w, study_random_chance(&w->g, 60) ? FMB_EQ : FMB_LE, 10);
}
