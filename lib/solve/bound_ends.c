/* bound_ends.c: see bound_ends.h. */
#include "solve/bound_ends.h"

/* In all: some milliseconds. One derivation at most looks at a row for each of its variables. */
#define WORK   ((size_t)1 << 17)
#define PASSES 4
/* Wide entries count for more, and an end of more digits than this is not looked for. */
#define WIDE_WORK 8
#define MOST_BITS 1024

static bool spend(fmb_ends *f, const fmb_vec *v)
{
    size_t cost = (size_t)f->e->n * (fmb_vec_is_wide(v) ? WIDE_WORK : 1);
    bool enough = f->work >= cost;
    f->work -= enough ? cost : f->work;
    return enough;
}

/* ---- a better end ---------------------------------------------------------------------------- */

/* Is value, not reached if open, a better end than what is known? */
static bool is_better(const fmb_ends *f, fmb_side side, int c, const mpq_t value, bool open)
{
    uint32_t known = f->row[side][c];
    if (known == FMB_NO_ROW)
        return true;
    int order = mpq_cmp(value, f->value[side][c]);
    if (order == 0)
        return open && !f->e->row[known].strict;
    return side == FMB_UPPER ? order < 0 : order > 0;
}

static fmb_status note_clash(fmb_ends *f, int c)
{
    uint32_t lower = f->row[FMB_LOWER][c], upper = f->row[FMB_UPPER][c], clash;
    if (lower == FMB_NO_ROW || upper == FMB_NO_ROW || lower == upper)
        return FMB_OK;
    int order = mpq_cmp(f->value[FMB_LOWER][c], f->value[FMB_UPPER][c]);
    bool open = f->e->row[lower].strict || f->e->row[upper].strict;
    if (order < 0 || (order == 0 && !open))
        return FMB_OK;
    bool turn = f->e->row[lower].equality; /* the second one may be subtracted, if an equality */
    return fmb_elim_derive_row(f->e, turn ? upper : lower, turn ? lower : upper, c, &clash);
}

/* Row r names column c only: take it for the end of that side. */
static fmb_status take(fmb_ends *f, fmb_side side, int c, uint32_t r, const mpq_t value)
{
    f->row[side][c] = r;
    mpq_set(f->value[side][c], value);
    return note_clash(f, c);
}

static void get(mpq_t out, const fmb_vec *v, int at)
{
    mpz_set_ui(mpq_denref(out), 1);
    fmb_vec_get(v, (size_t)at, mpq_numref(out));
}

static fmb_status take_single(fmb_ends *f, uint32_t i)
{
    const fmb_derived *r = &f->e->row[i];
    int c = fmb_elim_single_column(f->e, r);
    fmb_status st = FMB_OK;
    mpq_t value, a;
    if (c < 0)
        return FMB_OK;
    mpq_inits(value, a, NULL);
    get(value, &r->v, f->e->n);
    get(a, &r->v, c);
    mpq_div(value, value, a);
    bool equality = r->equality, strict = r->strict, upper = mpq_sgn(a) > 0;
    for (int side = FMB_LOWER; st == FMB_OK && side <= FMB_UPPER; side++)
        if ((equality || upper == (side == FMB_UPPER)) &&
            is_better(f, (fmb_side)side, c, value, strict))
            st = take(f, (fmb_side)side, c, i, value);
    mpq_clears(value, a, NULL);
    return st;
}

/* ---- a row over ends ------------------------------------------------------------------------- */

/* Cancel every column of row r but c, so that what is left is an end of that side. An inequality is
 * added as it is; an equality in whichever direction the end needs. */
static fmb_status make_end(fmb_ends *f, uint32_t r, int c, fmb_side side, uint32_t *out)
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
        (void)spend(f, &d->v); /* a chain that was begun is finished */
        st = fmb_elim_derive_row(e, turned ? end : r, turned ? r : end, k, &r);
    }
    *out = r;
    return st;
}

/* What a row in one direction is worth at the ends. */
typedef struct worth {
    mpq_t sum; /* of the terms at those ends of their columns where they are least */
    int infinite, open;
    int column; /* the last infinite one */
    mpq_t t, a;
} worth;

