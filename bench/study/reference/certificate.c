/* certificate.c: see certificate.h. Whatever is handed in, what is accepted is true: the proofs
 * stand above the functions. */
#include "study/reference/certificate.h"

#include <float.h>
#include <math.h>

enum { MOST = STUDY_PAIR_MOST_DIM, COLUMNS = STUDY_MEETING_MOST_COLUMNS };

/* ---- life ------------------------------------------------------------------------------------ */

void study_meeting_init(study_meeting *s)
{
    for (int i = 0; i < MOST; i++) {
        for (int j = 0; j < COLUMNS; j++)
            mpz_init(s->m[i][j]);
        mpz_inits(s->h[i], s->origin[i], s->speed[i], NULL);
    }
    for (int j = 0; j < COLUMNS; j++)
        mpz_init(s->price[j]);
    mpz_inits(s->sum, s->most, s->part, NULL);
}

void study_meeting_clear(study_meeting *s)
{
    for (int i = 0; i < MOST; i++) {
        for (int j = 0; j < COLUMNS; j++)
            mpz_clear(s->m[i][j]);
        mpz_clears(s->h[i], s->origin[i], s->speed[i], NULL);
    }
    for (int j = 0; j < COLUMNS; j++)
        mpz_clear(s->price[j]);
    mpz_clears(s->sum, s->most, s->part, NULL);
}

void study_form_init(study_form *f)
{
    mpz_init(f->w0);
    for (int j = 0; j < COLUMNS; j++)
        mpz_init(f->w[j]);
}

void study_form_clear(study_form *f)
{
    mpz_clear(f->w0);
    for (int j = 0; j < COLUMNS; j++)
        mpz_clear(f->w[j]);
}

/* ---- numbers --------------------------------------------------------------------------------- */

void study_split(double x, double *whole, int *exponent)
{
    int64_t all = (int64_t)ldexp(frexp(x, exponent), DBL_MANT_DIG);
    int zeros = all == 0 ? 0 : __builtin_ctzll((unsigned long long)all);
    *exponent += zeros - DBL_MANT_DIG;
    *whole = ldexp((double)all, -zeros);
}

static void lower_unit(double x, int *unit)
{
    double whole;
    int exponent;
    study_split(x, &whole, &exponent);
    if (whole != 0 && exponent < *unit)
        *unit = exponent;
}

/* x / 2^unit, which is whole. */
static void set_whole(mpz_t out, double x, int unit)
{
    double whole;
    int exponent;
    study_split(x, &whole, &exponent);
    mpz_set_d(out, whole);
    if (whole != 0)
        mpz_mul_2exp(out, out, (mp_bitcnt_t)(exponent - unit));
}

/* The largest power of 2 of which all numbers of coordinate i are multiples. */
static int find_unit(const fmb_frame *const *f, int i)
{
    int unit = DBL_MAX_EXP;
    for (int k = 0; k < 2; k++) {
        lower_unit(f[k]->origin[i], &unit);
        for (int j = 0; j < f[k]->naxes; j++)
            lower_unit(f[k]->axes[j * f[k]->dim + i], &unit);
        if (f[k]->speed)
            lower_unit(f[k]->speed[i], &unit);
    }
    return unit;
}

/* Row i. */
static void load_coordinate(study_meeting *s, const fmb_frame *const *f, int i)
{
    int unit = s->unit[i] = find_unit(f, i);
    set_whole(s->origin[i], f[0]->origin[i], unit);
    set_whole(s->h[i], f[1]->origin[i], unit);
    mpz_sub(s->h[i], s->h[i], s->origin[i]);
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < f[k]->naxes; j++) {
            mpz_t *to = &s->m[i][s->from[k] + j];
            set_whole(*to, f[k]->axes[j * s->dim + i], unit);
            if (k == 1)
                mpz_neg(*to, *to);
        }
    mpz_set_ui(s->speed[i], 0);
    if (f[0]->speed)
        set_whole(s->speed[i], f[0]->speed[i], unit);
    if (s->columns == s->from[2])
        return;
    mpz_set_ui(s->part, 0);
    if (f[1]->speed)
        set_whole(s->part, f[1]->speed[i], unit);
    mpz_sub(s->m[i][s->from[2]], s->speed[i], s->part);
}

