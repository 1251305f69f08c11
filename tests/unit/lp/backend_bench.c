/* backend_bench.c: see backend_bench.h. */
#include "backend_bench.h"

#include <criterion/criterion.h>
#include <stdlib.h>

static mpq_t *new_numbers(size_t count)
{
    mpq_t *q = malloc((count + 1) * sizeof *q);
    for (size_t k = 0; k < count; k++)
        mpq_init(q[k]);
    return q;
}

static void free_numbers(mpq_t *q, size_t count)
{
    for (size_t k = 0; k < count; k++)
        mpq_clear(q[k]);
    free(q);
}

bool backend_bench_open(backend_bench *b, support_family family, uint64_t seed,
                        const support_shape *shape)
{
    fmb_options o = {.size = sizeof o};
    *b = (backend_bench){.c = support_make(family, seed, shape)};
    fmb_mem_init(&b->mem, NULL, 0);
    fmb_arena_init(&b->arena, &b->mem);
    fmb_run_begin(&b->run, &b->mem, &o, &b->cancel, (fmb_sink){0}, "test");
    cr_assert_eq(fmb_parts_split(&b->parts, b->c.s, &b->run, &b->arena, true), FMB_OK);
    b->part = b->parts.count > 0 ? &b->parts.part[0] : NULL;
    if (b->part)
        cr_assert_eq(fmb_part_load(&b->parts.part[0], b->c.s, b->parts.place, &b->run, false),
                     FMB_OK);
    b->n = b->part ? (size_t)b->part->n : 0;
    fmb_program_init(&b->p, &b->mem, (int)b->n);
    b->basis = calloc(b->n + 1, sizeof *b->basis);
    b->cost = calloc(b->n + 1, sizeof *b->cost);
    b->off = calloc(b->part ? b->part->m : 1, sizeof *b->off);
    b->matrix = new_numbers(b->n * (b->n + 1));
    b->x = new_numbers(b->n);
    b->y = new_numbers(b->n);
    return b->part != NULL;
}

void backend_bench_append(backend_bench *b, size_t m)
{
    for (size_t i = b->p.m; i < m; i++)
        cr_assert_eq(fmb_program_add_dense(&b->p, &b->part->row[i], b->part->rel[i]), FMB_OK);
}

void backend_bench_close(backend_bench *b)
{
    free(b->basis);
    free(b->cost);
    free(b->off);
    free_numbers(b->matrix, b->n * (b->n + 1));
    free_numbers(b->x, b->n);
    free_numbers(b->y, b->n);
    fmb_program_clear(&b->p);
    fmb_parts_clear(&b->parts, &b->mem);
    fmb_arena_clear(&b->arena);
    cr_assert_eq(b->mem.used, 0);
    support_case_clear(&b->c);
}

/* ---- exact arithmetic ------------------------------------------------------------------------ */

static void coefficient(const backend_bench *b, size_t i, size_t k, mpq_t out)
{
    fmb_vec_get_q(b->p.row[i].value, k, out);
}

/* matrix row r = member i of a basis, its right side last. */
static void write_member(backend_bench *b, size_t r, size_t i)
{
    mpq_t *row = &b->matrix[r * (b->n + 1)];
    for (size_t j = 0; j <= b->n; j++)
        mpq_set_ui(row[j], 0, 1);
    if (i >= b->p.m) {
        mpq_set_ui(row[i - b->p.m], 1, 1);
        return;
    }
    for (size_t k = 0; k < b->p.row[i].size; k++)
        coefficient(b, i, k, row[b->p.row[i].column[k]]);
    coefficient(b, i, b->p.row[i].size, row[b->n]);
}

static void subtract_row(mpq_t *from, mpq_t *row, size_t column, size_t n)
{
    mpq_t factor, t;
    if (mpq_sgn(from[column]) == 0)
        return;
    mpq_inits(factor, t, NULL);
    mpq_div(factor, from[column], row[column]);
    for (size_t j = 0; j <= n; j++) {
        mpq_mul(t, factor, row[j]);
        mpq_sub(from[j], from[j], t);
    }
    mpq_clears(factor, t, NULL);
}

/* Solve matrix x = last column, by Gauss and Jordan. False: singular. */
static bool solve(backend_bench *b, mpq_t *x)
{
    size_t n = b->n, w = n + 1;
    for (size_t j = 0; j < n; j++) {
        size_t r = j;
        while (r < n && mpq_sgn(b->matrix[r * w + j]) == 0)
            r++;
        if (r == n)
            return false;
        for (size_t k = 0; r != j && k <= n; k++)
            mpq_swap(b->matrix[r * w + k], b->matrix[j * w + k]);
        for (size_t s = 0; s < n; s++)
            if (s != j)
                subtract_row(&b->matrix[s * w], &b->matrix[j * w], j, n);
    }
    for (size_t j = 0; j < n; j++)
        mpq_div(x[j], b->matrix[j * w + n], b->matrix[j * w + j]);
    return true;
}

bool backend_bench_meet(backend_bench *b)
{
    for (size_t r = 0; r < b->n; r++)
        write_member(b, r, b->basis[r]);
    return solve(b, b->x);
}

