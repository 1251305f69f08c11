/* long_gcd.c: greatest common divisors of long integers, with a poll; see gcd.h.
 *
 * Euclid's quotients depend on the leading bits: those of the leading halves of two numbers are
 * quotients of the numbers as long as the remainders are longer than half of these halves. So a
 * matrix with entries of a quarter of the bits is found from half of them, by recursion; two such
 * matrices, the second from what the first leaves, halve the two numbers (half-gcd). Short pieces
 * use words.
 *
 * CLAIM. Whatever matrices are found from the halves, the result is right, and there is one.
 *
 * A matrix is a product of swaps, sign changes, and subtractions of a multiple of one number from
 * the other: its entries are integers and its determinant is 1 or -1, so the pair of numbers and
 * its product with the matrix have the same common divisors. The product is used only if it is
 * shorter, and each round divides by the smaller number: so it ends. END
 *
 * As nothing else is required of a matrix, quotients near the end of a half need no correction:
 * some are not those of the numbers, which costs a few bits. A half returns only its matrix; the
 * remainders between its two parts are computed to the precision that the second part needs.
 *
 * Source: Moeller 2008, On Schoenhage's algorithm and subquadratic integer gcd computation,
 * Mathematics of Computation 77; Lehmer 1938 for the words.
 */
#include "base/mem.h"
#include "num/gcd.h"

#include <stdbool.h>
#include <stdint.h>

#include "num/word.h"

/* Numbers of at most this many bits are halved word by word; longer ones than MOMENT_BITS poll. */
#define WORDWISE_BITS ((size_t)3072)
#define MOMENT_BITS   ((size_t)1 << 17)
/* Bits of a leading word, and how many of them the quotients use up at most. */
#define WORD_BITS 62
#define STEP_BITS 31
/* Bits by which a product modulo a power of two may be longer than estimated. */
#define SPARE_BITS 64
/* A matrix is found from the leading 1 / PIECES of the bits at a time. */
#define PIECES 3

/* A matrix that maps a pair of numbers to another pair. */
typedef struct transform {
    mpz_t at[2][2];
} transform;

typedef struct half_gcd {
    const fmb_poll *poll;
    mpz_t s[2]; /* scratch */
} half_gcd;

static void open_matrix(transform *m)
{
    mpz_init_set_ui(m->at[0][0], 1);
    mpz_init_set_ui(m->at[0][1], 0);
    mpz_init_set_ui(m->at[1][0], 0);
    mpz_init_set_ui(m->at[1][1], 1);
}

static void close_matrix(transform *m)
{
    mpz_clears(m->at[0][0], m->at[0][1], m->at[1][0], m->at[1][1], NULL);
}

static size_t bits_of(const mpz_t z)
{
    return mpz_sgn(z) == 0 ? 0 : mpz_sizeinbase(z, 2);
}

static size_t longest_entry(const transform *m)
{
    size_t most = 0;
    for (int i = 0; i < 4; i++) {
        size_t bits = bits_of(m->at[i / 2][i % 2]);
        most = bits > most ? bits : most;
    }
    return most;
}

static void negate_row(transform *m, int i)
{
    mpz_neg(m->at[i][0], m->at[i][0]);
    mpz_neg(m->at[i][1], m->at[i][1]);
}

static void swap_rows(transform *m)
{
    mpz_swap(m->at[0][0], m->at[1][0]);
    mpz_swap(m->at[0][1], m->at[1][1]);
}

/* After a step: make a and b nonnegative and sort them, a >= b >= 0; m changes accordingly. */
static void put_in_order(transform *m, mpz_t a, mpz_t b)
{
    if (mpz_sgn(a) < 0) {
        mpz_neg(a, a);
        negate_row(m, 0);
    }
    if (mpz_sgn(b) < 0) {
        mpz_neg(b, b);
        negate_row(m, 1);
    }
    if (mpz_cmp(a, b) < 0) {
        mpz_swap(a, b);
        swap_rows(m);
    }
}

/* One step of Euclid's algorithm, with a quotient of any length; b > 0. */
static void divide_once(half_gcd *h, transform *m, mpz_t a, mpz_t b)
{
    mpz_tdiv_qr(h->s[0], a, a, b);
    mpz_submul(m->at[0][0], h->s[0], m->at[1][0]);
    mpz_submul(m->at[0][1], h->s[0], m->at[1][1]);
    mpz_swap(a, b);
    swap_rows(m);
}

/* ---- words ----------------------------------------------------------------------------------- */

/* Absolute values of the entries of a matrix of words; signs alternate, and at[0][0] is positive
 * unless `odd`.
 */
typedef struct word_matrix {
    uint32_t at[2][2];
    bool odd;
} word_matrix;

/* The matrix of the quotients of leading words x >= y, x < 2^62. While y >= 2^31, an entry is at
 * most 2^62 / 2^31, as x is at least an entry times a later remainder. False: no step. */
