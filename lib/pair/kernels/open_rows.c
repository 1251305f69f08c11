/* open_rows.c: see open_rows.h.
 *
 * All edges and speeds of a pair are multiples of a power of two, the origins of one that may be
 * less (their records say which): so they are whole numbers of a word. n is made of the minors of
 * its D - 1 vectors; vectors that begin the row before as well are not taken again. All is modulo
 * 2^64 or 2^128. With b bits of edges, s of the shift and f by which its unit is finer, no number
 * is larger than
 *
 *     D! 2^((D - 1) b) (2 2^s + 2 (2 D + 1) 2^(b + f)) <= D! (4 D + 4) 2^((D - 1) b + max(s, b +
 * f)),
 *
 * which has to be less than a half of that.
 *
 * Where faces touch many rows have the same n, and where edges are parallel many are 0. So a row is
 * settled if all its vectors are perpendicular to an n that was asked (its own is that, or 0), or
 * if there are vectors among them that are known to be dependent.
 */
#define FMB_LANES 1

#include "pair/kernels/open_rows.h"

#include <math.h>

#include "num/laplace.h"
#include "pair/kernels/lane/lane.h"
#include "pair/kernels/minors_kernels.h"

enum { VECTORS = 2 * FMB_MINORS_MOST_DIM + 1, MOST_SETTLED = 64 };

/* ---- whole numbers --------------------------------------------------------------------------- */

/* What numbers of a pair are multiples of, as exponents of two. */
typedef struct units {
    int axes, origins;
} units;

static units units_of_pair(const fmb_open_rows *x, unsigned l)
{
    const int at = (x->dim * (2 * x->dim + 3) + 3) * x->width + (int)l;
    units of[2];
    for (int k = 0; k < 2; k++)
        fmb_minors_split_units(x->record[k][at], &of[k].axes, &of[k].origins);
    const int axes = of[0].axes < of[1].axes ? of[0].axes : of[1].axes;
    const int origins = of[0].origins < of[1].origins ? of[0].origins : of[1].origins;
    return (units){axes, origins < axes ? origins : axes};
}

/* Bits of differences of n numbers of both frames, from number `from` on. */
static int count_bits(const fmb_open_rows *x, unsigned l, int from, int n, int unit)
{
    double most = 0;
    int e;
    for (int k = 0; k < 2; k++)
        for (int i = from; i < from + n; i++) {
            const double size = fabs(x->record[k][i * x->width + (int)l]);
            most = size > most ? size : most;
        }
    frexp(most, &e);
    return most == 0 ? 0 : e - unit + 1;
}

int fmb_open_rows_words(const fmb_open_rows *x, unsigned l)
{
    static const int FACTORIAL_BITS[] = {5, 7, 10, 13, 16};
    const int dim = x->dim;
    const units unit = units_of_pair(x, l);
    const int axes = count_bits(x, l, dim, dim * (dim + x->moves), unit.axes);
    const int shift = count_bits(x, l, 0, dim, unit.origins), finer = unit.axes - unit.origins;
    const int last = shift > axes + finer ? shift : axes + finer;
    const int bits = FACTORIAL_BITS[dim - 4] + 6 + (dim - 1) * axes + last + 1;
    return axes > 62 || shift > 62 || finer > 62 || bits > 128 ? 0 : bits > 64 ? 2 : 1;
}

/* Edges of A, of B, the drift; what both are apart. */
typedef struct whole_pair {
    fmb_u128 vector[VECTORS][FMB_MINORS_MOST_DIM], shift[FMB_MINORS_MOST_DIM];
    int finer;
} whole_pair;

static int64_t whole_of(const fmb_open_rows *x, unsigned l, int k, int number, double scale)
{
    return (int64_t)(x->record[k][number * x->width + (int)l] * scale);
}

/* Numbers that fmb_open_rows_words has found to be short. */
static void read_pair(const fmb_open_rows *x, unsigned l, whole_pair *out)
{
    const int dim = x->dim, speed = dim * (dim + 1);
    const units unit = units_of_pair(x, l);
    const double axes = ldexp(1, -unit.axes), origins = ldexp(1, -unit.origins);
    for (int i = 0; i < 2 * dim; i++)
        for (int j = 0; j < dim; j++)
            out->vector[i][j] =
                fmb_words_of(whole_of(x, l, i / dim, dim * (i % dim + 1) + j, axes));
    for (int j = 0; j < dim; j++) {
        out->shift[j] = fmb_words_of(whole_of(x, l, 1, j, origins) - whole_of(x, l, 0, j, origins));
        if (x->moves)
            out->vector[2 * dim][j] = fmb_words_of(whole_of(x, l, 1, speed + j, axes) -
                                                   whole_of(x, l, 0, speed + j, axes));
    }
    out->finer = unit.axes - unit.origins;
}

/* ---- directions ------------------------------------------------------------------------------ */

typedef struct decider {
    const fmb_open_rows *x;
    whole_pair pair;
    int taken[FMB_MINORS_MOST_DIM],
        known; /* vectors whose minors are known: by number, and how many */
    fmb_u128 minor[1 << FMB_MINORS_MOST_DIM];
    uint32_t flat[MOST_SETTLED]; /* the vectors that are perpendicular to an n that was asked */
    uint32_t null[MOST_SETTLED]; /* vectors that are dependent */
    int flats, nulls;
} decider;

static bool is_settled(const decider *d, uint32_t vectors)
{
    for (int i = 0; i < d->flats; i++)
        if (!(vectors & ~d->flat[i]))
            return true;
    for (int i = 0; i < d->nulls; i++)
        if (!(d->null[i] & ~vectors))
            return true;
    return false;
}

