/* exact_box_load.c: frames as integers; see exact_box_program.h. */
#include "pair/exact_box/exact_box_program.h"

#include <stdlib.h>

#include "frame/frame_private.h"
#include "num/split_double.h"

/* Reads number i of a row. */
typedef void fmb_exact_box_reader(const void *self, int frame, int i, int row, fmb_wide *out);

enum { ORIGIN = -1, SPEED = -2 }; /* in place of an axis */

/* Bits of M, h, origins and speeds, relative to one another, of which all numbers of a row are made
 * (point.h): minors of order k have k times as many and the bits of k!. The longest product is that
 * of two of order dim and a number. */
static int most_bits(int dim)
{
    return (FMB_WIDE_BITS - 40) / (2 * dim + 1) - 3;
}

/* ---- doubles --------------------------------------------------------------------------------- */

/* m 2^e; of 0 m is 0. */
typedef struct split_double {
    uint64_t m;
    int e;
    bool minus;
} split_double;

typedef struct double_pair {
    const fmb_frame *frame[2];
    int exponent[FMB_EXACT_BOX_DIM];
    split_double part[2][FMB_EXACT_BOX_DIM + 2][FMB_EXACT_BOX_DIM]; /* SPEED, ORIGIN, axes */
} double_pair;

static double number_of_frame(const fmb_frame *f, int axis, int row)
{
    if (axis == ORIGIN)
        return f->origin[row];
    if (axis == SPEED)
        return f->speed ? f->speed[row] : 0;
    return f->axes[axis * f->dim + row];
}

/* Split the numbers of a row, and find their least power of two; false: the largest is too large in
 * that unit. */
static bool split_row(double_pair *d, int row)
{
    int least = INT32_MAX, most = INT32_MIN;
    for (int k = 0; k < 2; k++)
        for (int axis = SPEED; axis < d->frame[k]->naxes; axis++) {
            const double x = number_of_frame(d->frame[k], axis, row);
            split_double *to = &d->part[k][axis - SPEED][row];
            to->m = fmb_split_double(x, &to->e);
            to->minus = x < 0;
            if (to->m == 0)
                continue;
            const int high = to->e + 64 - __builtin_clzll(to->m);
            least = to->e < least ? to->e : least;
            most = high > most ? high : most;
        }
    d->exponent[row] = least == INT32_MAX ? 0 : -least;
    return least == INT32_MAX || most - least < most_bits(d->frame[0]->dim);
}

static void read_double(const void *self, int frame, int axis, int row, fmb_wide *out)
{
    const double_pair *d = self;
    const split_double *x = &d->part[frame][axis - SPEED][row];
    const int by = x->m == 0 ? 0 : x->e + d->exponent[row];
    fmb_wide_set_word(out, x->m);
    out->minus = x->minus;
    if (x->m != 0 && by <= __builtin_clzll(x->m))
        out->word[0] <<= by;
    else
        fmb_wide_shift(out, by);
}

/* ---- rationals ------------------------------------------------------------------------------- */

typedef struct rational_pair {
    const fmb_frame_q *frame[2];
    mpq_t *unit;
    mpz_t *whole;
} rational_pair;

static mpq_srcptr rational_of_frame(const fmb_frame_q *f, int axis, int row)
{
    if (axis == ORIGIN)
        return f->origin[row];
    if (axis == SPEED)
        return f->speed ? f->speed[row] : NULL;
    return f->axes[axis * f->dim + row];
}

static bool is_word(mpz_srcptr z)
{
    return fmb_integer_words(z) <= 1;
}

/* Does d divide unit? Only cheap tests. */
static bool is_divisor(mpz_srcptr d, mpz_srcptr unit)
{
    return mpz_cmp_ui(d, 1) == 0 || mpz_cmp(d, unit) == 0 ||
           (is_word(d) && is_word(unit) && fmb_integer_low(unit) % fmb_integer_low(d) == 0);
}

/* |x| is less than 2 to that power. */
static int bits_of_rational(mpq_srcptr x)
{
    return (int)mpz_sizeinbase(mpq_numref(x), 2) - (int)mpz_sizeinbase(mpq_denref(x), 2) + 1;
}

/* The least common denominator of a row; false if it is too long. *most: bits of the largest
 * number. */
static bool find_denominator_of_row(const rational_pair *d, int row, int *most)
{
    mpz_ptr common = mpq_denref(d->unit[row]);
    for (int k = 0; k < 2; k++)
        for (int axis = SPEED; axis < d->frame[k]->naxes; axis++) {
            mpq_srcptr x = rational_of_frame(d->frame[k], axis, row);
            if (!x || mpq_sgn(x) == 0)
                continue;
            size_t longest = fmb_integer_words(mpq_numref(x)) + fmb_integer_words(mpq_denref(x));
            if (longest > 2 * FMB_WIDE_WORDS || fmb_integer_words(common) > 2 * FMB_WIDE_WORDS)
                return false;
            if (!is_divisor(mpq_denref(x), common))
                mpz_lcm(common, common, mpq_denref(x));
            *most = bits_of_rational(x) > *most ? bits_of_rational(x) : *most;
        }
    return true;
}

