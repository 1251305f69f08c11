/* refinement.c: see refinement.h.
 *
 * Theorem. Let B be square, R any matrix and H = I - B R with |H| <= 1/2, |H| being the largest sum
 * of a row's absolute values. Then B is regular; and if y' B = c - rest, the y with y B = c differs
 * from y' in no entry by more than 2 |rest R|_1.
 *
 * Proof. |z H|_1 <= |z|_1 |H|, so I - H = B R has the inverse I + H + H^2 + ..., and y - y' = rest
 * B^-1 = rest R (I - H)^-1 has a norm of at most |rest R|_1 / (1 - |H|).
 *
 * R is an inverse in doubles, and |H| is bounded with their rounding errors. y' are integers over
 * 2^places, so `rest` is known exactly; and rest R, in doubles, gives a correction of y', some more
 * places at a time (iterative refinement: Wan 2006, see factor.h). Once the bound is less than each
 * |y'_r|, the signs are known, and so is that of the combined right side. Rows are divided by
 * powers of two, so that they fit into doubles.
 *
 * Zero multipliers cannot be recognized in this way. Their rows are left out, and the columns
 * without entries in the others: if equally many rows and columns remain, they form B.
 */
#include "lp/oracle/refinement.h"

#include <math.h>
#include <string.h>

#include "base/arrays.h"

/* Places of y' that each correction gains. */
#define PLACES 32
/* Multipliers below this, relative to the largest, count as 0. */
#define NO_MULTIPLIER 1e-11
/* Factor that makes a bound, a sum of doubles of one sign, safe. */
#define SAFE 1.01
/* Smaller numbers cannot be distinguished from underflow. */
#define LEAST 0x1p-1000

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays_of_refinement(fmb_refinement *t, bool get)
{
    const size_t n = t->n;
    return FMB_ARRAYS(t->run->mem, get, FMB_ARRAY(t->member, n), FMB_ARRAY(t->column, n),
                      FMB_ARRAY(t->at, n), FMB_ARRAY(t->exponent, n), FMB_ARRAY(t->matrix, n * n),
                      FMB_ARRAY(t->inverse, n * n), FMB_ARRAY(t->c, n), FMB_ARRAY(t->y, n),
                      FMB_ARRAY(t->rest, n), FMB_ARRAY(t->reach, n), FMB_ARRAY(t->is_nonzero, n));
}

fmb_status fmb_refinement_open(fmb_refinement *t, fmb_run *run, const fmb_program *p, size_t m,
                               size_t odd)
{
    *t = (fmb_refinement){.run = run, .p = p, .odd = odd, .m = m, .n = (size_t)p->n};
    mpz_inits(t->term, t->entry, NULL);
    FMB_TRY(hold_arrays_of_refinement(t, true));
    FMB_TRY(fmb_integers_init(&t->multiplier, t->n, run->mem));
    return fmb_integers_init(&t->left, t->n, run->mem);
}

void fmb_refinement_close(fmb_refinement *t)
{
    fmb_integers_clear(&t->multiplier, t->run->mem);
    fmb_integers_clear(&t->left, t->run->mem);
    (void)hold_arrays_of_refinement(t, false);
    mpz_clears(t->term, t->entry, NULL);
}

/* ---- B and its inverse ----------------------------------------------------------------------- */

/* Coefficient k of a row, k == size: its right side, as a number from 1/2 to 1 times a power of
 * two, up to a factor of 1 +- 2^-52. */
static double split_coefficient(const fmb_refinement *t, size_t row, size_t k, int *exponent)
{
    const fmb_vec *v = t->p->row[row].value;
    long e = 0;
    if (!v->z)
        return frexp((double)v->s[k], exponent);
    double x = mpz_get_d_2exp(&e, v->z[k]);
    *exponent = (int)e;
    return x;
}

