/* lifted.c: polytopes that have fewer rows in more variables, projected back.
 *
 * Sources: Balas 1998 (Disjunctive programming: properties of the convex hull of feasible points),
 * Yannakakis 1991 (parity polytopes, doi 10.1016/0022-0000(91)90024-Y); Birkhoff's theorem for the
 * orders of numbers.
 */
#include "study/program/writer.h"

/* A row over dim variables from `at` on, and others from `from` on with the opposite sign unless it
 * is negative; right side b, times the variable `times` unless that is negative. */
static void write_row(study_writer *w, const int64_t *a, int dim, int at, int from, int64_t b,
                      int times)
{
    for (int j = 0; j < dim; j++) {
        study_write_term(w, at + j, a[j]);
        if (from >= 0)
            study_write_term(w, from + j, -a[j]);
    }
    if (times >= 0)
        study_write_term(w, times, -b);
    study_write_end(w, FMB_LE, times >= 0 ? 0 : b);
}

/* Rows of a polytope around (or near) the origin: so many, after a box. */
static void write_polytope(study_writer *w, int dim, int rows, int at, int from)
{
    int64_t a[8];
    for (int i = 0; i < 2 * dim + rows; i++) {
        for (int j = 0; j < dim; j++)
            a[j] =
                i < 2 * dim ? (i / 2 == j) * (i % 2 ? -1 : 1) : study_random_between(&w->g, -7, 7);
        write_row(w, a, dim, at, from, study_draw(w, i < 2 * dim ? 4 : 8, i < 2 * dim ? 9 : 40),
                  -1);
    }
}

/* x, then per polytope its part of x and its weight. The last part is x minus the others. */
void study_image_union(study_writer *w)
{
    int dim = study_draw_size(w, 2, 3), parts = study_draw(w, 2, dim == 2 ? 4 : 3), step = dim + 1;
    if (!study_write_image(w, dim + parts * step, dim))
        return;
    for (int j = 0; j < dim; j++) {
        study_write_term(w, j, -1);
        for (int k = 0; k < parts; k++)
            study_write_term(w, dim + k * step + j, 1);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int k = 0; k < parts; k++)
        study_write_term(w, dim + k * step + dim, 1);
    study_write_end(w, FMB_EQ, 1);
    for (int k = 0; k < parts; k++) {
        int at = dim + k * step;
        study_write_least(w, at + dim, 0);
        for (int i = study_draw(w, dim + 2, 2 * dim + 3); i > 0; i--) {
            int64_t a[8], b = study_draw(w, 2, 20);
            for (int j = 0; j < dim; j++) {
                a[j] = study_random_nonzero(&w->g, -7, 7);
                b += a[j] * (3 * k + j); /* they lie apart */
            }
            write_row(w, a, dim, at, -1, b, at + dim);
        }
        for (int i = 0; i < 2 * dim; i++) {
            int64_t a[8] = {0};
            a[i / 2] = i % 2 ? -1 : 1;
            write_row(w, a, dim, at, -1, 4 + a[i / 2] * (3 * k + i / 2), at + dim);
        }
    }
}

void study_image_sum(study_writer *w)
{
    int dim = study_draw(w, 2, 4) + w->larger / 4, rows = study_draw_size(w, 2, dim == 4 ? 4 : 7);
    if (!study_write_image(w, 2 * dim, dim))
        return;
    write_polytope(w, dim, rows, dim, -1);
    write_polytope(w, dim, rows, 0, dim);
}

void study_image_zonotope(study_writer *w)
{
    int usual = study_draw(w, 2, 4), dim = usual + w->larger / 4,
        segments = study_draw_size(w, usual + 3, usual == 2 ? 20 : 12 - usual);
    if (!study_write_image(w, dim + segments, dim))
        return;
    for (int j = 0; j < dim; j++) {
        study_write_term(w, j, -1);
        for (int k = 0; k < segments; k++)
            study_write_term(w, dim + k, study_random_between(&w->g, -9, 9));
        study_write_end(w, FMB_EQ, 0);
    }
    for (int k = 0; k < segments; k++) {
        study_write_least(w, dim + k, -1);
        study_write_most(w, dim + k, 1);
    }
}