bool study_meeting_load(study_meeting *s, const fmb_frame *p, const fmb_frame *q)
{
    const fmb_frame *const f[2] = {p, q};
    if (p->dim != q->dim || p->dim > MOST || p->shape > FMB_SIMPLEX || q->shape > FMB_SIMPLEX)
        return false;
    s->dim = p->dim;
    s->from[0] = 0;
    for (int k = 0; k < 2; k++) {
        s->shape[k] = f[k]->shape;
        s->from[k + 1] = s->from[k] + f[k]->naxes;
    }
    s->columns = s->from[2] + (p->speed || q->speed);
    for (int i = 0; i < s->dim; i++)
        load_coordinate(s, f, i);
    return true;
}

/* ---- points ---------------------------------------------------------------------------------- */

/* x > 0, or x >= 0 if the contact is closed. */
static bool is_within(const mpz_t x, fmb_contact contact)
{
    return contact == FMB_CONTACT_OPEN ? mpz_sgn(x) > 0 : mpz_sgn(x) >= 0;
}

/* Is c of frame f, in parts of N, within it? */
static bool is_in_frame(study_meeting *s, int f, fmb_contact contact, mpz_t *z, const mpz_t n)
{
    bool good = true, is_simplex = s->shape[f] == FMB_SIMPLEX;
    mpz_set(s->part, n);
    for (int j = s->from[f]; good && j < s->from[f + 1]; j++) {
        if (!is_simplex)
            mpz_set(s->part, n);
        mpz_sub(s->part, s->part, z[j]);
        good = is_within(z[j], contact) && (is_simplex || is_within(s->part, contact));
    }
    return good && (!is_simplex || is_within(s->part, contact));
}

/* M Z = N h says that Z / N is a solution. */
bool study_meeting_has_point(study_meeting *s, fmb_contact contact, mpz_t *z, const mpz_t n)
{
    bool good = mpz_sgn(n) > 0;
    for (int i = 0; good && i < s->dim; i++) {
        mpz_mul(s->sum, s->h[i], n);
        for (int j = 0; j < s->columns; j++)
            mpz_submul(s->sum, s->m[i][j], z[j]);
        good = mpz_sgn(s->sum) == 0;
    }
    for (int f = 0; good && f < 2; f++)
        good = is_in_frame(s, f, contact, z, n);
    for (int j = s->from[2]; good && j < s->columns; j++)
        good = mpz_sgn(z[j]) >= 0 && mpz_cmp(z[j], n) <= 0;
    return good;
}

/* ---- directions ------------------------------------------------------------------------------ */

/* most := the largest value of price z over all z in their places: an unknown of a cuboid, or t,
 * adds what is positive; those of a simplex add the largest of them, or 0. */
static void find_largest_sum(study_meeting *s)
{
    mpz_set_ui(s->most, 0);
    for (int f = 0; f < 2; f++) {
        mpz_set_ui(s->part, 0);
        for (int j = s->from[f]; j < s->from[f + 1]; j++)
            if (mpz_sgn(s->price[j]) > 0 && s->shape[f] == FMB_CUBOID)
                mpz_add(s->part, s->part, s->price[j]);
            else if (mpz_cmp(s->price[j], s->part) > 0)
                mpz_set(s->part, s->price[j]);
        mpz_add(s->most, s->most, s->part);
    }
    for (int j = s->from[2]; j < s->columns; j++)
        if (mpz_sgn(s->price[j]) > 0)
            mpz_add(s->most, s->most, s->price[j]);
}

/* price := y M, sum := y h. */
static void multiply_by_rows(study_meeting *s, mpz_t *y)
{
    mpz_set_ui(s->sum, 0);
    for (int j = 0; j < s->columns; j++)
        mpz_set_ui(s->price[j], 0);
    for (int i = 0; i < s->dim; i++) {
        mpz_addmul(s->sum, y[i], s->h[i]);
        for (int j = 0; mpz_sgn(y[i]) != 0 && j < s->columns; j++)
            mpz_addmul(s->price[j], y[i], s->m[i][j]);
    }
}

/* M z = h makes y M z = y h; where the largest y M z is less there is no solution. Where it is
 * equal and y M is not 0 on some frame, y M z is less for all z inside the frames: a cuboid's are
 * not at the end where the largest is, and a simplex's are means, with no weight 0, of its corners,
 * of which not all have the largest value. */