/* to[size] = a row divided by 2^exponent. */
static void write_row(const fmb_refinement *t, size_t row, int *exponent, double *to)
{
    const fmb_program_row *r = &t->p->row[row];
    int e;
    *exponent = (int)fmb_vec_most_bits(r->value, r->size);
    memset(to, 0, t->size * sizeof *to);
    for (size_t k = 0; k < r->size; k++) {
        double x = split_coefficient(t, row, k, &e);
        to[t->at[r->column[k]]] = ldexp(x, e - *exponent);
    }
}

static void write_matrix(fmb_refinement *t)
{
    for (size_t k = 0; k < t->size; k++)
        t->at[t->column[k]] = k;
    write_row(t, t->odd, &t->odd_exponent, t->c);
    t->unit = t->odd_exponent;
    for (size_t s = 0; s < t->size; s++) {
        double *to = &t->matrix[s * t->size];
        size_t row = t->member[s];
        if (row < t->m) {
            write_row(t, row, &t->exponent[s], to);
        } else {
            memset(to, 0, t->size * sizeof *to);
            to[t->at[row - t->m]] = 1;
            t->exponent[s] = 0;
        }
        t->unit = t->exponent[s] > t->unit ? t->exponent[s] : t->unit;
    }
}

static void swap_matrix_rows(double *a, double *b, size_t size)
{
    for (size_t j = 0; a != b && j < size; j++) {
        double x = a[j];
        a[j] = b[j];
        b[j] = x;
    }
}

static size_t find_largest_in_column(const fmb_refinement *t, size_t k)
{
    size_t best = k;
    for (size_t i = k + 1; i < t->size; i++)
        if (fabs(t->matrix[i * t->size + k]) > fabs(t->matrix[best * t->size + k]))
            best = i;
    return best;
}

/* Gauss-Jordan elimination; the matrix is overwritten. False: it seems to be singular. */
static bool invert_matrix(fmb_refinement *t)
{
    size_t n = t->size;
    memset(t->inverse, 0, n * n * sizeof *t->inverse);
    for (size_t k = 0; k < n; k++)
        t->inverse[k * n + k] = 1;
    for (size_t k = 0; k < n; k++) {
        double *a = &t->matrix[k * n], *b = &t->inverse[k * n];
        size_t best = find_largest_in_column(t, k);
        swap_matrix_rows(a, &t->matrix[best * n], n);
        swap_matrix_rows(b, &t->inverse[best * n], n);
        if (fabs(a[k]) < 1e-200)
            return false;
        double factor = 1 / a[k];
        for (size_t j = 0; j < n; j++) {
            a[j] *= factor;
            b[j] *= factor;
        }
        for (size_t i = 0; i < n; i++) {
            double x = t->matrix[i * n + k];
            if (i == k || x == 0)
                continue;
            for (size_t j = k; j < n; j++)
                t->matrix[i * n + j] -= x * a[j];
            for (size_t j = 0; j < n; j++)
                t->inverse[i * n + j] -= x * b[j];
        }
    }
    return true;
}

/* Is |I - B R| <= 1/2? The error of a row of it, in doubles, is less than (size + 8) 2^-52 times 1
 * + the absolute values of the row of B times those of R: size + 1 roundings by 2^-53 and one of
 * each entry of B. y is scratch. */
static bool is_inverse_good(fmb_refinement *t)
{
    size_t n = t->size;
    for (size_t k = 0; k < n; k++) {
        t->reach[k] = 0;
        for (size_t j = 0; j < n; j++)
            t->reach[k] += fabs(t->inverse[k * n + j]);
        if (!(t->reach[k] < 1e50))
            return false;
    }
    write_matrix(t);
    for (size_t r = 0; r < n; r++) {
        double sizes = 1, sum = 1e-60; /* more than any underflow */
        memset(t->y, 0, n * sizeof *t->y);
        t->y[r] = 1;
        for (size_t k = 0; k < n; k++) {
            double x = t->matrix[r * n + k];
            sizes += fabs(x) * t->reach[k];
            for (size_t j = 0; x != 0 && j < n; j++)
                t->y[j] -= x * t->inverse[k * n + j];
        }
        for (size_t j = 0; j < n; j++)
            sum += fabs(t->y[j]);
        if (!(SAFE * (sum + (double)(n + 8) * 0x1p-52 * sizes) <= 0.5))
            return false;
    }
    return true;
}

