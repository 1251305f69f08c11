/* ray.c: see ray.h. */
#include "lp/redundancy/ray_shooting/ray.h"

#include <math.h>
#include <string.h>

/* Bits of the coordinates of a direction: short ones make points of few digits. */
#define FEW_BITS  20
#define MOST_BITS 52

/* ---- life ------------------------------------------------------------------------------------ */

fmb_status fmb_ray_init(fmb_ray *r, fmb_mem *mem, const fmb_polar_points *p)
{
    size_t d = p->d;
    *r = (fmb_ray){.mem = mem, .p = p, .hit = SIZE_MAX};
    r->bound = fmb_mem_get(mem, p->blocks, sizeof *r->bound);
    r->rate = fmb_mem_get(mem, p->m, sizeof *r->rate);
    r->scaled = fmb_mem_get(mem, d, sizeof *r->scaled);
    r->aside = fmb_mem_get(mem, d, sizeof *r->aside);
    r->tried = fmb_mem_get(mem, FMB_RAY_TRIES, sizeof *r->tried);
    r->way = fmb_mem_get(mem, d, sizeof *r->way);
    for (size_t k = 0; r->way && k < d; k++)
        mpz_init(r->way[k]);
    return r->bound && r->rate && r->scaled && r->aside && r->tried && r->way ? FMB_OK
                                                                              : fmb_mem_status(mem);
}

void fmb_ray_clear(fmb_ray *r)
{
    if (!r->mem)
        return;
    fmb_mem *mem = r->mem;
    size_t d = r->p->d;
    for (size_t k = 0; r->way && k < d; k++)
        mpz_clear(r->way[k]);
    fmb_mem_put(mem, r->bound, r->p->blocks, sizeof *r->bound);
    fmb_mem_put(mem, r->rate, r->p->m, sizeof *r->rate);
    fmb_mem_put(mem, r->scaled, d, sizeof *r->scaled);
    fmb_mem_put(mem, r->aside, d, sizeof *r->aside);
    fmb_mem_put(mem, r->tried, FMB_RAY_TRIES, sizeof *r->tried);
    fmb_mem_put(mem, r->way, d, sizeof *r->way);
    r->mem = NULL;
}

/* ---- rays ------------------------------------------------------------------------------------ */

/* way . round = scaled . point_at: scaled = half^-T way. */
static void turn_to_scaled_columns(fmb_ray *r, const double *way)
{
    const fmb_polar_points *p = r->p;
    size_t d = p->d;
    for (size_t j = d; j-- > 0;) {
        double sum = way[j];
        for (size_t k = j + 1; k < d; k++)
            sum -= p->half[k * d + j] * r->scaled[k];
        r->scaled[j] = sum / p->half[j * d + j];
    }
}

/* Round the direction to so many bits; way / 2^unit is the same, exactly, in columns as they are.
 * False if it is 0, or so large or small that rates might overflow or underflow. */
static bool round_direction(fmb_ray *r, int bits)
{
    const fmb_polar_points *p = r->p;
    double most = 0;
    int top, least = 0;
    for (size_t k = 0; k < p->d; k++)
        most = fmax(most, fabs(r->scaled[k]));
    if (!(most > 0x1p-400 && most < 0x1p400))
        return false;
    frexp(most, &top);
    for (size_t k = 0; k < p->d; k++) /* column k counts 2^exponent, so its way as much less */
        least = k == 0 || -p->exponent[k] < least ? -p->exponent[k] : least;
    for (size_t k = 0; k < p->d; k++) {
        double whole = nearbyint(ldexp(r->scaled[k], bits - top));
        mpz_set_d(r->way[k], whole);
        mpz_mul_2exp(r->way[k], r->way[k], (mp_bitcnt_t)(-p->exponent[k] - least));
        r->scaled[k] = ldexp(whole, top - bits);
    }
    r->unit = bits - top - least;
    return true;
}

/* ---- which row is met first ------------------------------------------------------------------ */

static double larger_of(double a, double b)
{
    return a > b ? a : b;
}

/* What the rate at a place may be at most or, with -error, must be at least. */
static double rate_bound(const fmb_ray *r, size_t at, double error)
{
    return r->rate[at] + error * r->p->size[at];
}

/* The largest bound of places in a block; in four maxima, so that none waits for the other. */
static double largest_rate_bound(const fmb_ray *r, size_t from, size_t to, double error)
{
    double most[4] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    size_t at = from;
    for (; at + 4 <= to; at += 4)
        for (size_t k = 0; k < 4; k++)
            most[k] = larger_of(most[k], rate_bound(r, at + k, error));
    for (; at < to; at++)
        most[0] = larger_of(most[0], rate_bound(r, at, error));
    return larger_of(larger_of(most[0], most[1]), larger_of(most[2], most[3]));
}

