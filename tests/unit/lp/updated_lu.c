/* updated_lu.c: factors of a sparse basis in doubles: each solution is multiplied back. */
#include <criterion/criterion.h>

#include <math.h>
#include <stdlib.h>

#include "lp/linalg/doubles/updated_lu.h"
#include "support/support.h"

enum { MOST = 40, ROWS = 90 };

typedef struct bench {
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_program p;
    fmb_scaled_program reals;
    fmb_updated_lu factors;
    size_t n, member[MOST];
    fmb_indexed_vector in, out;
} bench;

/* Sparse rows, some of one term, some that depend on others. */
static void append_random_row(bench *b, support_rng *g, int share)
{
    int64_t s[MOST + 1] = {0};
    fmb_vec v = {.s = s};
    int one = support_chance(g, 30) ? support_between(g, 0, (int)b->n - 1) : -1;
    for (size_t j = 0; j < b->n; j++)
        if (one < 0 ? support_chance(g, share) : (int)j == one)
            s[j] = support_between(g, -9, 9);
    s[support_between(g, 0, (int)b->n - 1)] |= one < 0;
    fmb_vec_measure(&v, b->n + 1);
    cr_assert_eq(fmb_program_add_dense(&b->p, &v, FMB_LE), FMB_OK);
}

static void open_bench(bench *b, support_rng *g)
{
    fmb_options o = {.size = sizeof o};
    *b = (bench){.n = (size_t)support_between(g, 1, MOST)};
    int share = support_between(g, 1, 30);
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    fmb_program_init(&b->p, &b->mem, (int)b->n);
    for (size_t i = 0; i < ROWS; i++)
        append_random_row(b, g, share);
    cr_assert_eq(fmb_scaled_program_init(&b->reals, &b->run, &b->p), FMB_OK);
    cr_assert_eq(fmb_updated_lu_init(&b->factors, &b->reals), FMB_OK);
    cr_assert_eq(fmb_indexed_vector_resize(&b->in, &b->mem, b->n), FMB_OK);
    cr_assert_eq(fmb_indexed_vector_resize(&b->out, &b->mem, b->n), FMB_OK);
}

static void close_bench(bench *b)
{
    fmb_indexed_vector_free(&b->in, &b->mem);
    fmb_indexed_vector_free(&b->out, &b->mem);
    fmb_updated_lu_clear(&b->factors);
    fmb_scaled_program_clear(&b->reals);
    fmb_program_clear(&b->p);
    cr_assert_eq(b->mem.used, 0);
}

/* line[n] = the member at place r. */
static void write_line(const bench *b, size_t r, double *line)
{
    size_t i = b->member[r];
    memset(line, 0, b->n * sizeof *line);
    if (i >= FMB_UNIT)
        line[i - FMB_UNIT] = 1;
    for (size_t k = 0; i < FMB_UNIT && k < b->p.row[i].size; k++)
        line[b->p.row[i].column[k]] = b->reals.value[b->reals.start[i] + k];
}

/* A vector of few numbers, and a copy of it. */
static void draw_input(bench *b, support_rng *g, double *copy)
{
    memset(copy, 0, b->n * sizeof *copy);
    for (int k = support_between(g, 1, 4); k > 0; k--) {
        size_t j = (size_t)support_between(g, 0, (int)b->n - 1);
        if (copy[j] != 0)
            continue;
        copy[j] = support_between(g, 1, 9);
        fmb_indexed_vector_add(&b->in, j, copy[j]);
    }
}

static void check_that_it_is_empty(const fmb_indexed_vector *v)
{
    cr_assert_eq(v->count, 0);
    for (size_t k = 0; k < v->size; k++)
        cr_assert_eq(v->at[k], 0);
}

/* Places in the index are different. */
static void check_index(const fmb_indexed_vector *v)
{
    bool seen[MOST] = {false};
    for (size_t t = 0; t < v->count; t++) {
        cr_assert_not(seen[v->index[t]]);
        seen[v->index[t]] = true;
    }
}

/* How far what is solved, both ways, is from what was to be solved. */
static double find_residual(bench *b, support_rng *g)
{
    double line[MOST], given[MOST], worst = 0, largest = 1;
    draw_input(b, g, given);
    fmb_updated_lu_solve(&b->factors, &b->in, &b->out);
    check_that_it_is_empty(&b->in);
    check_index(&b->out);
    for (size_t r = 0; r < b->n; r++) {
        double sum = -given[r];
        write_line(b, r, line);
        for (size_t j = 0; j < b->n; j++)
            sum += line[j] * b->out.at[j];
        worst = fmax(worst, fabs(sum));
        largest = fmax(largest, fabs(b->out.at[r]));
    }
    draw_input(b, g, given);
    fmb_updated_lu_solve_transposed(&b->factors, &b->in, &b->out);
    check_that_it_is_empty(&b->in);
    check_index(&b->out);
    for (size_t r = 0; r < b->n; r++) {
        write_line(b, r, line);
        for (size_t j = 0; j < b->n; j++)
            given[j] -= b->out.at[r] * line[j];
        largest = fmax(largest, fabs(b->out.at[r]));
    }
    for (size_t j = 0; j < b->n; j++)
        worst = fmax(worst, fabs(given[j]));
    return worst / largest;
}

/* A row comes in where it fits; true if it does. */
static bool exchange(bench *b, support_rng *g)
{
    size_t i = (size_t)support_between(g, 0, ROWS - 1), place = 0;
    fmb_indexed_vector edge = {0};
    for (size_t k = 0; k < b->p.row[i].size; k++)
        fmb_indexed_vector_add(&b->in, (size_t)b->p.row[i].column[k],
                               b->reals.value[b->reals.start[i] + k]);
    fmb_updated_lu_solve_transposed(&b->factors, &b->in, &b->out);
    for (size_t r = 0; r < b->n; r++)
        place = fabs(b->out.at[r]) > fabs(b->out.at[place]) ? r : place;
    if (fabs(b->out.at[place]) < 1e-3)
        return false;
    cr_assert_eq(fmb_indexed_vector_resize(&edge, &b->mem, b->n), FMB_OK);
    fmb_indexed_vector_add(&b->in, place, 1);
    fmb_updated_lu_solve(&b->factors, &b->in, &edge);
    cr_assert_eq(fmb_updated_lu_pivot(&b->factors, place, i, b->out.at[place]), FMB_OK);
    fmb_indexed_vector_free(&edge, &b->mem);
    b->member[place] = i;
    return true;
}

Test(triangles, solve_what_multiplies_back)
{
    size_t units = 0, exchanges = 0;
    for (uint64_t seed = 0; seed < 1000 / WATCHED; seed++) {
        support_rng g = {seed};
        bench b;
        open_bench(&b, &g);
        for (size_t r = 0; r < b.n; r++)
            b.member[r] = support_chance(&g, 20) ? FMB_UNIT + r : r;
        cr_assert_eq(fmb_updated_lu_factor(&b.factors, b.member), FMB_OK);
        cr_assert_lt(find_residual(&b, &g), 1e-8, "seed %lu", (unsigned long)seed);
        for (int k = 0; k < 30; k++) {
            exchanges += exchange(&b, &g);
            cr_assert_lt(find_residual(&b, &g), 1e-9, "seed %lu, %d", (unsigned long)seed, k);
        }
        for (size_t r = 0; r < b.n; r++)
            units += b.member[r] >= FMB_UNIT;
        close_bench(&b);
    }
    cr_assert_gt(units, 1000 / WATCHED);
    cr_assert_gt(exchanges, 10000 / WATCHED);
}
