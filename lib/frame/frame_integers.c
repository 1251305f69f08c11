/* frame_integers.c: see frame_integers.h. */
#include "frame/frame_integers.h"

#include <math.h>

#include "frame/frame_private.h"
#include "num/vec.h"

struct fmb_number_source {
    /* Replace unit by a common multiple of it and the number's denominator. */
    void (*widen)(mpz_t unit, const void *frame, int i, int j);
    /* out = the number times unit. */
    void (*take)(mpz_t out, const void *frame, int i, int j, const mpz_t unit);
};

/* The index of number j of edge row i, in a frame whose rows are origin, edges, speed. */
static size_t edge_cell(int i, int j, int dim)
{
    return (size_t)(i - 1) * (size_t)dim + (size_t)j;
}

/* ---- doubles --------------------------------------------------------------------------------- */

static double double_at(const fmb_frame *f, int i, int j)
{
    return i == 0 ? f->origin[j] : i <= f->naxes ? f->axes[edge_cell(i, j, f->dim)] : f->speed[j];
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
static int log_of_unit(const mpz_t unit)
{
    return (int)mpz_sizeinbase(unit, 2) - 1;
}

static void widen_double(mpz_t unit, const void *frame, int i, int j)
{
    int exponent;
    odd_part(double_at(frame, i, j), &exponent);
    if (-exponent > log_of_unit(unit))
        mpz_mul_2exp(unit, unit, (mp_bitcnt_t)(-exponent - log_of_unit(unit)));
}

static void take_double(mpz_t out, const void *frame, int i, int j, const mpz_t unit)
{
    int exponent;
    fmb_integer_set_i64(out, odd_part(double_at(frame, i, j), &exponent));
    mpz_mul_2exp(out, out, (mp_bitcnt_t)(log_of_unit(unit) + exponent));
}

/* ---- rationals ------------------------------------------------------------------------------- */

static mpq_srcptr rational_at(const fmb_frame_q *f, int i, int j)
{
    return i == 0 ? f->origin[j] : i <= f->naxes ? f->axes[edge_cell(i, j, f->dim)] : f->speed[j];
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

/* The frames are described. */
static fmb_status find_units(fmb_scene *w, fmb_run *run)
{
    w->unit = fmb_vec_block((size_t)w->dim, w->mem);
    if (!w->unit)
        return fmb_mem_status(w->mem);
    for (int j = 0; j < w->dim; j++) {
        mpz_set_ui(w->unit[j], 1);
        for (size_t k = 0; k < w->frames; k++)
            for (int i = 0; i < w->frame[k].rows; i++)
                w->from->widen(w->unit[j], w->frame[k].source, i, j);
        FMB_TRY(fmb_poll_if_limited(run));
    }
    return FMB_OK;
}

static fmb_integer_frame outline_of_frame(fmb_shape shape, int naxes, bool moves,
                                          const void *source)
{
    bool is_simplex = shape == FMB_SIMPLEX || shape == FMB_SIMPLEX_BY_CORNERS;
    return (fmb_integer_frame){.shape = is_simplex ? FMB_SIMPLEX : FMB_CUBOID,
                               .naxes = naxes,
                               .rows = 1 + naxes + moves,
                               .moves = moves,
                               .by_corners = fmb_frame_is_by_corners(shape),
                               .source = source};
}

fmb_status fmb_scene_open(fmb_scene *w, const fmb_frame *f, const fmb_frame_q *q, size_t n,
                          fmb_mem *mem, fmb_run *run)
{
    static const fmb_number_source doubles = {widen_double, take_double},
                                   rationals = {widen_rational, take_rational};
    *w = (fmb_scene){
        .mem = mem, .dim = f ? f[0].dim : q[0].dim, .frames = n, .from = f ? &doubles : &rationals};
    FMB_TRY(FMB_GET(mem, w->frame, n));
    for (size_t k = 0; k < n; k++)
        w->frame[k] = f ? outline_of_frame(f[k].shape, f[k].naxes, f[k].speed != NULL, &f[k])
                        : outline_of_frame(q[k].shape, q[k].naxes, q[k].speed != NULL, &q[k]);
    return find_units(w, run);
}

void fmb_scene_clear(fmb_scene *w)
{
    fmb_vec_block_free(w->unit, (size_t)w->dim, w->mem);
    fmb_mem_put(w->mem, w->frame, w->frames, sizeof *w->frame);
}

void fmb_scene_number(const fmb_scene *w, const fmb_integer_frame *f, int i, int j, mpz_t out)
{
    w->from->take(out, f->source, i, j, w->unit[j]);
    if (!f->by_corners || i == 0 || i > f->naxes)
        return;
    mpz_t origin;
    mpz_init(origin);
    w->from->take(origin, f->source, 0, j, w->unit[j]);
    mpz_sub(out, out, origin);
    mpz_clear(origin);
}