/* The greatest common divisor of a row's numerators, if there is any number but 0. */
static void find_divisor_of_row(const rational_pair *d, int row)
{
    mpz_ptr common = mpq_numref(d->unit[row]);
    mpz_set_ui(common, 0);
    for (int k = 0; k < 2; k++)
        for (int axis = SPEED; axis < d->frame[k]->naxes && mpz_cmp_ui(common, 1) != 0; axis++) {
            mpq_srcptr x = rational_of_frame(d->frame[k], axis, row);
            if (x)
                mpz_gcd(common, common, mpq_numref(x));
        }
    if (mpz_sgn(common) == 0)
        mpz_set_ui(common, 1);
}

/* The greatest rational of which all numbers of a row are multiples: as they are in lowest terms,
 * their numerators' divisor over their common denominator. Where numbers are a word, the divisor is
 * not looked for. False: they are too long. */
static bool find_rational_unit(const rational_pair *d, int row)
{
    const int none = INT32_MIN / 2;
    int most = none, divided = 1;
    mpq_set_ui(d->unit[row], 1, 1);
    if (!find_denominator_of_row(d, row, &most))
        return false;
    most += (int)mpz_sizeinbase(mpq_denref(d->unit[row]), 2);
    if (most > 64) {
        find_divisor_of_row(d, row);
        divided = (int)mpz_sizeinbase(mpq_numref(d->unit[row]), 2);
    }
    return most - divided < most_bits(d->frame[0]->dim);
}

/* n / d in that unit, where all of them are words. */
static void read_words(mpz_srcptr n, mpz_srcptr d, mpq_srcptr unit, fmb_wide *out)
{
    uint64_t factor = fmb_integer_low(mpq_denref(unit)) / fmb_integer_low(d);
    uint64_t times = fmb_integer_low(n) / fmb_integer_low(mpq_numref(unit));
    fmb_u128 product = fmb_u128_product(times, factor);
    out->word[0] = fmb_u128_low(product);
    out->word[1] = fmb_u128_high(product);
    out->n = 1 + (out->word[1] != 0);
    out->minus = mpz_sgn(n) < 0;
}

static void write_wide(mpz_srcptr z, fmb_wide *out)
{
    size_t words = 0;
    mpz_export(out->word, &words, -1, sizeof *out->word, 0, 0, z);
    out->n = (int)words;
    out->minus = mpz_sgn(z) < 0;
}

static void read_rational(const void *self, int frame, int axis, int row, fmb_wide *out)
{
    const rational_pair *d = self;
    mpq_srcptr x = rational_of_frame(d->frame[frame], axis, row), unit = d->unit[row];
    out->n = 0;
    out->minus = false;
    if (!x || mpq_sgn(x) == 0)
        return;
    if (is_word(mpq_numref(x)) && is_word(mpq_denref(x)) && is_word(mpq_denref(unit))) {
        read_words(mpq_numref(x), mpq_denref(x), unit, out);
        return;
    }
    mpz_divexact(*d->whole, mpq_denref(unit), mpq_denref(x));
    mpz_mul(*d->whole, *d->whole, mpq_numref(x));
    if (mpz_cmp_ui(mpq_numref(unit), 1) != 0)
        mpz_divexact(*d->whole, *d->whole, mpq_numref(unit));
    write_wide(*d->whole, out);
}

/* ---- both ------------------------------------------------------------------------------------ */

/* The shape of a frame, for doubles and rationals. */
typedef struct body {
    fmb_shape shape;
    int dim, naxes;
    bool moves;
} body;

/* Columns of frame k, whose edges come with that sign. */
static void load_axes_of_frame(fmb_exact_box_program *s, int k, const body *b,
                               fmb_exact_box_reader *read, const void *self)
{
    bool by_corners = fmb_frame_is_by_corners(b->shape);
    s->is_simplex[k] = b->shape == FMB_SIMPLEX || b->shape == FMB_SIMPLEX_BY_CORNERS;
    for (int axis = 0; axis < b->naxes; axis++, s->columns++) {
        s->group[s->columns] = (signed char)(s->is_simplex[k] ? k : FMB_EXACT_BOX_UNIT);
        for (int row = 0; row < s->dim; row++) {
            fmb_wide *to = &s->m[s->columns].whole[row], origin;
            read(self, k, axis, row, to);
            if (by_corners) {
                read(self, k, ORIGIN, row, &origin);
                fmb_wide_subtract(to, &origin);
            }
            if (k == 1)
                fmb_wide_negate(to);
        }
    }
    if (s->is_simplex[k])
        s->group[s->slack + k] = (signed char)k;
}

