/* combination.c: see combination.h. */
#include "lp/linalg/exact/combination.h"

#include "base/arrays.h"
#include "lp/linalg/exact/hadamard.h"
#include "num/gcd.h"

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays_of_combination(fmb_combination *c, bool get)
{
    const size_t n = c->n;
    return FMB_ARRAYS(c->mem, get, FMB_ARRAY(c->index, n), FMB_ARRAY(c->column, n),
                      FMB_ARRAY(c->matrix, n * (n + 1)), FMB_ARRAY(c->inverse, n),
                      FMB_ARRAY(c->digit, n), FMB_ARRAY(c->sum, n));
}

fmb_status fmb_combination_init(fmb_combination *c, fmb_mem *mem, size_t n, const fmb_lp_row *row)
{
    *c = (fmb_combination){.mem = mem, .n = n, .row = row, .q = fmb_prime_number(0)};
    mpz_inits(c->all, c->left, c->power, c->s, c->t, c->u, c->v, NULL);
    fmb_rational_init(&c->rational);
    FMB_TRY(hold_arrays_of_combination(c, true));
    c->part = fmb_vec_block(n, mem);
    c->rest = fmb_vec_block(n, mem);
    return c->part && c->rest ? FMB_OK : fmb_mem_status(mem);
}

void fmb_combination_clear(fmb_combination *c)
{
    size_t n = c->n;
    if (!c->mem)
        return;
    mpz_clears(c->all, c->left, c->power, c->s, c->t, c->u, c->v, NULL);
    fmb_rational_clear(&c->rational);
    (void)hold_arrays_of_combination(c, false);
    fmb_vec_block_free(c->part, n, c->mem);
    fmb_vec_block_free(c->rest, n, c->mem);
    c->mem = NULL;
}

/* ---- the equations --------------------------------------------------------------------------- */

static const fmb_vec *unknown_row(const fmb_combination *c, size_t k)
{
    return c->row[c->index[k]].v;
}

/* List the columns with entries of the rows: one equation each. */
static void list_equations(fmb_combination *c)
{
    c->equations = 0;
    for (size_t j = 0; j < c->n; j++) {
        bool named = fmb_vec_sgn(c->row[c->i].v, j) != 0;
        for (size_t k = 0; !named && k < c->unknowns; k++)
            named = fmb_vec_sgn(unknown_row(c, k), j) != 0;
        if (named)
            c->column[c->equations++] = j;
    }
}

static void load_equations(fmb_combination *c)
{
    size_t wide = c->unknowns + 1;
    for (size_t e = 0; e < c->equations; e++) {
        for (size_t k = 0; k < c->unknowns; k++)
            c->matrix[e * wide + k] = fmb_prime_of_entry(&c->q, unknown_row(c, k), c->column[e]);
        c->matrix[e * wide + c->unknowns] = fmb_prime_of_entry(&c->q, c->row[c->i].v, c->column[e]);
    }
}

static void swap_equations(fmb_combination *c, size_t a, size_t b)
{
    size_t wide = c->unknowns + 1, column = c->column[a];
    for (size_t k = 0; a != b && k < wide; k++) {
        uint64_t t = c->matrix[a * wide + k];
        c->matrix[a * wide + k] = c->matrix[b * wide + k];
        c->matrix[b * wide + k] = t;
    }
    c->column[a] = c->column[b];
    c->column[b] = column;
}

/* Compute column k of L U: subtract the products of earlier columns (Crout). */
static void reduce_matrix_column(fmb_combination *c, size_t k)
{
    size_t wide = c->unknowns + 1;
    for (size_t e = 0; e < c->equations; e++) {
        uint64_t *row = &c->matrix[e * wide];
        size_t before = e < k ? e : k;
        row[k] = fmb_prime_minus_dot(&c->q, row[k], row, c->sum, NULL, before);
        if (e < k)
            c->sum[e] = row[k];
    }
}

