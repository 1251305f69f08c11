/* images_fitted.c: projections that were invented for the fit of the choice of ways: what it learns
 * from many families holds for others, too. The first ones mix rows of all kinds. */
#include "study/program/writer.h"

/* ---- rows of all kinds ----------------------------------------------------------------------- */

/* Of 100 rows, so many name all variables, others one to four; are strict; equalities; go through
 * the planted point. */
typedef struct mixture {
    int full, strict, equal, tight;
    int64_t most; /* of a coefficient */
} mixture;

/* A row around the point -1, 0, 1, -1, ..., or around 0, beside n variables from the first. */
static void write_mixed_row(study_writer *w, int n, const mixture *m, bool around_zero)
{
    int64_t at = 0;
    int terms = study_random_chance(&w->g, m->full) ? n : study_draw(w, 1, 4);
    for (int t = 0; t < terms; t++) {
        int64_t coef = study_random_nonzero(&w->g, -m->most, m->most);
        int x = terms == n ? t : study_draw(w, 0, n - 1);
        study_write_term(w, x, coef);
        at += coef * (around_zero ? 0 : x % 3 - 1);
    }
    bool equal = study_random_chance(&w->g, m->equal);
    bool tight = equal || study_random_chance(&w->g, m->tight);
    bool strict = !tight && study_random_chance(&w->g, m->strict);
    at += tight ? 0 : study_random_between(&w->g, 1, 9) * m->most;
    study_write_end(w, equal ? FMB_EQ : strict ? FMB_LT : FMB_LE, at);
}

static mixture draw_mixture(study_writer *w)
{
    static const int64_t MOST[] = {1, 3, 9, 99, 9999, 9999999999};
    mixture m;
    m.full = study_draw(w, 0, 3) * 33;
    m.strict = study_random_chance(&w->g, 30) ? 50 : 0;
    m.tight = study_random_chance(&w->g, 30) ? 30 : 0;
    m.equal = 0;
    m.most = MOST[study_draw(w, 0, 5)];
    return m;
}

/* Rows of all kinds, in a box or none. */
void study_image_mixed(study_writer *w)
{
    int n = study_draw(w, 4, 9), rows = study_draw(w, n + 1, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 1, n - 2)))
        return;
    mixture m = draw_mixture(w);
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, false);
    if (study_random_chance(&w->g, 50))
        study_write_box(w, 0, n, -study_draw(w, 2, 9), 9);
}

/* All rows through 0. */
void study_image_fans(study_writer *w)
{
    int n = study_draw(w, 4, 8), rows = study_draw(w, n + 1, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n - 2)))
        return;
    mixture m = draw_mixture(w);
    m.tight = 100;
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, true);
    int signs = study_draw(w, 0, n);
    for (int x = n - signs; x < n; x++)
        study_write_least(w, x, 0);
}

/* A quarter of the rows are equalities. */
void study_image_bound(study_writer *w)
{
    int n = study_draw(w, 6, 14), rows = study_draw(w, n, 2 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n / 2)))
        return;
    mixture m = draw_mixture(w);
    m.equal = 25;
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, false);
    int bounded = study_draw(w, 0, n);
    study_write_box(w, 0, bounded, -9, 9);
}

/* Many rows in few variables. */
void study_image_plenty(study_writer *w)
{
    int n = study_draw(w, 3, 5), rows = study_draw(w, 20, 80);
    if (!study_write_image(w, n, study_draw(w, 1, n - 1)))
        return;
    mixture m = draw_mixture(w);
    m.most = m.most == 1 ? 2 : m.most;
    for (int r = 0; r < rows; r++)
        write_mixed_row(w, n, &m, false);
}

/* Many rows of numbers around 0: polars of points, of which one or two variables go. */
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

/* ---- rows in places -------------------------------------------------------------------------- */

/* Blocks of variables of their own, bound together by what stays. */
void study_image_blocks(study_writer *w)
{
    int kept = study_draw(w, 2, 5), blocks = study_draw(w, 2, 4), each = study_draw(w, 2, 3);
    if (!study_write_image(w, kept + blocks * each, kept))
        return;
    for (int b = 0; b < blocks; b++) {
        int first = kept + b * each;
        for (int rows = study_draw(w, each + 1, 3 * each); rows > 0; rows--) {
            for (int x = 0; x < each; x++)
                study_write_term(w, first + x, study_random_between(&w->g, -5, 5));
            for (int x = 0; x < kept; x++)
                if (study_random_chance(&w->g, 40))
                    study_write_term(w, x, study_random_between(&w->g, -5, 5));
            study_write_end(w, FMB_LE, study_draw(w, 1, 30));
        }
        if (study_random_chance(&w->g, 60))
            study_write_box(w, first, each, 0, study_draw(w, 3, 20));
    }
}