void study_image_orbit(study_writer *w)
{
    int n = study_draw(w, 3, 6);
    int64_t number[6];
    if (!study_write_image(w, n + n * n, n))
        return;
    for (int i = 0; i < n; i++)
        number[i] = study_random_between(&w->g, -9, 9);
    for (int i = 0; i < n; i++) {
        study_write_term(w, i, -1);
        for (int j = 0; j < n; j++)
            study_write_term(w, n + i * n + j, number[j]);
        study_write_end(w, FMB_EQ, 0);
        for (int across = 0; across < 2; across++) {
            for (int j = 0; j < n; j++)
                study_write_term(w, across ? n + i * n + j : n + j * n + i, 1);
            study_write_end(w, FMB_EQ, 1);
        }
    }
    for (int k = 0; k < n * n; k++)
        study_write_least(w, n + k, 0);
}

/* One weight per sum that is allowed, and shares of each variable in it; some variables are turned
 * around, x -> 1 - x. */
void study_image_parity(study_writer *w)
{
    int n = study_draw_size(w, 4, 6), odd = study_draw(w, 0, 1), sums = (n - odd) / 2 + 1;
    if (!study_write_image(w, n + sums * (n + 1), n))
        return;
    for (int i = 0; i < n; i++) {
        bool turned = study_random_chance(&w->g, 50);
        study_write_term(w, i, turned ? 1 : -1);
        for (int t = 0; t < sums; t++)
            study_write_term(w, n + sums + i * sums + t, 1);
        study_write_end(w, FMB_EQ, turned);
    }
    for (int t = 0; t < sums; t++)
        study_write_term(w, n + t, 1);
    study_write_end(w, FMB_EQ, 1);
    for (int t = 0; t < sums; t++) {
        study_write_least(w, n + t, 0);
        study_write_term(w, n + t, -(2 * t + odd));
        for (int i = 0; i < n; i++)
            study_write_term(w, n + sums + i * sums + t, 1);
        study_write_end(w, FMB_EQ, 0);
        for (int i = 0; i < n; i++) {
            study_write_least(w, n + sums + i * sums + t, 0);
            study_write_term(w, n + sums + i * sums + t, 1);
            study_write_term(w, n + t, -1);
            study_write_end(w, FMB_LE, 0);
        }
    }
}

/* An arc from (i, room left r) leaves item i, or takes it; x_i is what flows over arcs that take.
 * Arcs: n + 2 (i (room + 1) + r) + take. Equalities in the order of items. */
void study_image_knapsack(study_writer *w)
{
    int n = study_draw(w, 3, 4), room = study_draw(w, 5, 8), size[4];
    if (!study_write_image(w, n + 2 * n * (room + 1), n))
        return;
    for (int i = 0; i < n; i++)
        size[i] = study_draw(w, 1, room / 2);
    for (int i = 0; i < n; i++) {
        study_write_term(w, i, -1);
        for (int r = 0; r <= room; r++)
            study_write_term(w, n + 2 * (i * (room + 1) + r) + 1, 1);
        study_write_end(w, FMB_EQ, 0);
        for (int r = 0; r <= room; r++) {
            int out = n + 2 * (i * (room + 1) + r), in = out - 2 * (room + 1);
            study_write_term(w, out, -1);
            study_write_term(w, out + 1, -1);
            if (i > 0)
                study_write_term(w, in, 1);
            if (i > 0 && r + size[i - 1] <= room)
                study_write_term(w, in + 2 * size[i - 1] + 1, 1);
            study_write_end(w, FMB_EQ, i == 0 && r == room ? -1 : 0);
            study_write_least(w, out, 0);
            if (r >= size[i])
                study_write_least(w, out + 1, 0);
            else {
                study_write_term(w, out + 1, 1);
                study_write_end(w, FMB_EQ, 0);
            }
        }
    }
}