/* L U = the equations, with rows reordered; false if the unknowns are dependent, or the equations
 * contradict each other. */
static bool factor_equations(fmb_combination *c)
{
    size_t wide = c->unknowns + 1, m = c->unknowns;
    if (c->equations < m)
        return false;
    for (size_t k = 0; k < m; k++) {
        size_t e = k;
        reduce_matrix_column(c, k);
        while (e < c->equations && c->matrix[e * wide + k] == 0)
            e++;
        if (e == c->equations)
            return false;
        swap_equations(c, k, e);
        c->inverse[k] = fmb_prime_inverse(&c->q, c->matrix[k * wide + k]);
        for (e = k + 1; e < c->equations; e++)
            c->matrix[e * wide + k] =
                fmb_prime_times(&c->q, c->matrix[e * wide + k], c->inverse[k]);
    }
    reduce_matrix_column(c, m);
    for (size_t e = m; e < c->equations; e++)
        if (c->matrix[e * wide + m] != 0)
            return false;
    return true;
}

/* digit = U^-1 sum. */
static void substitute_back(fmb_combination *c)
{
    size_t wide = c->unknowns + 1;
    for (size_t k = c->unknowns; k-- > 0;) {
        uint64_t left = fmb_prime_minus_dot(&c->q, c->sum[k], &c->matrix[k * wide + k + 1],
                                            &c->digit[k + 1], NULL, c->unknowns - k - 1);
        c->digit[k] = fmb_prime_times(&c->q, left, c->inverse[k]);
    }
}

static void solve_modulo_prime(fmb_combination *c)
{
    for (size_t k = 0; k < c->unknowns; k++)
        c->sum[k] = c->matrix[k * (c->unknowns + 1) + c->unknowns];
    substitute_back(c);
}

/* ---- lifting --------------------------------------------------------------------------------- */

/* The number of least absolute value with that remainder. */
static void set_symmetric(mpz_t z, const fmb_prime *q, uint64_t remainder)
{
    if (remainder > q->p / 2)
        fmb_integer_set_i64(z, -(int64_t)(q->p - remainder));
    else
        fmb_integer_set_u64(z, remainder);
}

/* Cramer's rule: the determinant and its products with the unknowns are minors, thus known. */
static void lift_minors(fmb_combination *c)
{
    uint64_t determinant = 1;
    for (size_t k = 0; k < c->unknowns; k++)
        determinant = fmb_prime_times(&c->q, determinant, c->matrix[k * (c->unknowns + 1) + k]);
    set_symmetric(c->all, &c->q, determinant);
    for (size_t k = 0; k < c->unknowns; k++)
        set_symmetric(c->part[k], &c->q, fmb_prime_times(&c->q, determinant, c->digit[k]));
}

/* ---- digit by digit -------------------------------------------------------------------------- */

/* s = equation e times the digits; small: all sums fit in 127 bits. */
static void multiply_by_digits(fmb_combination *c, size_t e, bool small)
{
    fmb_i128 sum = fmb_i128_of(0);
    size_t j = c->column[e];
    mpz_set_ui(c->s, 0);
    for (size_t k = 0; k < c->unknowns; k++) {
        const fmb_vec *v = unknown_row(c, k);
        if (small) {
            sum = fmb_i128_plus_product(sum, v->s[j], (int64_t)c->digit[k]);
            continue;
        }
        fmb_vec_get(v, j, c->t);
        fmb_integer_add_product_u64(c->s, c->t, c->digit[k]);
    }
    if (small)
        fmb_integer_set_128(c->s, sum);
}

static bool do_digit_sums_fit(const fmb_combination *c)
{
    int bits = FMB_PRIME_BITS + fmb_bits64(c->unknowns) + 1;
    for (size_t k = 0; k < c->unknowns; k++)
        if (unknown_row(c, k)->z || unknown_row(c, k)->bits + bits > 127)
            return false;
    return true;
}