static fmb_side least_side(const fmb_derived *r, int c, int direction)
{
    return fmb_vec_sgn(&r->v, (size_t)c) * direction > 0 ? FMB_LOWER : FMB_UPPER;
}

static void add_up(const fmb_ends *f, const fmb_derived *r, int direction, worth *w)
{
    mpq_set_ui(w->sum, 0, 1);
    w->infinite = w->open = 0;
    for (int k = 0; k < f->e->n; k++) {
        if (fmb_vec_sgn(&r->v, (size_t)k) == 0)
            continue;
        fmb_side side = least_side(r, k, direction);
        uint32_t end = f->row[side][k];
        if (end == FMB_NO_ROW) {
            w->infinite++;
            w->column = k;
            continue;
        }
        w->open += f->e->row[end].strict;
        get(w->a, &r->v, k);
        mpq_mul(w->t, w->a, f->value[side][k]);
        mpq_add(w->sum, w->sum, w->t);
    }
}

/* Bound column c by row i, whose other terms are worth w: a x_c <= b - (sum of the others). */
static fmb_status bound_column(fmb_ends *f, uint32_t i, int direction, int c, worth *w)
{
    const fmb_derived *r = &f->e->row[i];
    fmb_side least = least_side(r, c, direction);
    fmb_side side = least == FMB_LOWER ? FMB_UPPER : FMB_LOWER;
    uint32_t own = f->row[least][c], end;
    int open = w->open - (own != FMB_NO_ROW && f->e->row[own].strict);
    get(w->t, &r->v, f->e->n);
    mpq_sub(w->t, w->t, w->sum);
    get(w->a, &r->v, c);
    mpq_div(w->t, w->t, w->a);
    if (own != FMB_NO_ROW)
        mpq_add(w->t, w->t, f->value[least][c]);
    if (mpz_sizeinbase(mpq_numref(w->t), 2) + mpz_sizeinbase(mpq_denref(w->t), 2) > MOST_BITS ||
        !is_better(f, side, c, w->t, r->strict || open > 0))
        return FMB_OK;
    fmb_status st = make_end(f, i, c, side, &end);
    return st == FMB_OK ? take(f, side, c, end, w->t) : st;
}

static fmb_status bound_by_row(fmb_ends *f, uint32_t i, int direction, worth *w)
{
    fmb_status st = FMB_OK;
    add_up(f, &f->e->row[i], direction, w);
    for (int c = 0; st == FMB_OK && f->e->clash == FMB_NO_ROW && c < f->e->n; c++) {
        bool bounded = w->infinite == 0 || (w->infinite == 1 && w->column == c);
        if (bounded && fmb_vec_sgn(&f->e->row[i].v, (size_t)c) != 0)
            st = bound_column(f, i, direction, c, w);
    }
    return st;
}

/* ---- all rows -------------------------------------------------------------------------------- */

static bool is_over(const fmb_ends *f, fmb_status st)
{
    return st != FMB_OK || f->e->clash != FMB_NO_ROW;
}

static fmb_status find_singles(fmb_ends *f)
{
    fmb_status st = FMB_OK;
    for (size_t i = 0; !is_over(f, st) && i < f->e->rows; i++)
        st = take_single(f, (uint32_t)i);
    return st;
}

/* One pass over the first rows: derived ones say more at once than those they come from. */
static fmb_status pass(fmb_ends *f, size_t rows, worth *w)
{
    fmb_status st = FMB_OK;
    for (uint32_t i = 0; i < rows && !is_over(f, st) && spend(f, &f->e->row[i].v); i++) {
        st = bound_by_row(f, i, 1, w);
        if (f->e->row[i].equality && !is_over(f, st))
            st = bound_by_row(f, i, -1, w);
    }
    return st;
}

static fmb_status propagate(fmb_ends *f)
{
    worth w;
    fmb_status st = FMB_OK;
    size_t rows = f->e->rows, before = 0;
    mpq_inits(w.sum, w.t, w.a, NULL);
    for (int k = 0; k < PASSES && before < f->e->rows && !is_over(f, st); k++) {
        before = f->e->rows;
        st = pass(f, rows, &w);
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
    fmb_status st = find_singles(f);
    if (!is_over(f, st))
        st = propagate(f);
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