static bool step_through_words(word_matrix *w, uint64_t x, uint64_t y)
{
    uint64_t m[2][2] = {{1, 0}, {0, 1}};
    bool odd = false, any = y >> STEP_BITS != 0;
    while (y >> STEP_BITS != 0) {
        uint64_t q = x / y, next = x - q * y;
        for (int j = 0; j < 2; j++) {
            uint64_t entry = m[0][j] + q * m[1][j];
            m[0][j] = m[1][j];
            m[1][j] = entry;
        }
        x = y;
        y = next;
        odd = !odd;
    }
    for (int i = 0; i < 4; i++)
        w->at[i / 2][i % 2] = (uint32_t)m[i / 2][i % 2];
    w->odd = odd;
    return any;
}

/* (x, y) becomes its product with the matrix. */
static void multiply_by_words(half_gcd *h, const word_matrix *w, mpz_t x, mpz_t y)
{
    mpz_ptr u = h->s[0], v = h->s[1];
    mpz_mul_ui(u, x, w->at[0][0]);
    mpz_submul_ui(u, y, w->at[0][1]);
    mpz_mul_ui(v, y, w->at[1][1]);
    mpz_submul_ui(v, x, w->at[1][0]);
    if (w->odd) {
        mpz_neg(u, u);
        mpz_neg(v, v);
    }
    mpz_swap(x, u);
    mpz_swap(y, v);
}

/* The bits of z above `cut`, which fit into a word. */
static uint64_t leading_word(half_gcd *h, const mpz_t z, size_t cut)
{
    mpz_tdiv_q_2exp(h->s[0], z, cut);
    return fmb_integer_low(h->s[0]);
}

/* Nearly halve the length of a >= b >= 0; m is multiplied by the matrix of these steps. */
static void halve_wordwise(half_gcd *h, transform *m, mpz_t a, mpz_t b)
{
    const size_t half = bits_of(a) / 2 + STEP_BITS;
    for (size_t n = bits_of(a); n > half && n > WORD_BITS && bits_of(b) > half - STEP_BITS;
         n = bits_of(a)) {
        word_matrix w;
        if (step_through_words(&w, leading_word(h, a, n - WORD_BITS),
                               leading_word(h, b, n - WORD_BITS))) {
            multiply_by_words(h, &w, a, b);
            multiply_by_words(h, &w, m->at[0][0], m->at[1][0]);
            multiply_by_words(h, &w, m->at[0][1], m->at[1][1]);
            put_in_order(m, a, b);
        } else {
            divide_once(h, m, a, b);
        }
    }
}

/* ---- halves ---------------------------------------------------------------------------------- */

/* z modulo 2^bits, with the least absolute value. */
static void wrap(mpz_t z, size_t bits)
{
    mpz_fdiv_r_2exp(z, z, bits);
    if (mpz_tstbit(z, bits - 1))
        mpz_cdiv_r_2exp(z, z, bits);
}

/* to = p x + q y */
static void combine(mpz_t to, const mpz_t p, const mpz_t x, const mpz_t q, const mpz_t y)
{
    mpz_mul(to, p, x);
    mpz_addmul(to, q, y);
}

/* (a, b) becomes its product with the matrix, modulo 2^bits unless bits is 0. After an error a and
 * b are undefined. */
static fmb_status multiply_pair(half_gcd *h, const transform *m, mpz_t a, mpz_t b, size_t bits)
{
    if (bits > 0) {
        mpz_fdiv_r_2exp(a, a, bits);
        mpz_fdiv_r_2exp(b, b, bits);
    }
    combine(h->s[0], m->at[0][0], a, m->at[0][1], b);
    FMB_TRY(bits_of(a) > FMB_LONG_BITS ? fmb_poll_ask(h->poll) : FMB_OK);
    combine(h->s[1], m->at[1][0], a, m->at[1][1], b);
    mpz_swap(a, h->s[0]);
    mpz_swap(b, h->s[1]);
    if (bits > 0) {
        wrap(a, bits);
        wrap(b, bits);
    }
    return FMB_OK;
}

/* m = by m */
static fmb_status multiply_matrix(half_gcd *h, const transform *by, transform *m)
{
    FMB_TRY(multiply_pair(h, by, m->at[0][0], m->at[1][0], 0));
    return multiply_pair(h, by, m->at[0][1], m->at[1][1], 0);
}

static fmb_status halve(half_gcd *h, transform *m, mpz_t a, mpz_t b);

/* m becomes its product with the matrix of the bits of a and b above `cut`. */
static fmb_status halve_leading_bits(half_gcd *h, transform *m, const mpz_t a, const mpz_t b,
                                     size_t cut)
{
    mpz_t x, y;
    transform piece;
    mpz_inits(x, y, NULL);
    open_matrix(&piece);
    mpz_tdiv_q_2exp(x, a, cut);
    mpz_tdiv_q_2exp(y, b, cut);
    fmb_status st = halve(h, &piece, x, y);
    FMB_THEN(st, multiply_matrix(h, &piece, m));
    close_matrix(&piece);
    mpz_clears(x, y, NULL);
    return st;
}