/* No digits yet: the parts are 0, the residuals are the right sides. */
static void begin_digits(fmb_combination *c)
{
    mpz_set_ui(c->power, 1);
    for (size_t k = 0; k < c->unknowns; k++) {
        fmb_vec_get(c->row[c->i].v, c->column[k], c->rest[k]);
        mpz_set_ui(c->part[k], 0);
    }
}

/* Add the current digits to the parts, and compute the next ones. */
static void lift_by_one_digit(fmb_combination *c, bool small)
{
    size_t wide = c->unknowns + 1;
    for (size_t e = 0; e < c->unknowns; e++) {
        fmb_integer_add_product_u64(c->part[e], c->power, c->digit[e]);
        multiply_by_digits(c, e, small);
        mpz_sub(c->rest[e], c->rest[e], c->s);
        fmb_integer_divide_exactly_u64(c->rest[e], c->rest[e], c->q.p);
    }
    fmb_integer_times_u64(c->power, c->power, c->q.p);
    for (size_t e = 0; e < c->unknowns; e++)
        c->sum[e] = fmb_prime_minus_dot(&c->q, fmb_prime_of_integer(&c->q, c->rest[e]),
                                        &c->matrix[e * wide], c->sum, NULL, e);
    substitute_back(c);
}

/* Guess numerators over one denominator `all` from the digits; false if some are too large to be
 * plausible, or the query ends. */
static bool guess_fractions(fmb_combination *c, mpz_t *numerator)
{
    const fmb_poll poll = fmb_run_asked(c->run);
    const size_t most = (mpz_sizeinbase(c->power, 2) - 2) / 2; /* bits */
    mpz_set_ui(c->all, 1);
    for (size_t k = 0; k < c->unknowns; k++) {
        mpz_mul(c->v, c->part[k], c->all);
        mpz_fdiv_r(c->v, c->v, c->power);
        mpz_sub(c->u, c->v, c->power); /* the remainder of least absolute value */
        mpz_set(numerator[k], mpz_cmpabs(c->u, c->v) < 0 ? c->u : c->v);
        if (mpz_sizeinbase(numerator[k], 2) <= most)
            continue;
        if (!fmb_rational_find(&c->rational, c->v, c->power, most, most, numerator[k], c->t, &poll))
            return false;
        mpz_mul(c->all, c->all, c->t);
        for (size_t i = 0; i < k; i++)
            mpz_mul(numerator[i], numerator[i], c->t);
        if (mpz_sizeinbase(c->all, 2) > most)
            return false;
    }
    return true;
}

/* ---- checking -------------------------------------------------------------------------------- */

/* left = all (row i) - sum of part_k (row k), at entry j. */
static fmb_status subtract_parts(fmb_combination *c, mpz_t *part, size_t j, mpz_t left)
{
    fmb_status st = FMB_OK;
    fmb_vec_get(c->row[c->i].v, j, c->t);
    mpz_mul(left, c->all, c->t);
    for (size_t k = 0; st == FMB_OK && k < c->unknowns; k++) {
        const fmb_vec *v = unknown_row(c, k);
        if (fmb_vec_sgn(v, j) == 0)
            continue;
        fmb_vec_get(v, j, c->t);
        mpz_submul(left, part[k], c->t);
        st = fmb_run_poll_long(c->run, left);
    }
    return st;
}

/* Do the parts solve the equations from number `from` on? */
static fmb_status try_equations(fmb_combination *c, mpz_t *part, size_t from, bool *solved)
{
    fmb_status st = FMB_OK;
    *solved = true;
    for (size_t e = from; st == FMB_OK && *solved && e < c->equations; e++) {
        st = subtract_parts(c, part, c->column[e], c->left);
        *solved = st == FMB_OK && mpz_sgn(c->left) == 0;
    }
    return st;
}

