/* exact_intervals.c: boxes and their ends, exact and rounded outward. */
#include "solve/query/exact_intervals.h"

#include <math.h>

#include "num/rationals.h"

fmb_status fmb_box_new(const int *var, int size, const fmb_alloc *hook, fmb_box **out)
{
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_box *b;
    FMB_TRY(FMB_GET_ZERO(&mem, b, 1));
    b->mem = mem;
    b->var = fmb_mem_get(&b->mem, (size_t)size, sizeof *b->var);
    b->side = fmb_mem_zero(&b->mem, (size_t)size, sizeof *b->side);
    b->size = size;
    for (int i = 0; b->side && i < size; i++)
        mpq_inits(b->side[i][FMB_LOWER].value, b->side[i][FMB_UPPER].value, NULL);
    if (!b->var || !b->side) {
        fmb_box_free(b);
        return FMB_ERR_MEMORY;
    }
    for (int i = 0; i < size; i++)
        b->var[i] = var ? var[i] : i;
    *out = b;
    return FMB_OK;
}

void fmb_box_free(fmb_box *b)
{
    if (!b)
        return;
    for (int i = 0; b->side && i < b->size; i++)
        mpq_clears(b->side[i][FMB_LOWER].value, b->side[i][FMB_UPPER].value, NULL);
    fmb_mem_put(&b->mem, b->side, (size_t)b->size, sizeof *b->side);
    fmb_mem_put(&b->mem, b->var, (size_t)b->size, sizeof *b->var);
    fmb_mem mem = b->mem;
    fmb_mem_put(&mem, b, 1, sizeof *b);
}

int fmb_box_size(const fmb_box *b)
{
    return b ? b->size : 0;
}

static bool has_interval(const fmb_box *b, int i)
{
    return i >= 0 && i < fmb_box_size(b);
}

int fmb_box_var(const fmb_box *b, int i)
{
    return has_interval(b, i) ? b->var[i] : -1;
}

/* The nearest double on the outer side of q. mpq_get_d rounds towards zero and overflows to
 * infinity only in the exponent, so one step outward is enough where it was not exact. */
static double round_outward(const mpq_t q, fmb_side side)
{
    double d = mpq_get_d(q);
    double out = side == FMB_LOWER ? -INFINITY : INFINITY;
    if (!isfinite(d)) /* beyond the largest double */
        return (d < 0) == (side == FMB_LOWER) ? out : nextafter(d, 0.0);
    mpq_t back;
    mpq_init(back);
    mpq_set_d(back, d);
    int order = mpq_cmp(back, q);
    mpq_clear(back);
    bool inside = side == FMB_LOWER ? order > 0 : order < 0;
    return inside ? nextafter(d, out) : d;
}

bool fmb_exact_side_has_value(const fmb_exact_side *e)
{
    return e->kind == FMB_END_FINITE || e->kind == FMB_END_OUTER;
}

fmb_end fmb_exact_side_end(const fmb_exact_side *e, fmb_side side)
{
    if (!fmb_exact_side_has_value(e))
        return (fmb_end){e->kind, false, side == FMB_LOWER ? -INFINITY : INFINITY};
    return (fmb_end){e->kind, e->attained, round_outward(e->value, side)};
}

double fmb_exact_side_nearest(const fmb_exact_side *e, fmb_side side)
{
    return fmb_exact_side_has_value(e) ? fmb_nearest_double(e->value)
                                       : fmb_exact_side_end(e, side).value;
}

size_t fmb_exact_side_print(const fmb_exact_side *e, char *text, size_t size)
{
    if (e && fmb_exact_side_has_value(e))
        return fmb_rational_print(e->value, text, size);
    if (text && size > 0)
        *text = '\0';
    return 0;
}

/* NULL: there is no such interval. */
static const fmb_exact_side *side_of_box(const fmb_box *b, int i, fmb_side side)
{
    bool is_there = has_interval(b, i) && (side == FMB_LOWER || side == FMB_UPPER);
    return is_there ? &b->side[i][side] : NULL;
}

fmb_end fmb_box_end(const fmb_box *b, int i, fmb_side side)
{
    const fmb_exact_side *e = side_of_box(b, i, side);
    return e ? fmb_exact_side_end(e, side) : (fmb_end){.kind = FMB_END_UNKNOWN};
}

double fmb_box_nearest(const fmb_box *b, int i, fmb_side side)
{
    const fmb_exact_side *e = side_of_box(b, i, side);
    return e ? fmb_exact_side_nearest(e, side) : 0;
}

size_t fmb_box_end_text(const fmb_box *b, int i, fmb_side side, char *text, size_t size)
{
    return fmb_exact_side_print(side_of_box(b, i, side), text, size);
}

bool fmb_box_end_q(const fmb_box *b, int i, fmb_side side, mpq_t value)
{
    const fmb_exact_side *e = side_of_box(b, i, side);
    bool known = value && e && fmb_exact_side_has_value(e);
    if (known)
        mpq_set(value, e->value);
    return known;
}

fmb_status fmb_box_ends(const fmb_box *b, double *lower, double *upper)
{
    double *const out[] = {[FMB_LOWER] = lower, [FMB_UPPER] = upper};
    if (!b)
        return FMB_ERR_ARG;
    for (int i = 0; i < b->size; i++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
            if (out[side])
                out[side][i] = fmb_box_end(b, i, (fmb_side)side).value;
    return FMB_OK;
}