bool study_meeting_has_none(study_meeting *s, fmb_contact contact, mpz_t *y)
{
    bool leans = false;
    multiply_by_rows(s, y);
    find_largest_sum(s);
    for (int j = 0; j < s->from[2]; j++)
        leans |= mpz_sgn(s->price[j]) != 0;
    int order = mpz_cmp(s->most, s->sum);
    return order < 0 || (order == 0 && leans && contact == FMB_CONTACT_OPEN);
}

/* ---- ends ------------------------------------------------------------------------------------ */

static void clear_form(study_form *f, const study_meeting *s)
{
    mpz_set_ui(f->w0, 0);
    for (int j = 0; j < s->columns; j++)
        mpz_set_ui(f->w[j], 0);
}

void study_form_of_coordinate(study_form *f, const study_meeting *s, int i, int sign)
{
    clear_form(f, s);
    f->unit = s->unit[i];
    mpz_mul_si(f->w0, s->origin[i], sign);
    for (int j = 0; j < s->from[1]; j++)
        mpz_mul_si(f->w[j], s->m[i][j], sign);
    for (int j = s->from[2]; j < s->columns; j++)
        mpz_mul_si(f->w[j], s->speed[i], sign);
}

void study_form_of_unknown(study_form *f, const study_meeting *s, int j, int sign)
{
    clear_form(f, s);
    f->unit = 0;
    mpz_set_si(f->w[j], sign);
}

/* The sign of (value / n) 2^unit - x, n > 0. */
static int compare_to_double(study_meeting *s, const mpz_t value, const mpz_t n, int unit, double x)
{
    double whole;
    int exponent;
    if (isinf(x))
        return x > 0 ? -1 : 1;
    study_split(x, &whole, &exponent);
    mpz_set_d(s->part, whole);
    mpz_mul(s->part, s->part, n);
    mpz_set(s->most, value);
    if (whole != 0 && exponent > unit)
        mpz_mul_2exp(s->part, s->part, (mp_bitcnt_t)(exponent - unit));
    else if (whole != 0)
        mpz_mul_2exp(s->most, s->most, (mp_bitcnt_t)(unit - exponent));
    return mpz_cmp(s->most, s->part);
}

/* Coordinate i is (origin + axes of A c + speed of A t) 2^unit. */
bool study_meeting_is_near(study_meeting *s, mpz_t *z, const mpz_t n, const double *x, double near)
{
    bool good = study_meeting_has_point(s, FMB_CONTACT_CLOSED, z, n);
    for (int i = 0; good && i < s->dim; i++) {
        mpz_mul(s->sum, s->origin[i], n);
        for (int j = 0; j < s->from[1]; j++)
            mpz_addmul(s->sum, s->m[i][j], z[j]);
        for (int j = s->from[2]; j < s->columns; j++)
            mpz_addmul(s->sum, s->speed[i], z[j]);
        good = isfinite(x[i]) && compare_to_double(s, s->sum, n, s->unit[i], x[i] - near) >= 0 &&
               compare_to_double(s, s->sum, n, s->unit[i], x[i] + near) <= 0;
    }
    return good;
}

/* w0 + w z at the point exceeds the next lower double, so the end is no lower; and for all z with
 * M z = h, K (w0 + w z) = K w0 + y h + (K w - y M) z, of which the last is at most its largest sum:
 * so nothing exceeds the end. */
bool study_meeting_has_end(study_meeting *s, const study_form *f, mpz_t *z, const mpz_t n, mpz_t *y,
                           const mpz_t k, double end)
{
    if (isnan(end) || mpz_sgn(k) <= 0 || !study_meeting_has_point(s, FMB_CONTACT_CLOSED, z, n))
        return false;
    mpz_mul(s->sum, f->w0, n);
    for (int j = 0; j < s->columns; j++)
        mpz_addmul(s->sum, f->w[j], z[j]);
    if (compare_to_double(s, s->sum, n, f->unit, nextafter(end, -INFINITY)) <= 0)
        return false;
    multiply_by_rows(s, y);
    mpz_addmul(s->sum, k, f->w0);
    for (int j = 0; j < s->columns; j++) {
        mpz_neg(s->price[j], s->price[j]);
        mpz_addmul(s->price[j], k, f->w[j]);
    }
    find_largest_sum(s);
    mpz_add(s->sum, s->sum, s->most);
    return compare_to_double(s, s->sum, k, f->unit, end) <= 0;
}