static size_t end_of_block(const fmb_ray *r, size_t b)
{
    return (b + 1) * FMB_SPATIAL_BLOCK < r->p->m ? (b + 1) * FMB_SPATIAL_BLOCK : r->p->m;
}

/* If a block reaches far enough, find its rates, and from them its bound; sure: some rate is at
 * least that. */
static void look_at_block(fmb_ray *r, size_t b, double error, double *sure)
{
    const fmb_polar_points *p = r->p;
    size_t from = b * FMB_SPATIAL_BLOCK, to = end_of_block(r, b);
    if (r->bound[b] <= 0 || r->bound[b] < *sure)
        return;
    memset(&r->rate[from], 0, (to - from) * sizeof *r->rate);
    for (size_t k = 0; k < p->d; k++)
        p->kernels->accumulate(&r->rate[from], &p->point_at[k * p->m + from], to - from,
                               r->scaled[k]);
    r->bound[b] = largest_rate_bound(r, from, to, error);
    if (r->bound[b] > *sure)
        *sure = larger_of(*sure, largest_rate_bound(r, from, to, -error));
}

/* Of a block that was looked at, the rows that may be the first; false if they are too many. */
static bool try_rows_of_block(fmb_ray *r, size_t b, double error, double sure)
{
    for (size_t at = b * FMB_SPATIAL_BLOCK; at < end_of_block(r, b); at++) {
        double most = rate_bound(r, at, error);
        if (most < sure || most <= 0)
            r->rest = larger_of(r->rest, most);
        else if (r->tries == FMB_RAY_TRIES)
            return false;
        else
            r->tried[r->tries++] = r->p->order[at];
    }
    return true;
}

/* No rate in a block is larger than its bound; the block with the largest. */
static size_t bound_blocks(fmb_ray *r, double length, double error)
{
    const fmb_polar_points *p = r->p;
    size_t best = 0;
    memset(r->bound, 0, p->blocks * sizeof *r->bound);
    for (size_t k = 0; k < p->d; k++)
        p->kernels->accumulate(r->bound, &p->middle[k * p->blocks], p->blocks, r->scaled[k]);
    for (size_t b = 0; b < p->blocks; b++) {
        r->bound[b] += length * p->radius[b] + 4 * error * p->reach[b];
        best = r->bound[b] > r->bound[best] ? b : best;
    }
    return best;
}

/* The rows that may be the first; true if some row is met for sure. Error of a rate: of its
 * entries, four roundings; of the sum, one for each. */
static bool list_first_rows(fmb_ray *r)
{
    const fmb_polar_points *p = r->p;
    double square = 0, sure = 0;
    for (size_t k = 0; k < p->d; k++)
        square += r->scaled[k] * r->scaled[k];
    double length = sqrt(square), error = (double)(p->d + 8) * 0x1.1p-53 * length;
    r->rest = 0;
    r->tries = 0;
    look_at_block(r, bound_blocks(r, length, error), error, &sure);
    for (size_t b = 0; b < p->blocks; b++)
        look_at_block(r, b, error, &sure);
    for (size_t b = 0; b < p->blocks; b++) {
        if (r->bound[b] < sure || r->bound[b] <= 0) {
            r->rest = larger_of(r->rest, r->bound[b]);
        } else if (!try_rows_of_block(r, b, error, sure)) {
            r->tries = 0;
            return false;
        }
    }
    return sure > 0;
}

/* The exact time at which the ray meets row i; false if it never does. */
static bool exact_time(const fmb_ray *r, size_t i, mpq_t time)
{
    const fmb_polar_points *p = r->p;
    mpz_ptr slack = mpq_numref(time), speed = mpq_denref(time);
    mpz_t t;
    mpz_init(t);
    fmb_polar_points_slack(p, i, slack, t);
    mpz_mul_2exp(slack, slack, (mp_bitcnt_t)(r->unit > 0 ? r->unit : 0));
    mpz_set_ui(speed, 0);
    for (size_t k = 0; k < p->d; k++) {
        fmb_vec_get(p->row[i].v, p->column[k], t);
        mpz_addmul(speed, t, r->way[k]);
    }
    mpz_mul_2exp(speed, speed, (mp_bitcnt_t)(p->shift + (r->unit < 0 ? -r->unit : 0)));
    mpz_clear(t);
    if (mpz_sgn(speed) <= 0) {
        mpq_set_ui(time, 0, 1);
        return false;
    }
    mpq_canonicalize(time);
    return true;
}

