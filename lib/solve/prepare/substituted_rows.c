/* substituted_rows.c: see substituted_rows.h.
 *
 * During substitution a row is kept (a substituted equality), redundant (it became constant, or
 * follows from one other row), or still open.
 *
 * A positive multiple of an inequality plus any multiple of an equality has the same solutions as
 * the inequality, among those of the equality. So a row is implied by others after substitution if
 * and only if it is implied by them and the equalities before; and an equality that became 0 = 0
 * follows from those substituted before it. */
#include "solve/prepare/substituted_rows.h"

#include <string.h>

#include "num/gcd.h"

typedef struct substitution {
    size_t n, m;
    const fmb_lp_row *from;
    fmb_vec *v;      /* [m] the rows after the substitutions made so far */
    fmb_lp_row *row; /* [rows] the inequalities that still name variables */
    size_t *number;  /* [rows] their numbers */
    size_t rows;
    fmb_sorting *out;
    bool *tight; /* [m] implicit equalities; NULL: they are not searched for */
} substitution;

static bool has_equality(size_t m, const fmb_lp_row *row)
{
    size_t i = 0;
    while (i < m && row[i].rel != FMB_EQ)
        i++;
    return i < m;
}

static fmb_status copy_rows_to_substitute(substitution *t, fmb_arena *arena, fmb_mem *mem)
{
    int64_t *entry;
    FMB_TRY(FMB_ARENA_GET(arena, t->v, t->m));
    FMB_TRY(FMB_ARENA_GET(arena, t->row, t->m));
    FMB_TRY(FMB_ARENA_GET(arena, t->number, t->m));
    FMB_TRY(FMB_ARENA_GET(arena, entry, t->m * (t->n + 1)));
    for (size_t i = 0; i < t->m; i++) {
        t->number[i] = i;
        t->v[i] = (fmb_vec){.s = entry + i * (t->n + 1)};
        FMB_TRY(fmb_vec_copy(&t->v[i], t->from[i].v, t->n + 1, mem));
    }
    return FMB_OK;
}

/* The column of the row's least coefficient; n: all are zero. */
static size_t find_pivot(const substitution *t, size_t i)
{
    size_t best = t->n;
    uint64_t least = UINT64_MAX;
    for (size_t j = 0; j < t->n; j++) {
        uint64_t size = fmb_abs64(t->v[i].s[j]);
        if (size > 0 && size < least) {
            least = size;
            best = j;
        }
    }
    return best;
}

/* Substitute the pivot variable in all rows but the equalities substituted before. *small false:
 * some number became long. */
static fmb_status substitute_equality(substitution *t, size_t i, size_t pivot, fmb_num *num,
                                      bool *small)
{
    t->out->kept[i] = true;
    for (size_t k = 0; *small && k < t->m; k++) {
        if (t->out->kept[k] || t->v[k].s[pivot] == 0)
            continue;
        FMB_TRY(fmb_vec_cancel(&t->v[k], &t->v[k], &t->v[i], t->n + 1, pivot, num));
        *small = !fmb_vec_is_wide(&t->v[k]);
    }
    return FMB_OK;
}

/* A row that names no variable is redundant if it holds; else the system is infeasible. */
static void settle_constant_row(substitution *t, size_t i)
{
    int64_t b = t->v[i].s[t->n];
    fmb_rel rel = t->from[i].rel;
    t->out->gone[i] = true;
    if (rel == FMB_EQ ? b != 0 : rel == FMB_LT ? b <= 0 : b < 0)
        t->out->feasible = false;
}

static fmb_status substitute_all_equalities(substitution *t, fmb_num *num, bool *small)
{
    for (size_t i = 0; *small && i < t->m; i++) {
        size_t pivot = t->from[i].rel == FMB_EQ ? find_pivot(t, i) : t->n;
        if (pivot < t->n)
            FMB_TRY(substitute_equality(t, i, pivot, num, small));
        else if (t->from[i].rel == FMB_EQ)
            settle_constant_row(t, i);
    }
    return FMB_OK;
}

/* ---- inequalities ---------------------------------------------------------------------------- */

static bool is_settled(const substitution *t, size_t i)
{
    return t->out->gone[i] || t->out->kept[i];
}

/* Decide constant inequalities, and divide the other open ones by their common divisors. */
static fmb_status reduce_open_inequalities(substitution *t, fmb_num *num)
{
    for (size_t i = 0; i < t->m; i++) {
        if (is_settled(t, i))
            continue;
        FMB_TRY(fmb_vec_reduce(&t->v[i], t->n + 1, num));
        if (find_pivot(t, i) == t->n)
            settle_constant_row(t, i);
    }
    return FMB_OK;
}

