/* whole.c: see whole.h. */
#include "frame/whole.h"

#include <math.h>

/* Where numbers come from: number j of row i of a frame. */
typedef struct origin {
    size_t size; /* of a frame [bytes] */
    /* Make unit a multiple of itself that is a multiple of the denominator. */
    void (*widen)(mpz_t unit, const void *frame, int i, int j);
    /* out = the number times unit. */
    void (*take)(mpz_t out, const void *frame, int i, int j, const mpz_t unit);
} origin;

/* ---- doubles --------------------------------------------------------------------------------- */

static double double_at(const fmb_frame *f, int i, int j)
{
    return i == 0 ? f->origin[j] : i <= f->naxes ? f->axes[(i - 1) * f->dim + j] : f->speed[j];
}

/* x = odd 2^*exponent; 0 = 0 2^0. */
static int64_t odd_part(double x, int *exponent)
{
    *exponent = 0;
    if (x == 0)
        return 0;
    int64_t m = (int64_t)ldexp(frexp(x, exponent), 53);
    int zeros = __builtin_ctzll((unsigned long long)m);
    *exponent += zeros - 53;
    return m / ((int64_t)1 << zeros);
}

/* k of unit = 2^k */
static int log_of(const mpz_t unit)
{
    return (int)mpz_sizeinbase(unit, 2) - 1;
}

static void widen_double(mpz_t unit, const void *frame, int i, int j)
{
    int exponent;
    odd_part(double_at(frame, i, j), &exponent);
    if (-exponent > log_of(unit))
        mpz_mul_2exp(unit, unit, (mp_bitcnt_t)(-exponent - log_of(unit)));
}

static void take_double(mpz_t out, const void *frame, int i, int j, const mpz_t unit)
{
    int exponent;
    mpz_set_si(out, odd_part(double_at(frame, i, j), &exponent));
    mpz_mul_2exp(out, out, (mp_bitcnt_t)(log_of(unit) + exponent));
}

/* ---- rationals ------------------------------------------------------------------------------- */

static mpq_srcptr rational_at(const fmb_frame_q *f, int i, int j)
{
    return i == 0 ? f->origin[j] : i <= f->naxes ? f->axes[(i - 1) * f->dim + j] : f->speed[j];
}

static void widen_rational(mpz_t unit, const void *frame, int i, int j)
{
    mpz_lcm(unit, unit, mpq_denref(rational_at(frame, i, j)));
}

static void take_rational(mpz_t out, const void *frame, int i, int j, const mpz_t unit)
{
    mpq_srcptr q = rational_at(frame, i, j);
    mpz_divexact(out, unit, mpq_denref(q));
    mpz_mul(out, out, mpq_numref(q));
}

/* ---- both ------------------------------------------------------------------------------------ */

static const void *frame_at(const origin *from, const void *frames, size_t k)
{
    return (const char *)frames + k * from->size;
}

static void fill_axis(fmb_scene *w, const origin *from, const void *frames, int j)
{
    mpz_set_ui(w->unit[j], 1);
    for (size_t k = 0; k < w->frames; k++)
        for (int i = 0; i < w->frame[k].rows; i++)
            from->widen(w->unit[j], frame_at(from, frames, k), i, j);
    for (size_t k = 0; k < w->frames; k++)
        for (int i = 0; i < w->frame[k].rows; i++)
            from->take(w->frame[k].number[i * w->dim + j], frame_at(from, frames, k), i, j,
                       w->unit[j]);
}

/* The frames themselves are described, but for the numbers. */
static fmb_status fill(fmb_scene *w, const origin *from, const void *frames)
{
    size_t rows = 1, dim = (size_t)w->dim;
    for (size_t k = 0; k < w->frames; k++)
        rows += (size_t)w->frame[k].rows;
    w->cells = rows * dim;
    w->cell = fmb_mem_get(w->mem, w->cells, sizeof *w->cell);
    if (!w->cell)
        return fmb_mem_status(w->mem);
    for (size_t i = 0; i < w->cells; i++)
        mpz_init(w->cell[i]);
    w->unit = w->cell;
    mpz_t *next = w->cell + dim;
    for (size_t k = 0; k < w->frames; k++) {
        w->frame[k].number = next;
        next += (size_t)w->frame[k].rows * dim;
    }
    for (int j = 0; j < w->dim; j++)
        fill_axis(w, from, frames, j);
    return FMB_OK;
}

static fmb_status begin(fmb_scene *w, int dim, size_t n, fmb_mem *mem)
{
    *w = (fmb_scene){.mem = mem, .dim = dim, .frames = n};
    w->frame = fmb_mem_get(mem, n, sizeof *w->frame);
    return w->frame ? FMB_OK : fmb_mem_status(mem);
}

static fmb_whole outline(fmb_shape shape, int naxes, bool moves)
{
    return (fmb_whole){.shape = shape, .naxes = naxes, .rows = 1 + naxes + moves, .moves = moves};
}

fmb_status fmb_scene_of_doubles(fmb_scene *w, const fmb_frame *f, size_t n, fmb_mem *mem)
{
    static const origin doubles = {sizeof *f, widen_double, take_double};
    fmb_status st = begin(w, f[0].dim, n, mem);
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        w->frame[k] = outline(f[k].shape, f[k].naxes, f[k].speed != NULL);
    return st == FMB_OK ? fill(w, &doubles, f) : st;
}

fmb_status fmb_scene_of_rationals(fmb_scene *w, const fmb_frame_q *f, size_t n, fmb_mem *mem)
{
    static const origin rationals = {sizeof *f, widen_rational, take_rational};
    fmb_status st = begin(w, f[0].dim, n, mem);
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        w->frame[k] = outline(f[k].shape, f[k].naxes, f[k].speed != NULL);
    return st == FMB_OK ? fill(w, &rationals, f) : st;
}

void fmb_scene_clear(fmb_scene *w)
{
    for (size_t i = 0; w->cell && i < w->cells; i++)
        mpz_clear(w->cell[i]);
    fmb_mem_put(w->mem, w->cell, w->cells, sizeof *w->cell);
    fmb_mem_put(w->mem, w->frame, w->frames, sizeof *w->frame);
}
