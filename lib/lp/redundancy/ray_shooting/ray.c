/* ray.c: see ray.h. */
#include "lp/redundancy/ray_shooting/ray.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"

/* Bits of the coordinates of a direction: short ones give points with few digits. */
#define FEW_BITS  20
#define MOST_BITS 52

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays_of_ray(fmb_ray *r, bool get)
{
    const size_t d = r->p->d;
    return FMB_ARRAYS(r->run->mem, get, FMB_ARRAY(r->bound, r->p->blocks),
                      FMB_ARRAY(r->rate, r->p->m), FMB_ARRAY(r->scaled, d), FMB_ARRAY(r->aside, d),
                      FMB_ARRAY(r->tried, FMB_RAY_TRIES), FMB_ARRAY(r->way, d));
}

fmb_status fmb_ray_init(fmb_ray *r, fmb_run *run, const fmb_polar_points *p)
{
    *r = (fmb_ray){.run = run, .p = p, .hit = SIZE_MAX};
    fmb_status st = hold_arrays_of_ray(r, true);
    for (size_t k = 0; r->way && k < p->d; k++)
        mpz_init(r->way[k]);
    return st;
}

void fmb_ray_clear(fmb_ray *r)
{
    if (!r->run)
        return;
    for (size_t k = 0; r->way && k < r->p->d; k++)
        mpz_clear(r->way[k]);
    (void)hold_arrays_of_ray(r, false);
    r->run = NULL;
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

/* Round the direction to so many bits; way / 2^unit is the same direction, exactly, in unscaled
 * columns. False if it is 0, or so large or small that rates might overflow or underflow. */
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
    for (size_t k = 0; k < p->d; k++) /* columns are scaled by 2^exponent, directions inversely */
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

/* The upper bound of the rate at a place or, with -error, the lower bound. */
static double rate_bound(const fmb_ray *r, size_t at, double error)
{
    return r->rate[at] + error * r->p->size[at];
}

/* The largest bound in a block; in four independent maxima, for parallel execution. */
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

/* Unless a block's bound is too small, compute its rates, and from them its bound; *sure: some rate
 * is at least that. */
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

/* List the rows of a visited block that may be first; false if there are too many. */
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

/* Bound the rates of each block; returns the block with the largest bound. */
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

/* List the rows that may be first; true if some row is certainly met. Error of a rate: four
 * roundings for its entries, and one for each summand. */
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

/* The time when the ray meets a row: slack / speed, both positive. Not in lowest terms: a gcd of
 * long numbers would take longer than all uses of the time. */
typedef struct meeting {
    mpz_t slack, speed;
} meeting;

static void open_meeting(meeting *t)
{
    mpz_inits(t->slack, t->speed, NULL);
}

static void close_meeting(meeting *t)
{
    mpz_clears(t->slack, t->speed, NULL);
}

static int compare_meetings(const meeting *a, const meeting *b)
{
    mpz_t left, right;
    mpz_inits(left, right, NULL);
    mpz_mul(left, a->slack, b->speed);
    mpz_mul(right, b->slack, a->speed);
    int order = mpz_cmp(left, right);
    mpz_clears(left, right, NULL);
    return order;
}

/* The exact time at which the ray meets row i; false if it never does. */
static bool exact_time(const fmb_ray *r, size_t i, meeting *time)
{
    const fmb_polar_points *p = r->p;
    mpz_t t;
    mpz_init(t);
    fmb_polar_points_slack(p, i, time->slack, t);
    mpz_mul_2exp(time->slack, time->slack, (mp_bitcnt_t)(r->unit > 0 ? r->unit : 0));
    mpz_set_ui(time->speed, 0);
    for (size_t k = 0; k < p->d; k++) {
        fmb_vec_get(p->row[i].v, p->column[k], t);
        mpz_addmul(time->speed, t, r->way[k]);
    }
    mpz_mul_2exp(time->speed, time->speed, (mp_bitcnt_t)(p->shift + (r->unit < 0 ? -r->unit : 0)));
    mpz_clear(t);
    return mpz_sgn(time->speed) > 0;
}

/* Move the rows met first to the front of those tried; returns their number; 0 also at a limit. */
static size_t compare_first_times(fmb_ray *r)
{
    size_t firsts = 0;
    fmb_status st = FMB_OK;
    meeting best, time;
    open_meeting(&best);
    open_meeting(&time);
    for (size_t k = 0; st == FMB_OK && k < r->tries; k++) {
        size_t i = r->tried[k];
        if (!exact_time(r, i, &time))
            continue;
        int order = firsts == 0 ? -1 : compare_meetings(&time, &best);
        if (order < 0) {
            mpz_swap(best.slack, time.slack);
            mpz_swap(best.speed, time.speed);
            firsts = 0;
        }
        if (order <= 0) {
            r->tried[k] = r->tried[firsts];
            r->tried[firsts++] = i;
        }
        st = fmb_run_poll_long(r->run, best.slack);
    }
    close_meeting(&best);
    close_meeting(&time);
    return st == FMB_OK ? firsts : 0;
}

/* Shoot in the rounded direction; *tie: several rows are met at once. */
static size_t shoot_rounded(fmb_ray *r, bool *tie)
{
    bool sure = list_first_rows(r);
    size_t firsts = r->tries;
    if (r->tries > 1 || !sure)
        firsts = compare_first_times(r);
    *tie = firsts > 1;
    return firsts == 1 ? r->tried[0] : SIZE_MAX;
}

/* Pseudorandom numbers from -1 to 1, always the same. */
static double number_between(uint32_t *h)
{
    *h = *h * 1664525u + 1013904223u;
    return (double)(*h >> 8) / (1 << 23) - 1;
}

/* scaled = way, slightly perturbed. */
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

/* The time when the next row is met, or a little before; 0 / 0 if none is. Rates below 2^-1000 are
 * rounding errors. */
static void next_time(const fmb_ray *r, meeting *next)
{
    meeting time;
    if (r->rest > 0) {
        mpq_t bound;
        mpq_init(bound);
        mpq_set_d(bound, (1 - 0x1p-50) / larger_of(r->rest, 0x1p-1000));
        mpz_swap(next->slack, mpq_numref(bound));
        mpz_swap(next->speed, mpq_denref(bound));
        mpq_clear(bound);
    }
    open_meeting(&time);
    for (size_t k = 0; k < r->tries; k++) {
        if (r->tried[k] == r->hit || !exact_time(r, r->tried[k], &time))
            continue;
        if (mpz_sgn(next->speed) > 0 && compare_meetings(&time, next) >= 0)
            continue;
        mpz_swap(next->slack, time.slack);
        mpz_swap(next->speed, time.speed);
    }
    close_meeting(&time);
}

/* The least multiple of 2^-bits above low, as the integer `whole`; is it below high? */
static bool is_multiple_between(mpz_t whole, const meeting *low, const meeting *high,
                                mp_bitcnt_t bits)
{
    meeting multiple;
    mpz_mul_2exp(whole, low->slack, bits);
    mpz_fdiv_q(whole, whole, low->speed);
    mpz_add_ui(whole, whole, 1);
    if (mpz_sgn(high->speed) == 0)
        return true;
    open_meeting(&multiple);
    mpz_set(multiple.slack, whole);
    mpz_setbit(multiple.speed, bits);
    bool below = compare_meetings(&multiple, high) < 0;
    close_meeting(&multiple);
    return below;
}

/* A number with few digits between low and high: a multiple of the largest power of two that has
 * one there. If a power has one, so has its half; so binary search finds the largest. */
static fmb_status find_time_between(fmb_run *run, mpq_t time, const meeting *low,
                                    const meeting *high)
{
    mp_bitcnt_t none = 0, some = 0; /* up to `none` bits there is none; with `some` there is one */
    mpz_ptr whole = mpq_numref(time);
    while (!is_multiple_between(whole, low, high, some)) {
        none = some + 1;
        some = 2 * some + 1;
        FMB_TRY(fmb_run_poll_long(run, low->slack));
    }
    while (none < some) {
        mp_bitcnt_t half = none + (some - none) / 2;
        if (is_multiple_between(whole, low, high, half))
            some = half;
        else
            none = half + 1;
        FMB_TRY(fmb_run_poll_long(run, low->slack));
    }
    (void)is_multiple_between(whole, low, high, some);
    mpz_set_ui(mpq_denref(time), 1);
    mpq_div_2exp(time, time, some);
    return FMB_OK;
}

/* x = the point of the ray at that time. */
static void go_along(const fmb_ray *r, mpq_t time, mpq_t *x)
{
    const fmb_polar_points *p = r->p;
    mpq_t t;
    mpq_init(t);
    fmb_polar_points_point(p, x);
    if (r->unit > 0)
        mpq_div_2exp(time, time, (mp_bitcnt_t)r->unit);
    else
        mpq_mul_2exp(time, time, (mp_bitcnt_t)-r->unit);
    for (size_t k = 0; k < p->d; k++) {
        mpq_set_z(t, r->way[k]);
        mpq_mul(t, t, time);
        mpq_add(x[p->column[k]], x[p->column[k]], t);
    }
    mpq_clear(t);
}

fmb_status fmb_ray_beyond(fmb_ray *r, mpq_t *x)
{
    meeting low, high;
    mpq_t time;
    open_meeting(&low);
    open_meeting(&high);
    mpq_init(time);
    exact_time(r, r->hit, &low);
    next_time(r, &high);
    fmb_status st = find_time_between(r->run, time, &low, &high);
    if (st == FMB_OK)
        go_along(r, time, x);
    mpq_clear(time);
    close_meeting(&low);
    close_meeting(&high);
    return st;
}
