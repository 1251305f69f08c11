/* factor.c: square sparse matrices of integers, solved exactly; see factor.h. */
#include "lp/linalg/exact/factor.h"

#include <assert.h>
#include <string.h>

#include "base/ways.h"
#include "lp/linalg/exact/dixon.h"
#include "lp/linalg/exact/minors.h"
#include "lp/linalg/exact/rational.h"
#include "lp/linalg/exact/triangular.h"
#include "lp/linalg/modular/modular_lu.h"
#include "num/integers.h"

struct fmb_factor {
    fmb_run *run;
    fmb_mem *mem;
    const fmb_program *p;
    fmb_arena lasting, passing;
    fmb_prime q;
    fmb_modular_lu lu;
    fmb_sparse b[2];     /* in the order of the pivots, and its transpose */
    fmb_sweep across[2]; /* the transposes of lu.upper, lu.lower */
    fmb_dixon lift[2];
    fmb_minors minors;
    bool is_short, has_minors; /* are minors suitable? are they computed? */
    bool *reached;             /* [n] scratch of substitution */
    fmb_rational rational;
    fmb_integers factor; /* [n] scratch: factors of d from each unknown in turn */
    mpz_t m, y, a, d, part;
    size_t usual[2]; /* digits that sufficed last time */
};

fmb_status fmb_factor_new(fmb_run *run, const fmb_program *p, fmb_factor **out)
{
    fmb_factor *f;
    FMB_TRY(FMB_GET_ZERO(run->mem, f, 1));
    f->run = run;
    f->mem = run->mem;
    f->p = p;
    fmb_arena_init(&f->lasting, f->mem);
    fmb_arena_init(&f->passing, f->mem);
    fmb_rational_init(&f->rational);
    mpz_inits(f->m, f->y, f->a, f->d, f->part, NULL);
    *out = f;
    return FMB_OK;
}

void fmb_factor_free(fmb_factor *f)
{
    if (!f)
        return;
    fmb_dixon_clear(&f->lift[0]);
    fmb_dixon_clear(&f->lift[1]);
    fmb_minors_clear(&f->minors, f->mem);
    fmb_rational_clear(&f->rational);
    fmb_integers_clear(&f->factor, f->mem);
    mpz_clears(f->m, f->y, f->a, f->d, f->part, NULL);
    fmb_arena_clear(&f->lasting);
    fmb_arena_clear(&f->passing);
    fmb_mem_put(f->mem, f, 1, sizeof *f);
}

/* ---- factors --------------------------------------------------------------------------------- */

static fmb_status factor_by_prime(fmb_factor *f, const fmb_sparse *rows, int k)
{
    f->q = fmb_prime_number(k);
    fmb_arena_reset(&f->lasting);
    fmb_run_count(f->run, 300 + 400 * rows->n + 10 * rows->start[rows->n]);
    return fmb_modular_lu_factor(&f->lu, f->run, &f->lasting, &f->passing, rows, &f->q);
}

fmb_status fmb_factor_set(fmb_factor *f, size_t *basis, bool *changed)
{
    fmb_sparse rows;
    f->has_minors = false;
    f->b[1] = (fmb_sparse){0};
    fmb_dixon_clear(&f->lift[0]);
    fmb_dixon_clear(&f->lift[1]);
    fmb_arena_reset(&f->passing);
    fmb_status st = fmb_sparse_gather(&rows, &f->passing, f->p, basis);
    for (int k = 0; st == FMB_OK && k < 2; k++) {
        st = factor_by_prime(f, &rows, k);
        if (st == FMB_OK && f->lu.rank == f->lu.n)
            break;
    }
    if (st != FMB_OK)
        return st;
    *changed = f->lu.rank < f->lu.n;
    for (size_t k = f->lu.rank; k < f->lu.n; k++)
        basis[f->lu.row_at[k]] = f->p->m + (size_t)f->lu.column_at[k];
    if (*changed)
        st = fmb_sparse_gather(&rows, &f->passing, f->p, basis);
    FMB_THEN(st,
             fmb_sparse_permute(&rows, &f->lasting, f->lu.row_at, f->lu.column_place, &f->b[0]));
    f->reached = fmb_arena_get(&f->lasting, f->lu.n, sizeof *f->reached);
    if (st == FMB_OK && !f->reached)
        st = fmb_mem_status(f->mem);
    if (st == FMB_OK)
        f->is_short = fmb_minors_suit(&f->b[0]) && fmb_way(FMB_WAY_MINORS);
    fmb_way_answered(FMB_WAY_MINORS, f->is_short);
    return st;
}