/* Rows of neighbours along a line or a ring, some way apart of which some stay. */
void study_image_band(study_writer *w)
{
    int n = study_draw(w, 7, 13), wide = study_draw(w, 2, 4), step = n % 3 ? 3 : n % 2 ? 2 : 5;
    int last = study_random_chance(&w->g, 50) ? n : n - wide + 1;
    if (!study_write_image(w, n, study_draw(w, 2, 4)))
        return;
    for (int i = 0; i < last; i++)
        for (int rows = study_draw(w, 1, 2); rows > 0; rows--) {
            for (int t = 0; t < wide; t++)
                study_write_term(w, (i + t) * step % n, study_random_between(&w->g, -4, 4));
            study_write_end(w, FMB_LE, study_draw(w, 0, 20));
        }
    study_write_box(w, 0, n, -study_draw(w, 5, 20), 20);
}

/* Sums of some variables are between bounds, as counters along a road or pipe tell. */
void study_image_measured(study_writer *w)
{
    int n = study_draw(w, 5, 9), sums = study_draw(w, n - 1, 2 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n - 3)))
        return;
    for (int s = 0; s < sums; s++) {
        int first = study_draw(w, 0, n - 2), count = study_draw(w, 2, n - first);
        int64_t least = study_draw(w, 2, 4) * count;
        study_write_sum(w, first, count, 1);
        study_write_end(w, FMB_GE, least);
        study_write_sum(w, first, count, 1);
        study_write_end(w, FMB_LE, least + study_draw(w, 2, 30));
    }
    for (int x = 0; x < n; x++)
        study_write_least(w, x, 0);
}

/* Differences of two are bounded, and some sums of several. */
void study_image_differences(study_writer *w)
{
    int n = study_draw(w, 5, 11), pairs = study_draw(w, n, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n / 2)))
        return;
    for (int p = 0; p < pairs; p++) {
        int x = study_draw(w, 0, n - 1);
        study_write_term(w, x, 1);
        study_write_term(w, (x + study_draw(w, 1, n - 1)) % n, -1);
        study_write_end(w, FMB_LE, study_draw(w, 0, 15));
    }
    for (int s = study_draw(w, 0, 3); s > 0; s--) {
        int first = study_draw(w, 0, n - 3);
        study_write_sum(w, first, study_draw(w, 2, 3), 1);
        study_write_end(w, FMB_LE, study_draw(w, 0, 20));
    }
    study_write_box(w, 0, study_draw(w, 1, n), -20, 20);
}

/* What is at least some functions of what is below it, in layers. */
void study_image_layers(study_writer *w)
{
    int each = study_draw(w, 2, 3), layers = study_draw(w, 2, 3), n = each * (layers + 1);
    if (!study_write_image(w, n, each))
        return;
    for (int l = 0; l < layers; l++)
        for (int y = l * each; y < (l + 1) * each; y++)
            for (int rows = study_draw(w, 2, 3); rows > 0; rows--) {
                study_write_term(w, y, 1);
                for (int x = (l + 1) * each; x < (l + 2) * each; x++)
                    study_write_term(w, x, study_random_between(&w->g, -3, 3));
                study_write_end(w, FMB_GE, study_draw(w, -9, 9));
            }
    study_write_box(w, layers * each, each, -study_draw(w, 2, 9), 9);
    if (study_random_chance(&w->g, 60))
        study_write_box(w, 0, layers * each, -99, study_draw(w, 20, 99));
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

/* Some of each set are needed; what all cost stays, too. */
void study_image_covers(study_writer *w)
{
    int n = study_draw(w, 5, 9), sets = study_draw(w, 4, 10), kept = study_draw(w, 2, 4);
    if (!study_write_image(w, 1 + n, kept))
        return;
    study_write_term(w, 0, -1);
    for (int x = 1; x <= n; x++)
        study_write_term(w, x, study_draw(w, 1, 9));
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_LE, 0);
    for (int s = 0; s < sets; s++) {
        for (int x = 1; x <= n; x++)
            if (x - 1 == s % n || study_random_chance(&w->g, 35))
                study_write_term(w, x, 1);
        study_write_end(w, FMB_GE, 1);
    }
    study_write_box(w, 1, n, 0, study_draw(w, 1, 3));
}

