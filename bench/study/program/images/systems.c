/* systems.c: behaviours of systems: networks, controllers, programs, clocks.
 *
 * Sources: Ehlers 2017 (triangles around rectifiers, doi 10.1007/978-3-319-68167-2_19); Jones,
 * Kerrigan, Maciejowski 2004 (equality set projection: controllable sets); Alur, Dill 1994 (clocks,
 * doi 10.1016/0304-3975(94)90010-8).
 */
#include "study/program/writer.h"

/* ---- networks of rectifiers ------------------------------------------------------------------ */

enum { MOST_NEURONS = 8 };

/* A layer: its first variable, and what its neurons lie between. */
typedef struct layer {
    int at, size;
    int64_t lo[MOST_NEURONS], hi[MOST_NEURONS];
} layer;

/* The variable `to` REL factor (a.x + b) + c over a layer's x. */
static void write_neuron(study_writer *w, const layer *in, const int64_t *a, int to, int64_t times,
                         int64_t factor, fmb_rel rel, int64_t right)
{
    study_write_term(w, to, times);
    for (int j = 0; j < in->size; j++)
        study_write_term(w, in->at + j, -factor * a[j]);
    study_write_end(w, rel, right);
}

/* y = max(0, a.x + b), or the triangle around it; linear: y = a.x + b. */
static void write_rectifier(study_writer *w, const layer *in, layer *out, int k, bool linear)
{
    int64_t a[MOST_NEURONS], b = study_random_between(&w->g, -2, 2), lo = b, hi = b;
    for (int j = 0; j < in->size; j++) {
        a[j] = study_random_between(&w->g, -3, 3);
        lo += a[j] * (a[j] > 0 ? in->lo[j] : in->hi[j]);
        hi += a[j] * (a[j] > 0 ? in->hi[j] : in->lo[j]);
    }
    int y = out->at + k;
    if (linear || lo >= 0)
        write_neuron(w, in, a, y, 1, 1, FMB_EQ, b);
    else if (hi <= 0)
        write_neuron(w, in, a, y, 1, 0, FMB_EQ, 0);
    else {
        study_write_least(w, y, 0);
        write_neuron(w, in, a, y, 1, 1, FMB_GE, b);
        write_neuron(w, in, a, y, hi - lo, hi, FMB_LE, hi * (b - lo));
    }
    out->lo[k] = linear || lo > 0 ? lo : 0;
    out->hi[k] = linear || hi > 0 ? hi : 0;
}

/* Outputs are kept and come first; then inputs, then hidden layers. */
void study_image_relu(study_writer *w)
{
    int outputs = study_draw(w, 2, 3) + w->larger / 2, inputs = study_draw(w, 2, 3),
        hidden = study_draw(w, 1, 2), size[2];
    int n = outputs + inputs;
    for (int k = 0; k < hidden; k++)
        n += size[k] = study_draw_size(w, 3, 5);
    if (!study_write_image(w, n, outputs))
        return;
    layer in = {.at = outputs, .size = inputs};
    for (int j = 0; j < inputs; j++) {
        in.lo[j] = -1;
        in.hi[j] = 1;
        study_write_least(w, in.at + j, -1);
        study_write_most(w, in.at + j, 1);
    }
    for (int k = 0; k <= hidden; k++) {
        bool last = k == hidden;
        layer out = {.at = last ? 0 : in.at + in.size, .size = last ? outputs : size[k]};
        for (int i = 0; i < out.size; i++)
            write_rectifier(w, &in, &out, i, last);
        in = out;
    }
}

/* ---- control --------------------------------------------------------------------------------- */

enum { MOST_STATES = 5, MOST_STEPS = 7 };

/* 10^t x(t) = sum of the row's terms over x(0) and the inputs. */
static void write_state_bounds(study_writer *w, const int64_t *row, int n, int64_t bound)
{
    for (int side = -1; side <= 1; side += 2) {
        for (int j = 0; j < n; j++)
            study_write_term(w, j, side * row[j]);
        study_write_end(w, FMB_LE, bound);
    }
}

/* x(t+1) = A x(t) + b u(t), numbers with one decimal; |x| <= 10, |u| <= 1. */
void study_image_control(study_writer *w)
{
    int states = study_draw_size(w, 2, 3), steps = study_draw_size(w, 3, 5), n = states + steps;
    int64_t a[MOST_STATES][MOST_STATES], b[MOST_STATES], power = 1;
    int64_t x[MOST_STATES][MOST_STATES + MOST_STEPS] = {{0}}, next[MOST_STATES];
    if (!study_write_image(w, n, states))
        return;
    for (int i = 0; i < states; i++) {
        x[i][i] = 1;
        b[i] = study_random_between(&w->g, -10, 10);
        for (int j = 0; j < states; j++)
            a[i][j] = (i == j ? 10 : 0) + study_random_between(&w->g, -5, 5);
    }
    for (int t = 0; t <= steps; t++) {
        for (int i = 0; i < states; i++)
            write_state_bounds(w, x[i], n, 10 * power);
        for (int c = 0; t < steps && c < n; c++) {
            for (int i = 0; i < states; i++) {
                next[i] = c == states + t ? b[i] * power : 0;
                for (int j = 0; j < states; j++)
                    next[i] += a[i][j] * x[j][c];
            }
            for (int i = 0; i < states; i++)
                x[i][c] = next[i];
        }
        power *= 10;
    }
    for (int t = 0; t < steps; t++) {
        study_write_least(w, states + t, -1);
        study_write_most(w, states + t, 1);
    }
}