static void load_places(fmb_exact_box_program *s, fmb_exact_box_reader *read, const void *self)
{
    for (int row = 0; row < s->dim; row++) {
        fmb_wide *h = &s->h.whole[row], *less = &s->origin[1].whole[row];
        for (int k = 0; k < 2; k++)
            read(self, k, ORIGIN, row, &s->origin[k].whole[row]);
        fmb_wide_copy(h, less);
        fmb_wide_subtract(h, &s->origin[0].whole[row]);
        fmb_wide_negate(less);
    }
}

static void load_speeds(fmb_exact_box_program *s, fmb_exact_box_reader *read, const void *self)
{
    for (int row = 0; row < s->dim; row++) {
        fmb_wide *drift = &s->m[s->columns].whole[row], *less = &s->speed[1].whole[row];
        for (int k = 0; k < 2; k++)
            read(self, k, SPEED, row, &s->speed[k].whole[row]);
        fmb_wide_negate(less);
        fmb_wide_copy(drift, &s->speed[0].whole[row]);
        fmb_wide_add(drift, less);
    }
    s->group[s->columns++] = FMB_EXACT_BOX_UNIT;
}

/* Slacks and artificial unknowns. */
static void load_unit_vectors(fmb_exact_box_program *s)
{
    for (int j = s->slack; j < s->unknowns; j++)
        for (int row = 0; row < s->dim; row++) {
            bool is_one = j - s->artificial == row;
            fmb_wide_set_word(&s->m[j].whole[row], is_one);
            s->m[j].near[row] = is_one;
            s->m[j].rest[row] = 0;
        }
}

/* ---- scaled doubles -------------------------------------------------------------------------- */

/* The bits of the longest number in each row. */
static void measure_vector(fmb_exact_box_program *s, const fmb_exact_box_vector *x)
{
    for (int row = 0; row < s->dim; row++) {
        int length = fmb_wide_length(&x->whole[row]);
        s->scale[row] = length > s->scale[row] ? length : s->scale[row];
    }
}

/* By how many bits, at most `most`, all numbers of a vector are shorter than the longest of their
 * rows. */
static int bits_below_rows(const fmb_exact_box_program *s, const fmb_exact_box_vector *x, int most)
{
    for (int row = 0; row < s->dim; row++) {
        int length = fmb_wide_length(&x->whole[row]);
        if (length > 0 && s->scale[row] - length < most)
            most = s->scale[row] - length;
    }
    return most;
}

static void round_vector(const fmb_exact_box_program *s, fmb_exact_box_vector *x, int up)
{
    for (int row = 0; row < s->dim; row++)
        x->near[row] = fmb_wide_to_doubles(&x->whole[row], s->scale[row] - up, &x->rest[row]);
}

/* The exponents of the powers of two by which doubles of A, of B, of time, and of h are scaled. */
typedef struct scaling {
    int up[3], of_h;
} scaling;

/* If one frame is so much smaller than the rest of its rows that doubles would take it for a point,
 * the unknowns of each frame get their own unit. */
static bool find_scaling(fmb_exact_box_program *s, scaling *by)
{
    const int none = INT32_MAX / 2, point = 40;
    for (int row = 0; row < s->dim; row++)
        s->scale[row] = 0;
    measure_vector(s, &s->h);
    for (int j = 0; j < s->columns; j++)
        measure_vector(s, &s->m[j]);
    *by = (scaling){{none, none, none}, none};
    for (int j = 0; j < s->columns; j++) {
        int *up = &by->up[fmb_exact_box_end_of(s, j)];
        *up = bits_below_rows(s, &s->m[j], *up);
    }
    bool one = FMB_WIDE_IS_LONG && by->up[0] < none && by->up[1] < none &&
               abs(by->up[0] - by->up[1]) > point;
    int most = by->up[0] > by->up[1] ? by->up[0] : by->up[1];
    by->of_h = bits_below_rows(s, &s->h, most);
    by->up[2] = by->up[2] < none ? by->up[2] : 0;
    if (!one)
        *by = (scaling){{0, 0, 0}, 0};
    return one;
}

