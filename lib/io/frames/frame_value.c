/* frame_value.c: the numbers of frames, exactly and as doubles. */
#include <math.h>

#include "io/core/number.h"
#include "io/core/short_decimal.h"
#include "io/frames/frame_reader.h"

/* Exactly, and as a double. */
static fmb_status read_exact_value(fmb_frame_reader *r, fmb_cursor *c, mpq_t out, double *near)
{
    fmb_short_decimal d;
    const char *p = c->at;
    bool exact = true;
    fmb_status st = FMB_OK;
    if (!fmb_scan_short_decimal(c, true, &d) || !fmb_short_decimal_nearest(&d, near) ||
        !fmb_short_decimal_value(&d, out, &exact)) {
        c->at = p;
        st = fmb_json_number(c, "a number", out);
        if (st == FMB_OK)
            *near = fmb_io_nearest(out, &exact);
    }
    r->exact = r->exact && exact;
    r->digits += st == FMB_OK ? fmb_io_digits(out) : 0;
    r->numbers++;
    return st;
}

static fmb_status read_nearest_value(fmb_cursor *c, double *near)
{
    fmb_short_decimal d;
    const char *p = c->at;
    bool exact;
    mpq_t q;
    if (fmb_scan_short_decimal(c, true, &d) && fmb_short_decimal_nearest(&d, near))
        return FMB_OK;
    c->at = p;
    mpq_init(q);
    fmb_status st = fmb_json_number(c, "a number", q);
    *near = st == FMB_OK ? fmb_io_nearest(q, &exact) : 0;
    mpq_clear(q);
    return isfinite(*near) ? st
                           : fmb_io_fail(c, p, "expected a number that is not beyond all doubles");
}

fmb_status fmb_frame_reader_value(fmb_frame_reader *r, fmb_cursor *c, mpq_t out)
{
    double near;
    fmb_json_blanks(c);
    if (!r->how.nearest)
        return read_exact_value(r, c, out, &near);
    FMB_TRY(read_nearest_value(c, &near));
    mpq_set_d(out, near);
    return FMB_OK;
}

static fmb_status reserve_one_double(fmb_numbers *a, fmb_mem *mem)
{
    return a->n < a->d_capacity ? FMB_OK : FMB_RESERVE(mem, &a->d, &a->d_capacity, a->n + 1);
}

static fmb_status reserve_rationals(fmb_numbers *a, size_t n, fmb_mem *mem)
{
    size_t before = a->capacity;
    fmb_status st = n <= before ? FMB_OK : FMB_RESERVE(mem, &a->q, &a->capacity, n);
    for (size_t i = before; i < a->capacity; i++)
        mpq_init(a->q[i]);
    return st;
}

fmb_status fmb_numbers_rationals(fmb_numbers *a, fmb_mem *mem)
{
    FMB_TRY(reserve_rationals(a, a->n, mem));
    for (size_t i = 0; i < a->n; i++)
        mpq_set_d(a->q[i], a->d[i]);
    return FMB_OK;
}

static fmb_status read_array_number(void *reader, fmb_cursor *c)
{
    fmb_frame_reader *r = reader;
    fmb_numbers *a = r->point;
    FMB_TRY(fmb_frame_reader_poll(r));
    FMB_TRY(reserve_one_double(a, &r->mem));
    if (!r->how.nearest)
        FMB_TRY(reserve_rationals(a, a->n + 1, &r->mem));
    fmb_json_blanks(c);
    FMB_TRY(r->how.nearest ? read_nearest_value(c, &a->d[a->n])
                           : read_exact_value(r, c, a->q[a->n], &a->d[a->n]));
    a->n++;
    return FMB_OK;
}

/* A fast path for an array of doubles with few digits, for which there is room, the usual case.
 * False, with nothing read, for anything else. */
static bool read_array_of_short_doubles(fmb_frame_reader *r, fmb_cursor *c, fmb_numbers *to)
{
    const char *start = c->at;
    size_t n = to->n;
    fmb_short_decimal d;
    bool more = fmb_peek(c) == '[';
    while (more && n < to->d_capacity && fmb_frame_reader_poll(r) == FMB_OK) {
        c->at++;
        fmb_json_blanks(c);
        if (!fmb_scan_short_decimal(c, true, &d) || !fmb_short_decimal_nearest(&d, &to->d[n]))
            break;
        n++;
        fmb_json_blanks(c);
        more = fmb_peek(c) == ',';
        if (fmb_peek(c) == ']') {
            c->at++;
            to->n = n;
            return true;
        }
    }
    c->at = start;
    return false;
}

/* All arrays of a pair must have the same size; the first one sets it. */
fmb_status fmb_frame_reader_point(fmb_frame_reader *r, fmb_cursor *c, fmb_numbers *to)
{
    fmb_json_blanks(c);
    const char *p = c->at;
    size_t before = to->n;
    r->point = to;
    if (!r->how.nearest || !read_array_of_short_doubles(r, c, to))
        FMB_TRY(fmb_json_array(c, "an array of numbers", read_array_number, r));
    size_t n = to->n - before;
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