/* ---- programs -------------------------------------------------------------------------------- */

/* v >= c.y for some y >= 0 with A y >= B p + b, p in a box: v and p are kept. */
void study_image_value(study_writer *w)
{
    int parameters = study_draw(w, 1, 2), y = study_draw(w, 4, 9), at = 1 + parameters;
    if (!study_write_image(w, at + y, at))
        return;
    study_write_term(w, 0, -1);
    for (int j = 0; j < y; j++)
        study_write_term(w, at + j, study_draw(w, 1, 9));
    study_write_end(w, FMB_LE, 0);
    for (int i = study_draw(w, y / 2 + 1, y + 2); i > 0; i--) {
        for (int j = 0; j < y; j++)
            study_write_term(w, at + j, -study_draw(w, -2, 7));
        for (int j = 0; j < parameters; j++)
            study_write_term(w, 1 + j, study_draw(w, -5, 5));
        study_write_end(w, FMB_LE, -study_draw(w, -3, 9));
    }
    for (int j = 0; j < y; j++)
        study_write_least(w, at + j, 0);
    for (int j = 0; j < parameters; j++) {
        study_write_least(w, 1 + j, -5);
        study_write_most(w, 1 + j, 5);
    }
}

/* a <= p x_i+1 - q x_i <= b; the kept variables are the first, one in the middle, and the last. */
void study_image_chain(study_writer *w)
{
    int n = study_draw(w, 12, 60), middle = study_draw(w, 4, n - 4);
    if (!study_write_image(w, n, 3))
        return;
    for (int i = 0; i < n; i++) {
        int var = i == 0 ? 0 : i == middle ? 1 : i == n - 1 ? 2 : i + 2 - (i > middle);
        int next = i + 1 == middle ? 1 : i + 1 == n - 1 ? 2 : i + 3 - (i + 1 > middle);
        int64_t p = study_draw(w, 1, 3), q = study_random_nonzero(&w->g, -2, 2);
        study_write_least(w, var, -study_draw(w, 5, 30));
        study_write_most(w, var, study_draw(w, 5, 30));
        for (int side = -1; i + 1 < n && side <= 1; side += 2) {
            study_write_term(w, next, side * p);
            study_write_term(w, var, -side * q);
            study_write_end(w, FMB_LE, study_draw(w, 0, 9));
        }
    }
}

/* ---- networks -------------------------------------------------------------------------------- */

/* Arcs of random ends between nodes; the first stay. What the last node takes is free. */
void study_image_flow(study_writer *w)
{
    int nodes = study_draw(w, 5, 8), arcs = study_draw(w, 2 * nodes, 3 * nodes), from[32], to[32];
    if (!study_write_image(w, arcs, study_draw(w, 2, 4)))
        return;
    for (int k = 0; k < arcs; k++) {
        from[k] = study_draw(w, 0, nodes - 2);
        to[k] = study_draw(w, from[k] + 1, nodes - 1);
        study_write_least(w, k, 0);
        study_write_most(w, k, study_draw(w, 3, 20));
    }
    for (int v = 1; v + 1 < nodes; v++) {
        for (int k = 0; k < arcs; k++)
            study_write_term(w, k, (to[k] == v) - (from[k] == v));
        study_write_end(w, FMB_EQ, 0);
    }
}

void study_image_transport(study_writer *w)
{
    int sources = study_draw(w, 3, 4), sinks = study_draw(w, 3, 5);
    int64_t into[5], all = 0;
    if (!study_write_image(w, sources * sinks, study_draw(w, 2, 4)))
        return;
    for (int j = 0; j < sinks; j++)
        all += into[j] = sources * study_draw(w, 2, 9);
    for (int i = 0; i < sources; i++) {
        for (int j = 0; j < sinks; j++)
            study_write_term(w, (i * sinks + j) * 7 % (sources * sinks), 1);
        study_write_end(w, FMB_EQ, all / sources);
    }
    for (int j = 0; j < sinks; j++) {
        for (int i = 0; i < sources; i++)
            study_write_term(w, (i * sinks + j) * 7 % (sources * sinks), 1);
        study_write_end(w, FMB_EQ, into[j]);
    }
    for (int k = 0; k < sources * sinks; k++)
        study_write_least(w, k, 0);
}

/* Clocks now stay; they were x before a delay d >= 0: x' = x + d, but those that were set to 0.
 * Then x' , then x, then d. */
void study_image_clocks(study_writer *w)
{
    int n = study_draw(w, 3, 6);
    if (!study_write_image(w, 2 * n + 1, n))
        return;
    study_write_least(w, 2 * n, 0);
    for (int i = 0; i < n; i++) {
        study_write_term(w, i, 1);
        study_write_term(w, n + i, -(i % 3 != 0));
        study_write_term(w, 2 * n, -1);
        study_write_end(w, FMB_EQ, 0);
        study_write_least(w, n + i, 0);
        study_write_most(w, n + i, study_draw(w, 5, 20));
        study_write_most(w, i, study_draw(w, 15, 30));
        for (int j = 0; j < n; j++) {
            if (i == j || study_random_chance(&w->g, 40))
                continue;
            study_write_term(w, n + i, 1);
            study_write_term(w, n + j, -1);
            study_write_end(w, FMB_LE, study_draw(w, 0, 9));
        }
    }
}
