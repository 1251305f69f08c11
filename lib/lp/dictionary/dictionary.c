/* dictionary.c: building a dictionary and pivoting it; see dictionary.h. */
#include "lp/dictionary/dictionary.h"

#include <stdlib.h>
#include <string.h>

static fmb_status allocate_dictionary(fmb_lp *lp)
{
    fmb_mem *mem = lp->run->mem;
    size_t n = (size_t)lp->n, m = lp->m, width = fmb_lp_width(lp), cells;
    if (__builtin_mul_overflow(m + 1, width, &cells))
        return FMB_ERR_MEMORY;
    lp->words = fmb_mem_zero(mem, cells, sizeof *lp->words);
    lp->row = fmb_mem_zero(mem, m, sizeof *lp->row);
    lp->basic = fmb_mem_get(mem, m, sizeof *lp->basic);
    lp->column = fmb_mem_get(mem, n, sizeof *lp->column);
    lp->where = fmb_mem_get(mem, n + m, sizeof *lp->where);
    lp->slack = fmb_mem_zero(mem, m, sizeof *lp->slack);
    lp->strict = fmb_mem_zero(mem, m, sizeof *lp->strict);
    if (!lp->words || !lp->row || !lp->basic || !lp->column || !lp->where || !lp->slack ||
        !lp->strict)
        return fmb_mem_status(mem);
    for (size_t r = 0; r < m; r++)
        lp->row[r].s = lp->words + r * width;
    lp->temp.s = lp->words + m * width;
    return FMB_OK;
}

/* Dictionary row of slack i: 0 = -a_i.x - s_i + b_i - delta [strict]. */
static fmb_status load_dictionary_row(fmb_lp *lp, size_t i, const fmb_lp_row *from)
{
    size_t n = (size_t)lp->n;
    fmb_vec *v = &lp->row[i];
    fmb_status st = FMB_OK;
    lp->strict[i] = from->rel == FMB_LT;
    lp->any_strict |= lp->strict[i];
    if (fmb_vec_is_wide(from->v)) {
        st = fmb_vec_widen(v, fmb_lp_width(lp), lp->run->mem);
        if (st != FMB_OK)
            return st;
        for (size_t j = 0; j < n; j++)
            mpz_neg(v->z[j], from->v->z[j]);
        mpz_set_si(v->z[n + FMB_LP_OWN], -1);
        mpz_set(v->z[n + FMB_LP_K], from->v->z[n]);
        mpz_set_si(v->z[n + FMB_LP_D], -lp->strict[i]);
        return FMB_OK;
    }
    for (size_t j = 0; j < n; j++)
        v->s[j] = -from->v->s[j];
    v->s[n + FMB_LP_OWN] = -1;
    v->s[n + FMB_LP_K] = from->v->s[n];
    v->s[n + FMB_LP_D] = -lp->strict[i];
    fmb_vec_measure(v, fmb_lp_width(lp));
    return lp->num.wide_only ? fmb_vec_widen(v, fmb_lp_width(lp), lp->run->mem) : FMB_OK;
}

/* ---- the start ------------------------------------------------------------------------------- */

/* A row on its turn: equalities before inequalities, short before long. */
typedef struct turn {
    size_t row;
    bool is_inequality;
    size_t terms;
} turn;

static int compare_turns(const void *x, const void *y)
{
    const turn *a = x, *b = y;
    if (a->is_inequality != b->is_inequality)
        return a->is_inequality ? 1 : -1;
    if (a->terms != b->terms)
        return a->terms < b->terms ? -1 : 1;
    return (a->row > b->row) - (a->row < b->row);
}

/* uses[j]: the rows that name x_j, at first. */
static void order_rows_by_turn(const fmb_lp *lp, const fmb_lp_row *rows, turn *turns, size_t *uses)
{
    for (size_t i = 0; i < lp->m; i++) {
        turns[i] = (turn){i, rows[i].rel != FMB_EQ, 0};
        for (size_t j = 0; j < (size_t)lp->n; j++) {
            bool named = fmb_vec_sgn(rows[i].v, j) != 0;
            turns[i].terms += named;
            uses[j] += named;
        }
    }
    qsort(turns, lp->m, sizeof *turns, compare_turns);
}