/* y = z R */
static void multiply_by_inverse(fmb_refinement *t, const double *z)
{
    memset(t->y, 0, t->size * sizeof *t->y);
    for (size_t k = 0; k < t->size; k++)
        for (size_t j = 0; z[k] != 0 && j < t->size; j++)
            t->y[j] += z[k] * t->inverse[k * t->size + j];
}

/* ---- which rows ------------------------------------------------------------------------------ */

static void take_all_rows(fmb_refinement *t, const size_t *basis)
{
    t->size = t->n;
    for (size_t k = 0; k < t->n; k++) {
        t->member[k] = basis[k];
        t->column[k] = k;
    }
}

static void note_columns(fmb_refinement *t, size_t row)
{
    const fmb_program_row *r = &t->p->row[row];
    for (size_t k = 0; k < r->size; k++)
        t->is_nonzero[r->column[k]] = true;
}

/* Lists the columns of the rows and of the odd row. Are there as many rows as columns? */
static bool list_columns(fmb_refinement *t)
{
    size_t columns = 0;
    memset(t->is_nonzero, 0, t->n * sizeof *t->is_nonzero);
    note_columns(t, t->odd);
    for (size_t s = 0; s < t->size; s++)
        note_columns(t, t->member[s]);
    for (size_t j = 0; j < t->n; j++)
        if (t->is_nonzero[j])
            t->column[columns++] = j;
    return t->size == columns && columns > 0;
}

/* Leave out rows whose multiplier, in y, seems to be 0. False: the other rows and their columns
 * differ in number, or one of these rows is a unit or off. */
static bool keep_rows_with_multipliers(fmb_refinement *t)
{
    size_t kept = 0;
    double most = 0;
    for (size_t s = 0; s < t->size; s++)
        most = fmax(most, fabs(t->y[s]));
    for (size_t s = 0; s < t->size; s++) {
        size_t row = t->member[s];
        if (!(fabs(t->y[s]) > NO_MULTIPLIER * most))
            continue;
        if (row >= t->m || t->p->row[row].off)
            return false;
        t->member[kept++] = row;
    }
    t->size = kept;
    return list_columns(t);
}

static bool find_inverse(fmb_refinement *t)
{
    write_matrix(t);
    return invert_matrix(t);
}

fmb_status fmb_refinement_of_basis(fmb_refinement *t, const size_t *basis, bool *good)
{
    take_all_rows(t, basis);
    *good = find_inverse(t);
    if (*good) {
        multiply_by_inverse(t, t->c);
        *good = keep_rows_with_multipliers(t);
    }
    fmb_status st = fmb_run_poll_now(t->run);
    if (st == FMB_OK && *good && t->size < t->n)
        *good = find_inverse(t);
    *good = *good && is_inverse_good(t);
    return st;
}

bool fmb_refinement_of_rows(fmb_refinement *t, size_t size, const size_t *row)
{
    t->size = size;
    for (size_t k = 0; k < size; k++)
        t->member[k] = row[k];
    return list_columns(t) && find_inverse(t) && is_inverse_good(t);
}

/* ---- corrections ----------------------------------------------------------------------------- */

/* number -= part times coefficient k of a row. */
static void subtract_coefficient(fmb_refinement *t, size_t row, size_t k, mpz_t number)
{
    fmb_program_get(t->p, row, k, t->entry);
    mpz_submul(number, t->term, t->entry);
}

/* term = the multiplier of row s of B, as an integer row of the program. */
static void take_multiplier(fmb_refinement *t, size_t s)
{
    mpz_mul_2exp(t->term, t->multiplier.z[s], (mp_bitcnt_t)(t->unit - t->exponent[s]));
}