/* y times the basis = these numbers, target[n]. */
static bool combine(backend_bench *b, mpq_t *target)
{
    size_t n = b->n, w = n + 1;
    mpq_t *rows = new_numbers(n * w);
    for (size_t r = 0; r < n; r++)
        write_member(b, r, b->basis[r]);
    for (size_t k = 0; k < n * w; k++)
        mpq_swap(rows[k], b->matrix[k]);
    for (size_t r = 0; r < n; r++)
        for (size_t j = 0; j < n; j++)
            mpq_set(b->matrix[j * w + r], rows[r * w + j]);
    for (size_t j = 0; j < n; j++)
        mpq_set(b->matrix[j * w + n], target[j]);
    free_numbers(rows, n * w);
    return solve(b, b->y);
}

/* out = row i times x. */
static void times(const backend_bench *b, size_t i, mpq_t *x, mpq_t out)
{
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(out, 0, 1);
    for (size_t k = 0; k < b->p.row[i].size; k++) {
        coefficient(b, i, k, t);
        mpq_mul(t, t, x[b->p.row[i].column[k]]);
        mpq_add(out, out, t);
    }
    mpq_clear(t);
}

bool backend_bench_holds(const backend_bench *b, mpq_t *x, bool flat)
{
    mpq_t sum, right;
    bool all = true;
    mpq_inits(sum, right, NULL);
    for (size_t i = 0; all && i < b->p.m; i++) {
        times(b, i, x, sum);
        if (!flat)
            coefficient(b, i, b->p.row[i].size, right);
        int side = mpq_cmp(sum, right);
        all = b->off[i] || side == 0 || (side < 0 && b->p.row[i].rel != FMB_EQ);
    }
    mpq_clears(sum, right, NULL);
    return all;
}

/* Are the multipliers y those of an optimum (sign 1), or of a conflict with one row more (-1)? */
static bool is_signed(const backend_bench *b, int sign)
{
    for (size_t r = 0; r < b->n; r++) {
        size_t i = b->basis[r];
        int s = sign * mpq_sgn(b->y[r]);
        bool off = i >= b->p.m || b->off[i];
        if (s != 0 && (off || (s < 0 && b->p.row[i].rel != FMB_EQ)))
            return false;
    }
    return true;
}

/* y . right sides of the basis, compared with the right side of row i. */
static int compare_sides(const backend_bench *b, size_t i)
{
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (size_t r = 0; r < b->n; r++) {
        if (b->basis[r] >= b->p.m)
            continue;
        coefficient(b, b->basis[r], b->p.row[b->basis[r]].size, t);
        mpq_mul(t, t, b->y[r]);
        mpq_add(sum, sum, t);
    }
    coefficient(b, i, b->p.row[i].size, t);
    int order = mpq_cmp(sum, t);
    mpq_clears(sum, t, NULL);
    return order;
}

bool backend_bench_proves_conflict(backend_bench *b, size_t odd)
{
    mpq_t *target = new_numbers(b->n);
    for (size_t k = 0; k < b->p.row[odd].size; k++)
        coefficient(b, odd, k, target[b->p.row[odd].column[k]]);
    bool proved = !b->off[odd] && combine(b, target);
    int order = proved ? compare_sides(b, odd) : 0;
    proved = proved && ((order > 0 && is_signed(b, -1)) ||
                        (order < 0 && b->p.row[odd].rel == FMB_EQ && is_signed(b, 1)));
    free_numbers(target, b->n);
    return proved;
}

static void exact_cost(const backend_bench *b, mpq_t *target)
{
    for (size_t j = 0; j < b->n; j++)
        mpq_set_d(target[j], b->cost[j]);
}

bool backend_bench_proves_optimum(backend_bench *b)
{
    mpq_t *target = new_numbers(b->n);
    exact_cost(b, target);
    bool proved = backend_bench_meet(b) && backend_bench_holds(b, b->x, false) &&
                  combine(b, target) && is_signed(b, 1);
    free_numbers(target, b->n);
    return proved;
}

bool backend_bench_proves_ray(backend_bench *b, size_t place)
{
    size_t w = b->n + 1;
    mpq_t *target = new_numbers(b->n), gain, t;
    mpq_inits(gain, t, NULL);
    exact_cost(b, target);
    bool proved = backend_bench_meet(b) && backend_bench_holds(b, b->x, false);
    for (size_t r = 0; r < b->n; r++) {
        write_member(b, r, b->basis[r]);
        mpq_set_si(b->matrix[r * w + b->n], r == place, 1);
    }
    proved = proved && solve(b, b->x);
    for (size_t j = 0; j < b->n; j++) {
        mpq_mul(t, target[j], b->x[j]);
        mpq_add(gain, gain, t);
    }
    for (size_t j = 0; mpq_sgn(gain) < 0 && j < b->n; j++)
        mpq_neg(b->x[j], b->x[j]);
    proved = proved && mpq_sgn(gain) != 0 && backend_bench_holds(b, b->x, true);
    mpq_clears(gain, t, NULL);
    free_numbers(target, b->n);
    return proved;
}