/* Add digits until fractions hold: tried as soon as they are plausible, and at the latest when no
 * larger ones are possible. */
static fmb_status lift_digits(fmb_combination *c, double bits, bool *found)
{
    fmb_status st = FMB_OK;
    bool small = do_digit_sums_fit(c);
    double enough = (2 * bits + 3) / FMB_PRIME_BITS + 1;
    mpz_t *numerator = fmb_vec_block(c->n, c->mem);
    if (!numerator)
        return fmb_mem_status(c->mem);
    begin_digits(c);
    for (size_t digits = 1, next = 2; st == FMB_OK && !*found; digits++) {
        lift_by_one_digit(c, small);
        st = fmb_run_poll(c->run);
        if (st != FMB_OK || (digits < next && (double)digits < enough))
            continue;
        if (guess_fractions(c, numerator))
            st = try_equations(c, numerator, 0, found);
        FMB_THEN(st, fmb_run_poll_now(c->run));
        if ((double)digits >= enough)
            break;
        next += next / 2;
    }
    for (size_t k = 0; *found && k < c->unknowns; k++)
        mpz_swap(c->part[k], numerator[k]);
    fmb_vec_block_free(numerator, c->n, c->mem);
    return st;
}

/* ---- the answer ------------------------------------------------------------------------------ */

/* Reduce to lowest terms, all > 0, without zero parts; compute `left` from the right sides. */
static fmb_status tidy_combination(fmb_combination *c)
{
    const fmb_poll poll = fmb_run_asked(c->run);
    fmb_status st = FMB_OK;
    size_t kept = 0;
    mpz_set(c->s, c->all);
    for (size_t k = 0; st == FMB_OK && k < c->unknowns && mpz_cmp_ui(c->s, 1) != 0; k++)
        st = fmb_long_gcd(c->s, c->s, c->part[k], &poll);
    if (st != FMB_OK)
        return st;
    if (mpz_sgn(c->all) < 0)
        mpz_neg(c->s, c->s);
    mpz_divexact(c->all, c->all, c->s);
    for (size_t k = 0; k < c->unknowns; k++) {
        if (mpz_sgn(c->part[k]) == 0)
            continue;
        mpz_divexact(c->part[k], c->part[k], c->s);
        mpz_swap(c->part[kept], c->part[k]);
        c->index[kept++] = c->index[k];
    }
    c->size = c->unknowns = kept;
    return subtract_parts(c, c->part, c->n, c->left);
}

fmb_status fmb_combine(fmb_combination *c, fmb_run *run, size_t i, const size_t *support,
                       size_t size, bool *found)
{
    fmb_status st = FMB_OK;
    c->run = run;
    c->i = i;
    c->unknowns = size;
    for (size_t k = 0; k < size; k++)
        c->index[k] = support[k];
    list_equations(c);
    load_equations(c);
    *found = factor_equations(c);
    if (!*found)
        return FMB_OK;
    solve_modulo_prime(c);
    double bits = fmb_hadamard_bits(c->row, c->i, c->unknowns, c->index, c->column);
    if (bits < FMB_PRIME_BITS - 2) {
        lift_minors(c);
        st = try_equations(c, c->part, c->unknowns, found);
    } else {
        *found = false;
        st = lift_digits(c, bits, found);
    }
    if (st == FMB_OK && *found)
        st = tidy_combination(c);
    return st;
}

bool fmb_combination_proves(const fmb_combination *c)
{
    bool strict = false;
    for (size_t k = 0; k < c->size; k++) {
        fmb_rel rel = c->row[c->index[k]].rel;
        if (mpz_sgn(c->part[k]) < 0 && rel != FMB_EQ)
            return false;
        strict = strict || (rel == FMB_LT && mpz_sgn(c->part[k]) > 0);
    }
    int sign = mpz_sgn(c->left);
    return sign > 0 || (sign == 0 && (strict || c->row[c->i].rel != FMB_LT));
}