static fmb_status prepare_minors(fmb_factor *f)
{
    if (f->has_minors)
        return FMB_OK;
    fmb_status st = fmb_minors_factor(&f->minors, &f->b[0], f->run);
    f->has_minors = st == FMB_OK;
    return st;
}

static fmb_status prepare_transposed(fmb_factor *f)
{
    return f->b[1].start ? FMB_OK : fmb_sparse_transpose(&f->b[0], &f->lasting, &f->b[1]);
}

static fmb_status prepare_lifting_transposed(fmb_factor *f)
{
    fmb_status st = prepare_transposed(f);
    FMB_THEN(st, fmb_sweep_transpose(&f->lu.upper, &f->lasting, &f->across[0]));
    FMB_THEN(st, fmb_sweep_transpose(&f->lu.lower, &f->lasting, &f->across[1]));
    if (st == FMB_OK)
        st =
            fmb_dixon_init(&f->lift[1], &f->lasting, &f->q, &f->b[1], &f->across[0], &f->across[1]);
    return st;
}

static fmb_status prepare_lifting(fmb_factor *f, bool across)
{
    if (f->lift[across].mem)
        return FMB_OK;
    if (across)
        return prepare_lifting_transposed(f);
    return fmb_dixon_init(&f->lift[0], &f->lasting, &f->q, &f->b[0], &f->lu.lower, &f->lu.upper);
}

/* ---- solutions ------------------------------------------------------------------------------- */

/* One system to solve: x[at[k]] is unknown k, right[right_at[k]] the right side of row k. */
typedef struct asked {
    fmb_dixon *lift;
    mpz_t *right;
    const int *right_at, *at;
    mpz_t *x;
    size_t right_bits;
    bool whole;  /* use all digits of each number */
    size_t some; /* digits used, for numbers modulo f->part: as many as were needed so far */
} asked;

#define GUARD_BITS 24

/* f->y = f->d times unknown k modulo p^digits = m, with least absolute value. False: the query
 * ends, which the next digit reports. */
static bool scale_unknown(fmb_factor *f, const asked *s, size_t k, size_t digits, const mpz_t m)
{
    const fmb_poll poll = fmb_run_asked(f->run);
    if (fmb_dixon_value(s->lift, k, digits, f->y, &poll) != FMB_OK)
        return false;
    mpz_mul(f->y, f->y, f->d);
    mpz_fdiv_r(f->y, f->y, m);
    mpz_sub(f->a, m, f->y);
    if (mpz_cmp(f->a, f->y) < 0)
        mpz_neg(f->y, f->a);
    return fmb_run_poll_long(f->run, m) == FMB_OK;
}

/* The i-th unknown to be processed: first those from which others follow. */
static size_t unknown_in_turn(const fmb_factor *f, const asked *s, size_t i)
{
    return s->lift == &f->lift[0] ? s->lift->n - 1 - i : i;
}

/* Expect numbers no longer than f->y from now on, with a digit to spare. */
static void expect_length(fmb_factor *f, asked *s)
{
    size_t digits = mpz_sizeinbase(f->y, 2) / (FMB_PRIME_BITS - 1) + 3;
    if (digits >= s->lift->digits || (s->some < s->lift->digits && digits <= s->some))
        return;
    mpz_set_ui(f->part, 1);
    for (s->some = 0; s->some < digits; s->some++)
        fmb_integer_times_u64(f->part, f->part, f->q.p);
}

/* f->y is a fraction whose denominator f->d lacks: multiply it into f->d. False: it is not found
 * yet, or the query ends, which the next digit reports. */
static bool widen_denominator(fmb_factor *f, size_t m_bits)
{
    const fmb_poll poll = fmb_run_asked(f->run);
    size_t half = (m_bits + mpz_sizeinbase(f->d, 2)) / 2;
    if (mpz_sgn(f->y) < 0)
        mpz_add(f->y, f->y, f->m);
    if (m_bits < half + GUARD_BITS ||
        !fmb_rational_find(&f->rational, f->y, f->m, half, m_bits - half - GUARD_BITS, f->a, f->y,
                           &poll) ||
        mpz_cmp_ui(f->y, 1) == 0)
        return false;
    mpz_mul(f->d, f->d, f->y);
    return true;
}

/* Find d times unknown k, and the factor multiplied into d for it; the factor 0 means 1, as mostly.
 */
