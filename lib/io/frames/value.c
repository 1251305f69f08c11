/* value.c: the numbers of frames, exactly and as doubles. */
#include <math.h>

#include "io/core/number.h"
#include "io/frames/frames.h"

/* Exactly, and as a double. */
static fmb_status read_exact_value(fmb_frames *r, fmb_cursor *c, mpq_t out, double *near)
{
    const char *p = c->at;
    bool exact;
    fmb_status st = fmb_json_number(c, "a number", out);
    if (st != FMB_OK)
        return st;
    *near = fmb_io_nearest(out, &exact);
    if (r->how.nearest && !isfinite(*near))
        return fmb_io_fail(c, p, "expected a number that is not beyond all doubles");
    r->exact = r->exact && (exact || r->how.nearest);
    return FMB_OK;
}

fmb_status fmb_frames_value(fmb_frames *r, fmb_cursor *c, mpq_t out, double *near)
{
    fmb_json_blanks(c);
    bool is_short = r->how.nearest && fmb_json_short_nearest(c, near);
    fmb_status st = is_short ? FMB_OK : read_exact_value(r, c, out, near);
    if (st != FMB_OK)
        return st;
    if (r->how.nearest)
        mpq_set_d(out, *near);
    r->digits += fmb_io_digits(out);
    r->numbers++;
    return FMB_OK;
}

static fmb_status reserve_one_number(fmb_numbers *a, fmb_mem *mem)
{
    size_t before = a->capacity;
    fmb_status st = fmb_mem_reserve(mem, (void **)&a->d, &a->d_capacity, a->n + 1, sizeof *a->d);
    if (st == FMB_OK)
        st = fmb_mem_reserve(mem, (void **)&a->q, &a->capacity, a->n + 1, sizeof *a->q);
    for (size_t i = before; i < a->capacity; i++)
        mpq_init(a->q[i]);
    return st;
}

static fmb_status read_array_number(void *reader, fmb_cursor *c)
{
    fmb_frames *r = reader;
    fmb_numbers *a = r->point;
    fmb_status st = fmb_frames_poll(r);
    if (st == FMB_OK)
        st = reserve_one_number(a, &r->mem);
    if (st == FMB_OK)
        st = fmb_frames_value(r, c, a->q[a->n], &a->d[a->n]);
    a->n += st == FMB_OK;
    return st;
}

/* As many numbers as in the arrays before; the first one says how many that is. */
fmb_status fmb_frames_point(fmb_frames *r, fmb_cursor *c, fmb_numbers *to)
{
    fmb_json_blanks(c);
    const char *p = c->at;
    size_t before = to->n;
    r->point = to;
    fmb_status st = fmb_json_array(c, "an array of numbers", read_array_number, r);
    size_t n = to->n - before;
    if (st != FMB_OK)
        return st;
    if (n == 0 || n > FMB_FRAMES_DIM)
        return fmb_io_fail(c, p, "expected 1 to %d numbers, found %zu", FMB_FRAMES_DIM, n);
    if (r->dim > 0 && n != (size_t)r->dim)
        return fmb_io_fail(c, p, "expected %d numbers, as in the arrays before, found %zu", r->dim,
                           n);
    r->dim = (int)n;
    return FMB_OK;
}

void fmb_numbers_clear(fmb_numbers *a, fmb_mem *mem)
{
    for (size_t i = 0; i < a->capacity; i++)
        mpq_clear(a->q[i]);
    fmb_mem_put(mem, a->q, a->capacity, sizeof *a->q);
    fmb_mem_put(mem, a->d, a->d_capacity, sizeof *a->d);
}
