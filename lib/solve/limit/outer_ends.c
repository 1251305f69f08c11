/* outer_ends.c: see outer_ends.h. */
#include "solve/limit/outer_ends.h"

/* Total work: some milliseconds. One derivation reads at most one row for each variable. */
#define WORK   ((size_t)1 << 17)
#define PASSES 4
/* Wide entries count for more, as multiplication and division of them are up to quadratic in their
 * length. Ends of more digits than this are not computed. */
#define WIDE_WORK 8
#define MOST_BITS 1024

static bool spend_work_on_row(fmb_ends *f, const fmb_vec *v)
{
    size_t n = (size_t)f->e->n, limbs = fmb_vec_is_wide(v) ? v->limbs / (n + 1) : 0;
    size_t cost = n * (fmb_vec_is_wide(v) ? WIDE_WORK + limbs * limbs : 1);
    bool enough = f->work >= cost;
    f->work -= enough ? cost : f->work;
    return enough;
}

void fmb_end_of_row(const fmb_vec *v, int n, int column, mpq_t value)
{
    mpq_t a;
    mpq_init(a);
    fmb_vec_get_q(v, (size_t)n, value);
    fmb_vec_get_q(v, (size_t)column, a);
    mpq_div(value, value, a);
    mpq_clear(a);
}

uint32_t fmb_end_tightest_row(const fmb_elim *e, int column, int sign)
{
    uint32_t best = FMB_NO_ROW;
    mpq_t value, t;
    mpq_inits(value, t, NULL);
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        int s = fmb_vec_sgn(&r->v, (size_t)column);
        if (s == 0 || (!r->equality && s != sign))
            continue;
        fmb_end_of_row(&r->v, e->n, column, t);
        int order = best == FMB_NO_ROW ? -1 : mpq_cmp(t, value) * sign;
        if (order < 0 || (order == 0 && r->strict && !e->row[best].strict)) {
            best = e->live.row[i];
            mpq_set(value, t);
        }
    }
    mpq_clears(value, t, NULL);
    return best;
}

/* ---- a better end ---------------------------------------------------------------------------- */

/* Is value, not attained if open, a better end than the known one? */
static bool is_better_end(const fmb_ends *f, fmb_side side, int c, const mpq_t value, bool open)
{
    uint32_t known = f->row[side][c];
    if (known == FMB_NO_ROW)
        return true;
    int order = mpq_cmp(value, f->value[side][c]);
    if (order == 0)
        return open && !f->e->row[known].strict;
    return side == FMB_UPPER ? order < 0 : order > 0;
}

static fmb_status derive_clash_of_ends(fmb_ends *f, int c)
{
    uint32_t lower = f->row[FMB_LOWER][c], upper = f->row[FMB_UPPER][c], clash;
    if (lower == FMB_NO_ROW || upper == FMB_NO_ROW || lower == upper)
        return FMB_OK;
    int order = mpq_cmp(f->value[FMB_LOWER][c], f->value[FMB_UPPER][c]);
    bool open = f->e->row[lower].strict || f->e->row[upper].strict;
    if (order < 0 || (order == 0 && !open))
        return FMB_OK;
    bool turn = f->e->row[lower].equality; /* the second row may be subtracted, if an equality */
    return fmb_elim_derive_row(f->e, turn ? upper : lower, turn ? lower : upper, c, &clash);
}

/* Row r names column c only: take it for the end of that side. */
static fmb_status take_row_as_end(fmb_ends *f, fmb_side side, int c, uint32_t r, const mpq_t value)
{
    f->row[side][c] = r;
    mpq_set(f->value[side][c], value);
    return derive_clash_of_ends(f, c);
}