/* Of the columns of free x that row r names, the one of the least used x, then of the least entry;
 * SIZE_MAX: none. */
static size_t find_free_column(const fmb_lp *lp, size_t r, const size_t *uses)
{
    const fmb_vec *v = &lp->row[r];
    size_t best = SIZE_MAX;
    for (size_t j = 0; j < (size_t)lp->n; j++) {
        size_t x = lp->column[j];
        if (!fmb_lp_is_x(lp, x) || fmb_vec_sgn(v, j) == 0)
            continue;
        if (best == SIZE_MAX || uses[x] < uses[lp->column[best]] ||
            (uses[x] == uses[lp->column[best]] && !v->z && llabs(v->s[j]) < llabs(v->s[best])))
            best = j;
    }
    return best;
}

/* Bring as many x as there are independent rows into the basis. Slacks of equalities are then
 * locked outside of it; an equality without a free x left is a combination of those before it and
 * stays basic: it must be 0. */
static fmb_status bring_x_into_basis(fmb_lp *lp, const turn *turns, const size_t *uses)
{
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < lp->m; k++) {
        size_t i = turns[k].row, j = find_free_column(lp, i, uses);
        if (!turns[k].is_inequality)
            lp->slack[i] = FMB_SLACK_LOCKED;
        if (j != SIZE_MAX)
            st = fmb_lp_pivot(lp, i, j);
    }
    return st;
}

static fmb_status pivot_to_start(fmb_lp *lp, const fmb_lp_row *rows)
{
    fmb_mem *mem = lp->run->mem;
    size_t n = (size_t)lp->n;
    turn *turns = fmb_mem_get(mem, lp->m, sizeof *turns);
    size_t *uses = fmb_mem_zero(mem, n, sizeof *uses);
    fmb_status st = turns && uses ? FMB_OK : fmb_mem_status(mem);
    if (st == FMB_OK) {
        order_rows_by_turn(lp, rows, turns, uses);
        st = bring_x_into_basis(lp, turns, uses);
    }
    fmb_mem_put(mem, turns, lp->m, sizeof *turns);
    fmb_mem_put(mem, uses, n, sizeof *uses);
    return st;
}

fmb_status fmb_lp_init(fmb_lp *lp, fmb_run *run, int n, size_t m, const fmb_lp_row *rows,
                       bool wide_only)
{
    *lp = (fmb_lp){.run = run, .n = n, .m = m, .source = rows, .at_row = SIZE_MAX};
    fmb_status st = fmb_run_open_num(run, &lp->num, fmb_lp_width(lp), wide_only);
    if (st == FMB_OK)
        st = allocate_dictionary(lp);
    for (size_t i = 0; st == FMB_OK && i < m; i++) {
        lp->basic[i] = (size_t)n + i;
        lp->where[(size_t)n + i] = i;
        st = load_dictionary_row(lp, i, &rows[i]);
        if (st == FMB_OK)
            st = fmb_run_poll(run);
    }
    for (size_t j = 0; st == FMB_OK && j < (size_t)n; j++) {
        lp->column[j] = j;
        lp->where[j] = m + j;
    }
    return st == FMB_OK ? pivot_to_start(lp, rows) : st;
}

void fmb_lp_clear(fmb_lp *lp)
{
    fmb_mem *mem = lp->run->mem;
    size_t n = (size_t)lp->n, m = lp->m, width = fmb_lp_width(lp);
    for (size_t r = 0; lp->row && r < m; r++)
        fmb_vec_clear(&lp->row[r], width, mem);
    fmb_vec_clear(&lp->temp, width, mem);
    fmb_mem_put(mem, lp->words, (m + 1) * width, sizeof *lp->words);
    fmb_mem_put(mem, lp->row, m, sizeof *lp->row);
    fmb_mem_put(mem, lp->basic, m, sizeof *lp->basic);
    fmb_mem_put(mem, lp->column, n, sizeof *lp->column);
    fmb_mem_put(mem, lp->where, n + m, sizeof *lp->where);
    fmb_mem_put(mem, lp->slack, m, sizeof *lp->slack);
    fmb_mem_put(mem, lp->strict, m, sizeof *lp->strict);
    lp->run->stats.promotions += lp->num.promotions;
    fmb_num_clear(&lp->num);
}