/* What is divided by an end is multiplied by its highest bit. */
static void find_doubles(fmb_exact_box_program *s, scaling *by)
{
    double rest;
    for (int k = 0; k < 3; k++) {
        int bits = fmb_wide_length(&s->end[k]) - 1;
        s->near_end[k] = fmb_wide_to_doubles(&s->end[k], bits + by->up[k] - by->of_h, &rest);
        by->up[k] += bits;
    }
    round_vector(s, &s->h, by->of_h);
    for (int j = 0; j < s->columns; j++)
        round_vector(s, &s->m[j], by->up[fmb_exact_box_end_of(s, j)]);
    for (int k = 0; k < 2; k++) {
        round_vector(s, &s->origin[k], by->of_h);
        if (s->time >= 0)
            round_vector(s, &s->speed[k], by->up[2]);
    }
}

/* ---- ends of places -------------------------------------------------------------------------- */

static void read_wide(const fmb_wide *a, mpz_t out)
{
    mpz_import(out, (size_t)a->n, -1, sizeof *a->word, 0, 0, a->word);
}

/* The common divisor of the columns of frame k, if it is longer than a word; else 1. */
static void find_end_of_frame(fmb_exact_box_program *s, int k, int first, int last)
{
    mpz_t common, x;
    mpz_inits(common, x, NULL);
    for (int j = first; j < last; j++)
        for (int row = 0; row < s->dim && mpz_cmp_ui(common, 1) != 0; row++) {
            read_wide(&s->m[j].whole[row], x);
            mpz_gcd(common, common, x);
        }
    if (!is_word(common))
        write_wide(common, &s->end[k]);
    mpz_clears(common, x, NULL);
}

static void divide_frame(fmb_exact_box_program *s, int k, int first, int last)
{
    for (int j = first; j < last; j++)
        for (int row = 0; row < s->dim; row++)
            fmb_wide_divide_exactly(&s->m[j].whole[row], &s->end[k]);
}

static void find_ends_of_places(fmb_exact_box_program *s)
{
    int last = s->time < 0 ? s->columns : s->time;
    for (int k = 0; s->has_ends && k < 2; k++) {
        int first = k == 0 ? 0 : s->first_of_b, end = k == 0 ? s->first_of_b : last;
        find_end_of_frame(s, k, first, end);
        divide_frame(s, k, first, end);
    }
}

static void load_both(fmb_exact_box_program *s, const body *p, const body *q,
                      fmb_exact_box_reader *read, const void *self)
{
    scaling by;
    s->dim = p->dim;
    s->columns = 0;
    s->first_of_b = p->naxes;
    s->time = p->moves || q->moves ? p->naxes + q->naxes : -1;
    s->slack = p->naxes + q->naxes + (s->time >= 0);
    s->artificial = s->slack + 2;
    s->unknowns = s->artificial + s->dim;
    for (int j = s->slack; j < s->unknowns; j++)
        s->group[j] = j < s->artificial ? FMB_EXACT_BOX_NONE : FMB_EXACT_BOX_ZERO;
    load_axes_of_frame(s, 0, p, read, self);
    load_axes_of_frame(s, 1, q, read, self);
    load_places(s, read, self);
    if (s->time >= 0)
        load_speeds(s, read, self);
    load_unit_vectors(s);
    s->has_ends = find_scaling(s, &by);
    for (int k = 0; k < 3; k++)
        fmb_wide_set_word(&s->end[k], 1);
    find_ends_of_places(s);
    find_doubles(s, &by);
}

bool fmb_exact_box_load(fmb_exact_box_program *s, const fmb_frame *p, const fmb_frame *q)
{
    double_pair d;
    d.frame[0] = p;
    d.frame[1] = q;
    bool good = fmb_exact_box_is_for(p->dim, p->naxes, q->naxes);
    for (int row = 0; good && row < p->dim; row++)
        good = split_row(&d, row);
    if (!good)
        return false;
    for (int row = 0; row < p->dim; row++)
        s->exponent[row] = d.exponent[row];
    load_both(s, &(body){p->shape, p->dim, p->naxes, p->speed != NULL},
              &(body){q->shape, q->dim, q->naxes, q->speed != NULL}, read_double, &d);
    return true;
}

bool fmb_exact_box_load_q(fmb_exact_box_program *s, const fmb_frame_q *p, const fmb_frame_q *q,
                          mpq_t *unit)
{
    mpz_t whole;
    rational_pair d = {.frame = {p, q}, .unit = unit, .whole = &whole};
    bool good = fmb_exact_box_is_for(p->dim, p->naxes, q->naxes);
    for (int row = 0; good && row < p->dim; row++)
        good = find_rational_unit(&d, row);
    if (!good)
        return false;
    mpz_init(whole);
    load_both(s, &(body){p->shape, p->dim, p->naxes, p->speed != NULL},
              &(body){q->shape, q->dim, q->naxes, q->speed != NULL}, read_rational, &d);
    mpz_clear(whole);
    return true;
}