static fmb_status take_single_row(fmb_ends *f, uint32_t i)
{
    const fmb_derived *r = &f->e->row[i];
    int c = fmb_elim_single_variable(f->e, r);
    fmb_status st = FMB_OK;
    mpq_t value;
    if (c < 0)
        return FMB_OK;
    mpq_init(value);
    fmb_end_of_row(&r->v, f->e->n, c, value);
    bool equality = r->equality, strict = r->strict, upper = fmb_vec_sgn(&r->v, (size_t)c) > 0;
    for (int side = FMB_LOWER; st == FMB_OK && side <= FMB_UPPER; side++)
        if ((equality || upper == (side == FMB_UPPER)) &&
            is_better_end(f, (fmb_side)side, c, value, strict))
            st = take_row_as_end(f, (fmb_side)side, c, i, value);
    mpq_clear(value);
    return st;
}

/* ---- a row over ends ------------------------------------------------------------------------- */

/* Cancel every column of row r but c, so that the result is an end of that side. An inequality is
 * added as it is; an equality in whichever direction the end needs. */
static fmb_status derive_end_row(fmb_ends *f, uint32_t r, int c, fmb_side side, uint32_t *out)
{
    fmb_elim *e = f->e;
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < e->n; k++) {
        const fmb_derived *d = &e->row[r];
        int sign = fmb_vec_sgn(&d->v, (size_t)k);
        if (k == c || sign == 0)
            continue;
        bool turned = d->equality && fmb_vec_sgn(&d->v, (size_t)c) != (side == FMB_UPPER ? 1 : -1);
        uint32_t end = f->row[(turned ? -sign : sign) > 0 ? FMB_LOWER : FMB_UPPER][k];
        (void)spend_work_on_row(f, &d->v); /* a derivation that was begun is finished */
        st = fmb_elim_derive_row(e, turned ? end : r, turned ? r : end, k, &r);
    }
    *out = r;
    return st;
}

/* The minimum of a row's left side, in one direction, over the ends. */
typedef struct worth {
    mpq_t sum; /* of the finite minima of the terms */
    int infinite, open;
    int column; /* the last infinite one */
    mpq_t t, a;
} worth;

static fmb_side side_of_least_term(const fmb_derived *r, int c, int direction)
{
    return fmb_vec_sgn(&r->v, (size_t)c) * direction > 0 ? FMB_LOWER : FMB_UPPER;
}

static void add_up_least_terms(const fmb_ends *f, const fmb_derived *r, int direction, worth *w)
{
    mpq_set_ui(w->sum, 0, 1);
    w->infinite = w->open = 0;
    for (int k = 0; k < f->e->n; k++) {
        if (fmb_vec_sgn(&r->v, (size_t)k) == 0)
            continue;
        fmb_side side = side_of_least_term(r, k, direction);
        uint32_t end = f->row[side][k];
        if (end == FMB_NO_ROW) {
            w->infinite++;
            w->column = k;
            continue;
        }
        w->open += f->e->row[end].strict;
        fmb_vec_get_q(&r->v, (size_t)k, w->a);
        mpq_mul(w->t, w->a, f->value[side][k]);
        mpq_add(w->sum, w->sum, w->t);
    }
}

/* Bound column c by row i with the minima w of its other terms: a x_c <= b - (their sum). */
static fmb_status bound_column_by_row(fmb_ends *f, uint32_t i, int direction, int c, worth *w)
{
    const fmb_derived *r = &f->e->row[i];
    fmb_side least = side_of_least_term(r, c, direction);
    fmb_side side = least == FMB_LOWER ? FMB_UPPER : FMB_LOWER;
    uint32_t own = f->row[least][c], end;
    int open = w->open - (own != FMB_NO_ROW && f->e->row[own].strict);
    fmb_vec_get_q(&r->v, (size_t)f->e->n, w->t);
    mpq_sub(w->t, w->t, w->sum);
    fmb_vec_get_q(&r->v, (size_t)c, w->a);
    mpq_div(w->t, w->t, w->a);
    if (own != FMB_NO_ROW)
        mpq_add(w->t, w->t, f->value[least][c]);
    if (mpz_sizeinbase(mpq_numref(w->t), 2) + mpz_sizeinbase(mpq_denref(w->t), 2) > MOST_BITS ||
        !is_better_end(f, side, c, w->t, r->strict || open > 0))
        return FMB_OK;
    FMB_TRY(derive_end_row(f, i, c, side, &end));
    return take_row_as_end(f, side, c, end, w->t);
}