/* Treat inequality i as an equality. */
static fmb_status substitute_tight_row(substitution *t, size_t i, fmb_num *num, bool *small)
{
    size_t pivot = find_pivot(t, i);
    t->out->feasible &= t->from[i].rel == FMB_LE;
    t->tight[i] = pivot < t->n;
    if (pivot < t->n)
        return substitute_equality(t, i, pivot, num, small);
    t->out->gone[i] = true;
    t->out->feasible &= t->v[i].s[t->n] == 0;
    return FMB_OK;
}

/* Treat inequality number[k] as an equality, for each bit k of set. */
static fmb_status substitute_tight_rows(substitution *t, uint64_t set, fmb_num *num, bool *small)
{
    for (; *small && set != 0; set &= set - 1)
        FMB_TRY(substitute_tight_row(t, t->number[__builtin_ctzll(set)], num, small));
    return *small ? reduce_open_inequalities(t, num) : FMB_OK;
}

static void list_inequalities(substitution *t)
{
    t->rows = 0;
    for (size_t i = 0; i < t->m; i++) {
        if (is_settled(t, i))
            continue;
        t->number[t->rows] = i;
        t->row[t->rows++] = (fmb_lp_row){&t->v[i], t->from[i].rel};
    }
}

/* *tight: the implicit equalities among the listed rows; with any, nothing else is known. */
static fmb_status sort_inequalities(substitution *t, fmb_run *run, fmb_arena *arena,
                                    uint64_t *tight)
{
    fmb_sorting some = {.known = t->out->known, .wants_tight = t->tight != NULL};
    FMB_TRY(FMB_ARENA_GET(arena, some.gone, t->rows));
    FMB_TRY(FMB_ARENA_GET(arena, some.kept, t->rows));
    memset(some.gone, 0, t->rows * sizeof *some.gone);
    memset(some.kept, 0, t->rows * sizeof *some.kept);
    FMB_TRY(fmb_lp_sort_rows(run, (int)t->n, t->rows, t->row, &some));
    *tight = some.tight;
    for (size_t k = 0; k < t->rows; k++) {
        t->out->gone[t->number[k]] = some.gone[k];
        t->out->kept[t->number[k]] = some.kept[k];
    }
    t->out->feasible = some.feasible;
    t->out->inner = some.inner;
    return FMB_OK;
}

/* Each pass but the last finds implicit equalities, and so removes columns; out->tight holds those
 * found by an earlier call. */
static fmb_status substitute_and_sort(substitution *t, fmb_run *run, fmb_arena *arena, fmb_num *num,
                                      bool *small)
{
    uint64_t tight = t->out->tight;
    FMB_TRY(substitute_all_equalities(t, num, small));
    FMB_TRY(substitute_tight_rows(t, tight, num, small));
    do {
        list_inequalities(t);
        t->out->inner = t->out->feasible && t->rows == 0;
        if (!*small || !t->out->feasible || t->rows == 0)
            return FMB_OK;
        FMB_TRY(sort_inequalities(t, run, arena, &tight));
        FMB_TRY(substitute_tight_rows(t, tight, num, small));
    } while (tight != 0);
    return FMB_OK;
}

static void forget_substitution(substitution *t, fmb_mem *mem)
{
    t->out->feasible = true;
    for (size_t i = 0; i < t->m; i++) {
        fmb_vec_clear(&t->v[i], t->n + 1, mem);
        t->out->gone[i] = t->out->kept[i] = false;
        if (t->tight)
            t->tight[i] = false;
    }
}

fmb_status fmb_substituted_rows_sort(fmb_run *run, fmb_arena *arena, fmb_num *num, size_t n,
                                     size_t m, const fmb_lp_row *row, fmb_sorting *out, bool *tight)
{
    substitution t = {.n = n, .m = m, .from = row, .out = out, .tight = tight};
    bool small = fmb_lp_rows_are_small(m, row);
    out->feasible = true;
    out->tight = 0;
    if (!small || !has_equality(m, row)) {
        out->wants_tight = small && tight;
        FMB_TRY(fmb_lp_sort_rows(run, (int)n, m, row, out));
        if (out->tight == 0)
            return FMB_OK;
    }
    FMB_TRY(copy_rows_to_substitute(&t, arena, run->mem));
    fmb_status st = substitute_and_sort(&t, run, arena, num, &small);
    if (st != FMB_OK || !small)
        forget_substitution(&t, run->mem);
    out->wants_tight = false;
    return st == FMB_OK && !small ? fmb_lp_sort_rows(run, (int)n, m, row, out) : st;
}