/* Of the rows tried, those that are met first go to the front: their number. */
static size_t compare_first_times(fmb_ray *r)
{
    size_t firsts = 0;
    mpq_t best, time;
    mpq_inits(best, time, NULL);
    for (size_t k = 0; k < r->tries; k++) {
        size_t i = r->tried[k];
        if (!exact_time(r, i, time))
            continue;
        int order = firsts == 0 ? -1 : mpq_cmp(time, best);
        if (order < 0) {
            mpq_swap(best, time);
            firsts = 0;
        }
        if (order <= 0) {
            r->tried[k] = r->tried[firsts];
            r->tried[firsts++] = i;
        }
    }
    mpq_clears(best, time, NULL);
    return firsts;
}

/* Shoot in the direction at hand; *tie: several rows are met at once. */
static size_t shoot_rounded(fmb_ray *r, bool *tie)
{
    bool sure = list_first_rows(r);
    size_t firsts = r->tries;
    if (r->tries > 1 || !sure)
        firsts = compare_first_times(r);
    *tie = firsts > 1;
    return firsts == 1 ? r->tried[0] : SIZE_MAX;
}

/* Fixed numbers, no two of them alike. */
static double number_between(uint32_t *h)
{
    *h = *h * 1664525u + 1013904223u;
    return (double)(*h >> 8) / (1 << 23) - 1;
}

/* scaled = way, turned a little. */
static void turn_aside(fmb_ray *r, const double *way, uint32_t *h)
{
    double square = 0;
    for (size_t k = 0; k < r->p->d; k++)
        square += way[k] * way[k];
    for (size_t k = 0; k < r->p->d; k++)
        r->aside[k] = way[k] + sqrt(square) * number_between(h) * 0x1p-16;
    turn_to_scaled_columns(r, r->aside);
}

size_t fmb_ray_shoot(fmb_ray *r, const double *way, bool roughly)
{
    uint32_t h = 1;
    bool tie;
    turn_to_scaled_columns(r, way);
    r->hit = SIZE_MAX;
    if (!round_direction(r, roughly ? FEW_BITS : MOST_BITS))
        return SIZE_MAX;
    r->hit = shoot_rounded(r, &tie);
    for (int k = 0; k < 3 && tie; k++) {
        turn_aside(r, way, &h);
        if (!round_direction(r, roughly ? 2 * FEW_BITS : MOST_BITS))
            return SIZE_MAX;
        r->hit = shoot_rounded(r, &tie);
    }
    return r->hit;
}

/* ---- points beyond --------------------------------------------------------------------------- */

/* When the next row is met, or a little before; false if none is. Rates that are less than 2^-1000
 * are rounding errors. */
static bool next_time(const fmb_ray *r, mpq_t next)
{
    bool any = r->rest > 0;
    mpq_t time;
    mpq_init(time);
    if (any)
        mpq_set_d(next, (1 - 0x1p-50) / larger_of(r->rest, 0x1p-1000));
    for (size_t k = 0; k < r->tries; k++) {
        if (r->tried[k] == r->hit || !exact_time(r, r->tried[k], time))
            continue;
        if (!any || mpq_cmp(time, next) < 0)
            mpq_set(next, time);
        any = true;
    }
    mpq_clear(time);
    return any;
}

/* A number of few digits between low and high (without an end if !bounded). */
static void find_time_between(mpq_t time, const mpq_t low, const mpq_t high, bool bounded)
{
    mpz_t whole;
    mpz_init(whole);
    for (mp_bitcnt_t bits = 0;; bits++) { /* the least multiple of 2^-bits above low */
        mpz_mul_2exp(whole, mpq_numref(low), bits);
        mpz_fdiv_q(whole, whole, mpq_denref(low));
        mpz_add_ui(whole, whole, 1);
        mpq_set_z(time, whole);
        mpq_div_2exp(time, time, bits);
        if (!bounded || mpq_cmp(time, high) < 0)
            break;
    }
    mpz_clear(whole);
}

void fmb_ray_beyond(fmb_ray *r, mpq_t *x)
{
    const fmb_polar_points *p = r->p;
    mpq_t low, high, time;
    mpq_inits(low, high, time, NULL);
    exact_time(r, r->hit, low);
    bool bounded = next_time(r, high);
    find_time_between(time, low, high, bounded);
    fmb_polar_points_point(p, x);
    if (r->unit > 0)
        mpq_div_2exp(time, time, (mp_bitcnt_t)r->unit);
    else
        mpq_mul_2exp(time, time, (mp_bitcnt_t)-r->unit);
    for (size_t k = 0; k < p->d; k++) {
        mpq_set_z(low, r->way[k]);
        mpq_mul(low, low, time);
        mpq_add(x[p->column[k]], x[p->column[k]], low);
    }
    mpq_clears(low, high, time, NULL);
}