/* The matrix m, initially 1, that nearly halves the length of a >= b >= 0. Both are used up.
 *
 * The matrix of the leading n/2 bits has entries of at most t bits, so n/2 - t of these bits
 * remain, and the lower bits times the matrix are t bits longer than they were. So the product of a
 * and b with it is computed modulo that power of two, with a few bits to spare. */
static fmb_status halve(half_gcd *h, transform *m, mpz_t a, mpz_t b)
{
    const size_t n = bits_of(a), half = n / 2;
    if (n <= WORDWISE_BITS) {
        halve_wordwise(h, m, a, b);
        return FMB_OK;
    }
    FMB_TRY(n > MOMENT_BITS ? fmb_poll_ask(h->poll) : FMB_OK);
    FMB_TRY(halve_leading_bits(h, m, a, b, n - half));
    size_t t = longest_entry(m), left = half > 2 * t ? half - t : t;
    FMB_TRY(multiply_pair(h, m, a, b, left + (n - half) + SPARE_BITS));
    put_in_order(m, a, b);
    t += bits_of(a) - bits_of(b);
    if (mpz_sgn(b) == 0 || t >= half)
        return FMB_OK;
    divide_once(h, m, a, b);
    size_t rest = bits_of(a), wanted = 2 * (half - t);
    return halve_leading_bits(h, m, a, b, rest > wanted ? rest - wanted : 0);
}

/* ---- rounds ---------------------------------------------------------------------------------- */

/* Replace a >= b > 0 by shorter numbers with the same common divisors. */
static fmb_status shorten(half_gcd *h, mpz_t a, mpz_t b)
{
    transform m;
    mpz_t x, y;
    size_t n = bits_of(a);
    open_matrix(&m);
    mpz_inits(x, y, NULL);
    fmb_status st = halve_leading_bits(h, &m, a, b, n - n / PIECES);
    if (st == FMB_OK) {
        mpz_set(x, a);
        mpz_set(y, b);
        st = multiply_pair(h, &m, x, y, 0);
    }
    if (st == FMB_OK) {
        put_in_order(&m, x, y);
        st = fmb_poll_ask(h->poll);
    }
    if (st == FMB_OK && bits_of(x) < n) {
        mpz_swap(a, x);
        mpz_swap(b, y);
    }
    close_matrix(&m);
    mpz_clears(x, y, NULL);
    return st;
}

static fmb_status reduce_long_pair(half_gcd *h, mpz_t a, mpz_t b)
{
    while (bits_of(b) > FMB_LONG_BITS) {
        mpz_tdiv_r(a, a, b);
        mpz_swap(a, b);
        FMB_TRY(fmb_poll_ask(h->poll));
        if (mpz_sgn(b) != 0)
            FMB_TRY(shorten(h, a, b));
    }
    return FMB_OK;
}

fmb_status fmb_long_gcd(mpz_t out, const mpz_t a, const mpz_t b, const fmb_poll *poll)
{
    if (bits_of(a) <= FMB_LONG_BITS || bits_of(b) <= FMB_LONG_BITS) {
        mpz_gcd(out, a, b);
        return FMB_OK;
    }
    half_gcd h = {.poll = poll};
    mpz_t x, y;
    mpz_inits(x, y, h.s[0], h.s[1], NULL);
    mpz_abs(x, a);
    mpz_abs(y, b);
    if (mpz_cmp(x, y) < 0)
        mpz_swap(x, y);
    fmb_status st = reduce_long_pair(&h, x, y);
    if (st == FMB_OK) {
        mpz_gcd(x, x, y);
        st = fmb_poll_ask(poll);
    }
    if (st == FMB_OK)
        mpz_swap(out, x);
    mpz_clears(x, y, h.s[0], h.s[1], NULL);
    return st;
}

/* The denominator of x is coprime to its numerator, and so is `by` after division of both by their
 * common divisor. */
fmb_status fmb_long_divide(mpq_t x, const mpz_t by, const fmb_poll *poll)
{
    mpz_t common, rest;
    mpz_inits(common, rest, NULL);
    fmb_status st = fmb_long_gcd(common, mpq_numref(x), by, poll);
    if (st == FMB_OK) {
        mpz_divexact(rest, by, common);
        mpz_divexact(mpq_numref(x), mpq_numref(x), common);
        mpz_mul(mpq_denref(x), mpq_denref(x), rest);
        if (mpz_sgn(by) < 0) {
            mpz_neg(mpq_numref(x), mpq_numref(x));
            mpz_neg(mpq_denref(x), mpq_denref(x));
        }
        if (mpz_sgn(mpq_numref(x)) == 0)
            mpz_set_ui(mpq_denref(x), 1);
    }
    mpz_clears(common, rest, NULL);
    return st;
}