int fmb_lp_sign(const fmb_lp *lp, size_t r)
{
    int k = fmb_vec_sgn(&lp->row[r], fmb_lp_place(lp, FMB_LP_K));
    return k != 0 ? k : fmb_vec_sgn(&lp->row[r], fmb_lp_place(lp, FMB_LP_D));
}

double fmb_lp_ratio(const fmb_lp *lp, size_t r, size_t j)
{
    const fmb_vec *v = &lp->row[r];
    size_t own = fmb_lp_place(lp, FMB_LP_OWN);
    if (!v->z)
        return (double)v->s[j] / -(double)v->s[own];
    long ej, eo;
    double a = mpz_get_d_2exp(&ej, v->z[j]), b = mpz_get_d_2exp(&eo, v->z[own]);
    long shift = ej - eo > 1000 ? 1000 : ej - eo < -1000 ? -1000 : ej - eo;
    return __builtin_ldexp(a / -b, (int)shift);
}

/* ---- pivoting -------------------------------------------------------------------------------- */

static void swap_entries(fmb_vec *v, size_t i, size_t j)
{
    if (v->z) {
        mpz_swap(v->z[i], v->z[j]);
        return;
    }
    int64_t t = v->s[i];
    v->s[i] = v->s[j];
    v->s[j] = t;
}

static void negate_entries(fmb_vec *v, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (v->z)
            mpz_neg(v->z[i], v->z[i]);
        else
            v->s[i] = -v->s[i];
    }
}

/* Row i with the variable of column j replaced by what row r says of it. Row r goes in as temp: its
 * entry of column j in the scratch place, that of its own variable in column j (where that variable
 * now belongs). */
static fmb_status substitute_pivot_row(fmb_lp *lp, size_t i, size_t j)
{
    size_t scratch = fmb_lp_place(lp, FMB_LP_SCRATCH);
    swap_entries(&lp->row[i], j, scratch);
    return fmb_vec_cancel(&lp->row[i], &lp->row[i], &lp->temp, fmb_lp_width(lp), scratch, &lp->num);
}

/* Gone for ever, or until it is activated. */
static bool is_row_out_of_use(const fmb_lp *lp, size_t r)
{
    size_t v = lp->basic[r];
    return !fmb_lp_is_x(lp, v) && lp->slack[v - (size_t)lp->n] >= FMB_SLACK_INACTIVE;
}

fmb_status fmb_lp_pivot(fmb_lp *lp, size_t r, size_t j)
{
    size_t width = fmb_lp_width(lp), own = fmb_lp_place(lp, FMB_LP_OWN);
    size_t in = lp->column[j], out = lp->basic[r];
    fmb_vec *pivot = &lp->row[r];
    fmb_status st = fmb_vec_copy(&lp->temp, pivot, width, lp->run->mem);
    if (st != FMB_OK)
        return st;
    swap_entries(&lp->temp, j, fmb_lp_place(lp, FMB_LP_SCRATCH));
    swap_entries(&lp->temp, j, own);
    for (size_t i = 0; i < lp->m; i++) {
        if (i == r || is_row_out_of_use(lp, i) || fmb_vec_sgn(&lp->row[i], j) == 0)
            continue;
        st = substitute_pivot_row(lp, i, j);
        if (st == FMB_OK)
            st = fmb_run_poll(lp->run);
        if (st != FMB_OK)
            return st;
    }
    swap_entries(pivot, j, own);
    if (fmb_vec_sgn(pivot, own) > 0)
        negate_entries(pivot, width);
    lp->column[j] = out;
    lp->basic[r] = in;
    lp->where[out] = lp->m + j;
    lp->where[in] = r;
    lp->run->stats.pivots++;
    return FMB_OK;
}