/* One more vector, unless it is the one that stands there. Are all minors 0? */
FMB_INLINE bool put_vector(int words, decider *d, int at, int number)
{
    const fmb_u128 *v = d->pair.vector[number];
    const int dim = d->x->dim;
    if (at < d->known && d->taken[at] == number)
        return false;
    d->taken[at] = number;
    d->known = at + 1;
    return at == 1   ? fmb_words_take_vector(words, dim, 1, v, d->minor)
           : at == 2 ? fmb_words_take_vector(words, dim, 2, v, d->minor)
           : at == 3 ? fmb_words_take_vector(words, dim, 3, v, d->minor)
                     : fmb_words_take_vector(words, dim, at, v, d->minor);
}

/* False: vectors of the row are dependent. */
FMB_INLINE bool find_direction(int words, decider *d, const fmb_open_row *row)
{
    const uint32_t of_a = (1U << d->x->dim) - 1, first = row->from_b ? ~of_a : of_a;
    uint32_t left[2] = {row->vectors & first, row->vectors & ~first}, part = 0;
    int at = 0;
    for (int i = 0; i < 2; i++)
        for (; left[i]; left[i] &= left[i] - 1) {
            part |= left[i] & -left[i];
            if (put_vector(words, d, at, __builtin_ctz(left[i]))) {
                d->known = at;
                d->null[d->nulls++] = part;
                return false;
            }
            at++;
        }
    return true;
}

/* n v */
FMB_INLINE fmb_u128 multiply(int words, const decider *d, const fmb_u128 *v)
{
    const unsigned all = (1U << d->x->dim) - 1;
    fmb_u128 sum[2] = {fmb_u128_of(0), fmb_u128_of(0)};
    for (int r = 0; r < d->x->dim; r++) {
        const fmb_u128 product = fmb_words_times(words, d->minor[all & ~(1U << r)], v[r]);
        sum[r % 2] = fmb_words_plus(words, sum[r % 2], product);
    }
    return fmb_words_minus(words, sum[0], sum[1]);
}

/* The gap. */
FMB_INLINE fmb_u128 ask_direction(int words, decider *d, uint32_t vectors)
{
    const int dim = d->x->dim;
    const fmb_u128 finer = fmb_u128_of(UINT64_C(1) << d->pair.finer);
    fmb_u128 away = fmb_u128_of(0), reach = away;
    for (int i = 0; i < 2 * dim + d->x->moves; i++) {
        if (vectors >> i & 1)
            continue;
        const fmb_u128 along = multiply(words, d, d->pair.vector[i]);
        vectors |= (uint32_t)fmb_words_are_zero(words, along) << i;
        reach = fmb_words_plus(words, reach, fmb_words_size(words, along));
        away = i < dim ? fmb_words_minus(words, away, along) : fmb_words_plus(words, away, along);
    }
    d->flat[d->flats++] = vectors;
    const fmb_u128 shift = multiply(words, d, d->pair.shift);
    away = fmb_words_plus(words, fmb_words_times(words, finer, away),
                          fmb_words_plus(words, shift, shift));
    return fmb_words_minus(words, fmb_words_size(words, away),
                           fmb_words_times(words, finer, reach));
}

/* ---- all of it ------------------------------------------------------------------------------- */

/* Numbers of a word. */
static bool are_parallel(int dim, const fmb_u128 *a, const fmb_u128 *b)
{
    int p = 0;
    while (p + 1 < dim && fmb_words_are_zero(2, a[p]))
        p++;
    for (int r = 0; r < dim; r++) {
        const fmb_u128 left = fmb_u128_times(a[p], b[r]), right = fmb_u128_times(a[r], b[p]);
        if (!fmb_words_are_zero(2, fmb_u128_minus(left, right)))
            return false;
    }
    return true;
}

/* Vectors, not of one frame, that are parallel: many rows have both. */
static void find_parallel(decider *d)
{
    const int dim = d->x->dim, n = 2 * dim + d->x->moves;
    for (int i = 0; i < n; i++)
        for (int j = i < dim ? dim : 2 * dim; j < n; j++)
            if (i < j && d->nulls < MOST_SETTLED &&
                are_parallel(dim, d->pair.vector[i], d->pair.vector[j]))
                d->null[d->nulls++] = 1U << i | 1U << j;
}

FMB_INLINE fmb_verdict decide(int words, decider *d, unsigned l)
{
    const fmb_open_rows *x = d->x;
    for (int i = 0; i < x->n; i++) {
        const fmb_open_row *row = &x->row[i];
        if (!(row->lanes >> l & 1) || is_settled(d, row->vectors))
            continue;
        if (d->flats == MOST_SETTLED || d->nulls == MOST_SETTLED)
            return FMB_UNKNOWN;
        if (!find_direction(words, d, row))
            continue;
        const fmb_u128 gap = ask_direction(words, d, row->vectors);
        if (fmb_words_are_zero(words, gap) ? !x->closed : !fmb_words_are_negative(words, gap))
            return FMB_INFEASIBLE;
    }
    return FMB_FEASIBLE;
}

static FMB_NEVER_CLONED fmb_verdict decide_in_one_word(decider *d, unsigned l)
{
    return decide(1, d, l);
}
static FMB_NEVER_CLONED fmb_verdict decide_in_two_words(decider *d, unsigned l)
{
    return decide(2, d, l);
}

fmb_verdict fmb_open_rows_decide(const fmb_open_rows *x, unsigned l, int words)
{
    decider d;
    if (x->full >> l & 1)
        return FMB_UNKNOWN;
    read_pair(x, l, &d.pair);
    d.x = x;
    d.minor[0] = fmb_u128_of(1);
    d.known = d.flats = d.nulls = 0;
    find_parallel(&d);
    return words == 1 ? decide_in_one_word(&d, l) : decide_in_two_words(&d, l);
}