/* The multiplier of the odd row is -1 times a power of two. */
static void take_odd_multiplier(fmb_refinement *t)
{
    mpz_set_si(t->term, -1);
    mpz_mul_2exp(t->term, t->term, (mp_bitcnt_t)(t->places + t->unit - t->odd_exponent));
}

static double in_units(const mpz_t number, int unit)
{
    long e = 0;
    double x = mpz_get_d_2exp(&e, number);
    e -= unit;
    return e > 2000 ? x * HUGE_VAL : e < -2000 ? 0 : ldexp(x, (int)e);
}

void fmb_refinement_find_rest(fmb_refinement *t)
{
    for (size_t k = 0; k < t->size; k++)
        mpz_set_ui(t->left.z[k], 0);
    for (size_t s = 0; s <= t->size; s++) {
        size_t row = s < t->size ? t->member[s] : t->odd;
        const fmb_program_row *r = &t->p->row[row];
        if (s < t->size)
            take_multiplier(t, s);
        else
            take_odd_multiplier(t);
        for (size_t k = 0; k < r->size; k++)
            subtract_coefficient(t, row, k, t->left.z[t->at[r->column[k]]]);
    }
    for (size_t k = 0; k < t->size; k++)
        t->rest[k] = in_units(t->left.z[k], t->places + t->unit);
}

void fmb_refinement_correct(fmb_refinement *t)
{
    multiply_by_inverse(t, t->rest);
    t->places += PLACES;
    for (size_t s = 0; s < t->size; s++) {
        mpz_mul_2exp(t->multiplier.z[s], t->multiplier.z[s], PLACES);
        mpz_set_d(t->term, nearbyint(ldexp(t->y[s], t->places)));
        mpz_add(t->multiplier.z[s], t->multiplier.z[s], t->term);
    }
}

/* ---- signs ----------------------------------------------------------------------------------- */

double fmb_refinement_bound_error(const fmb_refinement *t)
{
    double sum = 0;
    for (size_t k = 0; k < t->size; k++)
        sum += fabs(t->rest[k]) * t->reach[k];
    return 2 * SAFE * sum + 1e-250;
}

bool fmb_refinement_common_sign(const fmb_refinement *t, double error, int *sign, bool *differ)
{
    bool known = true;
    *sign = 0;
    *differ = false;
    for (size_t s = 0; s < t->size && !*differ; s++) {
        double y = in_units(t->multiplier.z[s], t->places);
        if (t->p->row[t->member[s]].rel == FMB_EQ)
            continue;
        if (!(fabs(y) > SAFE * error)) {
            known = false;
            continue;
        }
        *differ = *sign * y < 0;
        *sign = y > 0 ? 1 : -1;
    }
    return known && !*differ;
}

/* The sign of b_odd - sum_r y_r b_r, 0 if it is not known. Right sides that underflow are less than
 * the initial `size`; that error, and the rest, are less than the least number accepted. */
int fmb_refinement_sign_of_remainder(fmb_refinement *t, double error)
{
    mpz_ptr sum = t->left.z[0];
    double size = (double)t->size * 0x1p-1074;
    int e;
    mpz_set_ui(sum, 0);
    for (size_t s = 0; s < t->size; s++) {
        size_t row = t->member[s], k = t->p->row[row].size;
        take_multiplier(t, s);
        subtract_coefficient(t, row, k, sum);
        double b = split_coefficient(t, row, k, &e);
        size += b == 0 ? 0 : ldexp(fabs(b), e - t->exponent[s]);
    }
    take_odd_multiplier(t);
    subtract_coefficient(t, t->odd, t->p->row[t->odd].size, sum);
    double rest = in_units(sum, t->places + t->unit);
    return fabs(rest) > SAFE * SAFE * error * size + LEAST ? mpz_sgn(sum) : 0;
}