static fmb_status bound_columns_by_row(fmb_ends *f, uint32_t i, int direction, worth *w)
{
    add_up_least_terms(f, &f->e->row[i], direction, w);
    for (int c = 0; f->e->clash == FMB_NO_ROW && c < f->e->n; c++) {
        bool bounded = w->infinite == 0 || (w->infinite == 1 && w->column == c);
        if (bounded && fmb_vec_sgn(&f->e->row[i].v, (size_t)c) != 0)
            FMB_TRY(bound_column_by_row(f, i, direction, c, w));
    }
    return FMB_OK;
}

/* ---- all rows -------------------------------------------------------------------------------- */

static bool is_search_over(const fmb_ends *f, fmb_status st)
{
    return st != FMB_OK || f->e->clash != FMB_NO_ROW;
}

static fmb_status take_all_single_rows(fmb_ends *f)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; !is_search_over(f, st) && i < f->e->rows; i++)
        st = take_single_row(f, (uint32_t)i);
    return st;
}

/* One pass over the first rows, derived ones included: they imply more than their parents do. */
static fmb_status propagate_once(fmb_ends *f, size_t rows, worth *w)
{
    fmb_status st = FMB_OK;
    for (uint32_t i = 0;
         i < rows && !is_search_over(f, st) && spend_work_on_row(f, &f->e->row[i].v); i++) {
        st = bound_columns_by_row(f, i, 1, w);
        if (f->e->row[i].equality && !is_search_over(f, st))
            st = bound_columns_by_row(f, i, -1, w);
    }
    return st;
}

static fmb_status propagate_some_times(fmb_ends *f)
{
    worth w;
    fmb_status st = FMB_OK;
    size_t rows = f->e->rows, before = 0;
    mpq_inits(w.sum, w.t, w.a, NULL);
    for (int k = 0; k < PASSES && before < f->e->rows && !is_search_over(f, st); k++) {
        before = f->e->rows;
        st = propagate_once(f, rows, &w);
    }
    mpq_clears(w.sum, w.t, w.a, NULL);
    return st;
}

fmb_status fmb_ends_open(fmb_ends *f, fmb_elim *e)
{
    size_t n = (size_t)e->n;
    fmb_mem *mem = e->run->mem;
    *f = (fmb_ends){.e = e, .work = WORK};
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        f->row[side] = fmb_mem_get(mem, n, sizeof *f->row[side]);
        f->value[side] = fmb_mem_get(mem, n, sizeof *f->value[side]);
        for (size_t c = 0; f->value[side] && c < n; c++)
            mpq_init(f->value[side][c]);
        if (!f->row[side] || !f->value[side])
            return fmb_mem_status(mem);
        for (size_t c = 0; c < n; c++)
            f->row[side][c] = FMB_NO_ROW;
    }
    return FMB_OK;
}

fmb_status fmb_ends_find(fmb_ends *f)
{
    fmb_status st = take_all_single_rows(f);
    if (!is_search_over(f, st))
        st = propagate_some_times(f);
    return st == FMB_LIMIT ? FMB_OK : st;
}

void fmb_ends_clear(fmb_ends *f)
{
    size_t n = (size_t)f->e->n;
    fmb_mem *mem = f->e->run->mem;
    for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
        for (size_t c = 0; f->value[side] && c < n; c++)
            mpq_clear(f->value[side][c]);
        fmb_mem_put(mem, f->value[side], n, sizeof *f->value[side]);
        fmb_mem_put(mem, f->row[side], n, sizeof *f->row[side]);
    }
}