static bool find_numerator(fmb_factor *f, asked *s, size_t k, size_t shorter, mpz_t factor)
{
    mpz_ptr x = s->x[s->at[k]];
    size_t digits = s->lift->digits;
    mpz_set_ui(factor, 0);
    if (s->some < digits) {
        if (!scale_unknown(f, s, k, s->some, f->part))
            return false;
        mpz_set(x, f->y);
        if (mpz_sizeinbase(x, 2) + FMB_PRIME_BITS <= mpz_sizeinbase(f->part, 2))
            return true;
    }
    if (!scale_unknown(f, s, k, digits, f->m))
        return false;
    if (mpz_sizeinbase(f->y, 2) > shorter) {
        bool widened = widen_denominator(f, mpz_sizeinbase(f->m, 2) - 1);
        mpz_swap(x, f->a);
        mpz_swap(factor, f->y);
        return widened;
    }
    mpz_set(x, f->y);
    if (!s->whole)
        expect_length(f, s);
    return true;
}

/* Find numerators over the current d, one unknown after the other; then multiply each by the
 * factors that d got later. */
static bool find_numerators(fmb_factor *f, asked *s, size_t shorter)
{
    bool found = true;
    s->some = s->lift->digits;
    for (size_t i = 0; found && i < s->lift->n; i++)
        found = find_numerator(f, s, unknown_in_turn(f, s, i), shorter, f->factor.z[i]);
    mpz_set_ui(f->a, 1);
    for (size_t i = s->lift->n; found && i-- > 0;) {
        mpz_ptr x = s->x[s->at[unknown_in_turn(f, s, i)]];
        if (mpz_cmp_ui(f->a, 1) != 0)
            mpz_mul(x, x, f->a);
        if (mpz_sgn(f->factor.z[i]) != 0)
            mpz_mul(f->a, f->a, f->factor.z[i]);
        found = fmb_run_poll_long(f->run, x) == FMB_OK;
    }
    return found;
}

/* Does B x = d right hold in integers? */
static bool is_solution(fmb_factor *f, const asked *s)
{
    const fmb_sparse *b = s->lift->b;
    bool holds = true;
    for (size_t k = 0; holds && k < b->n; k++) {
        mpz_mul(f->a, f->d, s->right[s->right_at[k]]);
        for (size_t t = b->start[k]; t < b->start[k + 1]; t++) {
            mpz_srcptr x = s->x[s->at[b->index[t]]];
            fmb_integer_set_i64(f->y, b->value[t]);
            mpz_submul(f->a, b->big && b->big[t] ? b->big[t] : f->y, x);
        }
        holds = mpz_sgn(f->a) == 0 && fmb_run_poll_long(f->run, f->a) == FMB_OK;
    }
    return holds;
}

/* Theorem. Let m = p^k, x the digits so far: B x = right modulo m. If y = d x modulo m, then B y =
 * d right modulo m; and if both sides are less than m/2, B y = d right.
 *
 * A fraction may look short by chance before d has its denominator (m is not random: 1/2^30 is
 * short modulo some powers of some primes), and not later: then all fractions are computed again
 * with the present d, and that one is not short again, or d has grown.
 *
 * Most numbers have about the same length, and are shorter than m. So they are computed from a few
 * digits first, and verified by multiplication; only if that fails, from all digits. */
static bool find_common_denominator(fmb_factor *f, asked *s)
{
    size_t m_bits = mpz_sizeinbase(f->m, 2) - 1, norm_bits = s->lift->b->bits_max;
    if (m_bits < norm_bits + 2 + GUARD_BITS)
        return false;
    size_t room = m_bits - norm_bits - 2;
    mpz_set_ui(f->d, 1);
    for (bool fits = false; !fits;) {
        if (!find_numerators(f, s, room - GUARD_BITS))
            return false;
        fits = true;
        for (size_t k = 0; fits && k < s->lift->n; k++)
            fits = mpz_sizeinbase(s->x[s->at[k]], 2) <= room;
        s->whole = s->whole || !fits;
    }
    if (mpz_sizeinbase(f->d, 2) + s->right_bits + 2 > m_bits)
        return false;
    s->whole = s->some < s->lift->digits && !is_solution(f, s);
    return !s->whole;
}

/* Work of a digit: residuals, each of a word or more, and both factors. */
static uint64_t work_of_digit(const fmb_dixon *l)
{
    size_t n = l->n, words = l->word_start[n];
    return 40 * n + 4 * l->b->start[n] * words / n;
}

/* Work of a search for fractions: so many digits of each unknown, mostly over the divisor of the
 * one before. */
static uint64_t work_of_fractions(const fmb_dixon *l)
{
    size_t digits = l->digits;
    return l->n * (200 + digits * digits / 2 + fmb_limbs_work(digits)) + 2 * fmb_gcd_work(digits);
}

/* Fractions are not looked for before there are about as many digits as sufficed last time: digits
 * are cheaper than a failed search. */