/* Numbers in order, the sums of whose first ones are bounded. */
void study_image_sorted(study_writer *w)
{
    int n = study_draw(w, 5, 9), kept = study_draw(w, 2, 4), step = n % 2 ? 2 : n % 3 ? 3 : 5;
    if (!study_write_image(w, n, kept))
        return;
    for (int i = 0; i + 1 < n; i++) {
        study_write_term(w, i * step % n, 1);
        study_write_term(w, (i + 1) * step % n, -study_draw(w, 1, 2));
        study_write_end(w, study_random_chance(&w->g, 20) ? FMB_LT : FMB_LE, 2);
    }
    for (int size = 2; size <= n; size += study_draw(w, 1, 2)) {
        for (int i = 0; i < size; i++)
            study_write_term(w, i * step % n, i % 2 ? 3 : 2);
        study_write_end(w, FMB_LE, study_draw(w, 5, 10) * size);
    }
    study_write_least(w, 0, -study_draw(w, 1, 50));
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

/* Shares that sum up to 1, and whose ratios are bounded. */
void study_image_shares(study_writer *w)
{
    int n = study_draw(w, 4, 9), ratios = study_draw(w, n, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n - 2)))
        return;
    for (int r = 0; r < ratios; r++) {
        int x = study_draw(w, 0, n - 1);
        study_write_term_q(w, x, 1, (uint64_t)study_draw(w, 1, 12));
        study_write_term(w, (x + study_draw(w, 1, n - 1)) % n, -1);
        study_write_end(w, FMB_LE, 0);
    }
    for (int x = 0; x < n; x++)
        study_write_least(w, x, 0);
    study_write_sum(w, 0, n, 1);
    study_write_end(w, FMB_EQ, 1);
}

/* ---- more variables than are asked for ------------------------------------------------------- */

/* What a state costs to be steered, by absolute values of inputs. */
void study_image_steered(study_writer *w)
{
    int states = study_draw(w, 1, 3), steps = study_draw(w, 2, 4), at = states + 1;
    if (!study_write_image(w, at + 2 * steps, at))
        return;
    for (int t = 0; t < steps; t++) {
        for (int side = -1; side <= 1; side += 2) {
            study_write_term(w, at + steps + t, 1);
            study_write_term(w, at + t, side);
            study_write_end(w, FMB_GE, 0);
        }
        for (int row = study_draw(w, 1, 3); row > 0; row--) {
            for (int x = 0; x < states; x++)
                study_write_term(w, x, study_random_between(&w->g, -5, 5));
            for (int u = 0; u <= t; u++)
                study_write_term(w, at + u, study_random_between(&w->g, -3, 3));
            study_write_end(w, FMB_LE, study_draw(w, 3, 15));
        }
    }
    study_write_sum(w, at + steps, steps, 1);
    study_write_term(w, states, -1);
    study_write_end(w, FMB_LE, 0);
    study_write_box(w, at, steps, -study_draw(w, 2, 6), 6);
}

/* Sums over windows of time, and stocks by then: these stay. */
void study_image_windows(study_writer *w)
{
    int kept = study_draw(w, 2, 4), n = study_draw(w, 5, 10), wide = study_draw(w, 2, 4);
    if (!study_write_image(w, kept + n, kept))
        return;
    for (int k = 0; k < kept; k++) {
        study_write_term(w, k, -1);
        study_write_sum(w, kept, (k + 1) * n / kept, 1);
        study_write_end(w, study_random_chance(&w->g, 70) ? FMB_EQ : FMB_GE, 0);
    }
    for (int t = 0; t + wide <= n; t++) {
        study_write_sum(w, kept + t, wide, 1);
        study_write_end(w, FMB_LE, study_draw(w, 3, 20));
        if (study_random_chance(&w->g, 40)) {
            study_write_sum(w, kept + t, wide, 1);
            study_write_end(w, FMB_GE, study_draw(w, 0, 2));
        }
    }
    for (int x = kept; x < kept + n; x++) {
        study_write_least(w, x, 0);
        if (study_random_chance(&w->g, 40))
            study_write_most(w, x, study_draw(w, 1, 9));
    }
}

/* Totals of totals, each with rough bounds; those on top stay. */
void study_image_totals(study_writer *w)
{
    int tops = study_draw(w, 2, 4), each = study_draw(w, 2, 3), n = tops + tops * each;
    int leaves = study_draw(w, n / 2, n), all = n + leaves;
    if (!study_write_image(w, all, tops))
        return;
    for (int t = 0; t < tops; t++) {
        study_write_term(w, t, -1);
        study_write_sum(w, tops + t * each, each, 1);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int m = tops; m < n; m++) {
        study_write_term(w, m, -1);
        for (int l = n; l < all; l++)
            if ((l + m) % (n - tops) == 0 || study_random_chance(&w->g, 25))
                study_write_term(w, l, study_draw(w, 1, 3));
        study_write_end(w, FMB_EQ, 0);
        study_write_most(w, m, study_draw(w, 10, 60));
    }
    for (int l = n; l < all; l++) {
        study_write_least(w, l, 0);
        study_write_most(w, l, study_draw(w, 2, 12));
    }
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
