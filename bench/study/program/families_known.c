/* families_known.c: programs with a name, whose best values are known.
 *
 * Sources: Klee and Minty 1972, How good is the simplex algorithm?; Beale 1955, Cycling in the dual
 * simplex algorithm; Balinski and Tucker 1969, Duality theory of linear programs (Kuhn's example).
 */
#include "study/program/writer.h"

/* max sum 2^(n-j) x_j with 2 sum_{j<i} 2^(i-j) x_j + x_i <= 5^i, x >= 0: it is 5^n. Numbers have 64
 * bits up to n = 27. */
void study_klee_minty(study_writer *w)
{
    int n = w->variables < 27 ? w->variables : 27;
    int64_t power = 1;
    if (!study_write_begin(w, n))
        return;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++)
            study_write_term(w, j, (int64_t)2 << (i - j));
        study_write_term(w, i, 1);
        study_write_end(w, FMB_LE, power *= 5);
        w->goal[i] = (double)((int64_t)1 << (n - 1 - i));
    }
    for (int i = 0; i < n; i++)
        study_write_least(w, i, 0);
    study_write_best(w, power, 1);
}

/* Rows of 4 coefficients num[]/den[] <= right, and x >= 0. */
static void write_four(study_writer *w, const int64_t num[4], const uint64_t den[4], int64_t right)
{
    for (int j = 0; j < 4; j++)
        study_write_term_q(w, j, num[j], den[j]);
    study_write_end(w, FMB_LE, right);
}

static void write_nonnegative(study_writer *w)
{
    for (int j = 0; j < fmb_system_dim(w->to->s); j++)
        study_write_least(w, j, 0);
}

/* The goal is times 100, as it has to be whole: 75 x1 - 15000 x2 + 2 x3 - 600 x4. */
void study_beale(study_writer *w)
{
    static const double goal[4] = {75, -15000, 2, -600};
    if (!study_write_begin(w, 4))
        return;
    write_four(w, (int64_t[]){1, -60, -1, 9}, (uint64_t[]){4, 1, 25, 1}, 0);
    write_four(w, (int64_t[]){1, -90, -1, 3}, (uint64_t[]){2, 1, 50, 1}, 0);
    write_four(w, (int64_t[]){0, 0, 1, 0}, (uint64_t[]){1, 1, 1, 1}, 1);
    write_nonnegative(w);
    for (int j = 0; j < 4; j++)
        w->goal[j] = goal[j];
    study_write_best(w, 5, 1);
}

void study_kuhn(study_writer *w)
{
    static const double goal[4] = {2, 3, -1, -12};
    if (!study_write_begin(w, 4))
        return;
    write_four(w, (int64_t[]){-2, -9, 1, 9}, (uint64_t[]){1, 1, 1, 1}, 0);
    write_four(w, (int64_t[]){1, 1, -1, -2}, (uint64_t[]){3, 1, 3, 1}, 0);
    write_four(w, (int64_t[]){2, 3, -1, -12}, (uint64_t[]){1, 1, 1, 1}, 2);
    write_nonnegative(w);
    for (int j = 0; j < 4; j++)
        w->goal[j] = goal[j];
    study_write_best(w, 2, 1);
}

/* 0 <= x <= 1, and sum x <= n, which touches; without it the variables would have nothing to do
 * with each other. */
void study_cube(study_writer *w)
{
    int n = w->variables;
    if (!study_write_begin(w, n))
        return;
    for (int j = 0; j < n; j++) {
        study_write_least(w, j, 0);
        study_write_most(w, j, 1);
        w->goal[j] = 1;
    }
    for (int j = 0; j < n; j++)
        study_write_term(w, j, 1);
    study_write_end(w, FMB_LE, n);
    study_write_best(w, n, 1);
}

/* -1 <= x1 <= 1, x_i - 2 <= 2 x_i+1 <= x_i + 2: each variable from -2 to 2 at most. The last one at
 * most 2 - 2^(1-n). */
void study_chain(study_writer *w)
{
    int n = w->variables;
    if (!study_write_begin(w, n))
        return;
    study_write_least(w, 0, -1);
    study_write_most(w, 0, 1);
    for (int i = 0; i + 1 < n; i++) {
        for (int side = -1; side <= 1; side += 2) {
            study_write_term(w, i + 1, 2 * side);
            study_write_term(w, i, -side);
            study_write_end(w, FMB_LE, 2);
        }
    }
    w->goal[n - 1] = 1;
    if (n <= 60)
        study_write_best(w, ((int64_t)1 << n) - 1, (uint64_t)1 << (n - 1));
}

/* x1 = 1/3, 3 x_i+1 = 2 x_i + 1, 0 <= x_n <= 1: one solution, whose denominators are 3^i. */
void study_chain_equal(study_writer *w)
{
    int n = w->variables;
    if (!study_write_begin(w, n))
        return;
    study_write_term(w, 0, 3);
    study_write_end(w, FMB_EQ, 1);
    for (int i = 0; i + 1 < n; i++) {
        study_write_term(w, i + 1, 3);
        study_write_term(w, i, -2);
        study_write_end(w, FMB_EQ, 1);
    }
    study_write_least(w, n - 1, 0);
    study_write_most(w, n - 1, 1);
    study_write_any_goal(w);
}

/* The differences of neighbours on a circle cannot all be positive; other rows are around 0. */
void study_strict_cycle(study_writer *w)
{
    int n = w->variables, others = w->rows - n;
    if (!study_write_begin(w, n))
        return;
    for (int i = 0; i < n; i++) {
        study_write_term(w, i, 1);
        study_write_term(w, (i + 1) % n, -1);
        study_write_end(w, FMB_LT, 0);
    }
    for (int i = 0; i < others; i++) {
        for (int k = 0; k < 4; k++) {
            int64_t coef = study_random_nonzero(&w->g, -9, 9);
            study_write_term(w, (int)study_random_between(&w->g, 0, n - 1), coef);
        }
        study_write_end(w, FMB_LE, study_random_between(&w->g, 1, 50));
    }
    study_write_any_goal(w);
}