static fmb_status lift_until_found(fmb_factor *f, asked *s, size_t most)
{
    size_t *usual = &f->usual[s->lift - f->lift];
    size_t first = *usual < most ? *usual : most, next = first;
    while (true) {
        fmb_status st = fmb_dixon_step(s->lift);
        fmb_run_count(f->run, work_of_digit(s->lift));
        FMB_THEN(st, fmb_run_poll(f->run));
        if (st != FMB_OK)
            return st;
        fmb_integer_times_u64(f->m, f->m, f->q.p);
        size_t digits = s->lift->digits;
        if (digits < next)
            continue;
        fmb_run_count(f->run, work_of_fractions(s->lift));
        if (find_common_denominator(f, s)) {
            *usual = digits > first ? digits : digits - digits / 8 - 1;
            return FMB_OK;
        }
        assert(digits <= most);
        if (digits > most) /* only if our arithmetic is wrong: better than an endless loop */
            return FMB_ERR_STATE;
        next = digits + digits / 8 + 1;
    }
}

/* Cramer: numerators and denominator are determinants, at most the product of the rows' norms. */
static size_t count_most_digits(const fmb_sparse *b, size_t right_bits)
{
    double bits = 2 * (fmb_sparse_determinant_bits(b) + (double)right_bits + b->bits_max + 64);
    return (size_t)(bits / (FMB_PRIME_BITS - 1)) + 3;
}

static fmb_status solve_by_lifting(fmb_factor *f, fmb_dixon *lift, mpz_t *right,
                                   const int *right_at, const int *at, mpz_t *x, mpz_t den)
{
    asked s = {.lift = lift, .right = right, .right_at = right_at, .at = at, .x = x};
    if (lift->n == 0) {
        mpz_set_ui(den, 1);
        return FMB_OK;
    }
    for (size_t k = 0; k < lift->n; k++) {
        size_t bits = mpz_sizeinbase(right[k], 2);
        s.right_bits = bits > s.right_bits ? bits : s.right_bits;
    }
    mpz_set_ui(f->m, 1);
    fmb_status st = FMB_OK;
    if (f->factor.size != lift->n) {
        fmb_integers_clear(&f->factor, f->mem);
        st = fmb_integers_init(&f->factor, lift->n, f->mem);
    }
    FMB_THEN(st, fmb_dixon_begin(lift, right, right_at));
    FMB_THEN(st, lift_until_found(f, &s, count_most_digits(lift->b, s.right_bits)));
    FMB_THEN(st, fmb_integers_settle(&f->factor, f->mem));
    if (st == FMB_OK)
        mpz_set(den, f->d);
    return st;
}

static bool substitute(fmb_factor *f, bool across, mpz_t *right, mpz_t *x, mpz_t den)
{
    fmb_triangular t = {
        .b = &f->b[across], .turn = f->lu.turn, .backwards = across, .reached = f->reached};
    const int *row = f->lu.row_at, *column = f->lu.column_at;
    return fmb_triangular_solve(&t, right, across ? column : row, across ? row : column, x, den);
}

/* Solve with B, or (across) with B^T: triangular, or by short minors, or digit by digit. */
static fmb_status solve_factored(fmb_factor *f, bool across, mpz_t *right, mpz_t *x, mpz_t den)
{
    const int *right_at = across ? f->lu.column_at : f->lu.row_at;
    const int *at = across ? f->lu.row_at : f->lu.column_at;
    fmb_status st = f->lu.is_triangular && across ? prepare_transposed(f) : FMB_OK;
    if (st == FMB_OK && f->lu.is_triangular && fmb_way(FMB_WAY_TRIANGULAR) &&
        substitute(f, across, right, x, den)) {
        fmb_way_answered(FMB_WAY_TRIANGULAR, true);
        return fmb_run_poll(f->run);
    }
    FMB_THEN(st, f->is_short ? prepare_minors(f) : prepare_lifting(f, across));
    if (st == FMB_OK && !f->is_short)
        return solve_by_lifting(f, &f->lift[across], right, right_at, at, x, den);
    FMB_THEN(st, fmb_minors_solve(&f->minors, f->run, across, right, right_at, at, x, den));
    return st == FMB_OK ? fmb_run_poll(f->run) : st;
}

fmb_status fmb_factor_solve(fmb_factor *f, mpz_t *right, mpz_t *x, mpz_t den)
{
    return solve_factored(f, false, right, x, den);
}

fmb_status fmb_factor_solve_transposed(fmb_factor *f, mpz_t *cost, mpz_t *y, mpz_t den)
{
    return solve_factored(f, true, cost, y, den);
}
